# Netting with hexagonal meshes or stiff knots as SI numbers, and the catch in it.

#' Netting models
#'
#' Fields of a panel in a plan (or of [netting_panel()]) select the mesh geometry, the drag model
#' and the stiffness of the netting.
#'
#' @section Meshes:
#' `orientation` is the direction of the meshes between the upper and the lower edge of a panel:
#'
#' - `diamond`: the netting's normal direction runs down the panel.
#' - `turned`: turned by 90 degrees (T90). Limp twines behave identically in both directions: only
#'   the stiffness of knots makes a difference.
#' - `square`: bars run down and across (T45).
#' - `hexagonal`: straight bars of length `straight_bar` run down the panel, between the oblique
#'   bars of diamonds. `mesh_size` remains the stretched length of a mesh: two straight and two
#'   oblique bars.
#' - `hexagonal_turned`: as `hexagonal`, with straight bars across the panel.
#'
#' In hexagonal netting all bars have the same twine, and knots that have a length are straight bars
#' too. Hexagonal netting always uses triangular elements (D. Priour, A Finite Element Method for
#' Netting, Springer 2013). Each element has its own internal point, which stiff twine leaves free
#' to move.
#'
#' @section Knots:
#' Netting is `knotted` by default. A knot is a sphere of diameter `knot_diameter`, by default twice
#' the twine diameter. Its drag depends on its Reynolds number. Knotless netting has no knots.
#'
#' A knot has the mass and the volume of its twine. `knot_twine` is the length of this twine in
#' twine diameters; default 16, a single knot. Knotted netting then weighs 1 + 16 d / mesh size
#' times as much as knotless netting. This ratio is an assumption: it was recalled from J. Prado and
#' P. Y. Dremiere, Fisherman's Workbook, FAO 1990, but not checked there.
#' [summary()][summary.codend_gear] of a gear lists the twine in its panels.
#'
#' @section Drag of twines and ropes: `coefficients` is a named set, or the numbers `normal`,
#'   `tangential` and `skin` (on diameter times length). It can be a field of the plan, of a
#'   material, or of one rope or panel. The last in this order takes precedence.
#'
#' | name | across the axis | along it |
#' |---|---|---|
#' `r paste(twine_drag_model_rows(), collapse = "\n")`
#'
#' Re is the Reynolds number of the flow across the axis. The drag along the axis is the most
#' uncertain part. It matters most in netting nearly parallel to the flow.
#' [summary()][summary.codend_state] of a state reports the total drag with this part halved and
#' doubled.
#'
#' @section Drag of netting:
#' Defaults: `blended` for trawls, `loland` for cages, `morison` for other gears. `method: paper`
#' always uses `morison`. `vignette("drag-models", "codend")` gives the evidence for each choice.
#'
#' `netting_drag`, of the plan or of one panel, selects the drag model:
#'
#' - `morison`: Morison-type (twine-by-twine) drag, the sum over all twines and knots with the
#'   `coefficients`.
#' - A screen drag model, which depends on the angle between the netting's normal and the flow and
#'   on the solidity of the open meshes:
#'   `r drag_model_sources("netting", "screen")`.
#' - `blended`: the sum over twines, with a smooth transition to the screen of Kristiansen and
#'   Faltinsen between 60 and 80 degrees.
#'
#' `blended` exists because twines shade each other in netting nearly parallel to the flow. The sum
#' over twines ignores this. Above some 70 degrees between normal and flow its drag is too large
#' (flume tests of rhombic panels, ASME OMAE2012, volume 44946, page 49; H. Cheng et al.,
#' Aquacultural Engineering 90, 2020). `blended` returns to the sum in two cases:
#'
#' - Meshes close: solidities from 0.35 to 1.
#' - Twines are far apart: the screen part decreases to zero from a solidity of 0.05 to 0.
#'
#' These bounds are a choice of this package. If the coefficients along the twine are small, as in
#' `hoerner`, the screen drag can exceed the sum over twines.
#'
#' Limits of the screen drag models:
#'
#' - They were fitted to square netting with these solidities:
#'   `r screen_ranges()`.
#'   Solidity is clamped to these ranges, and so is the Reynolds number of a model's cylinder drag
#'   (32 to 10000).
#' - [settle()] warns if the solidity, the Reynolds number or the angle is outside the fitted range
#'   ([findings()]).
#' - `loland` and `aarsnes` have a minimum drag, 0.04 of the netting area, even without twine. Below
#'   a solidity of 0.1 they are therefore scaled with solidity. Their drag is still far too large
#'   for the front meshes of a midwater trawl.
#' - Solidity counts each knot as a sphere, and crossings of knotless netting once (2d/a - (d/a)^2
#'   in square meshes).
#' - Parallel to the flow, `loland` and `aarsnes` have a drag coefficient of 0.04 on their whole
#'   area. `blended` and `kristiansen_faltinsen` have skin friction there: the coefficient `skin` of
#'   the twine if it is above 0, otherwise 0.02 on the twine area (S. F. Hoerner, Fluid-Dynamic
#'   Drag, 1965, 3-11). `multipliers.twine_tangential_drag` scales it.
#' - A mesh that closes loses its area and its screen drag.
#' - In netting of `bars`, the screens are sheets between the rows of knots.
#' - Hexagonal netting supports screens, but not `blended`. If the plan has `blended`, hexagonal
#'   netting uses `morison`.
#'
#' @section Stiffness of meshes:
#' Knots and stiff twine resist opening and closing of meshes. Every knot has a couple: `couple`
#' times the change of the angle between its twines from `angle`, its angle at rest (D. Priour,
#' 2013, as above). In turned meshes the angle is measured across the panel.
#'
#' Without `opening_stiffness`, the couple follows from the twine if the panel meets all
#' conditions:
#'
#' - it is knotted, turned (T90) and of `cells`;
#' - its twine is at least 2 mm thick;
#' - its fibre is in the table below.
#'
#' Other netting is limp. Multifilament (PA, PES, HMPE) and thin twine bend easily. In diamond
#' netting these couples would hardly change the openings, except in a slack codend.
#'
#' Between two knots that do not turn, twine is a beam of bending stiffness EI. Its length is the
#' bar minus the knot. For small slopes and without the stiffening effect of tension (F. G. O'Neill,
#' IMA Journal of Applied Mathematics 58, 1997):
#'
#' couple = 6 n EI / (bar - knot), angle = 2 asin(knot / bar)
#'
#' n is 2 for double twine and otherwise 1. knot is `knot_diameter`, times the square root of 2 for
#' double twine. At rest, twines leave both sides of a knot along the netting's normal direction (an
#' assumption). EI is proportional to the cube of the diameter. Values for one twine of 4 mm:
#'
#' | fibre | EI, N m2 |
#' |---|---|
#' `r paste(twine_bending_rows(), collapse = "\n")`
#'
#' All values are assumed, within a factor of 2. The file `twine_bending.csv` in
#' `system.file("extdata", package = "codend")` gives the reasons. Measured values of your netting
#' are better. `couple: 0` makes meshes limp. `multipliers.mesh_opening` multiplies all couples, and
#' [uncertainty()] includes it. Netting of `bars` has no default couple; a couple in the plan acts
#' on the sheets between the rows of knots. `vignette("forces", "codend")` shows the effect of
#' couples on codends and on the height of trawls.
#'
#' @seealso [netting_panel()] for the fields, [as.data.frame()][as.data.frame.codend_state] for
#'   computed openings, [force_coefficients()] for all coefficients.
#'
#' @examples
#' panel <- read_gear("flat_panel")
#' as_screen <- update(panel, netting_drag = "loland")
#' measures(settle(panel))[["total_drag_kN"]]
#' measures(settle(as_screen))[["total_drag_kN"]]
#' @name netting
NULL

