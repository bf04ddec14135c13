# Netting that is not plain diamonds, squares or turned meshes, as SI numbers; and the catch in it.

#' Netting
#'
#' How a panel's netting is modelled, by fields of the panel in a plan (or of [netting_panel()]).
#'
#' @section Meshes:
#' `orientation` is how meshes lie between the upper and the lower edge of a panel:
#'
#' - `diamond`: with the netting's normal direction down the panel; `turned`: by 90 degrees (T90).
#'   Thin twines know no difference: only the stiffness of knots distinguishes them.
#' - `square`: bars run down and across (T45).
#' - `hexagonal`: between the oblique bars of diamonds straight bars of length `straight_bar` run
#'   down the panel; `hexagonal_turned`: across it. `mesh_size` stays the stretched length of a
#'   mesh, two straight and two oblique bars. Knots that have a length are straight bars too. All
#'   bars are of one twine. Hexagonal netting is always divided into cells of three corners (D.
#'   Priour, A Finite Element Method for Netting, Springer 2013), each with a point of its own, with
#'   which stiff twine leaves it free to move.
#'
#' @section Knots:
#' Netting is `knotted` where a plan does not say otherwise. A knot is a sphere of `knot_diameter`,
#' twice the twine's where not given, which drags by its Reynolds number, and has the mass and the
#' volume of the twine in it: `knot_twine` diameters of twine, 16 where not given, which is what a
#' single knot takes: knotted netting weighs 1 + 16 d / mesh size times as much as knotless
#' (recalled of J. Prado and P. Y. Dremiere, Fisherman's Workbook, FAO 1990, which was not at hand:
#' an assumption until it is checked there). Knotless netting has none of this.
#' [summary()][summary.codend_gear] of a gear lists the twine that the panels of a gear take.
#'
#' @section Drag of twines and ropes:
#' `coefficients`, of the plan, of one of its own `materials`, or of one rope or panel (the last
#' wins), is a set by name, or numbers `normal`, `tangential` and `skin` on diameter times length:
#'
#' | name | across the axis | along it |
#' |---|---|---|
#' `r twine_law_rows()`
#'
#' Re is that of the flow across the axis. What is known worst, and counts most in netting that lies
#' nearly along the flow, is the part along the axis: [summary()][summary.codend_state] of a state
#' reports the total drag with it halved and doubled.
#'
#' @section Drag of netting:
#' Which law for which gear, with the evidence, is explained in `vignette("drag-laws", "codend")`.
#' Where a plan says nothing, trawls have `blended`, cages `loland`, all else `twines`.
#' `method: paper` has `twines` whatever a plan says.
#'
#' `netting_drag`, of the plan or of one panel, is `twines` (the sum over all twines and knots by
#' the `coefficients`) or the name of a formula for netting as a screen, by the angle between its
#' normal and the flow and its solidity as the meshes are open:
#' `r law_sources("netting", "screen")`.
#' They were fitted to square netting of these solidities: `r screen_ranges()`; and are held at the
#' ends beyond them; so is the cylinder drag of a law by Reynolds number (32 to 10000). Below a
#' solidity of 0.1 `loland` and `aarsnes`, whose least drag is that of 0.04 of the netting's area
#' even without any twine, are taken in proportion to the solidity; in the large meshes at the front
#' of a midwater trawl they still give far too much. Solidity counts knots by their spheres, and the
#' crossings of knotless netting once (2d/a - (d/a)^2 in square meshes). Where
#' netting lies nearly along the flow its twines lie in each other's wake, which the sum over
#' twines does not know: above some 70 degrees between normal and flow it gives too much drag (flume
#' tests of rhombic panels, ASME OMAE2012, volume 44946, page 49; H. Cheng et al., Aquacultural
#' Engineering 90, 2020). `blended` is the sum over twines that passes smoothly into the screen of
#' Kristiansen and Faltinsen between 60 and 80 degrees; where meshes close (solidities from 0.35 to
#' 1) back to the sum. Netting so open that its twines are far apart is none: from a solidity of
#' 0.05 down to 0 the screen's part vanishes. These bounds are a choice made here. With coefficients
#' whose part along the twine is small, such as `hoerner`, the screen may be the larger of the two.
#' Along the flow screens have a drag coefficient of 0 to 0.04 on their whole area;
#' `multipliers.screen_friction` adds one on the area of the twine, 0 where a plan gives none, whose
#' doubt [uncertainty()] counts.
#' A mesh that closes up loses its area, and as a screen its drag. In netting of bars the screens
#' are sheets between the rows of its knots. Hexagonal netting can be a screen, but not blended:
#' where the plan's law is
#' that, it has the sum over its twines. `settle()` warns where a screen's law is used outside the
#' solidity, the Reynolds number or the angle that it was fitted to ([findings()]).
#'
#' @section Stiffness of meshes:
#' Knots and stiff twine resist opening and closing of meshes: every knot has a couple, `couple`
#' times the change of the angle between its twines from `angle`, its angle at rest (D. Priour,
#' 2013, as above); of turned meshes the angle is measured across the panel. Where a plan gives no
#' `opening_stiffness`, knotted netting of cells that is turned, of twine of 2 mm and more of a
#' fibre in the table below, has that of its twine: its knots hold its meshes open. Multifilament
#' (PA, PES, HMPE) and thin twine are limp, and so is diamond netting: the same couples would change
#' its openings little where water or a catch opens them, and only a slack codend by more. Between
#' two knots that do not turn, twine is a beam of the bending stiffness EI
#' (F. G. O'Neill, IMA Journal of Applied Mathematics 58, 1997, for small slopes and without the
#' part of its tension, which makes it stiffer), of the length of a bar less a knot, so that
#'
#' couple = 6 n EI / (bar - knot), angle = 2 asin(knot / bar)
#'
#' with n = 2 of double twine, knot = `knot_diameter`, times the root of 2 of double twine, and at
#' rest twines that leave both sides of a knot along the netting's normal direction (an assumption).
#' EI goes with the cube of the diameter, and is for one twine of 4 mm:
#'
#' | fibre | EI, N m2 |
#' |---|---|
#' `r twine_bending_rows()`
#'
#' All of these are assumed, within a factor of 2 (the file `twine_bending.csv` of
#' `system.file("extdata", package = "codend")` says from what); measured values for a netting are
#' better. `couple: 0` leaves meshes limp, and `multipliers.mesh_opening` multiplies all couples:
#' [uncertainty()] knows it. In netting of bars no couple is assumed; one that a plan gives acts on
#' the sheets between the rows of its knots. `vignette("forces", "codend")` shows what the couples
#' do to codends and to the height of trawls.
#'
#' @examples
#' panel <- read_gear("flat_panel")
#' as_screen <- update(panel, netting_drag = "loland")
#' measures(settle(panel))[["total_drag_kN"]]
#' measures(settle(as_screen))[["total_drag_kN"]]
#' @name netting
NULL

