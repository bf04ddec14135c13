# The gears that are measured, by name: list(label, gear = function() -> a read gear, netting = as
# in settle()). Those of `refined` are measured at every size, those of `public` as their plans say.

refined <- list(
  trawl_bars = list(
    label = "midwater trawl, bars", gear = function() read_gear("midwater_trawl"), netting = "bars"
  ),
  trawl_cells = list(
    label = "midwater trawl, cells", gear = function() read_gear("midwater_trawl"),
    netting = "cells"
  ),
  panel_bars = list(
    label = "flat panel, bars", gear = function() read_gear("flat_panel"), netting = "bars"
  ),
  panel_cells = list(
    label = "flat panel, cells", gear = function() read_gear("flat_panel"),
    netting = "cells"
  )
)

test_plan <- function(name) {
  read_gear(file.path("tests", "testthat", "plans", paste0(name, ".yaml")))
}

# n x n knots of square netting, 0.5 m apart, held by the upper edge.
square_net <- function(n) {
  half <- (n - 1) / 4
  update(test_plan("square_net"),
    panels.net.meshes = list(upper = n - 1, lower = n - 1, deep = n - 1),
    panels.net.columns = n - 1, pieces.sinkers.number = n,
    points.port.position = c(0, -half, -10), points.starboard.position = c(0, half, -10)
  )
}

public <- c(
  list(warp_200 = list(label = "A: warp, 200 segments", gear = function() test_plan("towed_warp"))),
  lapply(c(square_net_20 = 20, square_net_40 = 40, square_net_80 = 80), function(n) {
    force(n)
    list(label = paste0("B: square net, n = ", n), gear = function() square_net(n))
  })
)

known_cases <- c(refined, public)