#' Catch in a codend
#'
#' The plan field `catch` fills netting from its closed end with a catch that blocks the water.
#'
#' The pressure on the netting around the catch acts along the outward normal:
#'
#' p = 1/2 C_d rho V^2
#'
#' V is the speed of the water past the netting. C_d is `drag_coefficient`, default 1.4 (D. Priour,
#' Modelling axisymmetric codends made of hexagonal mesh types, Ocean Engineering, 2014,
#' doi:10.1016/j.oceaneng.2014.09.037, and the program AxiCodend). The resultant force is p times
#' the area of the catch front.
#'
#' The catch is in `panels` of equal depth that are closed at their lower edges. Its front follows a
#' row of meshes. One field sets the position of the front:
#'
#' - `blocked_meshes`: depth in meshes from the lower edge;
#' - `volume`: the volume that the netting behind the front encloses;
#' - `mass`: the same with the volume `mass` / `density` (default 1000 kg/m3, an assumption).
#'
#' [settle()] computes the front. The catch has no weight in water. In netting of `bars` the catch
#' presses on the sheets between the rows of knots.
#'
#' [measures()] of a state with a catch include `catch_volume_m3`, `catch_surface_m2` (area of the
#' netting behind the front) and `catch_front_meshes` (depth of the catch in meshes).
#'
#' @seealso [as.data.frame()][as.data.frame.codend_state] for the openings ahead of a catch,
#'   [gear()] for the field in R.
#'
#' @examples
#' codend <- read_gear("t90_codend")
#' codend$plan$catch
#' fuller <- settle(update(codend, catch.blocked_meshes = 20), nodes = 300)
#' measures(fuller)[c("catch_volume_m3", "catch_front_meshes")]
#' @name catch
NULL

