# Returns list(standard, order). `standard`: kinds of the measures that every gear has; `order`:
# name, kind and size of the unit of each measure, in the engine's order: those of the gear's plan,
# then the standard ones.
shared_measures <- function(state) {
  found <- measures(state)
  own <- vapply(state$si$measures, `[[`, "", "column")
  order <- match(union(own, names(found)), names(found))
  kind <- unname(attr(found, "kind"))
  list(
    standard = kind[!names(found) %in% own],
    order = lapply(order, function(k) {
      list(name = names(found)[k], kind = kind[k], size = unit_size(attr(found, "unit")[[k]]))
    })
  )
}
