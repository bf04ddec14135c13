test_that("printed_measures selects spreads, heights, drag and a tension of a trawl", {
  found <- measures(settle("midwater_trawl", nodes = 200))
  expect_identical(printed_measures(found), c(
    "door_spread_m", "wing_end_spread_m", "net_mouth_height_m", "wing_end_height_m",
    "mouth_area_m2", "door_depth_m", "warp_tension_port_kN", "warp_declination_deg", "total_drag_kN"
  ))
})

test_that("printed_measures returns all measures of a small gear in their order", {
  found <- measures(settle("crossing_cables"))
  expect_identical(printed_measures(found), names(found))
})
