test_that("measures end in their unit and have a definition", {
  for (state in lapply(shipped_states, shipped_state)) {
    found <- measures(state)
    expect_true(all(is.finite(found)))
    expect_false(anyDuplicated(names(found)) > 0)
    expect_true(all(endsWith(names(found), paste0("_", unit_suffix(attr(found, "unit"))))))
    defined <- measure_definitions(state)
    expect_identical(defined$name, names(found))
    expect_identical(defined$unit, unname(attr(found, "unit")))
    expect_identical(defined$definition, definitions_of(found))
  }
})

test_that("measures of the plan come first in its order", {
  expect_equal(
    names(measures(settled("crossing_cables"))),
    c("sag_m", "edge_tension_kN", "total_drag_kN", "largest_rope_tension_kN", "least_depth_m",
      "greatest_depth_m")
  )
})

test_that("midwater trawl has the usual measures of the trade", {
  # with fewer nodes the panels' meshes are not mirror images of each other
  found <- measures(settled("midwater_trawl"))
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
    found[["swept_area_km2_per_h"]], found[["wing_end_spread_m"]] * metres * 0.0036,
    tolerance = 1e-7
  )
  # the gear is symmetric; the solver's tolerance is 1e-8 of the largest tension
  expect_equal(
    found[["warp_tension_port_kN"]], found[["warp_tension_starboard_kN"]], tolerance = 1e-5
  )
})

test_that("measure of the plan replaces the general measure with its name", {
  gear <- update(read_gear("crossing_cables"), measures.greatest_depth = list(depth = "west_south"))
  expect_equal(sum(names(measures(settle(gear))) == "greatest_depth_m"), 1)
  expect_equal(measures(settle(gear))[["greatest_depth_m"]], 0)
})

test_that("filtered volume uses the water speed at the mouth's depth", {
  state <- list(mesh = sketched_mesh(model = list(
    water = list(depth = c(0, 100), x = c(2, 1), y = c(0, 0))
  )))
  expect_equal(water_velocity(state, 25), c(1.75, 0))
  expect_equal(water_velocity(state, 500), c(1, 0))
})

test_that("measure_labels() returns words and units", {
  found <- new_measures(
    list(door_spread_m = 30, swept_area_km2_per_h = 100, a_kN_m = 1),
    c(user_measure_kinds()["spread"], standard_measures["swept_area"],
      user_measure_kinds()["length"]),
    c(door_spread_m = 1, swept_area_km2_per_h = 1, a_kN_m = 1), FALSE
  )
  said <- measure_labels(found)
  expect_equal(said$words, c("door spread", "swept area", "a kN"))
  expect_equal(said$unit, c("m", "km2/h", "m"))
  # 100 m2/s are 3600 x 100 m2 an hour
  expect_equal(found[["swept_area_km2_per_h"]], 0.36)
})

test_that("measures are numbers that keep their units", {
  found <- measures(settled("crossing_cables"))
  expect_identical(attr(found[2:1], "unit"), c(edge_tension_kN = "kN", sag_m = "m"))
  expect_identical(attr(utils::head(found, 1), "unit"), c(sag_m = "m"))
  expect_identical(as.list(found)$sag_m, found[["sag_m"]])
  expect_null(attributes(found[["sag_m"]]))
  expect_null(attributes(unname(found)))
  table <- data.frame(value = found)
  expect_identical(table["sag_m", "value"], found[["sag_m"]])
})

test_that("measure_definitions() covers exactly the kinds a plan may request", {
  fields <- kind_node("assembly")$properties$measures$additionalProperties$properties
  defined <- measure_definitions()
  expect_setequal(defined$name[defined$user_defined], names(fields))
  for (kind in names(fields)) {
    description <- schema_description(fields[[kind]]$description)
    expect_true(startsWith(description, user_measure_kinds()[[kind]]$definition))
  }
  for (unit in defined$unit) expect_gt(unit_size(unit), 0)
  expect_false(anyDuplicated(defined$name) > 0)
  # one sentence in one line
  expect_match(defined$definition, "^[A-Z][^\n]{15,}[.]$")
})

test_that("measure_definitions() describes most measures as a sensor sees them", {
  defined <- measure_definitions()
  told <- defined$sensor[!is.na(defined$sensor)]
  expect_gt(length(told), nrow(defined) / 2)
  expect_match(told, "^[A-Z][^\n]{15,}[.]$")
  state <- settled("towed_cable")
  of_state <- measure_definitions(state)
  kind <- attr(measures(state), "kind")
  expect_identical(of_state$sensor, defined$sensor[match(kind, defined$name)])
})

test_that("state of 4,700 nodes takes at most 0.3 MB in a file", {
  state <- settled("midwater_trawl", nodes = 4700)
  measures(state)
  expect_gt(state$mesh$nodes, 4500)
  file <- file.path(test_folder(), "state.rds")
  saveRDS(state, file, compress = FALSE)
  expect_lt(file.size(file), 3e5)
})

test_that("saved state computes the same mesh, forces and measures", {
  for (name in c("poly_noreastern_trawl", "stow_net", "cage", "longline", "purse_seine")) {
    state <- settled(name, nodes = 300)
    again <- unserialize(serialize(state, NULL))
    for (field in setdiff(computed_fields, "mesh")) {
      expect_identical(again[[field]], state[[field]])
    }
    expect_identical(plain_mesh(again), plain_mesh(state))
    expect_identical(measures(again), measures(state))
  }
})
