# A codend of hexagonal netting with a catch, compared with AxiCodend, an axisymmetric model whose
# nodes are the ends of the real bars and knots. Our model is not axisymmetric: it has panels around
# the codend with triangles of netting.

codend_reference <- function(name) {
  utils::read.csv(test_path("reference", paste0("axicodend_t0_", name, ".csv")), comment.char = "#")
}

# The codend of `sides` panels next to each other, whose entrance is fixed on a circle; catch: the
# plan's fields of the catch.
codend_plan <- function(catch, sides = 50, rows = 100) {
  # Neutral twine, so that only the catch's pressure acts.
  net <- list(
    mesh_size = 0.144, meshes = list(upper = 100 / sides, lower = 100 / sides, deep = 100),
    orientation = "hexagonal", straight_bar = 0.012, knotted = FALSE,
    twine = list(diameter = 0.003, axial_stiffness = 1000,
      mass_per_length = 1025 * pi / 4 * 0.003^2),
    columns = 1, rows = rows
  )
  bag_plan(net, circle_of_corners(sides, 0.4), catch, coefficients = list(normal = 0))
}

# The plan defines its mesh; for so few nodes no coarser gear is solved first.
settle_codend <- function(...) settle(as_gear(codend_plan(...)), nodes = 400)

# x and mean radius of every row of nodes, and the area of its polygon.
codend_shape <- function(state) {
  nodes <- vapply(panels_of(state), function(panel) panel$grid[1, ],
    integer(ncol(panel_of(state, 1)$grid)))
  y <- matrix(state$position[2, nodes], nrow(nodes))
  z <- matrix(state$position[3, nodes], nrow(nodes))
  data.frame(
    x = rowMeans(matrix(state$position[1, nodes], nrow(nodes))), r = rowMeans(sqrt(y^2 + z^2)),
    area = vapply(seq_len(nrow(y)), function(k) abs(polygon_area(y[k, ], z[k, ])), 0)
  )
}

# The requirement for the codend is 0.5 %. Rows of one mesh on a radius of curvature of 0.7 m
# flatten it by (0.14 / 0.7)^2 / 24.
within <- 0.005

test_that("codend with 50 meshes blocked has AxiCodend's shape", {
  shape <- codend_shape(settle_codend(list(blocked_meshes = 50)))
  reference <- codend_reference("shape_50")
  expect_lt(max(abs(shape$x - reference$x_m)), within * max(reference$x_m))
  expect_lt(max(abs(shape$r - reference$r_m)), within * max(reference$r_m))
})

test_that("codend with automatic mesh has AxiCodend's catch", {
  plan <- codend_plan(list(blocked_meshes = 50), sides = 4)
  for (panel in names(plan$panels)) plan$panels[[panel]][c("columns", "rows")] <- NULL
  state <- settle(as_gear(plan))
  wanted <- codend_reference("metrics")[1, ]
  found <- measures(state)
  expect_lt(abs(1000 * found[["total_drag_kN"]] / wanted$catch_drag - 1), within)
  expect_lt(abs(found[["catch_volume_m3"]] / wanted$catch_volume - 1), within)
  expect_lt(abs(found[["catch_surface_m2"]] / wanted$catch_surface - 1), within)
})

test_that("codends filled to three quarters converge on different meshes", {
  volumes <- vapply(seq(50, 75, by = 5), function(blocked) {
    states <- list(
      settle_codend(list(blocked_meshes = blocked), sides = 16, rows = 30),
      settle_codend(list(blocked_meshes = blocked), sides = 20, rows = 50)
    )
    found <- vapply(states, function(state) measures(state)[["catch_volume_m3"]], 0)
    # polygons of 16 and 20 sides, rows of 3.3 and 2 meshes
    expect_lt(abs(found[1] / found[2] - 1), 0.01)
    found[2]
  }, 0)
  expect_true(all(diff(volumes) > 0))
})

test_that("catch drag equals its pressure times its front area", {
  for (blocked in c(30, 50.5)) {
    state <- settle_codend(list(blocked_meshes = blocked), sides = 20, rows = 50)
    shape <- codend_shape(state)
    # The front may cut through the rows: between rows the radius is linear and the area quadratic.
    area <- stats::approx(seq(100, 0, by = -2), sqrt(shape$area), blocked)$y^2
    pressure <- 0.5 * 1.4 * 1025 * 1.5^2
    # on the circle with the polygon's circumference
    pressure <- pressure * 20 * tan(pi / 20) / pi
    # the same sum over triangles in another order, and the solver's residual, 1e-8 of a tension
    expect_equal(1000 * measures(state)[["total_drag_kN"]], pressure * area, tolerance = 1e-7)
    expect_equal(as.data.frame(state, what = "drag")$drag_kN[21], pressure * area / 1000,
      tolerance = 1e-7)
  }
})

