# A gear without a file: each constructor gives the same piece of tree as its map in a plan file.

# fields: by name; those not given are NULL.
component <- function(group, fields) {
  structure(Filter(Negate(is.null), fields), class = "codend_component", group = group)
}

# The names of a part's fields in the schema, in order.
part_fields <- function(part) {
  file <- system.file("schema", "plan.schema.json", package = "codend", mustWork = TRUE)
  definitions <- jsonlite::fromJSON(file, simplifyVector = FALSE)[["$defs"]]
  names(definitions[[part]]$properties)
}

# The constructor of a part: its arguments are the part's fields, each NULL where not given. Made
# when the package is installed.
constructor <- function(part, group) {
  fields <- part_fields(part)
  made <- function() component(group, as.list(environment()))
  formals(made) <- stats::setNames(rep(list(NULL), length(fields)), fields)
  made
}

#' Make a gear in R
#'
#' The same tree as a plan file ([read_gear()]), made by calls. Quantities are text with a unit
#' (`"4.5 knot"`, `"32 mm"`) or bare numbers in SI. Fields and their meaning are those of the plan.
#'
#' @param name Name of the gear.
#' @param ... Components made by `point()`, `rope()`, `panel()`, `piece()`, `otter_board()`, `kite()`,
#'   `seam()` and `measure()`, each under its name; and further fields of the plan (`water`, `towing`,
#'   `netting`, `coefficients`, `netting_drag`, `slack_twine`, `catch` ([catch]), `shooting`,
#'   `tow`, `materials`, `notes`, `sources`) as lists or text.
#' @param kind Kind of plan: `"assembly"`, or a short form.
#' @return `gear()` returns a checked gear of class `codend_gear`; the others a component for it. A
#'   wrong plan is an error of class `codend_error_plan`.
#' @export
#' @examples
#' gear(
#'   "A weight on a line",
#'   top = point(position = c(0, 0, 0), held = "moved"), bottom = point(),
#'   line = rope("top", "bottom", length = "20 m", diameter = "8 mm", material = "polyamide"),
#'   weight = piece(at = "bottom", mass = "5 kg", material = "steel_wire"),
#'   depth = measure(depth = "bottom"),
#'   towing = list(speed = "2 knot")
#' )
gear <- function(name, ..., kind = "assembly") {
  given <- list(...)
  if (length(given) && (is.null(names(given)) || any(!nzchar(names(given))))) {
    cli::cli_abort(
      "Every argument of {.fn gear} after the first must be named.",
      class = c("codend_error_argument", "codend_error"), call = NULL
    )
  }
  tree <- list(codend = 1, name = name, kind = kind)
  for (i in seq_along(given)) {
    group <- attr(given[[i]], "group")
    key <- names(given)[i]
    if (is.null(group)) {
      tree[[key]] <- given[[i]]
      next
    }
    if (key %in% names(tree[[group]])) {
      abort_field(join(group, key), NULL, "given once", "is given twice")
    }
    tree[[group]] <- c(tree[[group]], given[i])
  }
  as_gear(tree)
}

#' @param position Where a held point is: x aft of the towing point, y to starboard, z up from the
#'   water surface (three lengths).
#' @param held `"fixed"` in the earth frame or `"moved"`: towed.
#' @param at An existing place: a point's name, a panel's corner such as `"belly.upper_left"`, a
#'   rope's start, middle or end such as `"warp.end"`, or the place at a share of its length such as
#'   `"warp[0.25]"` (on a rope that is not laced, the node next to it).
#' @param load Force on a point: x, y, z (three forces).
#' @param near Where a free point lies, about: three lengths. Only for where the solver starts, in
#'   gears whose stiff parts (rings of pipe, poles) it could not unfold by itself.
#' @rdname gear
#' @export
point <- constructor("point", "points")

#' @param from,to Places of a rope's start and end.
#' @param along Panel edges that a rope is laced to, or that a piece is spread along (a piece: also
#'   a rope's name): an edge such as `"belly.left"`, a range of its meshes such as
#'   `"belly.upper[0:6]"`, backwards such as `"-belly.right"`, or several of these end to end.
#' @param through Places that a rope slides through, in order from its start, such as rings or
#'   blocks: one tension throughout, without friction. Its weight and drag are spread along it in equal
#'   shares from place to place.
#' @param length Unstretched length of a rope.
#' @param hanging_ratio Rope length over the stretched length of the netting edge.
#' @param lengths Unstretched length of a rope along each edge of `along`, instead of one for all.
#' @param diameter Nominal diameter of a rope; diameter of a spherical piece.
#' @param material Name of a material: `steel_wire`, `steel_chain`, `polyethylene` (PE),
#'   `polyamide` (PA), `polyester` (PES), `polypropylene` (PP), `hmpe` (HMPE), `combination_rope`,
#'   or one of the plan's own `materials`.
#' @param axial_stiffness,mass_per_length,volume_per_length EA, mass in air and displaced volume per
#'   length; each wins over the material's.
#' @param bending_stiffness EI of a pipe or pole, N m2 or text: it resists bending, is straight at
#'   rest and also pushes. Where its start is its end, so for a ring; 0 for ropes.
#' @param pushes Whether it also pushes, as a pole does, and never goes slack.
#' @param damping_ratio Damping of a rope's stretch while the gear moves ([tow()]), as a share of
#'   what is critical for one bar of the lattice; 0 by default.
#' @param coefficients Drag coefficients of this rope or panel instead of its material's or the
#'   plan's: the name of a published set, or `list(normal, tangential, skin)`; see [netting].
#' @param added_mass Added mass as a share of the mass of the displaced water:
#'   `list(normal, tangential)` of a rope or panel, one number of a piece.
#' @param strength Breaking load.
#' @param segments Number of straight segments of a rope.
#' @param role What it is on the gear (`"warp"`, `"head_line"`, `"otter_board"`...).
#' @rdname gear
#' @export
rope <- constructor("rope", "ropes")

