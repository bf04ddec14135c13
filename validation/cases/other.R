# Cages, seines and published values of whole gears.

case_model_cage <- function() {
  at <- function(speed, mass = "400 g", ...) {
    settle(update(read_gear("model_cage"), water.current.speed = speed, sinkers.mass = mass, ...),
      nodes = 700)
  }
  speeds <- c(0.13, 0.26, 0.39, 0.52)
  states <- lapply(speeds, at)
  of <- function(states, name) vapply(states, function(state) measures(state)[[name]], 0)
  masses <- c(400, 600, 800)
  weighted <- lapply(masses, function(mass) at(0.39, paste(mass, "g")))
  still <- at(0.04)
  # Published results: forces grow with a power of speed below 2, and volume falls with speed and
  # grows with weight. The power of the drag is compared as less than 2.
  falls <- -1
  rbind(
    compared("water_left", "middle of the model", 0.8, min(still$mesh$model$wake)),
    sign_of("volume", "speed", falls, speeds, of(states, "volume_left_percent")),
    sign_of("volume", "sinkers", 1, masses, of(weighted, "volume_left_percent")),
    sign_of("drag", "sinkers", 1, masses, of(weighted, "net_drag_kN")),
    sign_of("drag_over_square", "speed", falls, speeds, of(states, "net_drag_kN") / speeds^2)
  )
}

# A trend with only its direction published.
sign_of <- function(quantity, at, published, x, computed) {
  row <- trend(quantity, at, x, computed, computed)
  row$measured <- published
  row
}

# A shielded cage has up to 22 % less drag in published simulations (OMAE2013, V003T05A027).
case_cage_shielding <- function() {
  drag <- function(...) {
    measures(settle(update(read_gear("model_cage"), water.current.speed = 0.13, ...),
      nodes = 700))[["net_drag_kN"]]
  }
  compared("drag", "shielded over unshielded", 0.78, drag() / drag(shielding = "none"))
}

seine_figures <- function(gear) {
  seine <- tow(gear, nodes = 300, accuracy = 0.3, every = 10)
  table <- as.data.frame(seine, what = "measures")
  series <- function(name) table[table$measure == name, ]
  depth <- series("lead_line_depth_middle_m")
  deepest <- which.max(depth$value)
  # the middle is released 50 s after the start of shooting
  c(depth$value[deepest], depth$value[deepest] / (depth$time_s[deepest] - 50),
    max(series("purse_wire_tension_kN")$value))
}

case_java_seine <- function() {
  plan <- read_gear("purse_seine")
  # the modified seine: 30.3 mm knotless polyester, with unchanged lengths and weights
  changes <- unlist(lapply(c("bunt", "body", "wing"), function(panel) {
    meshes <- lapply(plan$plan$panels[[panel]]$meshes, function(n) n * 25.4 / 30.3)
    stats::setNames(list("30.3 mm", meshes, FALSE, "polyester"), paste0("panels.", panel, ".",
      c("mesh_size", "meshes", "knotted", "twine.material")))
  }), recursive = FALSE)
  first <- seine_figures(plan)
  other <- seine_figures(do.call(update, c(list(plan), changes)))
  published <- rbind(c(30, 0.13, 1794 * 9.81 / 1000), c(38, 0.16, 1044 * 9.81 / 1000))
  gears <- c("seine of Java", "modified")
  x <- c(25.4, 30.3)
  do.call(rbind, lapply(1:3, function(k) {
    name <- c("depth", "sinking_speed", "purse_line_tension")[k]
    ours <- c(first[k], other[k])
    rbind(compared(name, gears, published[, k], ours),
      trend(name, "mesh", x, published[, k], ours))
  }))
}

# The shipped midwater trawl was fitted to the paper's three values, so it does not count.
case_paper_trawl <- function() {
  found <- measures(settle(read_gear("midwater_trawl"), nodes = 1500))
  wanted <- c(net_mouth_height = 105, wing_end_spread = 113, door_spread = 151.89)
  compared(names(wanted), "4 knot, 700 m of warp", wanted,
    as.double(found[paste0(names(wanted), "_m")]), TRUE)
}