# Assumed bending stiffness (N m2) of one twine of 4 mm, by fibre, with its sources.
twine_bending <- package_table("twine_bending.csv", row.names = "material")

twine_bending_rows <- function() {
  sprintf("| %s | %s |", rownames(twine_bending), format(twine_bending$bending_stiffness_N_m2))
}

# Minimum diameter of stiff twine, m.
thinnest_stiff_twine <- 2e-3

# Returns the default stiffness of the knots of a panel of `gear_si()`: list(couple (N m/rad), angle
# (rad), assumed = TRUE). NULL for limp netting. The help page `netting` explains the rules.
usual_opening_stiffness <- function(panel) {
  fibre <- panel$material
  if (fibre %in% names(material_abbreviations)) fibre <- material_abbreviations[[fibre]]
  thin <- panel$twine_diameter < thinnest_stiff_twine * (1 - 1e-9)
  if (thin || !fibre %in% rownames(twine_bending) || panel$knot_diameter == 0 ||
    panel$netting != "cells" || panel$orientation != "turned") {
    return(NULL)
  }
  bar <- panel$mesh_size / 2
  # Very large knots would leave no free twine: limit them to 2/3 of a bar.
  knot <- min(panel$knot_diameter * sqrt(panel$twine_count), 2 / 3 * bar)
  stiffness <- twine_bending[fibre, "bending_stiffness_N_m2"] * (panel$twine_diameter / 4e-3)^3
  list(
    couple = 6 * panel$twine_count * stiffness / (bar - knot), angle = 2 * asin(knot / bar),
    assumed = TRUE
  )
}

# Returns the length (m) of the straight bars of a panel, or 0.
si_hexagons <- function(panel, path) {
  hexagonal <- panel$orientation %in% c("hexagonal", "hexagonal_turned")
  refuse <- function(field) {
    abort_field(paste0(path, ".", field), panel[[field]], NULL,
      sprintf("is given, but `%s.orientation` is %s", path, panel$orientation))
  }
  if (!hexagonal) {
    if (!is.null(panel$straight_bar)) refuse("straight_bar")
    return(0)
  }
  if (!is.null(panel$opening_stiffness)) refuse("opening_stiffness")
  if (identical(panel$netting_drag, "blended")) {
    abort_field(paste0(path, ".netting_drag"), "blended",
      "another drag model for hexagonal netting")
  }
  if (identical(panel$netting, "bars")) {
    abort_field(paste0(path, ".netting"), panel$netting, "cells for hexagonal netting")
  }
  straight <- first_of(panel$straight_bar, panel$mesh_size / 4)
  if (straight >= panel$mesh_size / 2) {
    abort_field(paste0(path, ".straight_bar"), format_si(straight, "length"),
      paste("less than half the mesh size,", format_si(panel$mesh_size / 2, "length")))
  }
  straight
}

# Returns list(panels, deep = depth of each panel in meshes, blocked (meshes, or NA), volume (m3, or
# NA), drag_coefficient).
si_catch <- function(catch, path, panels) {
  for (i in seq_along(catch$panels)) {
    name <- catch$panels[i]
    at <- sprintf("%s.panels[%d]", path, i)
    if (!name %in% names(panels)) abort_reference(name, name, names(panels), "panel", at)
  }
  deep <- vapply(panels[catch$panels], `[[`, 0, "deep")
  if (any(deep != deep[1])) {
    abort_field(paste0(path, ".panels"), catch$panels, NULL, sprintf(
      "has panels %s and %s meshes deep; the depths must be equal", format(deep[1]),
      format(deep[deep != deep[1]][1])
    ))
  }
  blocked <- first_of(catch$blocked_meshes, NA_real_)
  if (!is.na(blocked) && blocked > deep[1]) {
    abort_field(paste0(path, ".blocked_meshes"), blocked,
      paste("at most the depth of its panels,", format(deep[[1]]), "meshes"))
  }
  list(
    panels = catch$panels, deep = deep[[1]], blocked = blocked,
    volume = first_of(catch$volume, first_of(catch$mass, NA_real_) / catch$density),
    drag_coefficient = catch$drag_coefficient
  )
}
