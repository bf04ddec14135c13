# Preferred units of a page's user.

# Units that a user may choose, by dimension. The first unit is codend's default.
preferred_units <- list(
  length = c("m", "fathom", "ft"), force = c("kN", "tf", "lbf"), speed = c("m/s", "knot")
)

# Returns the chosen units by the unit that they replace, such as list(m = "fathom"). Invalid
# choices are ignored.
preferred_of <- function(said) {
  said <- as.list(said)
  chosen <- lapply(names(preferred_units), function(dimension) {
    wanted <- said[[dimension]]
    if (is_text(wanted) && wanted %in% preferred_units[[dimension]][-1L]) wanted
  })
  names(chosen) <- vapply(preferred_units, `[[`, "", 1L)
  Filter(Negate(is.null), chosen)
}

preferred_number <- function(value, unit, preferred) {
  wanted <- preferred[[unit]]
  if (is.null(wanted)) return(list(value = value, unit = unit))
  list(value = in_unit(from_unit(value, unit), wanted), unit = wanted)
}

# table: from design_table().
in_preferred <- function(table, preferred) {
  factor <- vapply(table$unit, function(unit) preferred_number(1, unit, preferred)$value, 0)
  table$values <- lapply(table$values, `*`, unname(factor))
  table$changes <- lapply(table$changes, `*`, unname(factor))
  table$unit <- vapply(table$unit, function(unit) preferred_number(1, unit, preferred)$unit, "",
    USE.NAMES = FALSE)
  table
}
