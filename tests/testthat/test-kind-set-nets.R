# Gillnet, stow net and dip net.

height_at <- function(speed, ...) {
  net <- update(read_gear("gillnet"), water.current.speed = speed, ...)
  measures(settle(net, nodes = 400))[["net_height_m"]]
}

test_that("gillnet has its hung height in still water and less in currents", {
  # 25 meshes of 150 mm hung at 50 / (667 x 0.15); its ends move inward, and the middle rises
  # slightly.
  tall <- 25 * 0.15 * sqrt(1 - (50 / (667 * 0.15))^2)
  expect_equal(height_at(0), tall, tolerance = 0.03)
  # Headlines of bottom-set gillnets fall with the tidal flow (P. A. M. Stewart, Fisheries Research
  # 6:181, 1988).
  height <- vapply(c(0, 0.1, 0.2, 0.3), height_at, 0)
  expect_true(all(diff(height) < 0))
  expect_lt(height[4], 0.5 * height[1])
  # more floats raise it
  floats <- list(number = 40, buoyancy = "2 N", diameter = "80 mm")
  expect_gt(height_at(0.2, floats = floats), height[3])
})

test_that("gillnet height depends only on the ratio of lift to drag", {
  # Drag is proportional to speed squared and the netting is neutral, so only the ratio of lift and
  # drag matters. Twine stretch, T/EA of at most 1e-3, and the lead line on the bed cause the
  # differences.
  water <- 1025
  neutral <- function(d) list(mass_per_length = water * pi / 4 * d^2, axial_stiffness = 2e5)
  height <- vapply(1:2, function(fold) {
    twine <- c(list(diameter = 6e-4), neutral(6e-4))
    line <- c(list(diameter = 0.012), neutral(0.012))
    height_at(0.1 * fold, coefficients = "wan", wall.twine = twine, float_line = line,
      floats = list(number = 50, buoyancy = 0.8 * fold^2, drag_area = 0),
      end_lines = NULL, lead_line.mass_per_length = 5)
  }, 0)
  expect_equal(height[2], height[1], tolerance = 0.01)
})

test_that("stow net opens between its beams and its anchor carries the drag", {
  state <- settle("stow_net", nodes = 500)
  found <- measures(state)
  expect_equal(found[["mouth_width_m"]], 8, tolerance = 0.01)
  expect_equal(found[["mouth_height_m"]], 5, tolerance = 0.05)
  expect_lt(abs(found[["upper_beam_depth_m"]]), 0.3)
  angle <- asin((15 - 4.4) / 60)
  # The line sags and stretches slightly: 1 % of its tension.
  expect_equal(found[["anchor_tension_kN"]] * cos(angle), found[["total_drag_kN"]],
    tolerance = 0.01)
  faster <- measures(settle(update(read_gear("stow_net"), water.current.speed = 1.6), nodes = 500))
  expect_lt(faster[["mouth_height_m"]], found[["mouth_height_m"]])
  expect_lt(log2(faster[["total_drag_kN"]] / found[["total_drag_kN"]]), 2)
  slack <- tow("stow_net", until = 60, every = 30, nodes = 300)
  expect_identical(slack$end, "reached")
})

test_that("dip net hangs upright, trails in a current and lifts", {
  net <- read_gear("dip_net")
  still <- measures(settle(update(net, water.current.speed = 0), nodes = 400))
  expect_equal(still[["lift_angle_deg"]], 90, tolerance = 1e-4)
  # Diamond netting closes under the weight in its middle.
  expect_gt(still[["volume_left_percent"]], 40)
  expect_lt(still[["volume_left_percent"]], 102)
  # In faster water it trails nearer to the surface, with its mouth against the flow.
  swept <- vapply(c(0.12, 0.46), function(speed) {
    measures(settle(update(net, water.current.speed = speed), nodes = 400))[["lift_angle_deg"]]
  }, 0)
  expect_true(all(diff(c(90, swept)) < 0))
  lifted <- tow(net, until = 20, every = 10, nodes = 300)
  depth <- as.data.frame(lifted, what = "measures")
  depth <- depth$value[depth$measure == "frame_depth_m"]
  expect_equal(depth[1] - depth[3], 6, tolerance = 0.25)
})

test_that("dip net reports the mean depth of its corners on any mesh", {
  net <- read_gear("dip_net")
  settled <- lapply(c(300, 400), function(nodes) settle(net, nodes = nodes))
  corners <- vapply(settled, function(state) {
    vapply(1:8, function(k) -state$position[3, state$mesh$places[[paste0("collar_", k)]]], 0)
  }, numeric(8))
  # the current moves it sideways, so a single corner does not give its depth
  expect_true(all(apply(corners, 2, function(depth) diff(range(depth))) > 0.5))
  found <- lapply(settled, function(state) as.data.frame(measures(state)))
  of_frame <- function(column) {
    vapply(found, function(table) table[[column]][table$measure == "frame_depth_m"], 0)
  }
  # floating-point rounding of two means
  expect_equal(of_frame("value"), colMeans(corners), tolerance = 1e-12)
  expect_lt(diff(range(of_frame("value"))), sum(of_frame("error")))
})

test_that("netting in bars holds the point of a cone", {
  depth <- function(nodes, netting) {
    measures(settle("dip_net", nodes = nodes, netting = netting))[["bottom_depth_m"]]
  }
  expected <- depth(1000, "cells")
  # 0.2 % on 400 nodes; without a twine at the point, the depth is 0.3 to 900 % larger
  for (nodes in c(250, 400, 500)) {
    expect_equal(depth(nodes, "bars"), expected, tolerance = 0.01)
  }
})
