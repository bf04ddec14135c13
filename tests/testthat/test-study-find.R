# Found values compared with the analytical solution of a towed sphere, whose depth is
# L W / sqrt(W^2 + D^2), with exhaustive search, and on shipped gears.

towed_sphere <- function(...) as_gear(towed_sphere_plan(...))
sphere_weight <- function(mass) 9.81 * (mass - 0.01 * 1025)
sphere_drag <- function(speed) 0.47 * pi / 16 * 1025 / 2 * speed^2
sphere_depth <- function(length, mass = 200, speed = 2) {
  length / sqrt(1 + (sphere_drag(speed) / sphere_weight(mass))^2)
}
sphere_pull <- function(mass, speed) sqrt(sphere_weight(mass)^2 + sphere_drag(speed)^2)

test_that("find_value() finds the analytical speed of a towed sphere", {
  found <- find_value(towed_sphere(), towing.speed = value_range("1 m/s", "6 m/s"),
    target = list(depth = "9 m"))
  speed <- uniroot(function(speed) sphere_depth(10, speed = speed) - 9, c(1, 6), tol = 1e-10)$root
  expect_equal(found$fields$value, speed, tolerance = 2e-4)
  expect_true(found$targets$reached)
  expect_lte(found$n_solves, 6)
  expect_equal(measures(found$state)[["depth_m"]], found$targets$value)
  expect_identical(found$gear$plan, found$state$gear$plan)
  again <- settle(found$gear)
  expect_equal(measures(again)[["depth_m"]], 9, tolerance = 1e-4)
})

test_that("find_value() meets two targets with two fields", {
  found <- find_value(towed_sphere(), towing.speed = c("1 m/s", "4 m/s"),
    pieces.sphere.mass = c("50 kg", "400 kg"), target = list(depth_m = 9.8, pull = "1.5 kN"))
  expect_true(all(found$targets$reached))
  value <- found$fields$value
  expect_equal(sphere_depth(10, value[2], value[1]), 9.8, tolerance = 2e-4)
  expect_equal(sphere_pull(value[2], value[1]), 1500, tolerance = 2e-4)
  expect_lte(found$n_solves, 8)
})

test_that("find_value() changes two fields for one target by the smallest ratio", {
  found <- find_value(towed_sphere(), ropes.line.length = c("5 m", "20 m"),
    towing.speed = c("1 m/s", "6 m/s"), target = list(depth = "9.5 m"))
  expect_true(found$targets$reached)
  change <- function(speed) {
    length <- 9.5 / sphere_depth(1, speed = speed)
    (length / 10 - 1)^2 + (speed / 2 - 1)^2
  }
  best <- optimize(change, c(1, 6), tol = 1e-8)
  expect_equal(sum((found$fields$value / found$fields$start - 1)^2), best$objective,
    tolerance = 0.02)
  expect_equal(found$fields$value[2], best$minimum, tolerance = 0.01)
})

test_that("find_value() returns the least-squares compromise of two targets", {
  found <- find_value(towed_sphere(), towing.speed = c("1 m/s", "6 m/s"),
    target = list(depth = "9 m", pull = "1.8 kN"))
  misfit <- function(speed) {
    (sphere_depth(10, speed = speed) / 9 - 1)^2 + (sphere_pull(200, speed) / 1800 - 1)^2
  }
  best <- optimize(misfit, c(1, 6), tol = 1e-8)
  expect_equal(found$fields$value, best$minimum, tolerance = 1e-3)
  expect_identical(found$targets$reached, c(FALSE, FALSE))
  expect_output(print(found), "compromise")
})

test_that("find_value() reports the nearest value if a target is out of reach", {
  expect_warning(
    found <- find_value(towed_sphere(), towing.speed = c("1 m/s", "3 m/s"),
      target = list(depth = "4 m")),
    class = "codend_warning_target_not_reached"
  )
  expect_identical(found$fields$at, "upper")
  expect_equal(found$fields$value, 3)
  expect_false(found$targets$reached)
  expect_equal(found$targets$value, sphere_depth(10, speed = 3), tolerance = 1e-4)
  # the tiny discretisation error consists of rounding
  expect_snapshot(print(found), transform = function(lines) sub(", with an error.*", "", lines))
})

test_that("find_value() finds the nearest whole number of floats", {
  found <- find_value(buoyed_line(), pieces.floats.number = c(5, 60),
    target = list(pull = "1234 N"))
  expect_identical(found$fields$value, 21)
  expect_true(found$targets$reached)
  expect_equal(found$targets$value, 1.26)
  expect_lte(found$n_solves, 6)
})

