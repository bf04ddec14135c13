# Plans of trawls to begin with, from a few numbers. Lengths go with the head line and areas with
# its square, so that a net of another size has the same shape; twines, meshes and ropes are as
# thick as the loads on them ask for. Mouths, spreads, drag and loads are checked against bands of
# practice (inst/extdata/bands.csv and the tests): what a plan of these is for is to be changed.

# Usual meshes of a bottom trawl for its head line (m), as texts: they and the twine grow with the
# root of it, so that twine hides the same share of every net's mouth.
usual_bottom_meshes <- function(h) {
  c(mesh_size = shown_mesh_size(max(0.04, round(0.02 * sqrt(h), 2))),
    codend_mesh_size = shown_mesh_size(max(0.03, round(0.016 * sqrt(h), 2))),
    # larger vessels tow faster
    speed = sprintf("%s knot", shortest_decimal(round(3 * (h / 25)^0.15, 1))))
}

# Of a demersal seine, which is hauled slowly: the rest as of a bottom trawl.
usual_seine_meshes <- function(h) replace(usual_bottom_meshes(h), "speed", "2 knot")

# Usual front meshes of a midwater trawl, a twelfth of the head line.
usual_midwater_meshes <- function(h) {
  c(mesh_size = shown_mesh_size(round_mesh(h / 12.5)), codend_mesh_size = "40 mm")
}

# Text of a two-panel bottom trawl. given: SI numbers of `new_plan()`.
new_bottom_trawl <- function(given) {
  h <- given$head_line
  boards <- round(1.8 * (h / 25)^1.95, if (h < 20) 2 else 1)
  # small gear in deep water needs more warp, as does a fast tow, which lifts it
  warps <- (3 + 0.05 * given$depth / h) * given$depth * max(1, 0.6 + 0.4 * faster(given)) + 2 * h
  lines <- c(
    "# A two-panel bottom trawl to begin with. Its proportions are usual, none is of a",
    "# tested gear: put in your own numbers, from the drawing, line by line.",
    "codend: 1",
    "kind: bottom_trawl",
    sprintf("name: Bottom trawl, head line %s", given$shown$head_line),
    new_bottom_conditions(given),
    field_line(sprintf("warps: {length: %s, diameter: %s, material: steel_wire, spacing: 6 m}",
      metres(warps, 5), millimetres(max(8, 3 + 0.45 * h))), "3 x depth and more"),
    field_line("otter_boards:", "one side"),
    field_line(sprintf("  area: %s m2", shortest_decimal(boards)), "more spreads wider"),
    field_line(sprintf("  mass: %s kg",
      shortest_decimal(signif(190 * (h / 25)^0.3 * boards * heavier(given), 2))), "in air"),
    "  density: 7850 kg/m3",
    field_line(sprintf("  lift_coefficient: %s",
      shortest_decimal(round(min(1.6, 1.2 * (h / 25)^0.25), 2))), "1.0 flat to 1.6 high lift"),
    field_line("  drag_coefficient: 0.7", "flat boards up to 0.9"),
    rope_line("sweeps", 1.5 * h, bottom_rope(h, 8, 0.35), "board to bridles"),
    new_bottom_net(given)
  )
  paste0(c(lines, ""), collapse = "\n")
}

# Text of a two-panel pair trawl: the same net, towed by two vessels.
new_pair_trawl <- function(given) {
  h <- given$head_line
  warps <- 4 * given$depth + 4 * h
  lines <- c(
    "# A two-panel pair trawl to begin with. Its proportions are usual, none is of a",
    "# tested gear: put in your own numbers, from the drawing, line by line.",
    "codend: 1",
    "kind: pair_trawl",
    sprintf("name: Pair trawl, head line %s", given$shown$head_line),
    new_bottom_conditions(given),
    field_line(sprintf("vessels: {distance: %s}", metres(0.36 * (warps + 3.7 * h), 5)),
      "spreads the net"),
    field_line(sprintf("warps: {length: %s, diameter: %s, material: steel_wire}",
      metres(warps, 5), millimetres(max(8, 3 + 0.45 * h))), "4 x depth and more"),
    field_line(sprintf("weights: {mass: %s kg, density: 7850 kg/m3}",
      shortest_decimal(round(0.16 * h^2, if (h < 20) 0 else -1))), "where warp and sweep meet"),
    rope_line("sweeps", 2.5 * h, bottom_rope(h, 8, 0.4, "combination_rope"), "warp to bridles"),
    new_bottom_net(given)
  )
  paste0(c(lines, ""), collapse = "\n")
}

