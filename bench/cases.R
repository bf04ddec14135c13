# The gears that are measured, by name: list(label, gear = function() -> a read gear, netting as
# settle() of each version takes it, flow = the field of the water's speed). Those of `refined` are
# measured at every size, those of `public` as their plans say.

# A gear of the last release, with the drag law that it had by default.
released <- function(name) {
  update(read_gear(file.path(release_folder, "inst", "gears", paste0(name, ".yaml"))),
    netting_drag = "twines")
}

bars <- c(release = "bars", now = "bars")
cells <- c(release = "triangles", now = "cells")
only_now <- function(netting) netting["now"]

refined <- list(
  trawl_bars = list(label = "midwater trawl of 0.1.0, bars",
    gear = function() released("midwater_trawl"), netting = bars, flow = "towing.speed"),
  trawl_cells = list(label = "midwater trawl of 0.1.0, cells",
    gear = function() released("midwater_trawl"), netting = cells, flow = "towing.speed"),
  panel_bars = list(label = "flat panel, bars",
    gear = function() released("flat_panel"), netting = bars, flow = "water.current.speed"),
  panel_cells = list(label = "flat panel, cells",
    gear = function() released("flat_panel"), netting = cells, flow = "water.current.speed"),
  own_trawl_bars = list(label = "midwater trawl, bars",
    gear = function() read_gear("midwater_trawl"), netting = only_now(bars), flow = "towing.speed"),
  own_trawl_cells = list(label = "midwater trawl, cells",
    gear = function() read_gear("midwater_trawl"), netting = only_now(cells), flow = "towing.speed")
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
  list(warp_200 = list(label = "A: warp, 200 segments", gear = function() test_plan("towed_warp"),
    netting = bars, flow = "water.current.speed")),
  lapply(c(square_net_20 = 20, square_net_40 = 40, square_net_80 = 80), function(n) {
    force(n)
    list(label = paste0("B: square net, n = ", n), gear = function() square_net(n), netting = bars,
      flow = "water.current.speed")
  })
)

known_cases <- c(refined, public)

# Five neighbours of every gear: shares of the water's speed. Where netting goes slack on its way,
# the number of steps changes by a half with the least change of a gear.
neighbours <- 1 + c(0, 0.001, -0.001, 0.002, -0.002)
