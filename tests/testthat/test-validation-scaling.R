# Random gears in other units and in another frame. Forces are dimensionless laws of plan quantities
# and gravity. Results must therefore follow if length, time and mass scale with gravity unchanged
# (Froude's scaling, here with viscosity too, so that the Reynolds number is constant).

random_gears <- test_path("..", "..", "bench", "random-gears.R")

random_gear_of <- function(kind, seed, ...) {
  source(random_gears, local = TRUE)
  update(random_gear(seed, kind), ...)
}

# A quarter of the length, half of the time and twice the density are exact in binary numbers. Every
# number of a solution then scales exactly, unless a constant of the program has a unit. This holds
# also for gears with several equilibria, whose iterations rounding errors would separate.
quarter <- froude(1 / 4, density = 2)

test_that("settle() follows Froude's scaling for random gears", {
  skip_if_not(file.exists(random_gears))
  kinds <- c("midwater_trawl", "bottom_trawl", "pair_trawl", "demersal_seine", "purse_seine",
    "cage", "gillnet", "stow_net", "dip_net", "filled_codend")
  for (kind in kinds) {
    for (netting in c("cells", "bars")) {
      gear <- random_gear_of(kind, 1, netting = netting)
      then <- settle(gear_in_units(gear, c(1, 1, 1)), nodes = 100)
      now <- settle(gear_in_units(gear, quarter), nodes = 100)
      expect_scaled(now, then, quarter, paste(kind, netting))
    }
  }
})

# Returns a tow with a change of speed and a turn, or with a change of the current.
scaled_tow <- function(gear, scale) {
  gear <- gear_in_units(gear, scale)
  times <- c(0, 2, 10) * scale[2]
  speed <- function(first, last) data.frame(time = times, value = c(first, first, last))
  schedule <- if ("moved" %in% held_points(gear_si(gear))) {
    towing <- gear_si(gear)$towing$speed
    tow_schedule(speed = speed(towing, 1.2 * towing),
      course = data.frame(time = times, value = c(0, 0, 0.2)))
  } else {
    current <- scale[1] / scale[2]
    tow_schedule(current = list(speed = speed(current, 1.3 * current)))
  }
  tow(gear, schedule, until = times[3], every = times[3] / 2, nodes = 80,
    accuracy = 0.01 * scale[1])
}

test_that("tow() follows Froude's scaling for random gears", {
  skip_if_not(file.exists(random_gears))
  netting <- c(midwater_trawl = "cells", bottom_trawl = "bars", pair_trawl = "cells",
    gillnet = "bars", cage = "cells", stow_net = "bars", dip_net = "cells")
  for (kind in names(netting)) {
    gear <- random_gear_of(kind, 1, netting = netting[[kind]])
    then <- scaled_tow(gear, c(1, 1, 1))
    now <- scaled_tow(gear, quarter)
    for (k in seq_along(then$time)) {
      expect_scaled(state_at(now, now$time[k]), state_at(then, then$time[k]), quarter,
        paste(kind, then$time[k], "s"))
    }
  }
})

test_that("settle() returns the same gear in a rotated and translated frame", {
  skip_if_not(file.exists(random_gears))
  seeds <- c(gillnet = 1, stow_net = 1, cage = 2)
  for (kind in names(seeds)) {
    for (netting in c("cells", "bars")) {
      gear <- gear_in_units(random_gear_of(kind, seeds[[kind]], netting = netting), c(1, 1, 1))
      then <- settle(gear, nodes = 120)
      now <- settle(moved_gear(gear, 0.7, c(30, -50)), nodes = 120)
      expect_scaled(now, then, c(1, 1, 1), paste(kind, netting))
    }
  }
})
