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

test_that("measures behave as named numbers in arithmetic", {
  slow <- measures(settle("towed_cable", nodes = 60))
  fast <- measures(settle(update(read_gear("towed_cable"), towing.speed = "5 knot"), nodes = 60))
  drag <- "total_drag_kN"
  expect_identical(fast / slow["total_drag_kN"], unlist(as.list(fast)) / slow[[drag]])
  expect_identical((fast / slow)[[drag]], fast[[drag]] / slow[[drag]])
  expect_identical((slow * 2)[[drag]], 2 * slow[[drag]])
  expect_identical((-slow)[[drag]], -slow[[drag]])
  expect_identical((fast > slow)[drag], c(total_drag_kN = TRUE))
  expect_identical(round(slow, 1)[drag], c(total_drag_kN = round(slow[[drag]], 1)))
  expect_identical(sum(slow), sum(as.double(slow)))
  expect_identical(max(slow, 1e9), 1e9)
})

test_that("measures match by name and leave out ratios of zeros", {
  found <- measures(settle("crossing_cables"))
  expect_identical(found[["least_depth_m"]], 0)
  expect_false("least_depth_m" %in% names(found / found))
  expect_false("least_depth_m" %in% names((found - found) / found))
  some <- found[c("greatest_depth_m", "sag_m")]
  expect_identical(found / some, c(sag_m = 1, greatest_depth_m = 1))
  # other names: by position
  expect_identical(unname(found["sag_m"] / found["edge_tension_kN"]),
    found[["sag_m"]] / found[["edge_tension_kN"]])
})

test_that("measures convert to a long table and keep their names", {
  found <- measures(settle("crossing_cables"))
  table <- as.data.frame(found)
  expect_named(table, c("measure", "value", "error", "unit"))
  expect_identical(table$measure, names(found))
  expect_identical(setNames(table$error, table$measure), attr(found, "error"))
  skip_if_not_installed("tibble")
  expect_identical(as.data.frame(tibble::as_tibble(found)), table)
})

test_that("measures complete by name after a dollar sign", {
  found <- measures(settle("crossing_cables"))
  expect_identical(utils::.DollarNames(found, "^sag"), "sag_m")
  expect_identical(found$sag_m, found[["sag_m"]])
})

test_that("print() of measures fits a screen and lists main measures first", {
  found <- measures(settle("midwater_trawl", nodes = 300))
  lines <- capture.output(shown <- withVisible(print(found)))
  expect_false(shown$visible)
  expect_lte(length(lines), 30L)
  first <- sub(" .*", "", trimws(lines[2:10]))
  expect_identical(first, printed_measures(found))
  expect_length(capture.output(print(found, n = Inf)), length(found) + 1L)
  expect_snapshot(print(found, n = 12))
})
