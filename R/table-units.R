#' Convert results to other units
#'
#' Converts values, errors and names of results to the units of your choice.
#'
#' All values of a quantity are converted, except values in mm and N: mesh openings and tensions of
#' twines keep their unit. `options(codend.units = c(speed = "knot", force = "tonnef"))` sets units
#' for printed results. It does not change stored values and names.
#'
#' @param x Measures ([measures()]), variations ([vary()]), effects, sensitivities, uncertainty, or
#'   a table of a state or a trajectory ([as.data.frame()][as.data.frame.codend_state]). For a state
#'   or a trajectory, the function converts the measures. For a calibration, posterior, optimum or
#'   found value, it converts the table of fields ([tidy()][codend_tidy]).
#' @param ... Units by quantity, such as `speed = "knot"`. Quantities: `length`, `area`, `volume`,
#'   `mass`, `force`, `speed`, `power`, `angle`, `time` and other quantities of plans. Units: those
#'   that plans accept.
#' @return The same kind of object with converted values and errors. Suffixes of names follow:
#'   `total_drag_kN` becomes `total_drag_tonnef`. Unknown quantities and units are an error of class
#'   `codend_error_argument`.
#' @seealso [measures()], [vary()], [as.data.frame()][as.data.frame.codend_state].
#' @export
#' @examples
#' state <- settle("midwater_trawl", nodes = 300)
#' in_units(measures(state), length = "fathom", force = "tonnef")
#' head(in_units(as.data.frame(state, what = "nodes"), length = "ft"))
in_units <- function(x, ...) {
  check_given("x")
  UseMethod("in_units")
}

#' @export
in_units.default <- function(x, ...) {
  abort_argument("{.arg x} must be measures, a state, a trajectory, a result of a study, or a table,
    not {.cls {class(x)}}.")
}

#' @export
in_units.codend_measures <- function(x, ...) measures_in_units(x, check_units(list(...), "..."))

#' @export
in_units.data.frame <- function(x, ...) table_in_units(x, check_units(list(...), "..."))

#' @export
in_units.codend_state <- function(x, ...) in_units(measures(x), ...)

#' @export
in_units.codend_trajectory <- function(x, ...) in_units(as.data.frame(x, what = "measures"), ...)

# Returns a result in the units of options(codend.units), for prints.
in_printed_units <- function(x) {
  preferred <- units_option()
  if (length(preferred)) do.call(in_units, c(list(x), preferred)) else x
}

# Columns of long tables in the unit of their row.
columns_in_unit <- c(
  "value", "error", "time_error", "mesh_error", "mean_error", "least_error", "greatest_error",
  "lower", "upper", "begun", "start", "end", "least", "median", "largest",
  "greatest", "target", "mean", "sd", "q5", "q50", "q95", "spread", "contribution", "remaining_sd"
)

# Columns of long tables with names that may end in a unit.
columns_of_names <- c("measure", "measurement", "field", "other")

# Converts rows by their column `unit`, columns by the suffix of their name, and attributes.
table_in_units <- function(table, preferred) {
  if (!length(preferred)) return(table)
  from <- units_of_names(names(table))
  from[!vapply(table, is.numeric, NA)] <- ""
  table <- columns_in_units(table, from, displayed_units(from, preferred))
  for (name in intersect(c("fields", "main"), names(attributes(table)))) {
    attr(table, name) <- names_in_units(attr(table, name), preferred)
  }
  for (name in intersect(c("unit", "measure_unit"), names(attributes(table)))) {
    unit <- attr(table, name)
    attr(table, name) <- setNames(displayed_units(unit, preferred),
      names_in_units(names(unit), preferred))
  }
  if ("unit" %in% names(table)) rows_in_units(table, preferred) else table
}

# `from`: unit of the values of each row.
rows_in_units <- function(table, preferred, from = table$unit) {
  to <- displayed_units(from, preferred)
  ratio <- unit_ratio(from, to)
  if ("unit" %in% names(table)) table$unit <- to
  for (name in intersect(c(columns_in_unit, names(group_words)), names(table))) {
    if (is.numeric(table[[name]])) table[[name]] <- table[[name]] * ratio
  }
  for (name in intersect(columns_of_names, names(table))) {
    table[[name]] <- names_in_units(table[[name]], preferred)
  }
  table
}

# Converts the suffixes of names.
names_in_units <- function(names, preferred) {
  from <- units_of_names(names)
  with_other_unit(names, from, displayed_units(from, preferred))
}

columns_in_units <- function(table, from, to) {
  old <- names(table)
  ratio <- unit_ratio(from, to)
  for (k in which(from != to)) table[[k]] <- table[[k]] * ratio[k]
  names(table) <- with_other_unit(old, from, to)
  if (is.data.frame(attr(table, "errors"))) {
    errors <- attr(table, "errors")
    k <- match(names(errors), old)
    attr(table, "errors") <- columns_in_units(errors, from[k], to[k])
  }
  table
}
