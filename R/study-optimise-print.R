# Returns " +- error", or "" if the error is unknown.
spread_text <- function(error) {
  if (is.finite(error) && error > 0) paste(" +-", sensitivity_digits(signif(error, 2))) else ""
}

#' @rdname optimise_gear
#' @param x An optimum.
#' @param n Largest number of fields and of conditions to print. Default 10. `Inf` prints all.
#' @param ... Not used.
#' @export
print.codend_optimum <- function(x, n = 10, ...) {
  check_rows(n)
  objective <- x$objective
  cat("Optimum of \"", x$gear$plan$name, "\"\n", sep = "")
  cat("  ", objective$text, ": ", sensitivity_digits(objective$begun), " before, ",
    sure_digits(objective$value, objective$error),
    spread_text(objective$error), " now (",
    with_plain_numbers(sprintf("%+.1f %%", -100 * objective$saving)), ")\n", sep = "")
  fields <- printed_rows(x$fields)
  cat_rows(list(
    paste0("  ", field_labels(fields$field)), sensitivity_digits(fields$begun),
    rep("to", nrow(fields)), sensitivity_digits(fields$value), fields$unit,
    end_text(fields$at)
  ), c(1L, 3L, 5L, 6L), n, "field")
  for (k in seq_len(min(n, nrow(x$keep)))) {
    keep <- x$keep[k, ]
    cat_wrapped(keep$text, ": ", sure_digits(keep$left, keep$error), spread_text(keep$error),
      " and ", sensitivity_digits(keep$right),
      if (!keep$holds) ", NOT MET" else if (keep$active) {
        paste0(", at its limit", if (!keep$sure) " within its error", "; ",
          sensitivity_digits(keep$price), " % of the objective per % of the limit")
      } else if (!keep$sure) ", within twice its error of the limit")
  }
  cat_more(c(condition = nrow(x$keep) - n))
  cat("  ", if (x$optimal) "a local optimum" else "not optimal", ": ",
    if (!all(x$keep$holds)) "not all conditions are met, and ", "first-order optimality ",
    if (x$optimality < 1e-5) "below 0.001" else sensitivity_digits(100 * x$optimality),
    " % of the objective per range of a field",
    if (!x$smooth) "; kinks nearby, see `kinks`", "\n", sep = "")
  cat("  ", x$n_solves, " gears settled, the last with ", mesh_size_text(x$nodes, x$accuracy), "\n",
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
