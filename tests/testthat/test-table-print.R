test_that("print() of a state takes at most ten lines", {
  for (name in shipped_states) {
    state <- shipped_state(name)
    lines <- capture.output(shown <- withVisible(print(state)))
    expect_lte(length(lines), 10)
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
  expect_equal(conditions_text(still), "Towed at 2.315 m/s (4.5 knot) in water of 1025 kg/m3")
  held <- list(
    water = list(
      density = 1000, current = data.frame(depth = c(0, 9), x = c(0.3, 0), y = c(0.4, 0))
    ),
    towing = list(speed = 0)
  )
  expect_equal(conditions_text(held), "Held in water of 1000 kg/m3, current up to 0.5 m/s")
  held$water$density <- 0
  held$water$current <- data.frame(depth = 0, x = 0, y = 0)
  expect_equal(conditions_text(held), "Held without water")
})
