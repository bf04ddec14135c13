# A small bottom trawl in the short form; `...` replaces fields.
small_bottom_trawl <- function(panels = 2, ...) {
  twine <- list(diameter = "3 mm", material = "PE")
  wing <- function(deep, base, flying = 0) {
    list(mesh_size = "100 mm", meshes = list(tip = 8, base = base, deep = deep), flying = flying,
      twine = twine)
  }
  wire <- function(length) list(length = length, diameter = "12 mm", material = "steel_wire")
  fields <- list(
    panels = panels, towing = list(speed = "3 knot"),
    seabed = list(depth = "40 m", friction = 0.5),
    warps = c(wire("140 m"), list(spacing = "4 m")),
    otter_boards = list(area = "1 m2", mass = "250 kg", density = "7850 kg/m3",
      lift_coefficient = 1.2, drag_coefficient = 0.6),
    sweeps = wire("20 m"), bridles = list(upper = wire("10 m"), lower = wire("10 m")),
    headline = list(length = "17 m", bosom = "4 m", diameter = "14 mm", material = "PE"),
    footrope = list(length = "20 m", bosom = "3 m", diameter = "12 mm", material = "steel_wire"),
    ground_gear = list(length = "20 m", diameter = "60 mm", mass_in_water = "6 kg/m",
      axial_stiffness = "8 MN"),
    side_lines = list(hanging_ratio = 0.8, diameter = "10 mm", material = "PE"),
    floats = list(number = 27L, buoyancy = "2.5 kgf", diameter = "200 mm"),
    wings = list(upper = wing(60, 30), lower = wing(80, 40)),
    square = list(mesh_size = "100 mm", meshes = list(upper = 150, lower = 140, deep = 20),
      twine = twine),
    sections = list(
      body = list(mesh_size = "100 mm", meshes = list(upper = 140, lower = 50, deep = 90),
        twine = twine),
      codend = list(mesh_size = "80 mm", meshes = list(upper = 60, lower = 60, deep = 60),
        twine = twine)
    )
  )
  if (panels == 4) {
    fields$wings$side <- list(mesh_size = "100 mm",
      meshes = list(upper = 30, lower = 40, deep = 80), twine = twine)
    fields$sections$body$side <- list(meshes = list(upper = 40, lower = 30, deep = 90))
    fields$sections$codend$side <- list(meshes = list(upper = 40, lower = 40, deep = 60))
  }
  given <- list(...)
  fields[names(given)] <- given
  do.call(gear, c(list(name = "Small bottom trawl", kind = "bottom_trawl"),
    Filter(Negate(is.null), fields)))
}

test_that("ground gear with mass in water has the mass of steel", {
  si <- gear_si(small_bottom_trawl())
  rope <- si$ropes[[which(vapply(si$ropes, `[[`, "", "role") == "ground_gear")]]
  expect_equal(rope$mass_per_length, 6 * 7850 / (7850 - 1025))
  expect_equal(rope$mass_per_length - si$water$density * rope$volume_per_length, 6)
})

test_that("bottom trawls of 2 and 4 panels settle symmetrically", {
  for (panels in c(2, 4)) {
    trawl <- small_bottom_trawl(panels)
    state <- settle(trawl, nodes = 400)
    found <- measures(state)
    expect_equal(found[["warp_tension_port_kN"]], found[["warp_tension_starboard_kN"]],
      tolerance = 1e-6)
    expect_gt(found[["door_spread_m"]], found[["wing_end_spread_m"]])
    expect_gt(found[["net_mouth_height_m"]], 0.3)
    # the discs of 60 mm carry the footrope, with a penetration of some millimetres
    expect_gt(found[["footrope_height_m"]], 0.02)
    expect_lt(found[["footrope_height_m"]], 0.03)
    expect_equal(
      found[["headline_height_m"]] - found[["footrope_height_m"]], found[["net_mouth_height_m"]]
    )
    expect_identical(settle(assembly(trawl), nodes = 400)$position, state$position)
  }
})

test_that("bottom trawl with jib and middle bridle has four-bridled wing ends", {
  wings <- list(
    upper = list(mesh_size = "100 mm", meshes = list(tip = 0, base = 30, deep = 80), flying = 20,
      twine = list(diameter = "3 mm", material = "PE")),
    lower = list(mesh_size = "100 mm", meshes = list(tip = 0, base = 40, deep = 80), flying = 15,
      twine = list(diameter = "3 mm", material = "PE")),
    side = list(mesh_size = "100 mm", meshes = list(upper = 30, lower = 40, deep = 65),
      twine = list(diameter = "3 mm", material = "PE")),
    jib = list(deep = 40)
  )
  wire <- list(length = "10 m", diameter = "12 mm", material = "steel_wire")
  trawl <- small_bottom_trawl(4, wings = wings,
    bridles = list(upper = wire, middle = wire, lower = wire),
    footrope_extensions = modifyList(wire, list(length = "3 m")))
  found <- measures(settle(trawl, nodes = 400))
  expect_true(is.finite(found[["bridle_middle_tension_kN"]]))
  ropes <- assembly(trawl)$plan$ropes
  # Square and upper wings reach 15 meshes further forward than the side wings. That length of the
  # jib is joined to them; the other part is free.
  expect_identical(ropes$side_line_starboard$along, c(
    "back_wing_right.right[0:20]", "-side_starboard_jib.left[0:25]", "side_starboard_jib.right",
    "-belly_wing_left.left[0:15]"
  ))
})

