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
label_of <- function(name, unit) {
  end <- nchar(name) - ifelse(nzchar(unit), nchar(unit_suffix(unit)) + 1L, 0L)
  gsub("_", " ", substring(name, 1L, end), fixed = TRUE)
}

# Returns units in the spelling of the CF conventions for NetCDF files.
cf_unit <- function(unit) {
  other <- c(
    "%" = "percent", deg = "degree", meshes = "1", "l/km2" = "l km-2", "l/Mm3" = "1e-9",
    "l/t" = "l t-1"
  )
  unname(ifelse(unit %in% names(other), other[unit], sub("^(.+)/(.+)$", "\\1 \\2-1", unit)))
}
