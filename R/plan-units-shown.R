# Units as people read them: conversion from SI, and how names and files spell them.

# Units in which results are shown and no plan is written: their size in SI units.
shown_units <- c(
  "km2/h" = 1e6 / 3600, "m3/h" = 1 / 3600, "l/h" = 1e-3 / 3600, "l/km2" = 1e-9, "l/Mm3" = 1e-9,
  "l/t" = 1e-6, meshes = 1
)

# The size of a unit such as "kN" in SI units, of `plan_units` or `shown_units`.
unit_size <- function(unit) {
  for (units in plan_units) {
    if (unit %in% names(units)) return(units[[unit]])
  }
  shown_units[[unit]]
}

# An SI number in a unit: in_unit(1500, "kN") is 1.5.
in_unit <- function(x, unit) x / unit_size(unit)

# A number in a unit as SI: from_unit(1.5, "kN") is 1500.
from_unit <- function(x, unit) x * unit_size(unit)

# A name with its unit at its end, as measures and columns have it: "speed_m_per_s",
# "slack_percent".
with_unit <- function(name, unit) {
  ifelse(nzchar(unit), paste0(name, "_", unit_suffix(unit)), name)
}

unit_suffix <- function(unit) {
  spelled <- gsub(" ", "_", sub("/", " per ", unit, fixed = TRUE), fixed = TRUE)
  ifelse(unit == "%", "percent", spelled)
}

# The words of names that end in their unit: "door spread" of "door_spread_m" in "m".
words_of <- function(name, unit) {
  end <- nchar(name) - ifelse(nzchar(unit), nchar(unit_suffix(unit)) + 1L, 0L)
  gsub("_", " ", substring(name, 1L, end), fixed = TRUE)
}

# Units as the CF conventions spell them in NetCDF files.
cf_unit <- function(unit) {
  other <- c(
    "%" = "percent", deg = "degree", meshes = "1", "l/km2" = "l km-2", "l/Mm3" = "1e-9",
    "l/t" = "l t-1"
  )
  unname(ifelse(unit %in% names(other), other[unit], sub("^(.+)/(.+)$", "\\1 \\2-1", unit)))
}
