# Units as a page's user likes them.

# What may be chosen in place of a unit: the first as codend shows it.
preferred_units <- list(
  length = c("m", "fathom", "ft"), force = c("kN", "tf", "lbf"), speed = c("m/s", "knot")
)

# The choices of a page as a list by the unit that they take the place of, such as
# list(m = "fathom"); what it may not choose is left out.
preferred_of <- function(said) {
  said <- as.list(said)
  chosen <- lapply(names(preferred_units), function(dimension) {
    wanted <- said[[dimension]]
    if (is_text(wanted) && wanted %in% preferred_units[[dimension]][-1L]) wanted
  })
  names(chosen) <- vapply(preferred_units, `[[`, "", 1L)
  Filter(Negate(is.null), chosen)
}

# A number in a unit as list(value, unit) in the preferred one.
preferred_number <- function(value, unit, preferred) {
  wanted <- preferred[[unit]]
  if (is.null(wanted)) return(list(value = value, unit = unit))
  list(value = in_unit(from_unit(value, unit), wanted), unit = wanted)
}

# A table of design_table() in preferred units.
in_preferred <- function(table, preferred) {
  factor <- vapply(table$unit, function(unit) preferred_number(1, unit, preferred)$value, 0)
  table$values <- lapply(table$values, `*`, unname(factor))
  table$changes <- lapply(table$changes, `*`, unname(factor))
  table$unit <- vapply(table$unit, function(unit) preferred_number(1, unit, preferred)$unit, "",
    USE.NAMES = FALSE)
  table
}