test_that("bottom trawl towed from two points keeps their distance", {
  rig <- update(small_bottom_trawl(), warps = NULL, otter_boards = NULL,
    towing_points = list(spread = "22 m", height = "1 m"))
  state <- settle(rig, nodes = 400)
  expect_equal(measures(state)[["door_spread_m"]], 22)
  expect_setequal(summary(state)$reactions$point, c("board_port", "board_starboard"))
  expect_equal(unname(state$position[3, nodes_at(state, "board_port")]), -39)
})

test_that("free boards tow sweeps by their backstrops", {
  place <- function(aft, inward, up) {
    list(aft = paste(aft, "m"), inward = paste(inward, "m"), up = paste(up, "m"))
  }
  boards <- list(attitude = "free", chord = "1 m", span = "1.5 m", mass = "250 kg",
    density = "7850 kg/m3", polar = "low_aspect_cambered", warp_at = place(0.3, 0.25, 0.1),
    upper_backstrop_at = place(0.85, 0.05, 0.5), lower_backstrop_at = place(0.85, 0.05, -0.5))
  backstrops <- list(length = "2.5 m", diameter = "12 mm", material = "steel_wire")
  trawl <- small_bottom_trawl(otter_boards = boards, backstrops = backstrops)
  # boards this small may stall or fall over with such a large net
  state <- suppressWarnings(settle(trawl, nodes = 400))
  tension <- tapply(state$bar_tension, parts_of(state)$name[part_of(state, "bar")], max)
  pulled <- c("backstrop_upper_port", "backstrop_lower_port")
  expect_gt(sum(tension[pulled]), tension[["sweep_port"]])
  expect_lt(max(tension[pulled]), tension[["sweep_port"]])
  expect_refused(small_bottom_trawl(otter_boards = boards), "backstrops")
})

test_that("pair trawl spreads with the distance of the vessels", {
  trawl <- read_gear("pair_trawl")
  near <- measures(settle(update(trawl, vessels.distance = "80 m"), nodes = 400))
  far <- measures(settle(update(trawl, vessels.distance = "160 m"), nodes = 400))
  expect_gt(far[["wing_end_spread_m"]], near[["wing_end_spread_m"]])
  expect_lt(far[["net_mouth_height_m"]], near[["net_mouth_height_m"]])
  expect_equal(far[["warp_tension_port_kN"]], far[["warp_tension_starboard_kN"]], tolerance = 1e-6)
  off <- measures(settle(update(trawl, seabed = NULL), nodes = 400))
  expect_false("headline_height_m" %in% names(off))
  expect_gt(off[["headline_depth_m"]], 10)
  expect_refused(update(trawl, vessels = NULL), "`vessels` is missing")
  expect_refused(update(trawl, otter_boards.area = 2), "otter_boards")
})

test_that("rope with lengths by edge is hung edge by edge", {
  trawl <- small_bottom_trawl()
  state <- settle(trawl, nodes = 400)
  bars <- elements_of(state, "bar", "headline")
  expect_equal(sum(engine_array(state, "bars", "rest")[bars]), 17)
  at <- along_rope(state, "headline")$at * 17
  # the bosom runs between the wings' bases, 6.5 m from each end
  expect_true(any(abs(at - 6.5) < 1e-9) && any(abs(at - 10.5) < 1e-9))
  expect_refused(
    gear("x", top = gear_point(position = c(0, 0, 0), held = "fixed"),
      net = netting_panel(mesh_size = 0.1, meshes = list(upper = 10, lower = 10, deep = 10),
        twine = list(diameter = 0.002, material = "PE")),
      hung = seam(edges = "net.upper", gathered_at = "top"),
      line = rope(along = "net.lower", lengths = c(0.3, 0.4), diameter = 0.01, material = "PE")),
    "ropes.line.lengths.*each of the 1 edges"
  )
})

test_that("pointed panel ends in one node, gathered or not", {
  twine <- list(diameter = 0.002, material = "PE")
  tip <- gear("x",
    top = gear_point(position = c(0, 0, 0), held = "moved"),
      end = gear_point(at = "net.upper_left"),
    line = rope("top", "end", length = 5, diameter = 0.01, material = "PE"),
    net = netting_panel(mesh_size = 0.1, meshes = list(upper = 0, lower = 40, deep = 40),
      twine = twine),
    towing = list(speed = 1))
  for (netting in c("cells", "bars")) {
    state <- settle(tip, nodes = 100, netting = netting)
    used <- c(
      engine_array(state, "bars", "node"), engine_array(state, "cells", "node"),
      engine_array(state, "ties", "first"), engine_array(state, "ties", "second")
    )
    expect_true(all(seq_len(engine_array(state, "nodes")) %in% used), label = netting)
  }
})
