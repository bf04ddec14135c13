test_that("gear_si() fills in defaults and converts units", {
  si <- gear_si(read_text(small_plan))
  expect_identical(si$water$density, 1025)
  expect_identical(si$water$viscosity, 1.19e-6)
  expect_identical(si$water$current, data.frame(depth = 0, x = 0, y = 0))
  expect_identical(si$towing$speed, 0)
  expect_identical(si[c("netting", "slack_twine")], list(netting = "cells", slack_twine = "curved"))
  expect_identical(si$points$knot$load, c(0, 0, 0))
  net <- si$panels$net
  expect_equal(net$mesh_size, 0.1, tolerance = 1e-15)
  expect_identical(c(net$lost_left, net$lost_right), rep((net$upper - net$lower) / 2, 2))
  # the schema's default
  expect_equal(net$knot_diameter, 2 * net$twine_diameter, tolerance = 1e-15)
  node <- path_node(list(), "panels.any.knot_diameter")
  expect_match(schema_description(node$description), fixed = TRUE,
    "Default: twice the twine diameter")
  expect_null(net$bar_segments)
  expect_identical(net$added_mass, c(normal = 1, tangential = 0))
  expect_identical(net$coefficients,
    list(law = "constant", normal = 1.1, tangential = 0, skin = 0.02))
  expect_identical(si$seams$top$edges[[1]][[1]][c("panel", "edge")],
    list(panel = "net", edge = "upper"))
})

test_that("trawl warp has the mass and stiffness of steel wire", {
  si <- gear_si(read_text(spoil("20 mm\n    material: PA", "32 mm\n    material: steel_wire")))
  warp <- si$ropes$warp
  # 4.1 kg/m and 48 MN at 32 mm, to the digits of the table
  expect_equal(warp$mass_per_length, 4.1, tolerance = 1e-3)
  expect_equal(warp$axial_stiffness, 48e6, tolerance = 1e-3)
  expect_equal(warp$volume_per_length, 4.1 / 7850, tolerance = 1e-3)
})

test_that("explicit rope values override the material", {
  plan <- spoil("material: PA", "material: PA\n    axial_stiffness: 1 MN\n    mass_per_length: 1")
  warp <- gear_si(read_text(plan))$ropes$warp
  expect_identical(c(warp$axial_stiffness, warp$mass_per_length), c(1e6, 1))
  expect_equal(warp$volume_per_length, 1 / 1140, tolerance = 1e-15)
  plan <- spoil("material: PA", "axial_stiffness: 1 MN\n    mass_per_length: 1")
  warp <- gear_si(read_text(plan))$ropes$warp
  expect_equal(warp$volume_per_length, pi * 0.01^2, tolerance = 1e-15)
  expect_identical(warp$strength, NA_real_)
})

test_that("user-defined material is a solid circle", {
  plan <- spoil("material: PA", "material: rod")
  plan <- spoil("points:", "materials:\n  rod: {density: 2, modulus: 3 Pa, strength: 5}\npoints:",
    plan)
  warp <- gear_si(read_text(plan))$ropes$warp
  circle <- pi * 0.01^2
  expect_equal(
    unlist(warp[c("mass_per_length", "axial_stiffness", "strength", "volume_per_length")]),
    circle * c(2, 3, 5, 1), tolerance = 1e-14, ignore_attr = TRUE
  )
})

test_that("double twine has twice the mass, volume and stiffness", {
  one <- gear_si(read_text(small_plan))$panels$net
  two <- gear_si(read_text(spoil("twine: {", "twine: {double: yes, ")))$panels$net
  expect_identical(two$twine_count, 2)
  expect_identical(two$twine_diameter, one$twine_diameter)
  for (field in c("axial_stiffness", "mass_per_length", "volume_per_length")) {
    expect_identical(two[[field]], 2 * one[[field]])
  }
  expect_identical(gear_si(read_text(spoil("mesh_size",
    "knotted: no\n    mesh_size")))$panels$net$knot_diameter, 0)
})

