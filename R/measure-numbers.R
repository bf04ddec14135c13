# Class `codend_measures`: named numbers with units, kinds and errors.

# `values`, `errors`: SI, by name; `kinds`: their entries in the registries; `light`: drag is small
# compared with the weights; `net`: net of a rig that each measure belongs to, or "".
new_measures <- function(values, kinds, errors, light, net = rep("", length(values))) {
  units <- measure_units(kinds)
  kind <- vapply(kinds, `[[`, "", "kind", USE.NAMES = FALSE)
  measures_of(
    numbers_in_display_units(values, units), setNames(units, names(values)),
    setNames(kind, names(values)), numbers_in_display_units(errors, units),
    setNames(main_measures(kind, units, light), names(values)), setNames(net, names(values))
  )
}

# Values, units, kinds, errors, main measures and nets, all named by measure.
measures_of <- function(values, unit, kind, error, main, net) {
  structure(values, unit = unit, kind = kind, error = error, main = main, net = net,
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
  of <- function(name) attr(x, name)[names(some)]
  measures_of(some, of("unit"), of("kind"), of("error"), of("main"), of("net"))
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

# data.frame() sets `optional` and gets one column.
#' @export
as.data.frame.codend_measures <- function(x, row.names = NULL, optional = FALSE, ...) {
  if (optional) return(as.data.frame(plain_measures(x), row.names, optional, ..., nm = "value"))
  data.frame(
    measure = names(x), value = as.double(x), error = unname(attr(x, "error")),
    unit = unname(attr(x, "unit")), row.names = row.names
  )
}

#' @rawNamespace S3method(utils::.DollarNames,codend_measures)
.DollarNames.codend_measures <- function(x, pattern = "") {
  grep(pattern, names(x), value = TRUE)
}

# Returns plain numbers. Operands with several names are matched by name. 0 / 0 is left out.
#' @export
Ops.codend_measures <- function(e1, e2) {
  operate <- get(.Generic)
  if (missing(e2)) return(operate(plain_measures(e1)))
  sides <- lapply(list(e1, e2), function(x) {
    if (inherits(x, "codend_measures")) plain_measures(x) else x
  })
  both <- intersect(names(e1), names(e2))
  if (length(both) && all(lengths(sides) > 1L)) sides <- lapply(sides, `[`, both)
  found <- operate(sides[[1L]], sides[[2L]])
  if (.Generic == "/") found[!(sides[[1L]] %in% 0 & sides[[2L]] %in% 0)] else found
}

#' @export
Math.codend_measures <- function(x, ...) get(.Generic)(plain_measures(x), ...)

#' @export
Summary.codend_measures <- function(..., na.rm = FALSE) {
  do.call(.Generic, c(lapply(list(...), as.double), na.rm = na.rm))
}

# Renamed values lose their units and errors and become plain numbers.
#' @export
`names<-.codend_measures` <- function(x, value) setNames(as.double(x), value)

#' @param x Measures.
#' @param n Largest number of lines below the heading. `Inf` prints all measures.
#' @param ... Not used.
#' @rdname measures
#' @export
print.codend_measures <- function(x, n = 29, ...) {
  x <- main_first(in_preferred_units(x))
  values <- align_points(figures(plain_measures(x), attr(x, "error")))
  said <- measure_labels(x)
  lines <- align_columns(Map(c, c("measure", "value", "unit", "error"),
    list(names(x), values, said$unit, said$error)), left = c(1L, 3L))
  cat(lines[1L], limited_lines(lines[-1L], n), sep = "\n")
  invisible(x)
}

measures_in_units <- function(measures, preferred) {
  from <- attr(measures, "unit")
  to <- displayed_units(from, preferred)
  names <- with_other_unit(names(measures), from, to)
  ratio <- unit_ratio(from, to)
  of <- function(name) setNames(attr(measures, name), names)
  measures_of(setNames(plain_measures(measures) * ratio, names), setNames(to, names), of("kind"),
    of("error") * ratio, of("main"), of("net"))
}

unit_ratio <- function(from, to) {
  as.double(mapply(function(from, to) if (from == to) 1 else unit_size(from) / unit_size(to),
    from, to))
}

in_preferred_units <- function(measures) measures_in_units(measures, units_option())

# Sorts the measures for short prints to the front, in the measures of a rig and in each net.
main_first <- function(measures) {
  net <- attr(measures, "net")
  measures[order(match(net, unique(net)), !names(measures) %in% printed_measures(measures))]
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
# measures of further kinds fill the rest. Each net of a rig adds at most four measures.
printed_measures <- function(measures) {
  kind <- attr(measures, "kind")
  net <- attr(measures, "net")
  main <- attr(measures, "main") | kind == "total_drag"
  position <- stats::ave(seq_along(kind), kind, net, FUN = seq_along)
  first <- position == 1
  rank <- ifelse(main & position <= 2, 1, ifelse(first & kind == "tension", 2, 4 - first))
  row <- stats::ave(rank, net, FUN = function(rank) order(order(rank)))
  names(measures)[row <= ifelse(nzchar(net), 4L, 9L)]
}

definitions_of <- function(measures) {
  measure_strings(all_kinds()[attr(measures, "kind")])
}
