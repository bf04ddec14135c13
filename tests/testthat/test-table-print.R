test_that("print() of a state lists its main measures", {
  for (name in shipped_states) {
    state <- shipped_state(name)
    lines <- capture.output(shown <- withVisible(print(state)))
    expect_lte(length(lines), 15)
    expect_false(shown$visible)
    expect_match(lines[1], state$si$name, fixed = TRUE)
    expect_true(any(grepl("total drag", lines)))
  }
})

test_that("printed output does not depend on R's number options", {
  state <- settle(update(read_gear("towed_cable"), ropes.cable.length = 1000.25))
  trajectory <- tow(state, until = 1, every = 0.5)
  shown <- list(
    state$gear, state, measures(state), summary(state), state_at(trajectory, 0.5), trajectory,
    summary(trajectory)
  )
  printed <- function(...) {
    kept <- options(...)
    on.exit(options(kept))
    lapply(shown, function(one) capture.output(print(one)))
  }
  expect_identical(printed(OutDec = ","), printed(OutDec = "."))
  expect_identical(printed(scipen = -9), printed(scipen = 0))
})

test_that("conditions_text() describes speed, water and current", {
  still <- list(
    water = list(density = 1025, current = data.frame(depth = 0, x = 0, y = 0)),
    towing = list(speed = 4.5 * 1852 / 3600)
  )
  expect_equal(conditions_text(still), "Towed at 2.315 m/s in water of 1025 kg/m3")
  plan <- list(towing = list(speed = "4.5 knots"), water = list(current = list(speed = "1 kn")))
  expect_equal(conditions_text(still, plan), "Towed at 4.5 knots in water of 1025 kg/m3")
  held <- list(
    water = list(
      density = 1000, current = data.frame(depth = c(0, 9), x = c(0.3, 0), y = c(0.4, 0))
    ),
    towing = list(speed = 0)
  )
  expect_equal(conditions_text(held), "Held in water of 1000 kg/m3, current up to 0.5 m/s")
  expect_equal(conditions_text(held, plan), "Held in water of 1000 kg/m3, current up to 0.9719 kn")
  held$water$density <- 0
  held$water$current <- data.frame(depth = 0, x = 0, y = 0)
  expect_equal(conditions_text(held), "Held without water")
})

test_that("prints of gears and results fit a screen", {
  gear <- read_gear("poly_noreastern_trawl")
  state <- settle(gear, nodes = 300)
  odd <- update(gear, towing.speed = "9 knot", sections.body.twine.diameter = "25 mm")
  tow <- tow("towed_cable", until = 20, every = 10)
  shown <- list(gear, state, summary(gear), summary(state), findings(gear), findings(odd),
    summary(odd), tow, summary(tow), state_at(tow, 10), normal_value("3 m", "1 m"),
    value_range("3 m", "4 m"), force_coefficients(), measures(state), gears())
  lines <- lapply(shown, function(one) capture.output(print(one)))
  expect_lte(max(lengths(lines)), 30L)
  expect_lte(max(nchar(unlist(lines))), 110L)
  expect_snapshot(for (one in shown[c(1:8, 11:13)]) print(one))
})

test_that("prints use the units of the option codend.units", {
  kept <- options(codend.units = c(speed = "km/h", force = "tonnef", length = "fathom", mass = "t"))
  on.exit(options(kept))
  state <- settle("towed_cable", nodes = 60)
  # residual forces are rounding errors
  stable <- function(lines) {
    grep("remainder|residual|within about", lines, invert = TRUE, value = TRUE)
  }
  expect_snapshot({
    print(state$gear)
    print(state)
    print(summary(state), n = Inf)
    print(summary(state$gear))
  }, transform = stable)
})
