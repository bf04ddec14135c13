# Smallest part of the variance that a line lists, %.
least_displayed_percent <- 10

# Returns a line per measure: "5.51 m, 90 %: 4.5 to 6.6 (plan 60 %, coefficients 30 %)".
#' @export
format.codend_uncertainty <- function(x, ...) {
  with_plain_numbers({
    table <- x$measures
    shown <- function(end) interval_ends(end, table$uncertainty)
    percent <- group_percent(table)
    parts <- vapply(seq_len(nrow(table)), function(m) {
      most <- sort(percent[m, percent[m, ] >= least_displayed_percent], decreasing = TRUE)
      paste0(group_words[names(most)], " ", round(most), " %", recycle0 = TRUE, collapse = ", ")
    }, "")
    align_columns(list(
      paste0("  ", label_of(table$measure, table$unit)), figures(table$value), table$unit,
      sprintf("%g %%:", 100 * x$level), shown(table$low), "to", shown(table$high),
      ifelse(nzchar(parts), paste0("(", parts, ")"), ""), ifelse(table$smooth, "", "not smooth")
    ), left = c(1L, 3L, 6L, 8L, 9L))
  })
}

#' @rawNamespace S3method(base::"$",codend_uncertainty)
`$.codend_uncertainty` <- result_element

#' @export
print.codend_uncertainty <- function(x, measures = NULL, ...) {
  main <- main_rows(x, measures)
  cat("Uncertainty of \"", x$gear_name, "\", ", x$conditions, "\n", sep = "")
  cat("  The interval contains the true value with a probability of ", format(100 * x$level), " %",
    if (x$method == "samples") paste0(" (", x$cost$n_solves, " samples)"),
    ".\n  Brackets: main sources of the uncertainty in % of the variance.\n", sep = "")
  cat(format(x), sep = "\n")
  for (name in main) {
    cat("\n", name, ": the largest sources with their uncertainty and their effect\n",
      sep = "")
    cat(source_lines(x, name), sep = "\n")
    cat(next_measurement_lines(x, name), sep = "\n")
  }
  if (any(!x$measures$smooth) && x$method == "linear") {
    cat("\nSome measures are not smooth; use method = \"samples\" for their intervals.\n")
  }
  invisible(x)
}

# Returns the measures with a list of sources: the requested ones, or the first height, spread and
# force.
main_rows <- function(x, measures) {
  if (!is.null(measures)) return(intersect(x$measures$measure, measures))
  names <- x$measures$measure
  pick <- function(pattern) grep(pattern, names, value = TRUE)[1L]
  found <- c(pick("mouth_height|headline_height|depth_m"), pick("spread_m"), pick("total_drag"))
  unique(found[!is.na(found)])
}

source_lines <- function(x, name) {
  unit <- x$measures$unit[x$measures$measure == name]
  rows <- utils::head(x$sources[x$sources$measure == name, ], 10L)
  if (!nrow(rows)) return(character())
  with_plain_numbers(align_columns(list(
    paste0("  ", rows$source), sprintf("%.2g %%", 100 * rows$share), group_words[rows$group],
    sprintf("%+.2g %s", rows$contribution, unit), sprintf("%.0f %% of the variance", rows$percent)
  ), left = c(1L, 3L)))
}

next_measurement_lines <- function(x, name) {
  row <- x$next_measurement[x$next_measurement$measure == name, ]
  if (!nrow(row)) return(character())
  now <- x$measures$uncertainty[x$measures$measure == name]
  unit <- x$measures$unit[x$measures$measure == name]
  as_measure <- match(row$measurement, x$measures$measure)
  by <- ifelse(is.na(as_measure), row$measurement, label_of(row$measurement,
    x$measures$unit[as_measure]))
  others <- sprintf("%s (%.2g %s)", by[-1L], row$remaining_sd[-1L], unit)
  with_plain_numbers(c(
    sprintf("  best next measurement: %s; the standard uncertainty falls from %.2g to %.2g %s",
      by[1L], now, row$remaining_sd[1L], unit),
    if (length(others)) paste0("  next: ", paste(others, collapse = ", "))
  ))
}
