# Pair trawls with two warps for each vessel.

four_warps <- function(...) {
  update(example_gear("midwater_pair_trawl"), ...)
}

test_that("pair trawl with four warps is symmetric and its warps carry its drag", {
  state <- settle(four_warps(), nodes = 800)
  found <- measures(state)
  for (name in c("warp_tension", "lower_warp_tension")) {
    expect_equal(found[[paste0(name, "_port_kN")]], found[[paste0(name, "_starboard_kN")]],
      tolerance = 1e-6)
  }
  warps <- paste0(rep(c("", "lower_"), each = 2), "warp_", c("port", "starboard"))
  # Tensions at the vessels, from the first elements of the warps.
  pull <- vapply(warps, function(name) {
    node <- state$mesh$ropes[[name]]$node[1:2]
    along <- state$position[, node[2]] - state$position[, node[1]]
    found[[paste0(sub("warp_", "warp_tension_", name), "_kN")]] * along[1] / sqrt(sum(along^2))
  }, 0)
  expect_equal(sum(pull), found[["total_drag_kN"]], tolerance = 2e-3)
  ends <- lapply(c("warp_end", "lower_warp_end"), function(end) {
    state$position[, state$mesh$points[paste(end, c("port", "starboard"), sep = "_")]]
  })
  # Mirror images of each other, and the weights are below the ends of the upper warps.
  for (end in ends) {
    expect_equal(end[, 1] * c(1, -1, 1), end[, 2], tolerance = 1e-6)
  }
  expect_lt(ends[[2]][3, 1], ends[[1]][3, 1] - 5)
  # Its mouth is higher than the mouth of bottom trawls, as usual in midwater.
  expect_identical(nrow(findings(state)), 0L)
})
