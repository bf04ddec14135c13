# Measures as numbers that keep what they are: each one's unit and kind.

# values: SI, by name; kinds: their entries in the registries.
new_measures <- function(values, kinds) {
  units <- measure_units(kinds)
  shown <- as.double(mapply(in_unit, values, units))
  structure(setNames(shown, names(values)), unit = setNames(units, names(values)),
    kind = setNames(vapply(kinds, `[[`, "", "kind", USE.NAMES = FALSE), names(values)),
    class = c("codend_measures", "numeric"))
}

plain_measures <- function(x) setNames(as.double(x), names(x))

#' @export
`[.codend_measures` <- function(x, i) {
  some <- plain_measures(x)[i]
  structure(some, unit = attr(x, "unit")[names(some)], kind = attr(x, "kind")[names(some)],
    class = class(x))
}

#' @export
as.list.codend_measures <- function(x, ...) as.list(plain_measures(x))

#' @export
as.data.frame.codend_measures <- function(x, row.names = NULL, optional = FALSE, ...) {
  as.data.frame(plain_measures(x), row.names, optional, ..., nm = "value")
}

# Under other names, or none, they are numbers alone.
#' @export
`names<-.codend_measures` <- function(x, value) setNames(as.double(x), value)

#' @export
print.codend_measures <- function(x, ...) {
  print(plain_measures(x), ...)
  invisible(x)
}

# What text shows of measures: list(words, unit).
measure_words <- function(measures) {
  unit <- unname(attr(measures, "unit"))
  list(words = words_of(names(measures), unit), unit = unit)
}

# The definitions of measures, one text each.
definitions_of <- function(measures) {
  measure_texts(c(asked_kinds(), standard_measures)[attr(measures, "kind")])
}
