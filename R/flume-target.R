# Required values of measures, typed into the results of the design on screen. The slow worker finds
# the value of a field by find_value(), within the range of the field's slider.

# `said`: list(paths (fields that change together), measure (its name), target (as typed), unit (of
# a bare number)). Returns list(paths, value, unit, low, high (in this unit), reached, measure,
# measure_unit, target, result (both in its unit)).
found_target <- function(state, said) {
  asked <- requested_field(state$gear$plan, said$paths)
  control <- number_control(asked$field)
  if (is.null(control$low)) {
    abort_argument("The field {.val {asked$paths[1]}} has no range; choose another field.")
  }
  unit <- if (is.null(control$dimension)) "" else control$unit
  range <- lapply(c(control$low, control$high), function(end) {
    if (nzchar(unit)) paste(shortest_decimal(end), unit) else end
  })
  target <- typed_target(said, measures(state))
  change <- setNames(list(range), paste(asked$paths, collapse = " + "))
  # the page reports a target out of reach
  found <- suppressWarnings(
    do.call(find_value, c(list(state$gear), change, list(target = target,
      nodes = nodes_of(state)))),
    classes = "codend_warning"
  )
  list(
    paths = asked$paths, value = signif(found$fields$value, 6L), unit = found$fields$unit,
    low = control$low, high = control$high, reached = found$targets$reached,
    measure = found$targets$measure, measure_unit = found$targets$unit,
    target = found$targets$target, result = found$targets$value
  )
}

# Returns the target of a request as an argument of find_value().
typed_target <- function(said, known) {
  name <- said$measure
  if (!is_text(name) || !name %in% names(known)) {
    abort_argument("The gear on screen does not have this measure.")
  }
  text <- said$target
  if (!is_text(text) || nchar(text) > most_characters) text <- ""
  parts <- split_quantity(with_point(text))
  if (is.null(parts)) {
    abort_argument("The required value is {.val {text}}; it must be a number, with a unit if you
      like.")
  }
  if (nzchar(parts[2L])) return(setNames(list(paste(parts[1L], parts[2L])), name))
  unit <- attr(known, "unit")[[name]]
  number <- as.double(parts[1L])
  if (is_text(said$unit) && said$unit %in% unlist(preferred_units)) {
    number <- in_unit(from_unit(number, said$unit), unit)
  }
  setNames(list(number), name)
}
