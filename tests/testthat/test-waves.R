# Waves and vessel motion: plans, tows and known solutions.

buoy <- function(..., water = list()) {
  gear("buoy line",
    anchor = gear_point(position = c(0, 0, -12), held = "fixed"), at_buoy = gear_point(),
    line = rope("anchor", "at_buoy", length = "13 m", diameter = "8 mm", material = "PA",
      segments = 6),
    buoy = piece(at = "at_buoy", mass = "20 kg", diameter = "600 mm"),
    water = water, ...
  )
}

long_waves <- function(...) {
  list(waves = list(height = "0.8 m", period = "7 s", rising = "5 s", ...))
}

test_that("truncated wave spectrum keeps its energy", {
  of <- function(...) {
    gear_si(buoy(water = list(waves = list(height = "2 m", period = "8 s", ...))))$water$waves
  }
  jonswap <- of(spectrum = "jonswap", components = 200)
  # significant height: four times the standard deviation of sums of cosines
  expect_equal(4 * sqrt(sum(jonswap$amplitude^2) / 2), 2, tolerance = 1e-12)
  # analytical solution of Pierson and Moskowitz: the fraction of energy below s is exp(-1.25 s^-4)
  plain <- of(spectrum = "pierson_moskowitz", components = 200)
  share <- (seq_len(200) - 0.5) / 200
  # the part above 6 times the peak, 1.25 / 6^4 = 0.001, is distributed over the components
  exact <- 2 * pi / 8 * (1.25 / -log(share * exp(-1.25 / 6^4)))^0.25
  expect_equal(plain$frequency, exact, tolerance = 1e-5)
  expect_equal(of(spectrum = "jonswap", peakedness = 1, components = 200)$frequency, exact,
    tolerance = 1e-5)
  # a peaked spectrum concentrates near its peak
  near <- function(waves) sum(abs(waves$frequency * 8 / (2 * pi) - 1) < 0.1)
  expect_gt(near(jonswap), 1.5 * near(plain))
})

test_that("wave seed determines the sea", {
  phase <- function(seed) {
    gear_si(buoy(water = list(waves = list(height = 2, period = 8, spectrum = "jonswap",
      seed = seed))))$water$waves$phase
  }
  expect_identical(phase(3), phase(3))
  expect_false(any(phase(3) == phase(4)))
  # the published test of the generator: after 10,000 draws from 1
  expect_equal(2147483647 * drawn_numbers(1, 9990)[9990], 1043618065, tolerance = 1e-12)
  # uniform within four standard deviations in each quarter
  expect_lt(max(abs(table(cut(drawn_numbers(1, 4000), 0:4 / 4)) - 1000)), 4 * sqrt(750))
})

test_that("settle() uses the mean of the waves and reports it", {
  still <- settle(buoy(water = list(free_surface = TRUE)))
  mean <- settle(buoy(water = long_waves()))
  expect_identical(mean$position, still$position)
  expect_match(state_conditions(mean), "mean over regular waves of 0.8 m and 7 s")
})

test_that("buoy on its line follows long waves", {
  found <- tow(buoy(water = long_waves()), until = 33, every = 0.25)
  late <- found$time >= 12
  node <- found$mesh$points[["at_buoy"]]
  z <- found$position[3, node, late]
  # The natural period of the buoy is 1.5 s, so it follows; the line's weight is 3 % of its
  # buoyancy.
  expect_equal(diff(range(z)), 0.8, tolerance = 0.06)
  expect_equal(diff(range(found$conditions$elevation[late])), 0.8, tolerance = 0.01)
  expect_lt(abs(utils::tail(found$conditions$energy_imbalance, 1L)),
    0.02 * utils::tail(found$conditions$energy_put_through, 1L) + 1)
  # equals the vessel's elevation, at the origin
  expect_equal(found$conditions$elevation[late], 0.4 * cos(2 * pi * found$time[late] / 7),
    tolerance = 1e-9)
  expect_match(state_conditions(state_at(found, 20)), "in regular waves")
})

