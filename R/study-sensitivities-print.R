# Slopes as text.

#' @export
print.codend_sensitivities <- function(x, ...) {
  shown <- intersect(c("measure", "field", "slope", "slope_unit", "elasticity", "smooth"), names(x))
  # a part of the table that lost columns is a table
  if (length(shown) < 6L) {
    print(as.data.frame(unclass(x)), ...)
    return(invisible(x))
  }
  cat("Sensitivities of ", length(unique(x$measure)), " measures to ", length(unique(x$field)),
    " fields",
    if (!is.null(attr(x, "gear_name"))) paste0(" of \"", attr(x, "gear_name"), "\""), "\n",
    sep = "")
  for (field in unique(x$field)) {
    rows <- x[x$field == field & is.finite(x$slope) & x$slope != 0, ]
    if (!nrow(rows)) next
    value <- with_plain_numbers(format(signif(rows$value[1L], 6)))
    cat("\n", field, " (", trimws(paste(value, rows$unit[1L])), ")\n", sep = "")
    rows <- rows[order(-abs(rows$elasticity)), ]
    cat_columns(list(
      rows$measure, slope_figures(rows$slope), rows$slope_unit,
      ifelse(is.na(rows$elasticity), "", sprintf("%+.3f %% per %%", rows$elasticity)),
      ifelse(rows$smooth, "", kink_text(rows))
    ), left = c(1L, 3L, 5L))
  }
  idle <- idle_fields(x)
  if (length(idle)) {
    cat("\n", paste(strwrap(paste("These fields change none of the measures:",
      paste(idle, collapse = ", ")), width = 98), collapse = "\n"), "\n", sep = "")
  }
  invisible(x)
}

# A slope of this elasticity is rounding.
least_effect <- 1e-9

# The fields by which no measure changes.
idle_fields <- function(x) {
  changes <- is.finite(x$slope) & x$slope != 0 &
    (is.na(x$elasticity) | abs(x$elasticity) > least_effect)
  setdiff(unique(x$field), x$field[changes])
}

# Slopes to four figures, small ones in powers of ten.
slope_figures <- function(x) {
  with_plain_numbers(vapply(x, function(one) format(signif(one, 4)), ""))
}

kink_text <- function(rows) {
  known <- !is.na(rows$secant_below) & !is.na(rows$secant_above)
  ifelse(known, sprintf("not smooth: %s below, %s above", slope_figures(rows$secant_below),
    slope_figures(rows$secant_above)), "not smooth")
}