#' @param mesh_size Stretched length of a full mesh.
#' @param meshes `list(upper, lower, deep)`: meshes across the upper and the lower edge and from one
#'   to the other (bars, in square netting).
#' @param twine `list(diameter, material, double, axial_stiffness, damping_ratio,
#'   mass_per_length)`.
#' @param orientation `"diamond"`, `"square"`, `"turned"`, `"hexagonal"` or `"hexagonal_turned"`;
#'   see [netting].
#' @param straight_bar Length of the straight bars of hexagonal meshes; see [netting].
#' @param tapered Which side edge takes the difference of upper and lower: `"both"`, `"left"` or
#'   `"right"`.
#' @param knotted Whether the netting has knots.
#' @param knot_diameter Diameter of a knot; twice the twine diameter by default.
#' @param netting `"cells"` or `"bars"`, instead of the plan's.
#' @param netting_drag `"twines"`, `"blended"`, `"loland"`, `"aarsnes"` or
#'   `"kristiansen_faltinsen"`, instead of the plan's; see [netting].
#' @param opening_stiffness `list(couple, angle)`, the stiffness of meshes against opening and
#'   closing; see [netting].
#' @param shielding Whether it slows the water behind it: `"none"`, `"loland"` or `"cheng"`, instead
#'   of the plan's; see [settle()].
#' @param columns,rows Elements across and down a panel.
#' @param bar_segments Straight segments of each equivalent bar.
#' @param part Part of the gear that a panel is counted with.
#' @rdname gear
#' @export
panel <- constructor("panel", "panels")

#' @param edges The chains of panel edges that a seam joins, as a list.
#' @param gathered_at The one place that all meshes of a seam are gathered at.
#' @param held_between Two held points: the meshes of a seam are held evenly along the straight line
#'   from the first to the second, as on a rigid bar or frame.
#' @rdname gear
#' @export
seam <- constructor("seam", "seams")

#' @param share From which to which fraction of that length (two numbers).
#' @param number How many pieces.
#' @param end_to_end Whether one piece sits at each end and the others at equal distances between;
#'   where not, they are spread evenly over the whole length.
#' @param mass,volume,density Mass in air and displaced volume of each, or its density instead of
#'   the volume.
#' @param buoyancy Net upward force in water of each, instead of mass and volume.
#' @param area Area that the coefficients act on.
#' @param drag_coefficient,drag_area Drag coefficient, or its product with the area; or
#'   `"smooth_sphere"`, that of a smooth sphere of its diameter by its Reynolds number. That falls to
#'   a fifth where Re passes 3e5; lugs and netting on a float keep it from falling so far.
#' @param attack Angle of attack that a piece is held at, with its `polar`.
#' @param lift_coefficient,lift_area Lift coefficient, or its product with the area.
#' @param lift_direction `"up"`, `"down"`, `"port"` or `"starboard"`.
#' @param added_mass_kg Added mass of each piece.
#' @rdname gear
#' @export
piece <- constructor("piece", "pieces")

#' @param chord,span Chord and span of an otter board.
#' @param polar Lift and drag coefficients by angle of attack: the name of a tested board
#'   ([board_polar()]), or a list of `list(attack, lift, drag)`.
#' @param attachments Three points of the gear, by name, with their places on the board:
#'   `list(aft, up, inward)`, aft of the leading edge along the chord, above the middle of the span,
#'   and from the chord towards the middle of the gear. Of a kite `list(aft, starboard, inward)`, to
#'   starboard of the middle of the span and from the chord to its bridles, against its push.
#' @param centre_of_gravity,centre_of_buoyancy Such places; by default the middle of the board, and
#'   the centre of gravity.
#' @param centre_of_pressure Where lift and drag act: share of the chord from the leading edge, or
#'   `"joessel"`: that of a flat plate, 0.2 + 0.3 sin(angle of attack) (Joessel, 1873).
#' @param shoe_area Underside of an otter board on the sea bed.
#' @rdname gear
#' @export
otter_board <- constructor("otter_board", "otter_boards")

#' @param pushes Side that a free otter board's lift points to: `"port"` or `"starboard"`; of a kite
#'   `"up"`, of a depressor `"down"`.
#' @rdname gear
#' @export
kite <- constructor("kite", "kites")

#' A measure to ask for
#'
#' One of the measures that a gear made by [gear()] is asked for; a plan's `measures` have the same
#' fields. [measures()] defines each kind and gives their values.
#'
#' @return A component for [gear()], which checks it.
#' @eval measure_questions()
#' @seealso [gear()] for points, ropes and panels, whose places and names are asked for.
#' @export
#' @examples
#' measure(depth = "bottom")
#' measure(angle = list(warp_port.start = "declination"))
measure <- constructor("measure", "measures")

# What each kind of measure asks for, as arguments of help, from the schema.
measure_questions <- function() {
  kinds <- plan_schema$kinds$assembly$properties$measures$additionalProperties$properties
  paste("@param", names(kinds), vapply(kinds, function(kind) kind$description, ""))
}
