# Returns material, size and twine (knots included) of a gear's panels, one row per panel. The help
# of `summary.codend_gear()` describes the columns. si: the gear in SI units.
netting_table <- function(si) {
  panels <- si$panels
  number <- function(value) vapply(panels, value, 0, USE.NAMES = FALSE)
  text <- function(field) {
    found <- vapply(panels, `[[`, "", field, USE.NAMES = FALSE)
    ifelse(is.na(found), "", found)
  }
  cells <- number(panel_bars)
  twine <- number(function(p) panel_bars(p) * cell_twine_with_knots(p) * p$twine_count)
  bars <- number(function(p) panel_bars(p) * cell_twine(p) * p$twine_count)
  mass <- twine * number(function(p) p$mass_per_length / p$twine_count)
  volume <- twine * number(function(p) p$volume_per_length / p$twine_count)
  knotted <- number(function(p) as.double(p$knot_diameter > 0))
  joins <- number(function(p) 1 + (p$straight_bar > 0))
  data.frame(
    panel = as.character(names(panels)), part = text("part"), material = text("material"),
    mesh_size_mm = in_unit(number(function(p) p$mesh_size), "mm"),
    twine_mm = in_unit(number(function(p) p$twine_diameter), "mm"),
    twines = number(function(p) p$twine_count),
    meshes = number(function(p) (p$upper + p$lower) / 2 * p$deep),
    knots = cells * joins * knotted,
    twine_m = twine, in_knots_percent = 100 * (1 - bars / twine),
    twine_area_m2 = bars * number(function(p) p$twine_diameter),
    mass_kg = mass,
    weight_in_water_kN = in_unit(gear_gravity * (mass - si$water$density * volume), "kN")
  )
}
