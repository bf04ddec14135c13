# Stiff lines in motion. Their reference solution is references/stiff-lines.csv.

use_tests("test-stiff-motion")

# Three hundred metres of steel warp with a clump, towed while the vessel heaves by 1.5 m every 8 s.
heaved_warp <- function() {
  as_gear(list(
    codend = 1, name = "Heaved warp",
    points = list(vessel = list(position = c(0, 0, 0), held = "moved"), at_clump = list()),
    ropes = list(warp = list(from = "vessel", to = "at_clump", length = "300 m", segments = 100,
      diameter = "20 mm", axial_stiffness = "20 MN", mass_per_length = "1.5 kg/m")),
    pieces = list(clump = list(at = "at_clump", mass = "400 kg", volume = "50 l",
      drag_area = "0.2 m2")),
    towing = list(speed = "1.5 m/s")
  ))
}

# A chain of 58 m from an anchor in 20 m, whose end at the surface heaves by 1 m every 7 s. It lifts
# off the ground and lands again.
anchor_line <- function() {
  as_gear(list(
    codend = 1, name = "Anchor line",
    points = list(anchor = list(position = c(0, 0, -20), held = "fixed"),
      buoy = list(position = c(50, 0, 0), held = "moved")),
    ropes = list(chain = list(from = "anchor", to = "buoy", length = "58 m", segments = 60,
      diameter = "16 mm", material = "steel_chain")),
    seabed = list(depth = "20 m", friction = 0.5)
  ))
}

heave_of <- function(height, period) function(t) height * (1 - cos(2 * pi * t / period)) / 2

# Each case: gear(), until and every (s), heave.
stiff_lines <- list(
  steel_chain = list(gear = steel_chain, until = 8, every = 0.5),
  chain_in_air = list(gear = chain_in_air, until = 4, every = 0.5),
  heaved_warp = list(gear = heaved_warp, until = 24, every = 1, heave = heave_of(1.5, 8)),
  anchor_line = list(gear = anchor_line, until = 24, every = 1, heave = heave_of(1, 7))
)

integrate_stiff_line <- function(name, ...) {
  case <- stiff_lines[[name]]
  tow(case$gear(), tow_schedule(heave = case$heave), case$until, case$every, ...)
}

# Compared values of a trajectory after its start: coordinates `axes` of nodes (m), tensions of bars
# and the largest tension (N). `column`: list with the name and value of the first column. Returns a
# data frame with that column, time (s), kind, number (of the node or bar, 0: all) and value.
motion_rows <- function(column, found, axes, node, bar = integer()) {
  late <- which(found$time > 0)
  of <- function(kind, number, value) {
    data.frame(column, time = rep(found$time[late], each = length(number)), kind = kind,
      number = number, value = as.vector(value))
  }
  coordinates <- lapply(axes, function(axis) {
    of(axis, node, found$position[match(axis, c("x", "y", "z")), node, late])
  })
  rbind(
    do.call(rbind, coordinates),
    if (length(bar)) of("tension", bar, found$bar_tension[bar, late]),
    of("largest_tension", 0, apply(found$bar_tension[, late], 2, max))
  )
}

stiff_line_rows <- function(name, found) {
  node <- unique(c(1, 2, round(seq(3, dim(found$position)[2], length.out = 9))))
  motion_rows(list(case = name), found, c("x", "z"), node)
}
