# Results of studies in other units.

#' @export
in_units.codend_sensitivities <- function(x, ...) {
  preferred <- check_units(list(...), "...")
  from <- attr(x, "measure_unit")[x$measure]
  found <- table_in_units(x, preferred)
  to <- attr(found, "measure_unit")[found$measure]
  ratio <- unit_ratio(from, to) / unit_ratio(x$unit, found$unit)
  changed <- c("derivative", "secant_below", "secant_above")
  found[changed] <- lapply(x[changed], `*`, ratio)
  found$derivative_unit <- derivative_units(to, found$unit)
  found
}

derivative_units <- function(of, by) unname(paste(of, "per", ifelse(nzchar(by), by, "1")))

#' @export
in_units.codend_effects <- function(x, ...) {
  preferred <- check_units(list(...), "...")
  x$level <- levels_in_units(x$level, x$field, preferred)
  table_in_units(x, preferred)
}

#' @export
in_units.codend_pair_effects <- function(x, ...) {
  preferred <- check_units(list(...), "...")
  means <- attr(x, "means")
  means$value <- levels_in_units(means$value, means$field, preferred)
  means$other_value <- levels_in_units(means$other_value, means$other, preferred)
  attr(x, "means") <- rows_in_units(means, preferred, units_of_names(means$measure))
  table_in_units(x, preferred)
}

# Converts the values of fields, which are text if one of the fields has text.
levels_in_units <- function(levels, fields, preferred) {
  from <- units_of_names(fields)
  to <- displayed_units(from, preferred)
  changed <- from != to
  levels[changed] <- as.double(levels[changed]) * unit_ratio(from, to)[changed]
  levels
}

#' @export
in_units.codend_uncertainty <- function(x, ...) {
  preferred <- check_units(list(...), "...")
  for (name in c("measures", "sources", "next_measurement")) {
    x[[name]] <- rows_in_units(x[[name]], preferred, units_of_names(x[[name]]$measure))
  }
  x$main <- names_in_units(x$main, preferred)
  x
}

# Returns the table of fields.
#' @export
#' @rawNamespace
#' S3method(in_units,codend_found,in_units.codend_calibration)
#' S3method(in_units,codend_optimum,in_units.codend_calibration)
#' S3method(in_units,codend_posterior,in_units.codend_calibration)
in_units.codend_calibration <- function(x, ...) in_units(as.data.frame(x), ...)

#' @export
in_units.codend_trade_off <- function(x, ...) in_units(as.data.frame(x, wide = TRUE), ...)

# Returns a table of fields or targets in the units of prints.
printed_rows <- function(table) rows_in_units(table, units_option())