test_that("catch front follows from the volume, mass or blocked meshes", {
  by_meshes <- settle_codend(list(blocked_meshes = 40), sides = 16, rows = 30)
  volume <- measures(by_meshes)[["catch_volume_m3"]]
  by_volume <- settle_codend(list(volume = volume), sides = 16, rows = 30)
  by_mass <- settle_codend(list(mass = 1040 * volume, density = 1040), sides = 16, rows = 30)
  # The volume is met to a relative error of 1e-6, and grows at least like the meshes.
  expect_equal(measures(by_volume)[["catch_volume_m3"]], volume, tolerance = 1e-6)
  expect_equal(measures(by_volume)[["catch_front_meshes"]], 40, tolerance = 1e-5)
  expect_equal(by_mass$position, by_volume$position, tolerance = 1e-9)
  expect_refused(settle_codend(list(volume = 1000), sides = 16, rows = 30))
})

test_that("hexagonal netting settles again from its own state", {
  gear <- as_gear(codend_plan(list(blocked_meshes = 40), sides = 16, rows = 30))
  state <- settle(gear, nodes = 400)
  again <- settle(gear, nodes = 400, from = state)
  expect_lte(again$report$iterations, 3)
  # the solver's tolerance of 1e-8, for netting that deforms by a metre under its tension
  expect_equal(again$position, state$position, tolerance = 1e-6)
})

test_that("catch volume includes lengthwise curvature, and surface the netting's area", {
  # Half a ball. The chords of the rows along its 24 meridians sum to the length of the ball's
  # meridian, and its rows of nodes have the ball's circumference.
  ball <- function(rows) {
    mesh <- build_mesh(gear_si(as_gear(codend_plan(list(blocked_meshes = 100), sides = 24,
      rows = rows))))
    x <- start_of(mesh)
    for (panel in seq_along(panels_of(mesh))) {
      grid <- panel_of(mesh, panel)$grid
      t <- pi / 2 * (seq_len(ncol(grid)) - 1) / (ncol(grid) - 1)
      long <- (pi / 4 / rows) / sin(pi / 4 / rows)
      wide <- long * (pi / 24) / sin(pi / 24)
      for (side in 1:2) {
        angle <- 2 * pi * (panel - 2 + side) / 24
        x[, grid[side, ]] <- 2 *
          rbind(long * sin(t), wide * cos(t) * cos(angle), wide * cos(t) * sin(angle))
      }
    }
    catch_sizes(mesh, x) / c(16 / 3 * pi, 8 * pi) - 1
  }
  # the volume error has fourth order in the rows' angle
  for (rows in c(12, 24)) expect_lt(abs(ball(rows)[1]), (pi / 2 / rows)^4 + 1e-5)
  # a flat strip is shorter than its sides by cos(pi / 24) at most
  expect_lt(abs(ball(24)[2]), 1 - cos(pi / 24))
})

test_that("catch volume equals the solid behind its front", {
  # A cone of 16 sides from its open end at x = 0 to its tip, cut by a plane: pieces of triangles.
  mesh <- build_mesh(gear_si(as_gear(codend_plan(list(blocked_meshes = 37.3), sides = 16,
    rows = 7))))
  x <- start_of(mesh)
  for (panel in seq_along(panels_of(mesh))) {
    grid <- panel_of(mesh, panel)$grid
    t <- (seq_len(ncol(grid)) - 1) / (ncol(grid) - 1)
    for (side in 1:2) {
      angle <- 2 * pi * (panel - 2 + side) / 16
      x[, grid[side, ]] <- rbind(3 * t, (1 - t) * cos(angle), (1 - t) * sin(angle))
    }
  }
  # the circle with the circumference of 16 sides
  base <- (16 * 2 * sin(pi / 16))^2 / (4 * pi)
  # a similar cone of 37.3 % of the length; rounding
  expect_equal(catch_volume(mesh, x), 0.373^3 * base * 3 / 3, tolerance = 1e-12)
  expect_equal(catch_volume(set_catch_front(mesh, 100), x), base * 3 / 3, tolerance = 1e-12)
})

test_that("codend of stiff meshes is equal with bars and cells", {
  # the shipped codend, without its fixed mesh
  gear <- read_gear("t90_codend")
  for (panel in names(gear$plan$panels)) gear$plan$panels[[panel]][c("columns", "rows")] <- NULL
  gear <- as_gear(unclass(gear$plan))
  found <- lapply(c(bars = "bars", cells = "cells"), function(netting) {
    measures(settle(gear, nodes = 4000, netting = netting))
  })
  # the two discretisations must agree to 1 %
  for (name in c("length_m", "catch_volume_m3", "total_drag_kN")) {
    expect_lt(abs(found$bars[[name]] / found$cells[[name]] - 1), 0.01, label = name)
  }
})
