# Uncertainties in words: the measure, the interval, and where it comes from.

# The least part of a variance that lines name, %.
least_shown_percent <- 10

# "5.51 m, 90 %: 4.5 to 6.6 (plan 60 %, coefficients 30 %)": of every measure a line.
#' @export
format.codend_uncertainty <- function(x, ...) {
  with_plain_numbers({
    table <- x$measures
    shown <- function(end) interval_ends(end, table$uncertainty)
    percent <- group_percent(table)
    parts <- vapply(seq_len(nrow(table)), function(m) {
      most <- sort(percent[m, percent[m, ] >= least_shown_percent], decreasing = TRUE)
      paste0(group_words[names(most)], " ", round(most), " %", recycle0 = TRUE, collapse = ", ")
    }, "")
    align_columns(list(
      paste0("  ", words_of(table$measure, table$unit)), figures(table$value), table$unit,
      sprintf("%g %%:", 100 * x$level), shown(table$low), "to", shown(table$high),
      ifelse(nzchar(parts), paste0("(", parts, ")"), ""), ifelse(table$smooth, "", "not smooth")
    ), left = c(1L, 3L, 6L, 8L, 9L))
  })
}

#' @export
print.codend_uncertainty <- function(x, measures = NULL, ...) {
  main <- main_rows(x, measures)
  cat("Uncertainty of \"", x$gear_name, "\", ", x$conditions, "\n", sep = "")
  cat("  The truth lies in the interval with a probability of ", format(100 * x$level), " %",
    if (x$method == "samples") paste0(" (", x$cost$settles, " samples)"),
    "; in brackets where most of the\n  uncertainty comes from, in % of its variance.\n", sep = "")
  cat(format(x), sep = "\n")
  for (name in main) {
    cat("\n", name, ": the largest sources, how far each may be off, and what that changes\n",
      sep = "")
    cat(source_lines(x, name), sep = "\n")
    cat(narrow_lines(x, name), sep = "\n")
  }
  if (any(!x$measures$smooth) && x$method == "linear") {
    cat("\nMeasures that are not smooth follow no straight line: use method = \"samples\".\n")
  }
  invisible(x)
}

# Measures whose sources are listed: those asked for, or the first height, spread and force.
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

narrow_lines <- function(x, name) {
  row <- x$narrow[x$narrow$measure == name, ]
  if (!nrow(row)) return(character())
  now <- x$measures$uncertainty[x$measures$measure == name]
  unit <- x$measures$unit[x$measures$measure == name]
  as_measure <- match(row$by, x$measures$measure)
  by <- ifelse(is.na(as_measure), row$by, words_of(row$by, x$measures$unit[as_measure]))
  others <- sprintf("%s (%.2g %s)", by[-1L], row$left[-1L], unit)
  with_plain_numbers(c(
    sprintf("  to narrow it most, measure %s: its standard uncertainty falls from %.2g to %.2g %s",
      by[1L], now, row$left[1L], unit),
    if (length(others)) paste0("  next: ", paste(others, collapse = ", "))
  ))
}

#' @export
as.data.frame.codend_uncertainty <- function(x, ...) x$measures
