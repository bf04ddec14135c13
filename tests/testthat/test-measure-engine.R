cable_with_engine <- function(...) {
  update(read_gear("towed_cable"), vessel = list(
    power = "1000 kW", pull = list(
      list(speed = "0 knot", pull = "150 kN"), list(speed = "10 knot", pull = "50 kN")
    ), ...
  ))
}

test_that("power and fuel follow from the stated pull, power and consumption", {
  gear <- cable_with_engine(fuel = "210 g/kWh", fuel_density = 840, catch_per_hour = "2 tonne")
  state <- settle(gear)
  found <- measures(state)
  knots <- gear_si(gear)$towing$speed * 3600 / 1852
  share <- found[["total_drag_kN"]] / (150 - 10 * knots)
  expect_equal(found[["pull_used_percent"]], 100 * share)
  expect_equal(found[["engine_power_kW"]], 1000 * share^1.5)
  # litres: 0.21 kg/kWh over 0.84 kg/l
  expect_equal(found[["fuel_rate_l_per_h"]], 1000 * share^1.5 * 0.21 / 0.84)
  expect_equal(found[["fuel_per_catch_l_per_t"]], found[["fuel_rate_l_per_h"]] / 2)
  # the shape knows nothing of it
  expect_identical(state$position, settled("towed_cable")$position)
})

test_that("the pull goes on straight beyond its rows, to nothing", {
  pull <- c(`5 knot` = 100, `12 knot` = 30, `20 knot` = 0)
  for (speed in names(pull)) {
    found <- measures(settle(update(cable_with_engine(), towing.speed = speed), nodes = 50))
    expect_equal(found[["pull_used_percent"]], 100 * found[["total_drag_kN"]] / pull[[speed]])
  }
  expect_equal(found[["engine_power_kW"]], Inf)
  expect_false(any(grepl("fuel", names(found))))
})

test_that("the speed that a power tows is that at which the drag is what the vessel pulls", {
  gear <- cable_with_engine(fuel = list(
    list(load = 0.25, consumption = "230 g/kWh"), list(load = 1, consumption = "200 g/kWh")
  ))
  for (power in list(NULL, "400 kW", "40 %")) {
    found <- measures(tow_speed(gear, power, nodes = 100))
    # the speed is found to 1e-4; the pull that is used grows faster than its square
    expect_equal(found[["engine_power_kW"]], if (is.null(power)) 1000 else 400, tolerance = 2e-3)
  }
  expect_error(tow_speed("towed_cable"), "vessel", class = "codend_error_argument")
  expect_error(tow_speed(gear, "2 MW"), "at most", class = "codend_error_argument")
})

test_that("a vessel's table that cannot be is told", {
  bad <- function(...) {
    expect_error(update(read_gear("towed_cable"), vessel = list(power = "1 MW", pull = list(...))),
      "vessel.pull", class = "codend_error_plan")
  }
  bad(list(speed = 3, pull = 10), list(speed = 1, pull = 5))
  bad(list(speed = 0, pull = 10), list(speed = 1, pull = 15))
})

test_that("what a tow swept is the integral of its measures", {
  trawl <- settle("beam_trawl", nodes = 200)
  found <- tow(trawl, until = 20, every = 10, accuracy = 0.1)
  swept <- as.data.frame(found, what = "swept")
  expect_equal(swept$time_s, c(0, 10, 20))
  speed <- trawl$si$towing$speed
  expect_equal(swept$distance_m, speed * c(0, 10, 20), tolerance = 1e-6)
  # a beam holds its width: what it passes over is that times the way; its shoes sway by less than
  # 1 %
  width <- measures(trawl)[["wing_end_spread_m"]]
  expect_equal(swept$swept_area_m2[3], width * speed * 20, tolerance = 0.01)
  expect_true(all(is.na(swept$swept_volume_m3)) || all(diff(swept$swept_volume_m3) > 0))
})
