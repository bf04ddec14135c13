# The netting of a gear panel by panel: twine, knots, weight.

#' Twine of a gear's netting
#'
#' What every panel of a gear is made of and how much twine it takes, knots included (see
#' [netting]).
#'
#' @param gear A gear, the name of a shipped plan, a plan file, or a state.
#' @return A data frame with a row per panel: `panel`, `part`, `material` (`""` where the plan gives
#'   numbers instead), `mesh_size_mm`, `twine_mm`, `twines` (2 where each bar is double), `meshes`
#'   (about how many), `knots`, `twine_m` (in bars and knots, of one twine), `in_knots_percent`
#'   (share of that in knots), `twine_area_m2` (projected area of bars, diameter times length),
#'   `mass_kg` (in air) and `weight_in_water_kN`. The last columns' sums are those of the gear.
#' @examples
#' found <- netting_table("t90_codend")
#' found[c("panel", "twine_m", "in_knots_percent", "mass_kg")]
#' sum(found$mass_kg)
#' @export
netting_table <- function(gear) {
  check_given("gear")
  if (is.character(gear)) gear <- read_gear(gear)
  if (!inherits(gear, c("codend_state", "codend_gear"))) {
    abort_argument(
      "{.arg gear} must be a gear, the name of a plan or a state, not {.cls {class(gear)}}."
    )
  }
  si <- if (inherits(gear, "codend_state")) gear$si else gear_si(gear)
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