test_that("find_value() updates derivatives by whole numbers on the way", {
  # With the derivative at 60 floats, the search would end at 26 floats.
  found <- find_value(update(buoyed_line(), pieces.floats.number = 60),
    pieces.floats.number = c(5, 60), target = list("pull^3" = 1260^3))
  expect_identical(found$fields$value, 21)
  expect_true(found$targets$reached)
  # the new derivatives explain the last step and agree with the former ones across it
  before <- list(place = c(1, 2), miss = c(0.5, -1), slopes = matrix(c(1, 0, 3, -2), 2L))
  after <- list(place = c(1.5, 1), miss = c(2, 4))
  slopes <- secant_slopes(before, after)
  expect_equal(drop(slopes %*% c(0.5, -1)), c(1.5, 5))
  expect_equal(slopes %*% c(1, 0.5), before$slopes %*% c(1, 0.5))
})

test_that("find_value() follows the derivative to the nearest of two solutions", {
  # The headline falls with speed, then the boards lift off the seabed and it rises.
  trawl <- read_gear("poly_noreastern_trawl")
  at <- function(speed) {
    measures(settle(update(trawl, towing.speed = speed), nodes = 300))[["headline_height_m"]]
  }
  find <- function(from, to, start = "3 knot", height = "9 m") {
    find_value(update(trawl, towing.speed = start), towing.speed = c(from, to),
      target = list(headline_height = height),
      nodes = 300)
  }
  low <- find("1.5 knot", "4.5 knot")
  expect_true(low$targets$reached)
  expect_true(low$fields$value > 1.5 && low$fields$value < 2)
  high <- find("2.5 knot", "4.5 knot", "3.9 knot")
  expect_true(high$targets$reached)
  expect_true(high$fields$value > 3.5 && high$fields$value < 4.1)
  for (found in list(low, high)) {
    expect_equal(at(paste(found$fields$value, "knot")), 9, tolerance = 5e-3)
  }
})

test_that("find_value() settles few gears in typical searches", {
  trawl <- read_gear("poly_noreastern_trawl")
  find <- function(...) find_value(trawl, ..., nodes = 300)
  searches <- list(
    find(warps.length = value_range("200 m", "600 m"), target = list(door_spread = "50 m")),
    find(warps.length = value_range("200 m", "600 m"), target = list(door_spread_m = "53 m")),
    find(floats.number = c(10, 60), target = list(headline_height = "6.5 m")),
    find(towing.speed = c("2 knot", "4 knot"), target = list(total_drag = "60 kN")),
    find(towing.speed = c("2 knot", "4 knot"), target = list("total_drag / door_spread" = 800))
  )
  expect_true(all(vapply(searches, function(found) found$targets$reached, NA)))
  solves <- vapply(searches, function(found) found$n_solves, 0L)
  expect_true(all(solves <= 6))
  expect_equal(searches[[1]]$targets$value, 50, tolerance = 1e-4)
  printed <- utils::capture.output(print(searches[[1]]))
  expect_lte(length(printed), 15)
  expect_snapshot(print(searches[[1]]))
  expect_snapshot(print(searches[[3]]))
})

test_that("find_value() accepts targets with and without their unit", {
  find <- function(target) {
    find_value(towed_sphere(), towing.speed = c("1 m/s", "6 m/s"), target = target)$fields$value
  }
  same <- find(list(depth = "9 m"))
  expect_identical(find(list(depth = 9)), same)
  expect_identical(find(list(depth_m = 9)), same)
  expect_identical(find(list(depth_m = "900 cm")), same)
  expect_identical(find(list("depth" = "900 cm")), same)
})

test_that("find_value() estimates the effect of discretisation errors on fields", {
  found <- find_value("towed_cable", towing.speed = c("2 knot", "6 knot"),
    target = list(body_depth = "600 m"), nodes = 20)
  slope <- sensitivities(found$state, of = "body_depth_m", fields = "towing.speed")$derivative
  # a ratio, because expect_equal() compares numbers below its tolerance without scale
  expect_equal(found$fields$error / abs(found$targets$error / slope), 1, tolerance = 1e-3)
})

test_that("find_value() throws if it does not converge", {
  find <- function() {
    find_value(towed_sphere(), towing.speed = c("1 m/s", "6 m/s"), target = list(depth = "9 m"))
  }
  expect_error(with_package_value("most_find_solves", 1L, find()), "does not converge",
    class = "codend_error_not_converged")
  expect_error(with_package_value("settle_point", function(...) NULL, find()),
    "does not settle with towing.speed =", class = "codend_error_not_converged")
})
