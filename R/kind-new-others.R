# Plans of other gear to begin with, from a few numbers: of a beam trawl all of its text, of others
# the fields of the shipped plan that go with the size.

# Text of a beam trawl. The pipe is as thick as its bending needs; given: SI numbers of
# `new_plan()`.
new_beam_trawl <- function(given) {
  x <- given$beam / 4
  m <- given$mesh_size
  codend <- given$codend_mesh_size
  meshes <- function(length) max(2, round(length * x / m))
  height <- 0.6 * x^0.3
  pipe <- 0.16 * x^0.6
  wall <- pipe / 16
  section <- pi * (pipe - wall) * wall
  twine <- function(share, mesh, double = FALSE) {
    twine_field(round(max(1.2, min(share * 4 * x^0.3, 100 * mesh)), 1), "PE", double)
  }
  tickler <- function(k, length, diameter) {
    sprintf("  tickler_%d: {length: %s, diameter: %s, material: steel_chain}", k,
      metres(length * x, 0.1), millimetres(max(6, diameter * x^0.4)))
  }
  number <- function(value) shortest_decimal(signif(value, 3))
  lines <- c(
    "# A beam trawl to begin with. Its proportions are usual, none is of a tested gear: put in",
    "# your own numbers, line by line.",
    "codend: 1",
    "kind: beam_trawl",
    sprintf("name: Beam trawl, %s", given$shown$beam),
    field_line(sprintf("towing: {speed: %s}", given$shown$speed), "through the water"),
    field_line(sprintf("seabed: {depth: %s, friction: 0.5}", given$shown$depth),
      "sand; 0.3 mud, 0.7 stones"),
    field_line(sprintf("warp: {length: %s, diameter: %s, material: steel_wire}",
      metres(3 * given$depth + 10, 5), millimetres(max(8, 18 * x^0.6))), "3 x depth + 10 m"),
    "bridles:",
    sprintf("  outer: {length: %s, diameter: %s, material: steel_chain}", metres(6 * x, 0.05),
      millimetres(max(6, 16 * x^0.5))),
    sprintf("  middle: {length: %s, diameter: %s, material: steel_chain}", metres(5.9 * x, 0.05),
      millimetres(max(6, 16 * x^0.5))),
    field_line("beam:", "a steel pipe, closed at its ends"),
    sprintf("  length: %s", given$shown$beam),
    sprintf("  diameter: %s", millimetres(1000 * pipe)),
    field_line(sprintf("  bending_stiffness: %s MN m2",
      number(210e3 * section * (pipe - wall)^2 / 8)), "of 210 GPa"),
    sprintf("  axial_stiffness: %s MN", number(210e3 * section)),
    sprintf("  mass_per_length: %s kg/m", number(7850 * section)),
    sprintf("  volume_per_length: %s m2", number(pi / 4 * pipe^2)),
    "shoes:",
    sprintf("  {height: %s, length: %s, mass: %s kg, density: 7850 kg/m3, area: %s m2,",
      metres(height, 0.01), metres(0.8 * x^0.3, 0.01), number(300 * x^1.2),
      number(0.1 * x^0.6)),
    "  drag_coefficient: 1.2}",
    "ticklers:",
    tickler(1, 5, 16), tickler(2, 6, 16), tickler(3, 7, 13),
    sprintf("head_line: {length: %s, diameter: %s, material: PE}", metres(4.4 * x, 0.1),
      millimetres(max(10, 20 * x^0.4))),
    sprintf("footrope: {length: %s, bosom: %s, diameter: %s, material: steel_chain}",
      metres(9 * x, 0.1), metres(1.2 * x, 0.1), millimetres(max(6, 12 * x^0.4))),
    field_line(sprintf(
      "ground_gear: {length: %s, diameter: %s, mass_in_water: %s kg/m, axial_stiffness: 10 MN}",
      metres(9 * x, 0.1), millimetres(80 * x^0.3), number(8 * x^0.4)), "rubber discs"),
    "side_lines: {hanging_ratio: 0.85, diameter: 12 mm, material: PE}",
    "",
    "wings:",
    sprintf("  lower: {mesh_size: %s, meshes: {tip: %d, base: %d, deep: %d}, %s}",
      given$shown$mesh_size, max(2, round(1.35 * height / m)), meshes(2.8), meshes(4), twine(1, m)),
    sprintf("square: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$mesh_size, meshes(10), meshes(9), meshes(4), twine(1, m)),
    field_line("sections:", "counts of one panel"),
    sprintf("  body: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$mesh_size, meshes(9), meshes(4.5), meshes(5), twine(1, m)),
    sprintf("  codend: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s}",
      given$shown$codend_mesh_size, round(4.4 * x / codend), round(4.4 * x / codend),
      round(3.6 * x^0.5 / codend), twine(0.75, codend / 2, TRUE))
  )
  paste0(c(lines, ""), collapse = "\n")
}

# Fields by path, from SI numbers and the shipped plan. Anchors of a cage lie three times as deep
# as its net, and its moorings have 2 % more than the straight way from the collar.
scaled_cage <- function(si, plan) {
  x <- si$diameter / 40
  deep <- max(50, 3 * si$depth)
  reach <- 1.8 * deep
  list(
    name = sprintf("Net cage, %s across", si$shown$diameter),
    diameter = si$shown$diameter, depth = si$shown$depth,
    wall.mesh_size = si$shown$mesh_size,
    wall.twine.diameter = millimetres_of(max(0.8, 50 * si$mesh_size)),
    water.current.speed = si$shown$current,
    bottom.cone = metres(0.15 * si$diameter),
    centre_weight.mass = kilograms(100 * x^2),
    collar.diameter = millimetres(640 * x^0.5),
    collar.mass_per_length = kilograms(66 * x, "kg/m"),
    collar.axial_stiffness = paste(shortest_decimal(signif(54 * x, 3)), "MN"),
    collar.bending_stiffness = paste(shortest_decimal(signif(1.2 * x^2, 3)), "MN m2"),
    moorings.length = metres(1.02 * sqrt(reach^2 + deep^2)),
    moorings.reach = metres(reach), moorings.anchor_depth = metres(deep)
  )
}

# A gillnet hung by 0.5: its float line lifts in proportion to its height, its lead line too.
scaled_gillnet <- function(si, plan) {
  tall <- si$height / 3.2
  # as the shipped one lifts 0.066 kg/m
  area <- (0.066 * tall + 0.05) / 1025
  weight <- 0.2 * tall
  list(
    name = sprintf("Gillnet, %s by %s", si$shown$length, si$shown$height),
    length = si$shown$length, seabed.depth = si$shown$depth,
    water.current.speed = si$shown$current,
    wall.mesh_size = si$shown$mesh_size,
    wall.meshes.across = round(2 * si$length / si$mesh_size),
    wall.meshes.deep = max(2, round(si$height / sqrt(0.75) / si$mesh_size)),
    wall.twine.diameter = millimetres_of(max(0.15, 4 * si$mesh_size)),
    float_line.diameter = millimetres_of(1000 * sqrt(4 / pi * area)),
    lead_line.mass_per_length = kilograms(weight, "kg/m"),
    lead_line.volume_per_length = paste(shortest_decimal(signif(weight / 2530 * 1e6, 3)), "mm2"),
    anchors.apart = metres(si$length + 18)
  )
}

scaled_longline <- function(si, plan) {
  list(
    name = sprintf("Pelagic longline, %d baskets", as.integer(round(si$baskets))),
    baskets = round(si$baskets), branch_lines.number = round(si$branch_lines),
    main_line.length = si$shown$main_line, branch_lines.length = si$shown$branch_line
  )
}

# A purse seine hung by 0.75, in thirds of the shipped one: bunt a tenth, body six, wing three.
scaled_purse_seine <- function(si, plan) {
  across <- si$length / 0.75 / si$mesh_size
  deep <- max(4, round(si$depth / si$mesh_size))
  x <- si$length / 300
  # the same lift and weight of a metre for its depth
  tall <- si$depth / 50
  share <- c(bunt = 0.1, body = 0.6, wing = 0.3)
  meshes <- unlist(lapply(names(share), function(panel) {
    count <- round(share[[panel]] * across)
    stats::setNames(list(count, count, deep),
      paste0("panels.", panel, ".meshes.", c("upper", "lower", "deep")))
  }), recursive = FALSE)
  mesh <- stats::setNames(rep(list(si$shown$mesh_size), 3L),
    paste0("panels.", names(share), ".mesh_size"))
  rope <- function(diameter) millimetres_of(diameter * sqrt(x * tall))
  c(
    list(name = sprintf("Purse seine, %s", si$shown$length)), mesh, meshes,
    list(
      float_line.length = si$shown$length, lead_line.length = metres(1.05 * si$length),
      floats.number = max(2, round(4 * si$length)),
      floats.buoyancy = paste(shortest_decimal(round(6.5 * tall, 2)), "N"),
      floats.diameter = millimetres_of(120 * tall^0.4),
      sinkers.number = max(2, round(16 / 3 * si$length)),
      sinkers.mass = kilograms(0.2 * tall),
      rings.number = max(4, round(si$length / 7.5)),
      float_line.diameter = rope(10), lead_line.diameter = rope(10),
      purse_wire.length = metres(1.5 * si$length), purse_wire.diameter = rope(22),
      end_ropes.diameter = rope(16)
    )
  )
}

# A stow net whose netting is as loose as the shipped one's, and beams that carry it.
scaled_stow_net <- function(si, plan) {
  wide <- si$width / 8
  tall <- si$height / 5
  x <- sqrt(wide * tall)
  middle <- sqrt(si$mesh_size * si$codend_mesh_size)
  counts <- function(section, mesh, upper, lower, deep) {
    count <- function(length, by) max(2, round(length * by / mesh))
    stats::setNames(
      list(count(upper, wide), count(lower, wide), count(deep, x), count(upper * 5 / 8, tall),
        count(lower * 5 / 8, tall), count(deep, x)),
      paste0("sections.", section, c(".meshes.upper", ".meshes.lower", ".meshes.deep",
        ".side.meshes.upper", ".side.meshes.lower", ".side.meshes.deep"))
    )
  }
  beam <- function(name, mass) {
    stats::setNames(
      list(millimetres(140 * x^0.7), kilograms(mass * x^1.2, "kg/m"),
        paste(shortest_decimal(signif(0.5 * x^2.8, 3)), "MN m2")),
      paste0(name, c(".diameter", ".mass_per_length", ".bending_stiffness"))
    )
  }
  rope <- function(diameter) millimetres_of(diameter * x)
  c(
    list(
      name = sprintf("Stow net, mouth %s by %s", si$shown$width, si$shown$height),
      mouth.width = si$shown$width, mouth.height = si$shown$height,
      water.current.speed = si$shown$current,
      bridles.length = metres(15 * wide), bridles.diameter = rope(20),
      anchor_line.diameter = rope(28), side_lines.diameter = rope(20),
      anchor_depth = metres(max(15, 3 * si$height)),
      floats.buoyancy = paste(shortest_decimal(signif(30 * x^2.2, 3)), "kgf"),
      floats.diameter = millimetres(450 * x^0.75),
      sections.front.mesh_size = si$shown$mesh_size,
      sections.middle.mesh_size = shown_mesh_size(round(middle, 3)),
      sections.codend.mesh_size = si$shown$codend_mesh_size
    ),
    beam("upper_beam", 13), beam("lower_beam", 30),
    counts("front", si$mesh_size, 16, 10, 6), counts("middle", round(middle, 3), 10, 4.8, 6.4),
    counts("codend", si$codend_mesh_size, 4.8, 4.8, 4.8)
  )
}

millimetres_of <- function(x) paste(shortest_decimal(signif(x, 2)), "mm")

kilograms <- function(mass, unit = "kg") paste(shortest_decimal(signif(mass, 2)), unit)