#' The catch
#'
#' The plan's field `catch` fills netting from its closed end with a catch that the water cannot
#' flow through. On the netting that it lies against acts a pressure p = 1/2 C_d rho V^2 along the
#' outward normal, with V the speed of the water past that netting and C_d 1.4 where
#' `drag_coefficient` gives no other (D. Priour, Modelling axisymmetric codends made of hexagonal
#' mesh types, Ocean Engineering, 2014, doi:10.1016/j.oceaneng.2014.09.037, and the program
#' AxiCodend). The resultant is p times the area of the catch's front.
#'
#' The catch lies in `panels`, alike in depth and closed at their lower edges, up to a front that
#' follows a row of meshes: `blocked_meshes` deep from the lower edge, or where the netting behind
#' it encloses the catch's `volume`, or its `mass` over its `density` (1000 kg/m3 where none is
#' given, an assumption). [settle()] finds that front. The catch has no weight in water. In netting
#' of bars it lies against the sheets between the rows of their knots.
#'
#' [measures()] of such a state include `catch_volume_m3`, `catch_surface_m2`, the area of the
#' netting behind the front, and `catch_front_meshes`, how many meshes deep the catch is.
#'
#' @examples
#' codend <- read_gear("t90_codend")
#' codend$plan$catch
#' fuller <- settle(update(codend, catch.blocked_meshes = 20), nodes = 300)
#' measures(fuller)[c("catch_volume_m3", "catch_front_meshes")]
#' @name catch
NULL

