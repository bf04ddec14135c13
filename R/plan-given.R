# The one reader of quantities: numbers in SI, text with a unit and objects of the package units.

# Returns a value, or all values of a list or data frame, without a class. Numbers, strings and
# logicals remain unchanged. Objects of the package units become strings in SI. Other types and
# classes are an error. `name`: argument or path in this error.
given_value <- function(value, name) {
  if (is.data.frame(value) || (is.list(value) && !is.object(value))) {
    inner <- names(value)
    if (is.null(inner)) inner <- seq_along(value)
    for (k in seq_along(value)) {
      if (!is.null(value[[k]])) {
        value[[k]] <- given_value(value[[k]], paste0(name, "$", inner[k]))
      }
    }
    return(value)
  }
  if (!is.atomic(value)) return(value)
  if (inherits(value, "units")) return(stats::setNames(units_text(value), names(value)))
  if (is.character(value) && is.object(value)) return(as.character(value))
  known <- is.null(value) || is.numeric(value) || is.character(value) || is.logical(value)
  if (known && !is.object(value)) return(value)
  abort_argument("{.arg {name}} has the class {.cls {class(value)}}; it must be a number, a string
    with a unit or an object of the package {.pkg units}.")
}

# Returns a given value in SI: one number, or NA if it is not a quantity of this dimension.
given_si <- function(value, dimension, name) {
  value <- given_value(value, name)
  one <- length(value) == 1L && (is_text(value) || is.numeric(value))
  if (one) quantity_si(value, dimension) else NA_real_
}

# Returns quantities in SI, one per value; NA stays NA. Any other value is an error about the
# argument `name`, with the text `must` after the dimension.
quantities_si <- function(value, dimension, name, must = "") {
  value <- given_value(value, name)
  quantities <- is.numeric(value) || is.character(value) || (is.logical(value) && all(is.na(value)))
  si <- if (is.numeric(value)) as.double(value) else rep(NA_real_, length(value))
  if (is.character(value)) {
    si[!is.na(value)] <- vapply(value[!is.na(value)], quantity_si, 0, dimension)
  }
  if (!quantities && length(value)) abort_quantity(name, value, dimension, must)
  degrees <- in_bare_degrees(value, si, dimension)
  most <- plan_largest[[dimension]]
  wrong <- which(degrees | is.na(si) & !is.na(value) | abs(si) > most)
  if (!length(wrong)) return(si)
  k <- wrong[1L]
  if (length(value) > 1L) name <- sprintf("%s[%d]", name, k)
  value <- value[[k]]
  if (is.na(si[k])) abort_quantity(name, value, dimension, must)
  must <- if (degrees[k]) bare_degrees_text(value) else {
    paste("at most", format_like(most, dimension, value))
  }
  abort_argument("{.arg {name}} is {show_value(value)}; it must be {must}.")
}

# Returns one quantity in SI. `positive`: TRUE if it must be above 0.
quantity_number <- function(value, dimension, name, positive = FALSE) {
  must <- if (positive) " greater than 0" else ""
  si <- quantities_si(value, dimension, name, must)
  if (length(si) != 1L || !is.finite(si) || positive && si <= 0) {
    abort_quantity(name, given_value(value, name), dimension, must)
  }
  si
}

abort_quantity <- function(name, value, dimension, must) {
  units <- if (dimension != "number") paste0(" (units: ", unit_examples(dimension), ")")
  abort_argument("{.arg {name}} is {show_value(value)}; it must be
    {noun(gsub('_', ' ', dimension))}{must}{units}.")
}

# Reports, once per session and field, how a number without a unit is read if the plan gives this
# field in another unit than SI. `values`: by path.
note_bare_numbers <- function(plan, values) {
  bare <- vapply(values, function(value) is.numeric(value) && !is.object(value), NA)
  for (path in names(values)[bare]) {
    written <- plan_field(plan, path)$value
    if (!is_text(written) || is.na(dimension <- quantity_dimension(written))) next
    unit <- plain_unit(split_quantity(written)[2L])
    if (unit_size(unit) == 1 || !is.finite(number <- values[[path]][1L])) next
    read <- format_si(number, dimension)
    other <- paste(figures(in_unit(number, unit)), unit)
    cli::cli_inform("{.field {path}} = {number} is read as {read} ({other}). Write
      {.val {paste(number, unit)}} for {unit}.",
      class = "codend_message_units", .frequency = "once", .frequency_id = paste0("codend_", path))
  }
}

# Returns a table whose columns of quantities are in SI. `dimensions`: named by column. A unit may
# follow the name of a column (`toward_deg`).
si_columns <- function(table, dimensions, name) {
  table <- with_named_units(table, function(column) dimensions[column], name)
  for (column in intersect(names(dimensions), names(table))) {
    path <- paste0(name, "$", column)
    table[[column]] <- quantities_si(table[[column]], dimensions[[column]], path)
  }
  table
}

# Returns a table without units in the names of its columns: bare numbers of the column `toward_deg`
# become text such as "270 deg" in the column `toward`. `dimension_of`: function that returns the
# dimension of a column by its name without unit, or NA.
with_named_units <- function(table, dimension_of, name) {
  units <- unlist(lapply(unname(plan_units), names))
  suffixes <- with_unit("", units)
  for (k in which(is.na(vapply(names(table), dimension_of, "")))) {
    column <- names(table)[k]
    for (unit in units[endsWith(column, suffixes)]) {
      plain <- without_unit(column, unit)
      dimension <- dimension_of(plain)
      if (is.na(dimension) || !unit %in% names(plan_units[[dimension]])) next
      if (plain %in% names(table)) {
        abort_argument("{.arg {name}} has the columns {.field {c(plain, column)}}; it must have only
          one of them.")
      }
      table[[k]] <- with_bare_unit(given_value(table[[k]], paste0(name, "$", column)), unit)
      names(table)[k] <- plain
    }
  }
  table
}

# Returns values as text; bare numbers get a unit.
with_bare_unit <- function(value, unit) {
  text <- if (is.numeric(value)) sprintf("%.15g", value) else as.character(value)
  bare <- !is.na(value) & grepl("[0-9.]$", text)
  text[bare] <- paste(text[bare], unit)
  text[is.na(value)] <- NA_character_
  text
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
