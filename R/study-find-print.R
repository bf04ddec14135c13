# `n`: largest numbers of printed fields and of targets.
#' @export
print.codend_found <- function(x, n = 5, ...) {
  check_rows(n)
  given <- x
  x[c("fields", "targets")] <- lapply(x[c("fields", "targets")], printed_rows)
  cat(if (all(x$targets$reached)) "Found" else "Nearest", " for \"", x$gear$plan$name, "\"\n",
    sep = "")
  fields <- utils::head(x$fields, n)
  targets <- utils::head(x$targets, n)
  cat_columns(list(
    c(fields$field, targets$measure),
    c(sensitivity_digits(fields$value), sensitivity_digits(targets$value)),
    c(fields$unit, targets$unit),
    c(paste("before", sensitivity_digits(fields$start)),
      paste("target", sensitivity_digits(targets$target))),
    c(end_text(fields$at), ifelse(targets$reached, "reached", "not reached"))
  ), left = c(1L, 3L, 4L, 5L))
  cat_more(c(field = nrow(x$fields) - nrow(fields), target = nrow(x$targets) - nrow(targets)))
  if (!all(x$targets$reached)) cat(strwrap(not_reached_text(x), 78, 2, 2), sep = "\n")
  cat("  ", x$n_solves, " gears settled with ",
    mesh_size_text(x$state$mesh$nodes, main_error(measures(x$state))), "\n", sep = "")
  invisible(given)
}

# Returns sentences about missed targets and the limits of the search.
not_reached_text <- function(x) {
  if (nrow(x$targets) > nrow(x$fields)) {
    return(paste(nrow(x$targets), "targets need as many fields. The result is the compromise with",
      "the smallest squared relative differences."))
  }
  missed <- x$targets[!x$targets$reached, ]
  ended <- x$fields[x$fields$at != "", ]
  with_unit <- function(value) trimws(paste(sensitivity_digits(value), missed$unit))
  paste0(
    paste0("The target ", missed$measure, " = ", with_unit(missed$target),
      " is out of reach. The nearest value found is ", with_unit(missed$value), ".",
      collapse = " "),
    if (nrow(ended)) paste0(" ", paste(ended$field, "is", end_text(ended$at), collapse = ", "), ".")
  )
}
