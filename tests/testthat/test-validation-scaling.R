# Random gears in other units and in another frame. Forces are dimensionless laws of plan quantities
# and gravity. Results must therefore follow if length, time and mass scale with gravity unchanged
# (Froude's scaling, here with viscosity too, so that the Reynolds number is constant).

random_gears <- test_path("..", "..", "bench", "random-gears.R")

random_gear_of <- function(kind, seed, ...) {
  source(random_gears, local = TRUE)
  update(random_gear(seed, kind), ...)
}

# Only netting in bars above the seabed: slack cells and seabed contact do not scale.
test_that("settle() follows Froude's scaling for random gears in bars", {
  skip_if_not(file.exists(random_gears))
  scale <- froude(1 / 8, density = 1.02)
  seeds <- c(midwater_trawl = 1, pair_trawl = 1, stow_net = 1, stow_net = 2, cage = 2,
    filled_codend = 1)
  for (k in seq_along(seeds)) {
    kind <- names(seeds)[k]
    gear <- random_gear_of(kind, seeds[[k]], netting = "bars")
    then <- settle(gear_in_units(gear, c(1, 1, 1)), nodes = 120)
    now <- settle(gear_in_units(gear, scale), nodes = 120)
    expect_scaled(now, then, scale, paste(kind, seeds[[k]]))
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