# Text of a demersal seine: the same net between two ropes that are laid as a triangle.
new_demersal_seine <- function(given) {
  h <- given$head_line
  rope <- given$rope
  if (rope < 6 * given$depth) {
    abort_argument(paste(
      "{.arg rope} is {.val {given$shown$rope}}; it must be at least six times the depth of the",
      "sea bed, {.val {given$shown$depth}}."
    ))
  }
  # what is left for the way along the bed of a rope that leads down to it
  flat <- rope - 0.2 * given$depth
  corner <- function(side) {
    sprintf("[[%s, %s]]", metres(0.32 * flat), metres(side * 0.36 * flat))
  }
  winch <- given$speed / 2
  lines <- c(
    "# A demersal seine to begin with. Its proportions are usual, none is of a",
    "# tested gear: put in your own numbers, from the drawing, line by line.",
    "codend: 1",
    "kind: demersal_seine",
    sprintf("name: Demersal seine, head line %s", given$shown$head_line),
    new_bottom_conditions(given),
    field_line(sprintf(
      "warps: {length: %s, diameter: %s, material: combination_rope, spacing: 5 m}",
      given$shown$rope, millimetres(min(40, max(14, 14 + 0.33 * h)))), "the seine ropes"),
    field_line("laying:", "a triangle; the vessel at one corner"),
    sprintf("  net: [%s, 0 m]", metres(0.645 * flat)),
    sprintf("  port: %s", corner(-1)),
    sprintf("  starboard: %s", corner(1)),
    field_line("hauling:", "vessel: 0 m/s for an anchored one"),
    "  - {time: 10 min, vessel: 1 knot}",
    sprintf("  - {rope_out: %s, winch: %s m/s, vessel: 1 knot}", metres(0.45 * rope),
      shortest_decimal(signif(0.75 * winch, 2))),
    sprintf("  - {rope_out: %s, winch: %s m/s, vessel: 1 knot}",
      metres(max(0.14 * rope, 2 * given$depth)), shortest_decimal(signif(winch, 2))),
    "",
    new_bottom_net(given)
  )
  paste0(c(lines, ""), collapse = "\n")
}

# The speed over what is usual for the head line, and what weights on the bed grow by with it.
faster <- function(given) {
  given$speed / (3 * plan_units$speed[["knot"]] * (given$head_line / 25)^0.15)
}

heavier <- function(given) min(1.8, max(0.7, faster(given)^2))

new_bottom_conditions <- function(given) {
  c(
    field_line(sprintf("towing: {speed: %s}", given$shown$speed), "through the water"),
    field_line(sprintf("seabed: {depth: %s, friction: 0.5}", given$shown$depth),
      "sand; 0.3 mud, 0.7 stones"),
    field_line("coefficients: choo_casarella", "drag of twines by Reynolds number"),
    field_line("panels: 2", "upper and lower; 4 with sides"),
    ""
  )
}

# Diameter and material of a rope that grows with the head line.
bottom_rope <- function(h, at_none, per_metre, material = "steel_wire") {
  sprintf("diameter: %s, material: %s", millimetres(at_none + per_metre * h), material)
}