swinging <- function() {
  gear("a line from a vessel",
    block = gear_point(position = c(6, 2, 3), held = "moved"), end = gear_point(),
    line = rope("block", "end", length = "25 m", diameter = "10 mm", material = "PA", segments = 8),
    weight = piece(at = "end", mass = "30 kg", diameter = "200 mm"),
    towing = list(speed = "1 m/s"), water = long_waves(toward = "180 deg")
  )
}

test_that("vessel response moves the towing points with the waves", {
  answers <- data.frame(period = c(5, 9), heave = 1, pitch = c(0.02, 0.04), pitch_lag = pi / 2)
  found <- tow(swinging(), until = 20, every = 0.5,
    schedule = tow_schedule(vessel_motion = list(response = answers, at = c(1, 0, 0))))
  late <- found$time > 6
  block <- found$position[, found$mesh$points[["block"]], late]
  elevation <- found$conditions$elevation[late]
  # The vessel moves with the waves, so their encounter period is longer.
  angle <- 2 * pi / 7 - (2 * pi / 7)^2 / gear_gravity * 1
  expect_equal(elevation, 0.4 * cos(angle * found$time[late]), tolerance = 1e-9)
  # between the periods: 0.03 rad per metre, a quarter period late; the bow rises, the stern falls
  pitch <- 0.03 * 0.4 * cos(angle * found$time[late] - pi / 2)
  expect_equal(block[3, ], elevation + 3 * cos(pitch) - 5 * sin(pitch), tolerance = 1e-9)
})

test_that("motion record moves the towing points and rises from zero", {
  time <- seq(0, 40, by = 0.05)
  record <- data.frame(time = time, sway = 0.5 * sin(time), yaw = 0.1)
  found <- tow(swinging(), until = 16, every = 4,
    schedule = tow_schedule(vessel_motion = list(record = record, rising = 8)))
  block <- found$position[, found$mesh$points[["block"]], ]
  expect_equal(block[, 1], c(6, 2, 3), tolerance = 1e-12)
  # bow to starboard: points aft move to port
  at <- function(t) 2 * cos(0.1) - 6 * sin(0.1) + 0.5 * sin(t)
  # cubics through points 0.05 s apart: h^3 / 15 of the third derivative
  expect_equal(block[2, 4:5], at(found$time[4:5]), tolerance = 1e-4)
})

test_that("tow() in waves continues within its accuracy", {
  answers <- data.frame(period = 7, heave = 0.8, roll = 0.05, roll_lag = 1)
  motion <- list(response = answers)
  whole <- tow(swinging(), until = 12, every = 3, schedule = tow_schedule(vessel_motion = motion))
  half <- tow(swinging(), until = 6, every = 3, schedule = tow_schedule(vessel_motion = motion))
  on <- tow(half, until = 12)
  # 1 % of an orbit of 1 m
  expect_lt(max(abs(on$position - whole$position)), 0.02)
  skip_if_not_installed("RNetCDF")
  file <- file.path(test_folder(), "made.nc")
  write_result(half, file)
  expect_identical(tow(read_result(file), until = 12)$position, on$position)
})

test_that("wave force on a cage grows with height and current", {
  # Published tests of cages in regular waves: the force grows with height, more than proportionally
  # where drag dominates, and with a current (Lader and Fredheim 2006; Zhao et al. 2007).
  pull <- function(height, current) {
    cage <- update(read_gear("model_cage"),
      water.current = list(speed = current, toward = "0 deg"),
      water.waves = list(height = height, period = "2.5 s", rising = "2 s"))
    found <- tow(cage, until = 7.5, every = 0.125, nodes = 150)
    force <- vapply(found$time[found$time > 5], function(t) {
      -sum(support_forces(state_at(found, t))[1, ])
    }, 0)
    c(largest = max(force), swing = diff(range(force)))
  }
  low <- pull("60 mm", "0 m/s")
  high <- pull("120 mm", "0 m/s")
  # drag alone would give 4, inertia alone 2
  ratio <- high[["swing"]] / low[["swing"]]
  expect_gt(ratio, 2)
  expect_lt(ratio, 4.5)
  slow <- pull("120 mm", "0.1 m/s")
  # drag by the sum of both speeds
  expect_gt(slow[["largest"]], 1.5 * high[["largest"]])
  expect_gt(slow[["swing"]], high[["swing"]])
})
