# Optima as text.

# An error beside a number; nothing where none is known.
spread_text <- function(error) {
  if (is.finite(error) && error > 0) paste(" +-", slope_figures(signif(error, 2))) else ""
}

#' @export
print.codend_optimum <- function(x, ...) {
  aim <- x$aim
  cat("Optimum of \"", x$gear$plan$name, "\"\n", sep = "")
  cat("  ", aim$text, ": ", slope_figures(aim$begun), " before, ", slope_figures(aim$value),
    spread_text(aim$error), " now (",
    with_plain_numbers(sprintf("%+.1f %%", -100 * aim$saving)), ")\n", sep = "")
  fields <- x$fields
  cat_columns(list(
    paste0("  ", fields$field), slope_figures(fields$begun), rep("to", nrow(fields)),
    slope_figures(fields$value), fields$unit,
    ifelse(fields$at == "", "", paste("at the", fields$at, "end of its range"))
  ), left = c(1L, 3L, 5L, 6L))
  for (k in seq_len(nrow(x$keep))) {
    keep <- x$keep[k, ]
    cat("  ", keep$text, ": ", slope_figures(keep$left), spread_text(keep$error), " and ",
      slope_figures(keep$right),
      if (!keep$holds) ", NOT KEPT" else if (keep$active) {
        paste0(", at its limit", if (!keep$sure) " within its error", "; ",
          slope_figures(keep$price), " % of the objective per % of it")
      } else if (!keep$sure) ", within twice its error of the limit", "\n", sep = "")
  }
  cat("  ", if (x$optimal) "a local optimum" else "not optimal", ": ",
    if (!all(x$keep$holds)) "not all conditions are kept, and ", "first-order optimality ",
    slope_figures(100 * x$optimality), " % of the objective per range of a field",
    if (!x$smooth) "; kinks near, see `kinks`", "\n", sep = "")
  cat("  ", x$settles, " gears settled, the last with ", lattice_words(x$nodes, x$accuracy), "\n",
    sep = "")
  invisible(x)
}

#' @export
summary.codend_optimum <- function(object, ...) {
  structure(list(optimum = object, state = summary(object$state)), class = "codend_optimum_summary")
}

#' @export
print.codend_optimum_summary <- function(x, ...) {
  print(x$optimum)
  starts <- x$optimum$starts
  if (nrow(starts) > 1L) {
    cat("\nStarts\n")
    print(starts, row.names = FALSE)
  }
  if (nrow(x$optimum$kinks)) {
    cat("\nNot smooth at the optimum\n")
    print(x$optimum$kinks, row.names = FALSE)
  }
  cat("\n")
  print(x$state)
  invisible(x)
}