# Lines of a bottom trawl's plan from the bridles on.
new_bottom_net <- function(given) {
  h <- given$head_line
  m <- given$mesh_size
  meshes <- function(length) round(length / m)
  # the rope lengths on which the rest hangs: bosoms, wings, and the overhang of the square
  footrope <- 1.22 * h
  bosom <- c(upper = 0.2, lower = 0.14) * h
  wing <- c(upper = (h - bosom[["upper"]]) / 2, lower = (footrope - bosom[["lower"]]) / 2)
  across <- 2 * meshes(0.6 * h)
  deep <- c(upper = meshes(wing[["upper"]]), lower = meshes(wing[["lower"]]))
  square <- deep[["lower"]] - deep[["upper"]]
  base <- round((across - bosom / 0.5 / m) / 2)
  rear <- 2 * meshes(0.15 * h)
  body <- meshes(0.85 * h)
  codend <- given$codend_mesh_size
  around <- round(rear * m / codend)
  twine <- function(share, mesh, double = FALSE) {
    # no thicker than a fifth of its bars, nor than twines that are sold
    twine_field(round(max(1.2, min(share * 3.2 * (h / 25)^0.85, 6.5, 100 * mesh)), 1), "PE", double)
  }
  float <- float_size(0.22 * h^2)
  c(
    "bridles:",
    rope_line("  upper", 1.2 * h, bottom_rope(h, 6, 0.3), "longer: the head line rises"),
    rope_line("  lower", 1.2 * h, bottom_rope(h, 8, 0.3), "to the footrope"),
    "# length: from wing end to wing end; bosom: of it, what lies between the wings",
    mouth_words("head_line", given$shown$head_line, bosom[["upper"]], 10 + 0.32 * h),
    mouth_words("footrope", metres(footrope), bosom[["lower"]], 10 + 0.32 * h),
    field_line(sprintf(
      "ground_gear: {length: %s, diameter: %s, mass_in_water: %s kg/m, axial_stiffness: %s MN}",
      metres(footrope), millimetres(20 * sqrt(h)),
      shortest_decimal(signif(5 * (h / 25)^1.4 * heavier(given), 2)),
      shortest_decimal(round(8 * (h / 25)^1.5, 1))), "discs on wire"),
    field_line(sprintf("side_lines: {hanging_ratio: 0.7, diameter: %s, material: PP}",
      millimetres(8 + 0.24 * h)), "wing ends"),
    field_line(sprintf("floats: {number: %d, buoyancy: %s kgf, diameter: %s mm}", float$number,
      shortest_decimal(float$lift), shortest_decimal(float$diameter)), "along the head line"),
    "",
    "wings:",
    sprintf("  upper: {mesh_size: %s, meshes: {tip: %d, base: %d, deep: %d}, %s}",
      given$shown$mesh_size, meshes(0.1 * h), base[[1]], deep[["upper"]], twine(0.83, m)),
    sprintf("  lower: {mesh_size: %s, meshes: {tip: %d, base: %d, deep: %d}, %s}",
      given$shown$mesh_size, meshes(0.1 * h), base[[2]], deep[["lower"]], twine(1, m)),
    field_line("square:", "overhangs the footrope"),
    sprintf("  {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$mesh_size, across, across, square, twine(0.83, m)),
    field_line("sections:", "counts of one panel"),
    sprintf("  body: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$mesh_size, across, rear, body, twine(1, m)),
    sprintf("  codend: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$codend_mesh_size, around, around, round(0.2 * h / codend),
      twine(1.33, codend / 2, TRUE))
  )
}

# The floats that together lift some kgf: their number, and of each lift (kgf) and diameter (mm), of
# the sizes that are sold (305 mm: 10.2 kgf, as on the Poly Nor'Eastern trawl).
float_size <- function(lift) {
  sizes <- data.frame(diameter = c(100, 150, 200, 305), lift = c(0.35, 1.2, 2.7, 10.2))
  # no more than about two in a metre of what a head line of this lift is long
  fits <- which(lift / sizes$lift <= 2.1 * sqrt(lift / 0.22))
  size <- sizes[if (length(fits)) fits[1L] else nrow(sizes), ]
  list(number = max(2, round(lift / size$lift)), lift = size$lift, diameter = size$diameter)
}

# Text of a four-panel midwater trawl without wings; its large meshes shrink by steps to the codend.
new_midwater_trawl <- function(given) {
  h <- given$head_line
  size <- h / 50
  codend <- given$codend_mesh_size
  # stretched, the front of a panel is twice the line that it hangs on
  front <- 2 * h
  # ... and a codend is for a haul that grows less than the net
  narrow <- 0.035 * size^-0.45
  sizes <- given$mesh_size
  while (utils::tail(sizes, 1L) / 2.2 > codend) {
    sizes <- c(sizes, round_mesh(utils::tail(sizes, 1L) / 2))
  }
  n <- length(sizes)
  # stretched widths along the net; large nets are short for their mouth, as the shipped one is
  # and sections of large meshes are longer, by that one's depths
  deep <- sizes^0.2 / sum(sizes^0.2)
  share <- 1 - (1 - narrow) * c(0, cumsum(deep))
  rows <- pmax(2, round(2.4 * h * size^-0.25 * deep / sizes))
  sections <- vapply(seq_len(n), function(k) {
    upper <- max(2, round(front * share[k] / sizes[k]))
    lower <- max(2, round(front * share[k + 1L] / sizes[k]))
    sprintf("  section_%d: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s%s}", k,
      shown_mesh_size(sizes[k]), upper, lower, rows[k], midwater_twine(sizes[k], size),
      if (sizes[k] > 0.8) ", knotted: no" else "")
  }, "")
  last <- max(2, round(front * narrow / codend))
  # larger meshes have less drag to be spread, and a faster tow lifts what hangs on it
  light <- min(1.3, max(0.6, (12.5 * given$mesh_size / h)^-0.3))
  fast <- min(1.4, max(0.5, (given$speed / (4 * plan_units$speed[["knot"]]))^2))
  boards <- round(2 * size^1.55 * light, if (h < 40) 2 else 1)
  hand_rope <- 1.4 * h
  rope <- function(factor) {
    sprintf("diameter: %s, material: hmpe", millimetres(max(6, factor * size^0.7)))
  }
  lift <- float_size(60 * size^1.6)
  lines <- c(
    "# A four-panel midwater trawl to begin with. Its proportions are usual, none is of",
    "# a tested gear: put in your own numbers, from the drawing, line by line.",
    "codend: 1",
    "kind: midwater_trawl",
    sprintf("name: Midwater trawl, head line %s", given$shown$head_line),
    field_line(sprintf("towing: {speed: %s}", given$shown$speed), "through the water"),
    field_line("panels: 4", "back, belly and two sides, all alike"),
    if (given$mesh_size > h / 8) field_line("netting: bars", "few large meshes: each is its bars"),
    "",
    field_line(sprintf("warps: {length: %s, diameter: %s, material: steel_wire, spacing: 8 m}",
      metres(max(3 * given$depth, 3 * h), 5), millimetres(max(8, 17 * size^0.55))), "3 x depth"),
    field_line("otter_boards:", "one side"),
    field_line(sprintf("  area: %s m2", shortest_decimal(boards)), "more spreads wider"),
    field_line(sprintf("  mass: %s kg", shortest_decimal(signif(220 * boards * fast, 2))),
      "in air"),
    "  density: 7850 kg/m3",
    field_line(sprintf("  lift_coefficient: %s",
      shortest_decimal(round(1.5 * size^0.08, 2))), "of pelagic boards 1.4 to 1.8"),
    "  drag_coefficient: 0.5",
    field_line("hand_ropes:", "board to wing tips; a longer lower one lets the footrope sink"),
    rope_line("  upper", hand_rope, rope(16), ""),
    rope_line("  lower", hand_rope * 1.03, rope(16), ""),
    sprintf("head_line: {length: %s, %s}", given$shown$head_line, rope(18)),
    rope_line("footrope", 1.02 * h, sprintf("diameter: %s, material: steel_chain",
      millimetres(max(6, 13 * size^0.3))), ""),
    rope_line("side_lines", 0.95 * h, rope(18), ""),
    sprintf("belly_lines: {hanging_ratio: 0.97, %s}", rope(18)),
    field_line(sprintf("hammers: {mass: %s kg, density: 7850 kg/m3, drag_area: %s m2}",
      shortest_decimal(signif(600 * size^1.5 * light * fast, 2)),
      shortest_decimal(round(0.1 * size, 2))),
    "weights at the lower wing tips, one side"),
    field_line(sprintf("floats: {number: %d, buoyancy: %s kgf, diameter: %s mm}", lift$number,
      shortest_decimal(lift$lift), shortest_decimal(lift$diameter)), "along the head line"),
    "",
    field_line("sections:", "counts of one panel, all four alike"),
    sections,
    sprintf("  codend: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$codend_mesh_size, last, last, round(0.3 * h * size^-0.4 / codend),
      twine_field(round(max(1.2, 55 * codend * size^0.25), 1), "PA", TRUE))
  )
  paste0(c(lines, ""), collapse = "\n")
}

# Twine of a midwater trawl's meshes (m): ropes of hmpe in the largest, which the shipped trawl of
# 2048 m has at 14 mm in meshes of 32 m.
midwater_twine <- function(mesh, size) {
  if (mesh >= 12) return(twine_field(round(14 * sqrt(mesh / 32), 1), "hmpe"))
  twine_field(round(max(1.4, 7 * sqrt(mesh / 4) * size^0.15), 1), "PA")
}

# A line of a plan with a remark, in a column where there is room.
field_line <- function(field, remark) {
  if (!nzchar(remark)) return(field)
  paste0(formatC(field, width = -40, flag = " "), "  # ", remark)
}

rope_line <- function(name, length, of, remark) {
  field_line(sprintf("%s: {length: %s, %s}", name, metres(length), of), remark)
}

mouth_words <- function(name, length, bosom, diameter) {
  sprintf("%s: {length: %s, bosom: %s, diameter: %s, material: combination_rope}", name,
    length, metres(bosom), millimetres(diameter))
}

metres <- function(x, step = 0.5) paste(shortest_decimal(max(step, round(x / step) * step)), "m")

millimetres <- function(x) paste(shortest_decimal(2 * round(x / 2)), "mm")

# A mesh size (m) as loose meshes are ordered: 2 m, 400 mm.
round_mesh <- function(x) if (x >= 1) round(x, 1) else round(x, 2)

shown_mesh_size <- function(x) {
  if (x >= 1) paste(shortest_decimal(x), "m") else paste(shortest_decimal(x * 1000), "mm")
}

twine_field <- function(diameter, material, double = FALSE) {
  sprintf("twine: {diameter: %s mm, material: %s%s}", shortest_decimal(diameter), material,
    if (double) ", double: yes" else "")
}
