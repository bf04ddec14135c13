#' Convert results to other units
#'
#' Converts values, errors and names of results to the units of your choice.
#'
#' All values of a quantity are converted, except values in mm and N: mesh openings and tensions of
#' twines keep their unit. `options(codend.units = c(speed = "knot", force = "tonnef"))` sets units
#' for printed results. It does not change stored values and names.
#'
#' @param x Measures ([measures()]), variations ([vary()]), or a table of a state or a trajectory
#'   ([as.data.frame()][as.data.frame.codend_state]). A state stands for its measures, a trajectory
#'   for its table of measures.
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
  abort_argument("{.arg x} must be measures, variations, or a table of a state or a trajectory, not
    {.cls {class(x)}}.")
}

#' @export
in_units.codend_measures <- function(x, ...) measures_in_units(x, check_units(list(...), "..."))

#' @export
in_units.data.frame <- function(x, ...) table_in_units(x, check_units(list(...), "..."))

#' @export
in_units.codend_state <- function(x, ...) in_units(measures(x), ...)

#' @export
in_units.codend_trajectory <- function(x, ...) in_units(as.data.frame(x, what = "measures"), ...)

# Columns of long tables in the unit of their row.
columns_in_unit <- c(
  "value", "error", "lower", "upper", "begun", "start", "end", "least", "median", "largest",
  "greatest"
)

# Converts rows by their column `unit`, and columns by the suffix of their name.
table_in_units <- function(table, preferred) {
  if (!length(preferred)) return(table)
  from <- units_of_names(names(table))
  from[!vapply(table, is.numeric, NA)] <- ""
  table <- columns_in_units(table, from, displayed_units(from, preferred))
  if ("unit" %in% names(table)) rows_in_units(table, preferred) else table
}

rows_in_units <- function(table, preferred) {
  from <- table$unit
  table$unit <- displayed_units(from, preferred)
  ratio <- unit_ratio(from, table$unit)
  for (name in intersect(columns_in_unit, names(table))) table[[name]] <- table[[name]] * ratio
  if ("measure" %in% names(table)) {
    table$measure <- with_other_unit(table$measure, from, table$unit)
  }
  table
}

# Attributes of variations that name columns follow the columns.
columns_in_units <- function(table, from, to) {
  old <- names(table)
  new <- with_other_unit(old, from, to)
  ratio <- unit_ratio(from, to)
  for (k in which(from != to)) table[[k]] <- table[[k]] * ratio[k]
  names(table) <- new
  renamed <- function(names) ifelse(names %in% old, new[match(names, old)], names)
  if (is.data.frame(attr(table, "errors"))) {
    errors <- attr(table, "errors")
    k <- match(names(errors), old)
    attr(table, "errors") <- columns_in_units(errors, from[k], to[k])
  }
  for (name in c("fields", "main")) {
    if (!is.null(attr(table, name))) attr(table, name) <- renamed(attr(table, name))
  }
  unit <- attr(table, "unit")
  if (!is.null(unit)) {
    changed <- which(from != to)
    unit[old[changed]] <- to[changed]
    attr(table, "unit") <- setNames(unit, renamed(names(unit)))
  }
  table
}
