# Random gears in other units and in another frame. All forces are dimensionless laws of plan
# quantities and gravity. Results must therefore follow if length, time and mass scale with gravity
# unchanged (Froude's scaling, here with viscosity too, so that the Reynolds number is constant).


random_gears <- test_path("..", "..", "bench", "random-gears.R")

scaled_gear_of <- function(kind, seed = 1, ...) {
  source(random_gears, local = TRUE)
  update(random_gear(seed, kind), ...)
}

test_that("settle() follows Froude's scaling for random gears", {
  skip_if_not(file.exists(random_gears))
  scale <- froude(1 / 8, density = 1.02)
  for (kind in c("bottom_trawl", "midwater_trawl", "demersal_seine", "gillnet", "cage")) {
    for (netting in c("cells", "bars")) {
      gear <- scaled_gear_of(kind, netting = netting)
      then <- settle(gear_at_scale(gear, c(1, 1, 1)), nodes = 120)
      now <- settle(gear_at_scale(gear, scale), nodes = 120)
      expect_scaled(now, then, scale, paste(kind, netting))
    }
  }
})

test_that("tow() follows Froude's scaling", {
  skip_if_not(file.exists(random_gears))
  scale <- froude(1 / 4)
  gear <- scaled_gear_of("bottom_trawl")
  speed <- gear_si(gear)$towing$speed
  # Fixed steps, because scaled steps must have the same error.
  towed <- function(scale) {
    times <- c(0, 8) * scale[2]
    faster <- data.frame(time = times, value = c(1, 1.2) * speed * scale[1] / scale[2])
    state <- settle(gear_at_scale(gear, scale), nodes = 80)
    state_at(tow(state, tow_schedule(speed = faster), until = times[2], every = times[2],
      step = 0.5 * scale[2]), times[2])
  }
  expect_scaled(towed(scale), towed(c(1, 1, 1)), scale, "bottom_trawl")
})

test_that("settle() returns the same gear in a rotated and translated frame", {
  skip_if_not(file.exists(random_gears))
  for (kind in c("gillnet", "cage")) {
    gear <- gear_at_scale(scaled_gear_of(kind), c(1, 1, 1))
    then <- settle(gear, nodes = 120)
    now <- settle(moved_gear(gear, 0.7, c(30, -50)), nodes = 120)
    expect_scaled(now, then, c(1, 1, 1), kind)
  }
})
