# Edges fixed on a line and pieces from end to end, compared with values by hand.

# Two panels next to each other on one beam, of 30 and 10 meshes, in air.
beam_plan <- function(netting, orientation = "diamond") {
  panel <- function(upper) {
    list(
      mesh_size = 0.1, meshes = list(upper = upper, lower = upper, deep = 12),
      orientation = orientation,
      twine = list(diameter = 0.002, axial_stiffness = 1e3, mass_per_length = 0.01)
    )
  }
  list(
    codend = 1, name = "Panels on a beam", netting = netting, water = list(density = 0),
    points = list(
      port = list(position = c(1, -1, 5), held = "fixed"),
      starboard = list(position = c(2, 1, 6), held = "fixed"),
      corner = list(at = "small.lower_right", load = c(0, 0, -20))
    ),
    panels = list(large = panel(30), small = panel(10)),
    seams = list(
      beam = list(
        edges = list(list("large.upper", "small.upper")), held_between = c("port", "starboard")
      ),
      middle = list(edges = list("large.right", "small.left"))
    )
  )
}

test_that("meshes are distributed evenly along a beam in both nettings", {
  for (netting in c("cells", "bars")) {
    si <- gear_si(as_gear(beam_plan(netting)))
    mesh <- build_mesh(si, nodes = 400)
    edge <- held_edge_of(mesh, "beam")
    expect_identical(sum(engine_array(mesh, "held")), length(edge$node))
    expect_identical(edge$node[c(1, length(edge$node))], nodes_at(mesh, c("port", "starboard")))
    # 30 and 10 meshes: the corner between the panels is at three quarters
    corner <- nodes_at(mesh, "small.upper_left")
    expect_equal(edge$at[edge$node == corner], 0.75, tolerance = 1e-12)
    expect_equal(
      start_of(mesh)[, edge$node], c(1, -1, 5) + outer(c(1, 2, 1), edge$at), tolerance = 1e-12
    )
    expect_gt(length(edge$node), 8)
  }
})

test_that("beam points carry the netting's load and moments", {
  for (netting in c("cells", "bars")) {
    state <- settle(as_gear(beam_plan(netting)), nodes = 200)
    reactions <- as.data.frame(state, what = "reactions")
    expect_identical(reactions$point, c("port", "starboard"))
    pull <- 1000 * t(as.matrix(reactions[c("x_kN", "y_kN", "z_kN")]))
    at <- cbind(c(1, -1, 5), c(2, 1, 6))
    weight <- 9.81 * c(engine_array(state, "mass"))
    # 40 meshes across, 12 deep: 4 bars of 50 mm and 2 knots each, of 16 diameters of 2 mm, 10 g/m
    expect_equal(sum(weight), 9.81 * 40 * 12 * (4 * 0.05 + 2 * 16 * 0.002) * 0.01,
      tolerance = 1e-12)
    points <- state_points(state)
    moment <- function(r, f) {
      rowSums(rbind(
        r[2, ] * f[3, ] - r[3, ] * f[2, ], r[3, ] * f[1, ] - r[1, ] * f[3, ],
        r[1, ] * f[2, ] - r[2, ] * f[1, ]
      ))
    }
    corner <- state$position[, nodes_at(state, "corner"), drop = FALSE]
    arms <- cbind(at, points, corner)
    forces <- cbind(pull, rbind(0, 0, -weight), c(0, 0, -20))
    # 1e-8 of a tension of about 10 N on about 200 nodes, with arms of about 5 m
    expect_lt(max(abs(rowSums(forces))), 1e-4)
    expect_lt(max(abs(moment(arms, forces))), 5e-4)
  }
})

test_that("frame fixes all four edges and leaves the inside free", {
  at <- function(y, z) list(position = c(0, y, z), held = "moved")
  frame <- as_gear(list(
    codend = 1, name = "Netting on a frame", towing = list(speed = 1),
    points = list(a = at(-0.5, 0), b = at(0.5, 0), c = at(-0.5, -1), d = at(0.5, -1)),
    panels = list(net = list(
      mesh_size = 0.1, meshes = list(upper = 20, lower = 20, deep = 20), orientation = "square",
      # neutral in water
      twine = list(diameter = 0.002, axial_stiffness = 4000, mass_per_length = 1025 * pi * 0.001^2),
      knotted = FALSE, netting = "bars", columns = 8, bar_segments = 1
    )),
    seams = list(
      upper = list(edges = list("net.upper"), held_between = c("a", "b")),
      lower = list(edges = list("net.lower"), held_between = c("c", "d")),
      left = list(edges = list("net.left"), held_between = c("a", "c")),
      right = list(edges = list("net.right"), held_between = c("b", "d"))
    )
  ))
  state <- settle(frame)
  expect_identical(sum(engine_array(state, "held")), 32L)
  remainder <- utils::tail(balance_table(state), 1)
  # kN: 1e-8 of a tension of about 10 N on 49 free knots
  expect_lt(max(abs(remainder[-1])), 1e-8)
  # a square frame across the flow: each corner carries a quarter
  pull <- as.data.frame(state, what = "reactions")$x_kN
  expect_equal(pull, rep(sum(pull) / 4, 4), tolerance = 1e-6)
})

