# A state of which only positions and ropes matter; ropes: nodes of each.
drawn_state <- function(position, ropes = list(), measures = list()) {
  point <- function(text) as.integer(sub("p", "", text))
  structure(
    list(position = position, lattice = sketched_lattice(point, ropes)),
    class = "codend_state"
  )
}

test_that("spread, height, length and depth are differences of coordinates", {
  state <- drawn_state(cbind(c(0, -10, -50), c(7, 14, -62), c(0, -8, -5), c(0, 8, -5)))
  expect_equal(measure_spread(state, list(pairs = list(list("p1", "p2")))), 25)
  expect_equal(
    measure_spread(state, list(pairs = list(list("p1", "p2"), list("p4", "p3")))), (25 + 16) / 2
  )
  expect_equal(measure_height(state, list(pairs = list(list("p1", "p2")))), 12)
  expect_equal(measure_height(state, list(pairs = list(list("p2", "p1")))), -12)
  expect_equal(
    measure_length(state, list(pairs = list(list("p1", "p2")))), sqrt(7^2 + 24^2 + 12^2)
  )
  expect_equal(measure_depth(state, list(place = "p2")), 62)
  expect_equal(
    measure_depth(state, list(place = c("p1", "p2"))),
    mean(vapply(c("p1", "p2"), function(p) measure_depth(state, list(place = p)), 0))
  )
})

test_that("ropes in any order and direction enclose the area of their polygon", {
  # a house: square of 4 m with a roof of 2 m, 16 + 4 m2, leaning aft, ahead and on another course
  y <- c(0, 4, 4, 2, 0)
  z <- c(0, 0, 4, 6, 4)
  orders <- list(
    c("floor", "right", "roof", "left"), c("roof", "floor", "left", "right"),
    c("left", "roof", "right", "floor")
  )
  for (course in c(0, 0.3, pi / 2)) {
    state <- drawn_state(to_vessel(course) %*% rbind(0.4 * z, y, z), list(
      floor = c(1L, 2L), right = c(3L, 2L), roof = c(3L, 4L, 5L), left = c(5L, 1L)
    ))
    for (ropes in orders) {
      expect_equal(measure_area(state, list(ropes = ropes)), 20)
    }
  }
})

test_that("gaps between ropes are closed by straight lines", {
  state <- drawn_state(rbind(0, c(0, 4, 0, 4), c(0, 0, 3, 3)), list(low = 1:2, high = 3:4))
  expect_equal(measure_area(state, list(ropes = c("low", "high"))), 12)
  expect_equal(measure_area(state, list(ropes = "low")), 0)
})

test_that("declination is below the horizontal and divergence out of the x axis", {
  angle <- function(end, which) {
    state <- drawn_state(cbind(c(1, 1, -1), c(1, 1, -1) + end))
    state$lattice <- sketched_lattice(
      engine = list(bars = list(node = 1:2, rest = 1)), bar_part = 1L,
      parts = data.frame(name = "warp", kind = "rope")
    )
    measure_angle(state, list(rope = "warp", place = "start", angle = which)) * 180 / pi
  }
  expect_equal(angle(c(1, 0, -1), "declination"), 45)
  expect_equal(angle(c(3, 4, -5), "declination"), 45)
  expect_equal(angle(c(1, 0, 1), "declination"), -45)
  expect_equal(angle(c(sqrt(3), 1, -9), "divergence"), 30)
  expect_equal(angle(c(sqrt(3), -1, -9), "divergence"), 30)
})

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
  at <- function(place) measure_tension(state, list(rope = "cable", place = place))
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
