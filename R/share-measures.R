# Returns list(programs, standard, order). `programs` lists kind, unit, size, words, value, relative
# error and definition of each measure; `standard` the kinds of measures that every gear has;
# `order` the names in the engine's order: those of the gear's plan, then the standard ones.
shared_measures <- function(state) {
  found <- measures(state)
  unit <- attr(found, "unit")
  error <- attr(found, "error")
  value <- plain_measures(found)
  words <- label_of(names(found), unname(unit))
  definition <- definitions_of(found)
  programs <- lapply(setNames(seq_along(found), names(found)), function(k) {
    list(
      kind = attr(found, "kind")[[k]], unit = unit[[k]], size = unit_size(unit[[k]]),
      words = words[k], value = value[[k]], definition = definition[[k]],
      error = if (is.finite(error[[k]]) && value[[k]] != 0) error[[k]] / abs(value[[k]])
    )
  })
  own <- vapply(state$si$measures, `[[`, "", "column")
  standard <- !names(found) %in% own
  list(
    programs = programs, standard = unname(attr(found, "kind")[standard]),
    order = c(own, names(found)[standard])
  )
}