test_that("edge length equals the shortest path along its twines", {
  # counted bar by bar: breadth-first search over the knots of the netting
  walk <- function(across, down, square) {
    steps <- if (square) {
      rbind(c(1, 0), c(-1, 0), c(0, 1), c(0, -1))
    } else {
      rbind(c(0.5, 0.5), c(-0.5, 0.5), c(0.5, -0.5), c(-0.5, -0.5))
    }
    front <- matrix(0, 1, 2)
    bars <- 0
    while (!any(front[, 1] == across & front[, 2] == down)) {
      front <- unique(do.call(rbind, lapply(1:4, function(k) sweep(front, 2, steps[k, ], `+`))))
      bars <- bars + 1
    }
    bars
  }
  for (square in c(FALSE, TRUE)) {
    for (lower in c(8, 4, 0)) {
      panel <- list(
        mesh_size = 0.2, upper = 8, lower = lower, deep = 3, lost_left = 8 - lower,
        lost_right = 0,
        orientation = if (square) "square" else "diamond"
      )
      expect_equal(edge_length(panel, "left"), 0.1 * walk(8 - lower, 3, square), tolerance = 1e-14)
      expect_equal(edge_length(panel, "right"), 0.1 * walk(0, 3, square), tolerance = 1e-14)
      expect_equal(edge_length(panel, "upper"), 0.1 * walk(8, 0, square), tolerance = 1e-14)
    }
  }
})

test_that("laced rope takes its length from the hanging ratio", {
  plan <- spoil(
    "panels:",
      paste0(
      "  line: {along: [\"-net.upper[2:10]\"], hanging_ratio: 45 %, diameter: 10 mm, ",
      "material: PE}\npanels:"
    )
  )
  line <- gear_si(read_text(plan))$ropes$line
  expect_equal(line$length, 0.45 * 8 * 0.1, tolerance = 1e-14)
  expect_identical(line$along[[1]],
    list(panel = "net", edge = "upper", from = 0.2, to = 1, reversed = TRUE))
})

test_that("currents become components by depth", {
  current <- paste0(
    "water:\n  current:\n    - {depth: 0, speed: 2, toward: 90 deg}\n",
    "    - {depth: 50 m, speed: 1, toward: 180 deg}\npoints:"
  )
  water <- gear_si(read_text(spoil("points:", current)))$water
  expect_equal(water$current, data.frame(depth = c(0, 50), x = c(0, -1), y = c(2, 0)),
    tolerance = 1e-15)
  wrong <- sub("depth: 50 m", "depth: 0", current)
  expect_plan_error("points:", wrong, "water.current", "from the surface down")
})

piece_si <- function(fields) {
  gear_si(read_text(spoil("seams:",
    paste0("pieces:\n  p: {at: knot, ", fields, "}\nseams:"))))$pieces$p
}

test_that("pieces have the mass, volume and areas of their fields", {
  weight <- piece_si("mass: 1 tonne, material: steel_chain")
  expect_equal(weight$volume, 1000 / 7850, tolerance = 1e-15)
  expect_equal(weight$added_mass, 0.5 * 1025 * 1000 / 7850, tolerance = 1e-15)
  expect_identical(c(weight$drag_area, weight$lift_area), c(0, 0))

  massless <- piece_si("buoyancy: 10 kgf")
  expect_equal(1025 * 9.81 * massless$volume, 98.0665, tolerance = 1e-14)

  float <- piece_si("buoyancy: 100 N, diameter: 300 mm, number: 4")
  expect_equal(float$volume, pi / 6 * 0.3^3, tolerance = 1e-14)
  expect_equal((1025 * float$volume - float$mass) * 9.81, 100, tolerance = 1e-12)
  expect_equal(float$drag_area, 0.47 * pi / 4 * 0.3^2, tolerance = 1e-14)
  expect_identical(float$number, 4)

  board <- piece_si(paste(
    "mass: 4000, area: 12 m2, drag_coefficient: 0.65, lift_coefficient: 1.4,",
    "lift_direction: port, added_mass_kg: 17.9 tonne"
  ))
  expect_equal(c(board$drag_area, board$lift_area), c(7.8, 16.8), tolerance = 1e-14)
  expect_identical(board$added_mass, 17900)
  expect_identical(board$lift_direction, "port")
})

