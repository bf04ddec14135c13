# Measured gears by name: list(label, gear = function() that returns a gear, netting = element type
# of the netting in each version, flow = field of the water's speed). `refined` gears are measured
# at every size, `public` gears at the size of their plans.

# Returns a gear of the last release with that release's default drag model.
released <- function(name) {
  update(read_gear(file.path(release_folder, "inst", "gears", paste0(name, ".yaml"))),
    netting_drag = "morison")
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

# Square netting of n x n knots, 0.5 m apart, fixed at the upper edge.
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

# Factors of the water speed: five neighbours of every gear. If netting slackens during the solve,
# the smallest change of a gear can change the number of iterations by half.
neighbours <- 1 + c(0, 0.001, -0.001, 0.002, -0.002)
