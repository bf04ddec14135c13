test_that("a towed cable measures as the cable equations say", {
  # Steady two-dimensional cable equations integrated as an ordinary differential equation: the
  # sphere 835.6825 m behind and 503.2749 m below the ship, 12046.7 N at 22.8288 deg at the ship.
  state <- settled("towed_cable")
  found <- measures(state)
  # one percent of a 5 m bar
  expect_lt(abs(found[["distance_m"]] - sqrt(835.6825^2 + 503.2749^2)), 0.05)
  expect_lt(abs(found[["body_depth_m"]] - 503.2749), 0.05)
  # the first bar tells the tension and angle at its middle, 2.5 m down the cable, where the cable
  # pulls less by at most its weight in water and drag along it, 8.89 and 0.1 N/m
  expect_lt(abs(found[["ship_tension_kN"]] * 1000 - 12046.7), 2.5 * 9)
  bars <- as.data.frame(state)
  turn <- diff(atan2(diff(bars$z_m), diff(bars$x_m))[1:2]) * 180 / pi
  expect_lt(abs(found[["ship_angle_deg"]] - 22.8288), abs(turn))
})

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
