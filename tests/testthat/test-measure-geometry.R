
test_that("tension and angle are read at the named end", {
  state <- settled("towed_cable")
  at <- function(place) {
    measure_values(state, list(list(kind = "tension", rope = "cable", place = place)))
  }
  # the solution of the cable's equations at the ship
  expect_equal(at("start"), 12046.7, tolerance = 1e-4)
  # what the sphere pulls with, in N: its weight in water and its drag at 4 knot. The last element's
  # middle has 23 N more, of which a tenth is left, as the cable bends within half of it.
  weight <- (1135 - 0.44236 * 1025) * 9.80665
  drag <- 0.5 * 1025 * 0.77 * pi / 4 * 0.736^2 * (4 * 1852 / 3600)^2
  expect_lt(abs(at("end") - sqrt(weight^2 + drag^2)), 2.5)
  expect_equal(at("middle"), state$bar_tension[100])
  expect_equal(at("max"), at("start"))
})
