# Prints of variations, effects and tables with many measures: main measures first, with the digits
# that are certain.

printed_columns <- function(x, n) {
  known <- unique(x$measure)
  if (is.infinite(n)) known else some_measures(x, known)
}

# Prints a long table with a column per measure.
#
#   `key`: string for each row of `x`; equal keys are one printed row.
#   `fixed`: function(rows) that returns the left columns for rows of `x`.
#   `cells`: function(rows) that returns strings for rows of `x` with the same measure.
#   `kind`: name of a printed row, for the line about the rest.
cat_by_measure <- function(x, key, fixed, cells, n, kind, units = TRUE) {
  check_rows(n)
  known <- unique(x$measure)
  printed <- utils::head(unique(key), n)
  columns <- lapply(printed_columns(x, n), function(name) {
    rows <- which(x$measure == name)
    unit <- first_of(attr(x, "measure_unit"), attr(x, "unit"))[[name]]
    text <- cells(rows[match(printed, key[rows])])
    headed(label_of(name, unit), if (units) unit, ifelse(is.na(text), "", text))
  })
  left <- fixed(match(printed, key))
  done <- cat_headed(c(left, columns), length(left), is.infinite(n))
  more <- c(length(unique(key)) - length(printed), length(known) - done)
  cat_more(setNames(more, c(kind, "measure")))
}

# ---- variations ----------------------------------------------------------------------------------

#' @rdname vary
#' @param x Variations.
#' @param n Number of rows to print. Default 20. `Inf` prints all rows and all measures.
#' @export
print.codend_variations <- function(x, n = most_rows, ...) {
  check_rows(n)
  given <- x
  x <- in_printed_units(x)
  everything <- is.infinite(n)
  known <- variations_measures(x)
  fields <- variations_fields(x)
  rows <- seq_len(min(n, nrow(x)))
  error <- if (all(attr(x, "fields") %in% fields)) errors_by_design(x)
  column <- function(name) {
    value <- x[[name]][rows]
    unit <- variations_unit(x, name)
    cells <- if (name %in% fields || !is.numeric(value)) group_labels(value) else {
      certain_figures(value, error[[name]][rows])
    }
    headed(label_of(name, unit), unit, cells)
  }
  cat(nrow(x), if (nrow(x) == 1L) " design" else " designs", " of \"", attr(x, "gear_name"), "\"\n",
    sep = "")
  left <- lapply(fields, column)
  # Fields beyond half of the width are left out, or follow on the right.
  fixed <- sum(cumsum(printed_widths(left)) <= getOption("width") / 2)
  right <- lapply(if (everything) known else some_measures(x, known), column)
  if (everything) right <- c(left[-seq_len(fixed)], right)
  done <- cat_headed(c(left[seq_len(fixed)], right), fixed, everything)
  if (!everything) {
    cat_more(c(design = nrow(x) - length(rows), field = length(fields) - fixed,
      measure = length(known) - done))
  }
  warned <- sum(!is.na(x$warning))
  if (warned) cat("  With a warning, see `warning`: ", warned, "\n", sep = "")
  cat_counted_problems(counted_problems(x$problem), 2L)
  invisible(given)
}

# Returns data frame(problem, designs): the most frequent problems first.
counted_problems <- function(problem) {
  counts <- sort(table(problem), decreasing = TRUE)
  data.frame(problem = as.character(names(counts)), designs = as.integer(counts))
}

cat_counted_problems <- function(problems, n = 5L) {
  if (!nrow(problems)) return(invisible())
  cat("  Not settled:\n")
  for (k in seq_len(min(n, nrow(problems)))) {
    cat_wrapped(problems$designs[k], "  ", problems$problem[k], indent = 4L, most = 2L)
  }
  cat_more(c(problem = nrow(problems) - n), "see `problem`")
}

# ---- effects -------------------------------------------------------------------------------------

#' @rdname effects.codend_variations
#' @param x Effects.
#' @param n Number of rows to print. Default 20. `Inf` prints all rows and all measures.
#' @export
print.codend_effects <- function(x, n = most_rows, ...) {
  given <- x
  x <- in_printed_units(x)
  cat_wrapped("Effects of fields of \"", attr(x, "gear_name"),
    "\": means over the designs with a value of the field", indent = 0L)
  x <- x[order(-largest_by(x$field, x$spread / pmax(abs(x$value), 1e-300))), ]
  cat_by_measure(x, paste(x$field, x$level, sep = "\r"), function(rows) {
    list(
      headed("field", "", field_titles(x, x$field[rows])),
      headed("value", "", group_labels(as.character(x$level[rows]))),
      headed("designs", "", format(x$designs[rows]))
    )
  }, function(rows) certain_figures(x$value[rows]), n, "value")
  invisible(given)
}

#' @export
print.codend_pair_effects <- function(x, n = most_rows, ...) {
  given <- x
  x <- in_printed_units(x)
  cat_wrapped("Effects of pairs of fields of \"", attr(x, "gear_name"),
    "\" beyond the effects of each field (root mean square)", indent = 0L)
  key <- paste(x$field, x$other, sep = "\r")
  x <- x[order(-largest_by(key, x$spread / stats::ave(x$spread, x$measure, FUN = max))), ]
  cat_by_measure(x, paste(x$field, x$other, sep = "\r"), function(rows) {
    list(
      headed("field", "", field_titles(x, x$field[rows])),
      headed("with", "", field_titles(x, x$other[rows]))
    )
  }, function(rows) certain_figures(x$spread[rows]), n, "pair")
  invisible(given)
}

#' @export
print.codend_sobol_indices <- function(x, n = most_rows, ...) {
  cat_wrapped("Sobol' indices of \"", attr(x, "gear_name"),
    "\": fraction of the variance with its ", format(100 * attr(x, "confidence")), " % interval",
    indent = 0L)
  x <- x[order(-largest_by(x$field, x$value)), ]
  cat_by_measure(x, paste(x$field, x$index, sep = "\r"), function(rows) {
    list(headed("field", NULL, x$field[rows]), headed("index", NULL, x$index[rows]))
  }, function(rows) {
    # adding 0 removes the sign of -0
    two <- function(value) sprintf("%.2f", round(value, 2) + 0)
    sprintf("%s (%s to %s)", two(x$value[rows]), two(x$lower[rows]), two(x$upper[rows]))
  }, n, "index", units = FALSE)
  invisible(x)
}

field_titles <- function(x, fields) {
  vapply(fields, function(field) field_words(x, field), "", USE.NAMES = FALSE)
}

# Returns the largest value of each group, by row.
largest_by <- function(group, value) {
  stats::ave(value, group, FUN = function(some) max(some, na.rm = TRUE))
}
