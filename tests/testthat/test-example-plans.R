# Plans of gears without a kind. Their closed forms are in the comments.
example_plan <- function(name) {
  file <- system.file("examples", paste0(name, ".yaml"), package = "codend")
  if (!nzchar(file)) file <- test_path("plans", paste0(name, ".yaml"))
  expect_lte(length(readLines(file)), 80L)
  read_gear(file)
}
settled_example <- function(name, nodes = 800) {
  suppressWarnings(settle(example_plan(name), nodes = nodes), classes = "codend_warning")
}
found_in <- function(name, ...) measures(settled_example(name, ...))

test_that("plans with hoops have mouths with the area of their hoop", {
  # Hoops of 0.9 m and 0.6 m; their polygons of netting nodes are a few percent smaller.
  expect_equal(found_in("fyke_net")[["mouth_area_m2"]], pi * 0.9^2 / 4, tolerance = 0.04)
  bongo <- found_in("bongo_net", nodes = 1600)
  expect_equal(bongo[["net_1_mouth_area_m2"]], pi * 0.6^2 / 4, tolerance = 0.04)
  expect_equal(bongo[["net_1_mouth_area_m2"]], bongo[["net_2_mouth_area_m2"]], tolerance = 1e-6)
})

test_that("swept area of rigid or hauled mouths is their width times the speed", {
  dredge <- found_in("scallop_dredge")
  expect_equal(dredge[["swept_area_km2_per_h"]], 2e-3 * 2.5 * 1.852, tolerance = 0.01)
  seine <- found_in("beach_seine")
  expect_equal(seine[["swept_area_km2_per_h"]],
    seine[["wing_end_spread_m"]] / 1000 * 0.3 * 3.6, tolerance = 0.01)
  # Its floats reach the water surface and go no higher.
  expect_equal(seine[["headline_height_m"]], 2.5, tolerance = 0.02)
})

test_that("outrigger trawls have the measures of one trawl each and their summed swept area", {
  found <- found_in("outrigger_trawls", nodes = 1500)
  for (name in c("wing_end_spread_m", "net_mouth_height_m", "door_spread_m")) {
    expect_equal(found[[paste0("port_net_", name)]], found[[paste0("starboard_net_", name)]],
      tolerance = 1e-6)
  }
  expect_equal(found[["swept_area_km2_per_h"]],
    2 * found[["port_net_wing_end_spread_m"]] / 1000 * 3 * 1.852, tolerance = 0.01)
})

test_that("plans of lines hang between the limits of their lengths", {
  fad <- found_in("anchored_fad")
  # A mooring of 630 m in 500 m of water reaches 383 m if it is straight; it stretches by 1 %.
  expect_lt(fad[["watch_circle_m"]], sqrt((1.01 * 630)^2 - 500^2))
  expect_gt(fad[["watch_circle_m"]], 0.8 * sqrt(630^2 - 500^2))
  trolling <- found_in("trolling_lines")
  expect_equal(trolling[["line_1_pull_kN"]], trolling[["line_2_pull_kN"]], tolerance = 1e-6)
  expect_gt(found_in("mussel_longline")[["anchor_force_kN"]],
    found_in("seaweed_longline")[["anchor_force_kN"]])
})

test_that("plans of set nets, lift nets and lampara nets settle with positive openings", {
  expect_gt(found_in("trammel_net")[["net_height_m"]], 1)
  # Walls of 8 m stretched depth on 12.5 m of rope enclose less than an upright box.
  expect_lt(found_in("set_net")[["volume_of_box_m3"]], 12.5^2 * 8)
  expect_lt(found_in("lift_net")[["area_of_net_m2"]], 12^2)
  expect_lt(found_in("lampara_net")[["depth_of_lead_line_m"]], 20)
})

test_that("topless trawl has the bosom of its headline behind the bosom of its footrope", {
  state <- settled_example("topless_trawl")
  middle <- vapply(state$mesh$ropes[c("headline", "footrope")], function(rope) {
    state$position[1, rope$node[ceiling(length(rope$node) / 2)]]
  }, 0)
  # The rear wings are 4.8 m deep (stretched) and diverge.
  behind <- middle[["headline"]] - middle[["footrope"]]
  expect_gt(behind, 4)
  expect_lt(behind, 4.8)
})
