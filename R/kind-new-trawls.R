# Plans of trawls to begin with, from a few numbers. The ratios are of common practice, and rounded:
# what a plan of these is for is to be changed.

# Text of a two-panel bottom trawl. given: SI numbers of `new_plan()`.
new_bottom_trawl <- function(given) {
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
  body <- meshes(0.8 * h)
  codend <- given$codend_mesh_size
  around <- round(rear * m / codend)
  boards <- max(0.4, round(0.013 * h^1.5, 1))
  lines <- c(
    "# A two-panel bottom trawl to begin with. Its proportions are usual, none is of a",
    "# tested gear: put in your own numbers, from the drawing, line by line.",
    "codend: 1",
    "kind: bottom_trawl",
    sprintf("name: Bottom trawl, head line %s", metres(h)),
    field_line(sprintf("towing: {speed: %s}", given$shown$speed), "through the water"),
    field_line(sprintf("seabed: {depth: %s, friction: 0.5}", given$shown$depth),
      "sand; 0.3 mud, 0.7 stones"),
    field_line("coefficients: choo_casarella", "drag of twines by Reynolds number"),
    field_line("panels: 2", "upper and lower; 4 with sides"),
    "",
    field_line(sprintf("warps: {length: %s, diameter: %s, material: steel_wire, spacing: 6 m}",
      metres(3 * given$depth + 25, 5), millimetres(10 + 0.3 * h)), "3 x depth + 25 m"),
    field_line("otter_boards:", "one side"),
    field_line(sprintf("  area: %s m2", shortest_decimal(boards)), "more spreads wider"),
    field_line(sprintf("  mass: %s kg", shortest_decimal(round(150 * boards, -1))), "in air"),
    "  density: 7850 kg/m3",
    field_line("  lift_coefficient: 1.2", "1.0 flat to 1.6 high lift"),
    field_line("  drag_coefficient: 0.7", "flat boards up to 0.9"),
    rope_line("sweeps", 1.2 * h, "diameter: 18 mm, material: steel_wire", "board to bridles"),
    "bridles:",
    rope_line("  upper", 1.2 * h, "diameter: 14 mm, material: steel_wire",
      "longer: the head line rises"),
    rope_line("  lower", 1.2 * h, "diameter: 16 mm, material: steel_wire", "to the footrope"),
    "# length: from wing end to wing end; bosom: of it, what lies between the wings",
    mouth_words("head_line", h, bosom[["upper"]]),
    mouth_words("footrope", footrope, bosom[["lower"]]),
    field_line(sprintf(
      "ground_gear: {length: %s, diameter: 100 mm, mass_in_water: 4 kg/m, axial_stiffness: 8 MN}",
      metres(footrope)), "discs on wire"),
    field_line("side_lines: {hanging_ratio: 0.7, diameter: 14 mm, material: PP}", "wing ends"),
    field_line(sprintf("floats: {number: %d, buoyancy: 2.7 kgf, diameter: 200 mm}", round(1.6 * h)),
      "three in two metres"),
    "",
    "wings:",
    sprintf("  upper: {mesh_size: %s, meshes: {tip: %d, base: %d, deep: %d}, %s}",
      given$shown$mesh_size, meshes(0.1 * h), base[[1]], deep[["upper"]], twine_field(2.5, "PE")),
    sprintf("  lower: {mesh_size: %s, meshes: {tip: %d, base: %d, deep: %d}, %s}",
      given$shown$mesh_size, meshes(0.1 * h), base[[2]], deep[["lower"]], twine_field(3, "PE")),
    field_line("square:", "overhangs the footrope"),
    sprintf("  {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$mesh_size, across, across, square, twine_field(2.5, "PE")),
    field_line("sections:", "counts of one panel"),
    sprintf("  body: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$mesh_size, across, rear, body, twine_field(3, "PE")),
    sprintf("  codend: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$codend_mesh_size, around, around, round(0.2 * h / codend),
      twine_field(4, "PE", TRUE))
  )
  paste0(c(lines, ""), collapse = "\n")
}

# Text of a four-panel midwater trawl without wings; its large meshes shrink by steps to the codend.
new_midwater_trawl <- function(given) {
  h <- given$head_line
  codend <- given$codend_mesh_size
  # stretched, the front of a panel is twice the line that it hangs on
  front <- 2 * h
  sizes <- given$mesh_size
  while (utils::tail(sizes, 1L) / 2.2 > codend) {
    sizes <- c(sizes, round_mesh(utils::tail(sizes, 1L) / 2))
  }
  n <- length(sizes)
  # stretched widths along the net, to a tenth at the codend, and depths that add up to 3 head lines
  share <- seq(1, 0.1, length.out = n + 1L)
  rows <- pmax(2, round(3 * h / n / sizes))
  sections <- vapply(seq_len(n), function(k) {
    upper <- max(2, round(front * share[k] / sizes[k]))
    lower <- max(2, round(front * share[k + 1L] / sizes[k]))
    twine <- min(max(2.4, 10 * sqrt(sizes[k] / 8)), 14)
    sprintf("  section_%d: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s%s}", k,
      shown_mesh_size(sizes[k]), upper, lower, rows[k], twine_field(round(twine, 1), "PA"),
      if (sizes[k] > 0.8) ", knotted: no" else "")
  }, "")
  last <- max(2, round(front * 0.1 / codend))
  boards <- max(1, round(0.095 * h, 1))
  hand_rope <- 1.4 * h
  lines <- c(
    "# A four-panel midwater trawl to begin with. Its proportions are usual, none is of",
    "# a tested gear: put in your own numbers, from the drawing, line by line.",
    "codend: 1",
    "kind: midwater_trawl",
    sprintf("name: Midwater trawl, head line %s", metres(h)),
    field_line(sprintf("towing: {speed: %s}", given$shown$speed), "through the water"),
    field_line("panels: 4", "back, belly and two sides, all alike"),
    "",
    field_line(sprintf("warps: {length: %s, diameter: %s, material: steel_wire, spacing: 8 m}",
      metres(3 * given$depth, 5), millimetres(12 + 0.1 * h)), "3 x depth"),
    field_line("otter_boards:", "one side"),
    field_line(sprintf("  area: %s m2", shortest_decimal(boards)), "more spreads wider"),
    field_line(sprintf("  mass: %s kg", shortest_decimal(round(220 * boards, -1))), "in air"),
    "  density: 7850 kg/m3",
    field_line("  lift_coefficient: 1.5", "of pelagic boards 1.4 to 1.8"),
    "  drag_coefficient: 0.5",
    field_line("hand_ropes:", "board to wing tips; a longer lower one lets the footrope sink"),
    rope_line("  upper", hand_rope, "diameter: 16 mm, material: hmpe", ""),
    rope_line("  lower", hand_rope * 1.03, "diameter: 16 mm, material: hmpe", ""),
    rope_line("head_line", h, "diameter: 18 mm, material: hmpe", ""),
    rope_line("footrope", 1.02 * h, "diameter: 13 mm, material: steel_chain", ""),
    rope_line("side_lines", 0.95 * h, "diameter: 18 mm, material: hmpe", ""),
    "belly_lines: {hanging_ratio: 0.97, diameter: 18 mm, material: hmpe}",
    field_line(sprintf("hammers: {mass: %s kg, density: 7850 kg/m3, drag_area: 0.1 m2}",
      shortest_decimal(round(12 * h, -1))), "weights at the lower wing tips, one side"),
    field_line(sprintf("floats: {number: %d, buoyancy: 2.7 kgf, diameter: 200 mm}", round(h / 2)),
      "along the head line"),
    "",
    field_line("sections:", "counts of one panel, all four alike"),
    sections,
    sprintf("  codend: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$codend_mesh_size, last, last, round(0.4 * h / codend), twine_field(3, "PA", TRUE))
  )
  paste0(c(lines, ""), collapse = "\n")
}

# A line of a plan with a remark, in a column where there is room.
field_line <- function(field, remark) {
  if (!nzchar(remark)) return(field)
  paste0(formatC(field, width = -40, flag = " "), "  # ", remark)
}

rope_line <- function(name, length, of, remark) {
  field_line(sprintf("%s: {length: %s, %s}", name, metres(length), of), remark)
}

mouth_words <- function(name, length, bosom) {
  sprintf("%s: {length: %s, bosom: %s, diameter: 18 mm, material: combination_rope}", name,
    metres(length), metres(bosom))
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