test_that("measures are parsed into kinds and positions", {
  plan <- spoil("seams:", "measures:
  opening: {height: [ship, net.lower_left]}
  wing_spread: {spread: [[net.lower_left, net.lower_right], [net.upper_left, net.upper_right]]}
  warp_pull: {tension: warp.max}
  warp_angle: {angle: {warp.start: declination}}
  mouth: {area: [warp]}
  deep: {depth: warp.middle}
seams:")
  m <- gear_si(read_text(plan))$measures
  expect_identical(
    vapply(m, `[[`, "", "column", USE.NAMES = FALSE),
    c("opening_m", "wing_spread_m", "warp_pull_kN", "warp_angle_deg", "mouth_m2", "deep_m")
  )
  expect_length(m$wing_spread$pairs, 2)
  expect_identical(m$opening$pairs, list(list("ship", "net.lower_left")))
  expect_identical(m$warp_pull[c("rope", "place")], list(rope = "warp", place = "max"))
  expect_identical(m$warp_angle[c("rope", "place", "angle")],
    list(rope = "warp", place = "start", angle = "declination"))
  expect_plan_error(
    "[[net.lower_left, net.lower_right], [net.upper_left, net.upper_right]]",
    "[ship, knot, ship]", "measures.wing_spread.spread", "two positions, or a list of pairs",
      plan = plan
  )
})

test_that("coefficient sets are read by name and by number", {
  law <- function(text) gear_si(read_text(spoil("points:",
    paste0("coefficients: ", text, "\npoints:"))))$ropes$warp$coefficients
  expect_identical(law("wan"), list(law = "constant", normal = 1.3, tangential = 0, skin = 0))
  expect_identical(law("takagi")$law, "takagi")
  expect_identical(law("{normal: 1, skin: 0.5}"),
    list(law = "constant", normal = 1, tangential = 0, skin = 0.5))
})

test_that("each kind of gear has its default drag model", {
  law <- function(name) {
    gear <- update(read_gear(name), netting_drag = NULL)
    unique(vapply(gear_si(gear)$panels, `[[`, "", "netting_drag", USE.NAMES = FALSE))
  }
  expect_identical(
    vapply(c("midwater_trawl", "poly_noreastern_trawl", "pair_trawl", "beam_trawl", "stow_net",
      "cage", "gillnet", "purse_seine"), law, ""),
    c(midwater_trawl = "blended", poly_noreastern_trawl = "blended", pair_trawl = "blended",
      beam_trawl = "blended", stow_net = "morison", cage = "loland", gillnet = "morison",
      purse_seine = "morison")
  )
  # the paper's shipped trawl keeps the paper's twine-by-twine drag
  expect_identical(gear_si(read_gear("midwater_trawl"))$panels[[1]]$netting_drag, "morison")
})

test_that("`method: paper` overrides all other model choices", {
  explicit <- list(netting = "bars", netting_drag = "morison", coefficients = "hoerner",
    slack_twine = "straight", shielding = "none")
  # a short form with other choices
  trawl <- read_gear("poly_noreastern_trawl")
  si <- gear_si(update(trawl, method = "paper"))
  expect_identical(si[c("netting", "slack_twine")],
    list(netting = "bars", slack_twine = "straight"))
  for (panel in si$panels) {
    expect_identical(panel$netting_drag, "morison")
    expect_identical(panel$shielding, "none")
    expect_identical(panel$added_mass, c(normal = 1, tangential = 1))
  }
  expect_identical(si$panels[[1]]$coefficients, drag_model("hoerner"))
  expect_identical(si$ropes$headline$coefficients$law, drag_model("hoerner")$law)
  expect_false(identical(gear_si(trawl)$netting, "bars"))

  # the same shape as with each choice given, for massless knots
  panel <- read_gear("flat_panel")
  name <- names(panel$plan$panels)[1]
  panel <- do.call(update, c(list(panel),
    stats::setNames(list(FALSE, 2), paste0("panels.", name, c(".knotted", ".bar_segments")))))
  one <- settle(update(panel, method = "paper"), nodes = 150)
  each <- settle(do.call(update, c(list(panel), explicit)), nodes = 150)
  expect_equal(one$position, each$position, tolerance = 1e-7)
  expect_refused(update(trawl, method = "papers"), "method")
})

test_that("ball has the area of its circle across the flow", {
  ball <- gear_si(read_gear("midwater_trawl"))$pieces$floats
  expect_equal(ball$area, pi / 4 * ball$height^2)
})

test_that("piece with only a volume is as high as a cube", {
  expect_equal(piece_height(list(), 0.027), 0.3)
  expect_equal(piece_height(list(diameter = 0.2), 0.027), 0.2)
})
