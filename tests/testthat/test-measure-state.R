test_that("every measure ends in its unit", {
  for (state in lapply(shipped_states, shipped_state)) {
    found <- measures(state)
    expect_true(all(is.finite(found)))
    expect_false(anyDuplicated(names(found)) > 0)
    expect_match(names(found), "_(m|m2|kN|N|kW|deg|percent|m3_per_h|km2_per_h)$")
  }
})

test_that("measures of the plan come first, in its order", {
  expect_equal(
    names(measures(settled("crossing_cables"))),
    c("sag_m", "edge_tension_kN", "total_drag_kN", "largest_rope_tension_kN", "least_depth_m",
      "greatest_depth_m")
  )
})

test_that("a midwater trawl has the field's measures", {
  found <- measures(shipped_state("midwater_trawl"))
  expect_true(all(c(
    "door_spread_m", "net_mouth_height_m", "wing_end_spread_m", "mouth_area_m2", "total_drag_kN",
    "warp_tension_port_kN", "headline_depth_m"
  ) %in% names(found)))
  speed <- settled_gear("midwater_trawl")$plan$towing$speed
  metres <- quantity_si(speed, "speed")
  # straight behind the vessel: the gear is its own mirror image to 1e-8 of the largest tension
  expect_equal(
    found[["filtered_volume_m3_per_h"]], found[["mouth_area_m2"]] * metres * 3600, tolerance = 1e-7
  )
  expect_equal(
    found[["swept_area_km2_per_h"]], found[["wing_end_spread_m"]] * metres * 0.0036, tolerance = 1e-7
  )
  # the gear is a mirror image of itself; the solver ends at 1e-8 of the largest tension
  expect_equal(
    found[["warp_tension_port_kN"]], found[["warp_tension_starboard_kN"]], tolerance = 1e-5
  )
})

test_that("a measure of the plan hides the general one of its name", {
  gear <- update(read_gear("crossing_cables"),
    measures.greatest_depth = list(depth = "west_south"))
  expect_equal(sum(names(measures(settle(gear))) == "greatest_depth_m"), 1)
  expect_equal(measures(settle(gear))[["greatest_depth_m"]], 0)
})

test_that("filtered volume takes the water's speed at the mouth's depth", {
  state <- list(lattice = sketched_lattice(engine = list(
    water = list(depth = c(0, 100), x = c(2, 1), y = c(0, 0))
  )))
  expect_equal(water_velocity(state, 25), c(1.75, 0))
  expect_equal(water_velocity(state, 500), c(1, 0))
})

test_that("names of measures split into words and units", {
  said <- measure_words(c("door_spread_m", "swept_area_km2_per_h", "mouth_m2", "a_kN_m"))
  expect_equal(said$words, c("door spread", "swept area", "mouth", "a kN"))
  expect_equal(said$unit, c("m", "km2/h", "m2", "m"))
})

test_that("only a state is measured", {
  expect_error(measures(1), class = "codend_error_argument")
})

test_that("a record of a state goes into JSON and back", {
  state <- settled("towed_cable")
  record <- state_record(state)
  back <- jsonlite::fromJSON(jsonlite::toJSON(record, auto_unbox = TRUE, digits = NA))
  expect_equal(back, record)
  expect_true(back$converged)
  expect_equal(back[c("nodes", "bars", "triangles")], list(nodes = 201, bars = 200, triangles = 0))
  expect_equal(unlist(back$measures), measures(state))
})
