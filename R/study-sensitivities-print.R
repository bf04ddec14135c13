#' @export
print.codend_sensitivities <- function(x, ...) {
  shown <- intersect(c("measure", "field", "derivative", "derivative_unit", "elasticity", "smooth"),
    names(x))
  # A subset of the columns prints as a plain data frame.
  if (length(shown) < 6L) {
    print(as.data.frame(unclass(x)), ...)
    return(invisible(x))
  }
  cat("Sensitivities of ", length(unique(x$measure)), " measures to ", length(unique(x$field)),
    " fields",
    if (!is.null(attr(x, "gear_name"))) paste0(" of \"", attr(x, "gear_name"), "\""), "\n",
    sep = "")
  for (field in unique(x$field)) {
    rows <- x[x$field == field & is.finite(x$derivative) & x$derivative != 0, ]
    if (!nrow(rows)) next
    value <- with_plain_numbers(format(signif(rows$value[1L], 6)))
    cat("\n", field, " (", trimws(paste(value, rows$unit[1L])), ")\n", sep = "")
    rows <- rows[order(-abs(rows$elasticity)), ]
    cat_columns(list(
      rows$measure, sensitivity_digits(rows$derivative), rows$derivative_unit,
      ifelse(is.na(rows$elasticity), "", sprintf("%+.3f %% per %%", rows$elasticity)),
      ifelse(rows$smooth, "", kink_text(rows))
    ), left = c(1L, 3L, 5L))
  }
  idle <- idle_fields(x)
  if (length(idle)) {
    cat("\n", paste(strwrap(paste("Fields without effect on the measures:",
      paste(idle, collapse = ", ")), width = 98), collapse = "\n"), "\n", sep = "")
  }
  invisible(x)
}

# Elasticities up to this value are rounding errors.
least_effect <- 1e-9

# Returns the fields that change no measure.
idle_fields <- function(x) {
  changes <- is.finite(x$derivative) & x$derivative != 0 &
    (is.na(x$elasticity) | abs(x$elasticity) > least_effect)
  setdiff(unique(x$field), x$field[changes])
}

# Formats numbers with four digits.
sensitivity_digits <- function(x) {
  with_plain_numbers(vapply(x, function(one) format(signif(one, 4)), ""))
}

kink_text <- function(rows) {
  known <- !is.na(rows$secant_below) & !is.na(rows$secant_above)
  ifelse(known, sprintf("not smooth: %s below, %s above", sensitivity_digits(rows$secant_below),
    sensitivity_digits(rows$secant_above)), "not smooth")
}