# Bending stiffness (N m2) of one twine of 4 mm by fibre, with its sources.
read_twine_bending <- function() {
  utils::read.csv(system.file("extdata", "twine_bending.csv", package = "codend"),
    comment.char = "#", row.names = "material")
}

known_twine_bending <- remembered(read_twine_bending)

# Rows of the table of these in help.
twine_bending_rows <- function() {
  known <- read_twine_bending()
  sprintf("| %s | %s |", rownames(known), format(known$bending_stiffness_N_m2))
}

# Thinner twine is limp, m.
thinnest_stiff_twine <- 2e-3

# list(couple (N m/rad), angle (rad), assumed = TRUE) of the knots of a panel of `gear_si()`, from
# its twine; NULL where none is assumed: see help of netting.
usual_opening_stiffness <- function(panel) {
  fibre <- panel$material
  if (fibre %in% names(material_abbreviations)) fibre <- material_abbreviations[[fibre]]
  known <- known_twine_bending()
  thin <- panel$twine_diameter < thinnest_stiff_twine * (1 - 1e-9)
  if (thin || !fibre %in% rownames(known) || panel$knot_diameter == 0 || panel$netting != "cells" ||
    panel$orientation != "turned") {
    return(NULL)
  }
  bar <- panel$mesh_size / 2
  # where knots leave no twine between them they are as large as leaves a third
  knot <- min(panel$knot_diameter * sqrt(panel$twine_count), 2 / 3 * bar)
  stiffness <- known[fibre, "bending_stiffness_N_m2"] * (panel$twine_diameter / 4e-3)^3
  list(
    couple = 6 * panel$twine_count * stiffness / (bar - knot), angle = 2 * asin(knot / bar),
    assumed = TRUE
  )
}

# Length (m) of the straight bars of a panel, 0 where it has none.
si_hexagons <- function(panel, path) {
  hexagonal <- panel$orientation %in% c("hexagonal", "hexagonal_turned")
  refuse <- function(field) {
    abort_plan(
      sprintf(
        "Plan field `%s.%s` is given, but `%s.orientation` is %s.", path, field, path,
        panel$orientation
      ),
      paste0(path, ".", field), panel[[field]]
    )
  }
  if (!hexagonal) {
    if (!is.null(panel$straight_bar)) refuse("straight_bar")
    return(0)
  }
  if (!is.null(panel$opening_stiffness)) refuse("opening_stiffness")
  if (identical(panel$netting_drag, "blended")) {
    abort_field(paste0(path, ".netting_drag"), "blended", "another for hexagonal netting")
  }
  if (identical(panel$netting, "bars")) {
    abort_field(paste0(path, ".netting"), panel$netting, "cells for hexagonal netting")
  }
  straight <- first_of(panel$straight_bar, panel$mesh_size / 4)
  if (straight >= panel$mesh_size / 2) {
    abort_field(
      paste0(path, ".straight_bar"), format_si(straight, "length"),
      paste("less than half the mesh size,", format_si(panel$mesh_size / 2, "length"))
    )
  }
  straight
}

# list(panels, deep (meshes of each), blocked (meshes, or NA), volume (m3, or NA),
# drag_coefficient).
si_catch <- function(catch, path, panels) {
  for (i in seq_along(catch$panels)) {
    name <- catch$panels[i]
    at <- sprintf("%s.panels[%d]", path, i)
    if (!name %in% names(panels)) abort_reference(name, name, names(panels), "panel", at)
  }
  deep <- vapply(panels[catch$panels], `[[`, 0, "deep")
  if (any(deep != deep[1])) {
    abort_plan(
      sprintf("Plan field `%s.panels` names panels of %s and %s meshes deep; they must be alike.",
        path, format(deep[1]), format(deep[deep != deep[1]][1])),
      paste0(path, ".panels"), catch$panels
    )
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
