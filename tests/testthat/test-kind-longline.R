# The shipped longline without current, with all floats fixed; `...` changes fields.
still_longline <- function(...) {
  fields <- list(floats.held = "all", end_lines = NULL, tow = NULL, water.current = NULL, ...)
  do.call(update, c(list(read_gear("longline")), fields))
}

sheared <- function(speed) {
  list(
    list(depth = "0 m", speed = 0, toward = "90 deg"),
    list(depth = "400 m", speed = speed, toward = "90 deg")
  )
}

test_that("longline hooks without current hang symmetrically at the depths of their table", {
  state <- settle(still_longline())
  found <- measures(state)[sprintf("hook_%d_depth_m", 1:15)]
  expect_equal(unname(found), rev(unname(found)), tolerance = 1e-6)
  hooks <- as.data.frame(state, what = "pieces")
  expect_identical(sum(hooks$role == "hook"), 45L)
  expect_equal(hooks$depth_m[hooks$part == "hook_2_3"], found[["hook_3_depth_m"]])
})

test_that("sheared current lifts the hooks, the deepest most", {
  depth <- vapply(c(0, 0.1, 0.25, 0.5), function(speed) {
    state <- settle(still_longline(water = list(current = sheared(speed))), nodes = 600)
    measures(state)[c("hook_1_depth_m", "hook_8_depth_m")]
  }, c(0, 0))
  share <- depth[, -1] / depth[, 1]
  expect_true(all(apply(cbind(1, share), 1, diff) < 0))
  expect_true(all(share["hook_8_depth_m", ] < share["hook_1_depth_m", ]))
})

test_that("short longline is shallower and accepts even numbers of branch lines", {
  deep <- measures(settle(still_longline(shortening_ratio = 0.5), nodes = 300))
  flat <- measures(settle(still_longline(shortening_ratio = 0.9), nodes = 300))
  expect_lt(flat[["main_line_depth_m"]], deep[["main_line_depth_m"]])
  one <- settle(still_longline(baskets = 1, branch_lines.number = 4), nodes = 300)
  expect_equal(measures(one)[["hook_2_depth_m"]], measures(one)[["hook_3_depth_m"]],
    tolerance = 1e-6)
})

test_that("longlines of many baskets settle with floats at the surface", {
  for (baskets in c("14", "16", "20", "30")) {
    state <- settle(new_plan("longline", baskets = baskets), nodes = 250)
    floats <- as.data.frame(state, what = "pieces")
    floats <- floats[floats$role == "float", ]
    expect_true(all(abs(floats$depth_m) < 0.18), label = paste(baskets, "baskets"))
  }
})

test_that("longline with free floats swims, and drifts together when released", {
  line <- read_gear("longline")
  state <- settle(line, nodes = 500)
  # end lines run outwards from the position of the first float
  out <- state$si$ropes$end_line_first$length
  expect_equal(state$position[1, nodes_at(state, "end_first")], -out)
  floats <- as.data.frame(state, what = "pieces")
  floats <- floats[floats$role == "float", ]
  expect_true(all(abs(floats$depth_m) < 0.18))
  drift <- tow(state, until = 1200, every = 600, schedule = tow_schedule(breaking = list(
    list(rope = "end_line_first", time = 60, position = "start"),
    list(rope = "end_line_last", time = 60, position = "start")
  )))
  after <- state_at(drift, 1200)
  expect_lt(measures(after)[["float_distance_m"]], measures(state)[["float_distance_m"]])
  moved <- (after$position - state$position)[2, nodes_at(state, "surface_2")]
  # The water between the surface and the deepest hook moves it.
  expect_gt(moved, 0)
  expect_lt(moved, 1140 * 0.2)
  expect_gt(measures(after)[["hook_8_depth_m"]], measures(state)[["hook_8_depth_m"]])
})
