
test_that("tension and angle refer to the named end of a rope", {
  state <- settled("towed_cable")
  at <- function(place) {
    measure_values(state, list(list(kind = "tension", rope = "cable", place = place)))
  }
  # the solution of the cable's equations at the ship
  expect_equal(at("start"), 12046.7, tolerance = 1e-4)
  # Force of the sphere, in N: its weight in water and its drag at 4 knot. The middle of the last
  # element has 23 N more. A tenth of this difference remains, as the cable bends within half of the
  # element.
  weight <- (1135 - 0.44236 * 1025) * 9.80665
  drag <- 0.5 * 1025 * 0.77 * pi / 4 * 0.736^2 * (4 * 1852 / 3600)^2
  expect_lt(abs(at("end") - sqrt(weight^2 + drag^2)), 2.5)
  expect_equal(at("middle"), state$bar_tension[100])
  expect_equal(at("max"), at("start"))
})
