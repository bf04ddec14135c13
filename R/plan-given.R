# Returns a value, or all values of a list or data frame, without a class. Numbers, strings and
# logicals remain unchanged. Objects of the package units become strings in SI. Other classes are an
# error. `name`: argument or path in this error.
given_value <- function(value, name) {
  if (is.data.frame(value) || (is.list(value) && !is.object(value))) {
    inner <- names(value)
    if (is.null(inner)) inner <- seq_along(value)
    for (k in seq_along(value)) {
      if (is.object(value[[k]]) || is.list(value[[k]])) {
        value[[k]] <- given_value(value[[k]], paste0(name, "$", inner[k]))
      }
    }
    return(value)
  }
  if (!is.object(value) || !is.atomic(value)) return(value)
  if (inherits(value, "units")) return(stats::setNames(units_text(value), names(value)))
  if (is.factor(value) || is.character(value)) return(as.character(value))
  abort_argument("{.arg {name}} has the class {.cls {class(value)}}; it must be a number, a string
    with a unit or an object of the package {.pkg units}.")
}

# Returns a given value in SI: one number, or NA if it is not a quantity of this dimension.
given_si <- function(value, dimension, name) {
  value <- given_value(value, name)
  one <- length(value) == 1L && (is_text(value) || is.numeric(value))
  if (one) quantity_si(value, dimension) else NA_real_
}

# Returns a table with its units objects converted to SI. `dimensions`: named by column.
si_columns <- function(table, dimensions, name) {
  for (column in intersect(names(dimensions), names(table))) {
    values <- table[[column]]
    if (!inherits(values, "units")) next
    path <- paste0(name, "$", column)
    dimension <- dimensions[[column]]
    si <- vapply(given_value(values, path), given_si, 0, dimension, path, USE.NAMES = FALSE)
    odd <- which(is.na(si) & !is.na(values))
    if (length(odd)) {
      said <- given_value(values[odd[1L]], path)
      abort_argument("{.arg {path}} is {said}; it must be {noun(dimension)}.")
    }
    table[[column]] <- si
  }
  table
}

# Returns units objects as strings in the SI unit of their dimension, or as numbers if they have no
# unit. Units unknown to plans keep the brackets of the package, which plans reject.
units_text <- function(value) {
  check_package("units", "An object of class units")
  unit <- as.character(units(value))
  if (unit == "1") return(as.double(value))
  # The udunits library converts percent to radians.
  si <- vapply(plan_units, function(of) names(of)[1L], "")
  si <- si[setdiff(names(si), if (unit %in% names(plan_units$angle)) "number" else "angle")]
  si <- Filter(function(one) units::ud_are_convertible(unit, one), si)
  shown <- rep(NA_character_, length(value))
  given <- which(!is.na(value))
  shown[given] <- if (length(si)) {
    number <- as.double(units::set_units(value[given], si[[1L]], mode = "standard"))
    paste(vapply(number, shortest_decimal, ""), si[[1L]])
  } else {
    trimws(format(value[given]))
  }
  shown
}
