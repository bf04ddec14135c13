# Display units: conversion from SI, and their spelling in names and files.

# Units of results that plans do not accept: their size in SI units.
display_units <- c(
  "km2/h" = 1e6 / 3600, "m3/h" = 1 / 3600, "l/h" = 1e-3 / 3600, "l/km2" = 1e-9, "l/Mm3" = 1e-9,
  "l/t" = 1e-6, meshes = 1
)

# Returns the size in SI units of a unit such as "kN", from `plan_units` or `display_units`.
unit_size <- function(unit) {
  for (units in plan_units) {
    if (unit %in% names(units)) return(units[[unit]])
  }
  display_units[[unit]]
}

# Converts from SI: in_unit(1500, "kN") is 1.5.
in_unit <- function(x, unit) x / unit_size(unit)

# Converts to SI: from_unit(1.5, "kN") is 1500.
from_unit <- function(x, unit) x * unit_size(unit)

# Returns a name with its unit as suffix: "speed_m_per_s", "slack_percent".
with_unit <- function(name, unit) {
  ifelse(nzchar(unit), paste0(name, "_", unit_suffix(unit)), name)
}

unit_suffix <- function(unit) {
  spelled <- gsub(" ", "_", sub("/", " per ", unit, fixed = TRUE), fixed = TRUE)
  ifelse(unit == "%", "percent", spelled)
}

# Returns a name without its unit, in words: "door spread" for "door_spread_m" in "m".
label_of <- function(name, unit) gsub("_", " ", without_unit(name, unit), fixed = TRUE)

# Returns names without the suffix of their unit: "speed" for "speed_m_per_s" in "m/s".
without_unit <- function(name, unit = units_of_names(name)) {
  substring(name, 1L, nchar(name) - nchar(with_unit("", unit)))
}

# Returns the names of the chosen measures; `values` may omit units. Default: all.
chosen_measures <- function(values, known, argument = deparse(substitute(values))) {
  force(argument)
  if (is.character(values)) {
    short <- known[match(values, without_unit(known))]
    values <- ifelse(values %in% known | is.na(short), values, short)
  }
  chosen_some(values, known, argument)
}

# Returns units in the spelling of the CF conventions for NetCDF files.
cf_unit <- function(unit) {
  other <- c(
    "%" = "percent", deg = "degree", meshes = "1", "l/km2" = "l km-2", "l/Mm3" = "1e-9",
    "l/t" = "l t-1"
  )
  unname(ifelse(unit %in% names(other), other[unit], sub("^(.+)/(.+)$", "\\1 \\2-1", unit)))
}

# Returns checked units by dimension, as c(speed = "knot"). name: argument or option in errors.
check_units <- function(units, name) {
  units <- unlist(units)
  known <- setdiff(names(plan_units), "number")
  if (length(units) && (!is.character(units) || is.null(names(units)))) {
    abort_argument("{.arg {name}} must name units by quantity, such as
      {.code speed = \"knot\"}.")
  }
  wrong <- setdiff(names(units), known)
  if (length(wrong)) {
    abort_argument("{.arg {name}} has a unit for {.val {wrong[1L]}}; the quantities with units are
      {.val {known}}.")
  }
  for (dimension in names(units)) {
    allowed <- names(plan_units[[dimension]])
    if (units[[dimension]] %in% allowed) next
    abort_argument("{.arg {name}} has the unit {.val {units[[dimension]]}} for {dimension}; it must
      be one of {.val {allowed}}.")
  }
  units
}

# Returns the units of options(codend.units = ), by dimension.
units_option <- function() check_units(getOption("codend.units"), "options(codend.units)")

# Returns the unit in which each unit is displayed. preferred: as from check_units(). Meshes and
# twines keep their small units.
displayed_units <- function(units, preferred) {
  for (dimension in names(preferred)) {
    of <- units %in% setdiff(names(plan_units[[dimension]]), c("mm", "N"))
    units[of] <- preferred[[dimension]]
  }
  units
}

# Returns names with the suffix of the unit `to` instead of `from`.
with_other_unit <- function(name, from, to) {
  ifelse(from == to, name, with_unit(without_unit(name, from), to))
}

# Returns the units of names with a suffix, such as "m/s" for "speed_m_per_s"; "" if there is none.
units_of_names <- function(names) {
  units <- c(unlist(lapply(plan_units, base::names), use.names = FALSE), base::names(display_units))
  units <- units[order(nchar(unit_suffix(units)))]
  found <- rep("", length(names))
  for (unit in units) found[endsWith(names, paste0("_", unit_suffix(unit)))] <- unit
  found
}

# Returns an SI value as text with four digits, in the preferred unit, else in the unit of `given`
# (the plan's value), else in SI.
quantity_text <- function(value, dimension, given = NULL) {
  said <- if (is_text(given)) split_quantity(given)
  unit <- c(units_option()[dimension], plain_unit(first_of(said[2L], "")))
  unit <- c(intersect(unit, names(plan_units[[dimension]])), names(plan_units[[dimension]]))[1L]
  number <- signif(in_unit(value, unit), 4)
  paste(with_plain_numbers(format(number, digits = 6)), unit)
}

# Returns the unit that prints show instead of `unit`.
printed_unit <- function(unit) displayed_units(unit, units_option())

# Returns a column of numbers in `unit` as text in the unit that prints show.
printed_figures <- function(x, unit) column_figures(in_unit(from_unit(x, unit), printed_unit(unit)))
