# Class `codend_measures`: named numbers with units, kinds and errors.

# `values`, `errors`: SI, by name; `kinds`: their entries in the registries; `light`: drag is small
# compared with the weights.
new_measures <- function(values, kinds, errors, light) {
  units <- measure_units(kinds)
  kind <- vapply(kinds, `[[`, "", "kind", USE.NAMES = FALSE)
  structure(numbers_in_display_units(values, units), unit = setNames(units, names(values)),
    kind = setNames(kind, names(values)), error = numbers_in_display_units(errors, units),
    main = setNames(main_measures(kind, units, light), names(values)),
    class = c("codend_measures", "numeric"))
}

numbers_in_display_units <- function(values, units) {
  setNames(as.double(mapply(in_unit, values, units)), names(values))
}

plain_measures <- function(x) setNames(as.double(x), names(x))

#' @export
`[.codend_measures` <- function(x, i) {
  if (!missing(i) && is.character(i)) check_measure_names(i, names(x))
  some <- plain_measures(x)[i]
  structure(some, unit = attr(x, "unit")[names(some)], kind = attr(x, "kind")[names(some)],
    error = attr(x, "error")[names(some)], main = attr(x, "main")[names(some)], class = class(x))
}

#' @export
`[[.codend_measures` <- function(x, i, ...) {
  if (is.character(i)) check_measure_names(i, names(x))
  plain_measures(x)[[i]]
}

#' @rawNamespace S3method(base::"$",codend_measures)
`$.codend_measures` <- function(x, name) x[[name]]

# Stops at the first unknown name. Names need their unit here; formulas may omit it.
check_measure_names <- function(wanted, known) {
  wrong <- setdiff(wanted, known)
  if (!length(wrong)) return(invisible())
  wrong <- wrong[1L]
  with_unit <- known[startsWith(known, paste0(wrong, "_"))]
  near <- c(with_unit, nearest(wrong, known))
  hint <- if (length(near)) " Did you mean {.val {near[1]}}?"
  abort_argument(paste0("The measure {.val {wrong}} does not exist.", hint,
    " Known here: {.val {known}}."))
}

#' @export
as.list.codend_measures <- function(x, ...) as.list(plain_measures(x))

#' @export
as.data.frame.codend_measures <- function(x, row.names = NULL, optional = FALSE, ...) {
  as.data.frame(plain_measures(x), row.names, optional, ..., nm = "value")
}

# Renamed values lose their units and errors and become plain numbers.
#' @export
`names<-.codend_measures` <- function(x, value) setNames(as.double(x), value)

#' @export
print.codend_measures <- function(x, digits = getOption("digits"), ...) {
  force(digits)
  with_plain_numbers(print(plain_measures(x), digits = digits, ...))
  invisible(x)
}

# Returns list(words, unit, error) for display; error is a string such as "0.6", or "".
measure_labels <- function(measures) {
  unit <- unname(attr(measures, "unit"))
  list(
    words = label_of(names(measures), unit), unit = unit,
    error = error_text(unname(attr(measures, "error")))
  )
}

# Returns names of at most nine measures for short prints, in the order of `measures`: two main
# measures of each kind (spreads, heights, areas, volumes), total drag and one tension. The first
# measures of further kinds fill the rest.
printed_measures <- function(measures) {
  kind <- attr(measures, "kind")
  main <- attr(measures, "main") | kind == "total_drag"
  position <- stats::ave(seq_along(kind), kind, FUN = seq_along)
  first <- position == 1
  rank <- ifelse(main & position <= 2, 1, ifelse(first & kind == "tension", 2, 4 - first))
  names(measures)[sort(utils::head(order(rank), 9L))]
}

definitions_of <- function(measures) {
  measure_strings(all_kinds()[attr(measures, "kind")])
}