test_that("check rejects a beam through a fixed position", {
  plan <- beam_plan("cells")
  plan$points$post <- list(at = "small.upper_left", position = c(0, 0, 5), held = "fixed")
  error <- tryCatch(settle(as_gear(plan)), codend_error_plan = identity)
  expect_s3_class(error, "codend_error_plan")
  expect_identical(error$path, "seams.beam.held_between")
  expect_match(conditionMessage(error), "held already", fixed = TRUE)
})

test_that("pieces with `end_to_end` are placed at both ends and evenly between", {
  chain <- function(number, share = NULL) {
    si <- gear_si(gear("Floats",
      port = gear_point(c(0, -1, 0), "fixed"), starboard = gear_point(c(0, 1, 0), "fixed"),
      line = rope("port", "starboard", length = 3, diameter = 0.01, axial_stiffness = 1e5,
        mass_per_length = 0, segments = 6),
      floats = piece(along = "line", extent = share, number = number, end_to_end = TRUE,
        mass = 2, drag_area = 0.1)
    ))
    mesh <- build_mesh(si)
    drag_area <- engine_array(mesh, "spheres", "drag_area")
    expect_equal(sum(drag_area), 0.1 * number, tolerance = 1e-14)
    engine_array(mesh, "mass")[along_rope(mesh, "line")$node]
  }
  expect_equal(chain(7), rep(2, 7), tolerance = 1e-14)
  expect_equal(chain(2), c(2, 0, 0, 0, 0, 0, 2), tolerance = 1e-14)
  # at 0, 1.5, 3, 4.5 and 6 of six segments
  expect_equal(chain(5), c(2, 1, 1, 2, 1, 1, 2), tolerance = 1e-14)
  # at 2, 2.5 and 3 of six segments
  expect_equal(chain(3, c(1 / 3, 1 / 2)), c(0, 0, 3, 3, 0, 0, 0), tolerance = 1e-14)
})

test_that("knotted netting has the published weight with both netting elements", {
  # J. Prado and P. Y. Dremiere, Fisherman's Workbook (FAO 1990): ratio of the weight to knotless
  # netting, by mesh size (mm) and twine diameter (mm), two decimals
  published <- data.frame(
    mesh = c(20, 50, 100, 120, 200, 400), twine = c(0.25, 2, 1, 4, 3, 4),
    ratio = c(1.20, 1.64, 1.16, 1.53, 1.24, 1.16)
  )
  plan <- function(mesh, twine, knotted, orientation = "diamond") {
    as_gear(list(
      codend = 1, name = "Netting", panels = list(net = list(
        mesh_size = mesh / 1000, meshes = list(upper = 40, lower = 30, deep = 20),
        twine = list(diameter = twine / 1000, material = "polyethylene"), knotted = knotted,
        orientation = orientation
      )), points = list(nail = list(at = "net.upper_left", position = c(0, 0, 0), held = "fixed"))
    ))
  }
  mass <- function(gear, netting) sum(build_mesh(gear_si(gear), 300, netting)$model$mass)
  for (netting in c("bars", "cells")) {
    ratio <- mapply(function(mesh, twine) {
      mass(plan(mesh, twine, TRUE), netting) / mass(plan(mesh, twine, FALSE), netting)
    }, published$mesh, published$twine)
    # published values are rounded to 0.01
    expect_lt(max(abs(ratio - published$ratio)), 0.0051)
  }
  # square meshes have one knot per two bars, as diamonds have
  square <- function(knotted) mass(plan(50, 2, knotted, "square"), "bars")
  expect_equal(square(TRUE) / square(FALSE), 1 + 16 * 2 / 50, tolerance = 1e-10)
})
