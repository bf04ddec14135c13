# A pole of 4 m on two supports, in vacuum, with a load in its middle.
pole <- function(..., load = -10) {
  gear("A pole", water = list(density = 0),
    left = gear_point(position = c(0, 0, 0), held = "fixed"),
    right = gear_point(position = c(4, 0, 0), held = "fixed"),
    middle = gear_point(at = "pole.middle", load = c(0, 0, load)),
    pole = rope("left", "right", diameter = "40 mm", axial_stiffness = "1 MN",
      mass_per_length = 0, segments = 40, ...),
    sag = measure(depth = "middle"))
}

test_that("pole bends as a beam", {
  # P L^3 / (48 B), and with n = 40 straight bars between hinges (1 + 2 / n^2) times that. Its ends
  # cannot move inward: stretch carries a fraction of about EA sag^2 / (32 B) = 1e-5.
  state <- settle(pole(length = "4 m", bending_stiffness = "10000 N m2"))
  expect_equal(measures(state)[["sag_m"]], 10 * 4^3 / (48 * 1e4) * (1 + 2 / 40^2), tolerance = 1e-4)
})

test_that("rope with `pushes` carries compression as a strut", {
  tripod <- gear("A strut", water = list(density = 0),
    foot = gear_point(position = c(0, 0, 0), held = "fixed"),
    stay_a = gear_point(position = c(-1, 1, 0), held = "fixed"),
    stay_b = gear_point(position = c(-1, -1, 0), held = "fixed"),
    top = gear_point(load = c(50, 0, -100), near = c(0, 0, 2)),
    strut = rope("foot", "top", length = "2 m", diameter = "50 mm", axial_stiffness = "10 MN",
      mass_per_length = 0, carries_compression = TRUE, segments = 1),
    a = rope("stay_a", "top", length = "2.449 m", diameter = "10 mm", axial_stiffness = "1 MN",
      mass_per_length = 0, segments = 1),
    b = rope("stay_b", "top", length = "2.449 m", diameter = "10 mm", axial_stiffness = "1 MN",
      mass_per_length = 0, segments = 1))
  tension <- as.data.frame(settle(tripod), what = "tensions")
  # Two stays pull 25 N each along -x over a fraction of 1/sqrt(6); the strut carries 100 N and
  # their downward pull.
  expect_equal(tension$tension_kN[tension$part == "a"], 25 * sqrt(6) / 1000, tolerance = 2e-3)
  expect_equal(tension$tension_kN[tension$part == "strut"], -(100 + 2 * 2 * 25) / 1000,
    tolerance = 2e-3)
})

# A pole of 4 m between supports that are 10 mm too close.
pressed_pole <- function(bending_stiffness) {
  gear("A pole", water = list(density = 0),
    left = gear_point(position = c(0, 0, 0), held = "fixed"),
    right = gear_point(position = c(3.99, 0, 0), held = "fixed"),
    middle = gear_point(at = "pole.middle", load = c(0, 0, 0)),
    pole = rope("left", "right", length = "4 m", diameter = "40 mm", axial_stiffness = "1 MN",
      mass_per_length = "1e-6 kg/m", segments = 20, bending_stiffness = bending_stiffness))
}

test_that("pole beyond its Euler load buckles", {
  # A straight pole would carry 2.5 kN.
  state <- settle(pressed_pole("640 N m2"))
  push <- -1000 * as.data.frame(state, what = "tensions")$tension_kN
  euler <- pi^2 * 640 / 4^2
  expect_false(state$report$unstable)
  # With n = 20 bars between hinges the load is less by (pi / n)^2 / 12. A further shortening of s =
  # 2.1e-3 raises it by s / 2 (elastica). The inclined bars carry its cosine, 0.5 % less at the
  # ends.
  expect_equal(max(push), euler, tolerance = 0.005)
  # One half wave shortens by (pi a / 2)^2 / L; a follows from the part that compression does not
  # take up.
  off <- sqrt(colSums(state$position[2:3, ]^2))
  expect_equal(max(off), 2 / pi * sqrt(4 * (0.01 - 4 * euler / 1e6)), tolerance = 0.01)
})

test_that("pole below its Euler load stays straight", {
  state <- settle(pressed_pole("6400 N m2"))
  expect_identical(state$report$perturbations, 0L)
  expect_lt(max(abs(state$position[2:3, ])), 1e-6)
})

test_that("settle() rejects a rope whose stiffness exceeds rounding of positions", {
  # Rounding of a position 100 m away stretches it by more than its load would.
  cable <- update(read_gear("towed_cable"), ropes.cable.axial_stiffness = "1e15 N")
  error <- expect_error(settle(cable), "rounding errors of positions.*cable",
    class = "codend_error_not_converged")
  expect_gt(error$report$part_rounding, 1e-3)
})

test_that("a stiff ring that hangs from a point sags as thin rings do", {
  ring <- function(stiffness, segments = 400) {
    gear("a ring", top = gear_point(position = c(0, 0, 0), held = "fixed"),
      ring = rope("top", "top", length = 3, diameter = 0.02, mass_per_length = 1,
        volume_per_length = 2e-4, axial_stiffness = 1e7, bending_stiffness = stiffness,
        segments = segments),
      height = measure(depth = "ring.middle"))
  }
  # A ring of radius R and weight w per length that hangs from its top becomes
  # (pi^2 / 4 - 2) w R^4 / EI longer: the linear solution of W. C. Young and R. G. Budynas, Roark's
  # Formulas for Stress and Strain, 7th ed., table 9.2, "ring supported at the base and loaded by
  # its own weight", upside down. Its second-order error is about the relative extension, 0.4 %, and
  # the polygon of 400 sides is 1e-5 lower than the circle.
  weight <- 9.80665 * (1 - 1025 * 2e-4)
  radius <- 3 / (2 * pi)
  sag <- (pi^2 / 4 - 2) * weight * radius^4 / 50
  expect_equal(measures(settle(ring(50)))[["height_m"]] - 2 * radius, sag, tolerance = 0.02)
  # Without stiffness it hangs as two legs.
  flat <- measures(settle(ring(0, segments = 40)))
  expect_equal(flat[["height_m"]], 1.5, tolerance = 1e-5)
})
