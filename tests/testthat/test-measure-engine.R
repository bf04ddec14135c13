cable_with_engine <- function(...) {
  update(read_gear("towed_cable"), vessel = list(
    power = "1000 kW", pull = list(
      list(speed = "0 knot", pull = "150 kN"), list(speed = "10 knot", pull = "50 kN")
    ), ...
  ))
}

test_that("engine power and fuel follow from pull, power and consumption", {
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
  # the shape does not depend on the engine
  expect_identical(state$position, settled("towed_cable")$position)
})

test_that("pull extrapolates linearly beyond its table down to zero", {
  pull <- c(`5 knot` = 100, `12 knot` = 30, `20 knot` = 0)
  for (speed in names(pull)) {
    found <- measures(settle(update(cable_with_engine(), towing.speed = speed), nodes = 50))
    expect_equal(found[["pull_used_percent"]], 100 * found[["total_drag_kN"]] / pull[[speed]])
  }
  expect_equal(found[["engine_power_kW"]], Inf)
  expect_false(any(grepl("fuel", names(found))))
})

test_that("tow_speed() returns the speed at which drag equals pull", {
  gear <- cable_with_engine(fuel = list(
    list(load = 0.25, consumption = "230 g/kWh"), list(load = 1, consumption = "200 g/kWh")
  ))
  for (power in list(NULL, "400 kW", "40 %")) {
    found <- measures(tow_speed(gear, power, nodes = 100))
    # the speed is solved to 1e-4; the required pull grows faster than speed squared
    expect_equal(found[["engine_power_kW"]], if (is.null(power)) 1000 else 400, tolerance = 2e-3)
  }
  expect_match(tow_speed(gear, "40 %", nodes = 100)$gear$plan$towing$speed, "^[0-9.]+ knot$")
  expect_wrong(tow_speed("towed_cable"), "vessel")
  expect_wrong(tow_speed(gear, "2 MW"), "at most")
})
