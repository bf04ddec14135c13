# Parts that leave the water at its surface lose buoyancy and drag.

test_that("float swims at the draught of its load", {
  state <- settle(gear("float",
    anchor = gear_point(position = c(0, 0, -10), held = "fixed"), at_float = gear_point(),
    line = rope("anchor", "at_float", length = "14 m", diameter = "6 mm", material = "polyamide"),
    float = piece(at = "at_float", mass = "5 kg", diameter = "300 mm"),
    water = list(free_surface = TRUE, current = list(speed = "0.4 m/s", toward = "0 deg"))
  ), nodes = 60)
  at <- state$position[3, nodes_at(state, "at_float")]
  # Volume of a spherical cap of height h below the surface, by the sphere's radius.
  h <- 0.15 - at
  carried <- 1025 * gear_gravity * pi * h^2 * (3 * 0.15 - h) / 3
  down <- summary(state)$balance
  weight <- down$z_kN[down$force == "weight_in_water"] * 1000
  full <- 1025 * gear_gravity * pi / 6 * 0.3^3
  lost <- -1000 * down$z_kN[down$force == "out_of_water"]
  # Also the line's last half element, 0.12 m of 6 mm: 0.03 N of 88 N.
  expect_equal(lost, full - carried, tolerance = 5e-4)
  # It carries its own weight and the line's pull, so it swims slightly deeper than alone.
  excess <- function(h) 1025 * pi * h^2 * (3 * 0.15 - h) / 3 - 5
  alone <- uniroot(excess, c(0, 0.3), tol = 1e-12)$root
  expect_gt(h, alone)
  expect_lt(h, 0.3)
  expect_lt(abs(down$z_kN[down$force == "remainder"]), 1e-9)
})

test_that("drag decreases with the immersed part", {
  rope_at <- function(height, free) {
    state <- settle(gear("a bar",
      a = gear_point(position = c(0, 0, height), held = "fixed"),
      b = gear_point(position = c(0, 1, height), held = "fixed"),
      bar = rope("a", "b", length = "1 m", diameter = "60 mm", axial_stiffness = "1 MN",
        mass_per_length = "3 kg/m", segments = 1),
      water = list(free_surface = free, current = list(speed = "1 m/s", toward = "0 deg"))
    ))
    state$forces$bar_drag[1, 1]
  }
  deep <- rope_at(-1, FALSE)
  expect_identical(rope_at(-1, TRUE), deep)
  expect_equal(rope_at(0, TRUE), deep / 2, tolerance = 1e-12)
  expect_equal(rope_at(0.03, TRUE), 0)
})

test_that("line leaves the water over 1/20 of its bars or its diameter", {
  height <- function(segments, of) {
    mesh <- build_mesh(gear_si(gear("a line",
      a = gear_point(position = c(0, 0, 0), held = "fixed"), b = gear_point(),
      line = rope("a", "b", length = "10 m", diameter = "60 mm", material = "PA",
        segments = segments),
      water = list(free_surface = TRUE)
    )))
    engine_array(mesh, of, "height")
  }
  expect_equal(height(5, "bars"), rep(0.1, 5))
  expect_equal(height(5, "volumes"), rep(0.1, 6))
  expect_equal(height(50, "bars"), rep(0.06, 50))
})

test_that("trawl with short warps swims at the surface", {
  # Surplus floats: large-mesh netting that meets the surface from below planes, and lifts the
  # headline of few floats out of the water by half a metre.
  trawl <- update(read_gear("midwater_trawl"), warps.length = "50 m", floats.number = 200,
    water.free_surface = TRUE)
  state <- settle(trawl, nodes = 500)
  # the floats, which support the headline, leave the water over 0.305 m
  expect_lt(abs(measures(state)[["headline_depth_m"]]), 0.305 / 2)
})
