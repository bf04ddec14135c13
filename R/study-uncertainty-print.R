# Smallest part of the variance that a line lists, %.
least_displayed_percent <- 10

# Returns a line per measure: "5.51 m, 90 %: 4.5 to 6.6 (plan 60 %, coefficients 30 %)".
#' @export
format.codend_uncertainty <- function(x, ...) {
  x <- in_printed_units(x)
  table <- x$measures
  parts <- main_sources(table)
  align_columns(list(
    paste0("  ", label_of(table$measure, table$unit)), figures(table$value), table$unit,
    sprintf("%g %%:", 100 * x$level), interval_ends(table$lower, table$error), "to",
    interval_ends(table$upper, table$error), ifelse(nzchar(parts), paste0("(", parts, ")"), ""),
    ifelse(table$smooth, "", "not smooth")
  ), left = c(1L, 3L, 6L, 8L, 9L))
}

# Returns the two largest groups of sources of each measure: "plan 60 %, coefficients 30 %".
main_sources <- function(table) {
  percent <- group_percent(table_rows(table))
  vapply(seq_len(nrow(table)), function(m) {
    most <- sort(percent[m, percent[m, ] >= least_displayed_percent], decreasing = TRUE)
    most <- utils::head(most, 2L)
    paste0(group_words[names(most)], " ", round(most), " %", recycle0 = TRUE, collapse = ", ")
  }, "")
}

#' @rdname uncertainty
#' @param x Uncertainties.
#' @param measures Names of measures to print with their sources. `NULL` (default) prints a list of
#'   the main measures and the sources of three of them.
#' @param n Number of measures and of sources to print. `NULL` (default) keeps the print within 30
#'   lines. `Inf` prints everything.
#' @param ... Not used.
#' @export
print.codend_uncertainty <- function(x, measures = NULL, n = NULL, ...) {
  if (!is.null(n)) check_rows(n)
  given <- x
  x <- in_printed_units(x)
  if (!is.null(measures)) measures <- names_in_units(measures, units_option())
  known <- x$measures$measure
  main <- some_measures(structure(list(), main = x$main), known)
  listed <- union(measures, if (is.null(n)) main else utils::head(known, n))
  cat("Uncertainty of \"", x$gear_name, "\", ", x$conditions, "\n", sep = "")
  table <- x$measures[match(listed, known), ]
  ends <- paste(interval_ends(table$lower, table$error), "to",
    interval_ends(table$upper, table$error))
  cat_columns(list(
    c("", label_of(table$measure, table$unit)), c("", figures(table$value)), c("", table$unit),
    c(sprintf("%g %% interval", 100 * x$level), ends),
    c("main sources, % of variance", main_sources(table))
  ), c(1L, 3L, 5L))
  cat_more(c(measure = length(known) - length(listed)))
  for (name in main_rows(x, measures)) {
    cat(name, ": sources with their uncertainty, effect and % of the variance\n", sep = "")
    cat(source_lines(x, name, first_of(n, 3L)), sep = "\n")
    cat(next_measurement_lines(x, name), sep = "\n")
  }
  if (any(!x$measures$smooth) && x$method == "linear") {
    cat("Some measures are not smooth; use method = \"samples\" for their intervals.\n")
  }
  invisible(given)
}

# Returns the measures with a list of sources: the requested ones, or the first height, spread and
# force.
main_rows <- function(x, measures) {
  if (!is.null(measures)) return(intersect(x$measures$measure, measures))
  names <- x$measures$measure
  pick <- function(pattern) grep(pattern, names, value = TRUE)[1L]
  found <- c(pick("mouth_height|headline_height|depth_"), pick("spread_"), pick("total_drag"))
  unique(found[!is.na(found)])
}

source_lines <- function(x, name, n = 10L) {
  unit <- x$measures$unit[x$measures$measure == name]
  rows <- utils::head(x$sources[x$sources$measure == name, ], n)
  if (!nrow(rows)) return(character())
  source <- ifelse(nchar(rows$source) > 40L, paste(substring(rows$source, 1L, 36L), "..."),
    rows$source)
  with_plain_numbers(align_columns(list(
    source, sprintf("%.2g %%", 100 * rows$share), group_words[rows$group],
    sprintf("%+.2g %s", rows$contribution, unit), sprintf("%.0f %%", rows$percent)
  ), left = c(1L, 3L)))
}

next_measurement_lines <- function(x, name) {
  row <- x$next_measurement[x$next_measurement$measure == name, ]
  if (!nrow(row)) return(character())
  now <- x$measures$error[x$measures$measure == name]
  unit <- x$measures$unit[x$measures$measure == name]
  as_measure <- match(row$measurement, x$measures$measure)
  by <- ifelse(is.na(as_measure), row$measurement, label_of(row$measurement,
    x$measures$unit[as_measure]))
  with_plain_numbers(
    sprintf("  best next measurement: %s; standard uncertainty %.2g, then %.2g %s", by[1L], now,
      row$remaining_sd[1L], unit)
  )
}
