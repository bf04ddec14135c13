# A tow that starts with the gear lying bunched at the surface along the vessel's way, and lets
# every node go when the vessel passes its place.

# Over this depth below the surface the whole of a gear lies bunched before it sinks, m.
bunched_depth <- 0.5

shot_trajectory <- function(gear, si, given, until, nodes, netting) {
  what <- tow_start(gear, si, build_lattice(si, nodes, netting), given, until)
  position <- shot_position(si, what$lattice)
  add_start(what, position, c(0, 0, 0))
}

# How far along the rope every node lies, m.
shot_reach <- function(si, lattice) {
  pmin(pmax(lattice$hung[1, ], 0), si$ropes[[si$shooting$rope]]$length)
}

# Positions (3 x nodes, m) of the gear as it is laid.
shot_position <- function(si, lattice) {
  hung <- lattice$hung
  # What floats lies with the rest.
  depth <- abs(hung[3, ])
  on_way <- vessel_way(si$shooting, si$ropes[[si$shooting$rope]]$length, shot_reach(si, lattice))
  position <- rbind(on_way, -depth * min(1, bunched_depth / max(depth)))
  held <- lattice$mesh$held
  position[, held] <- lattice$start[, held]
  position
}

# When the nodes of a gear that is shot are let go: list(node, time (s)); none where it is not, or
# where a tow starts with all of it in the water.
shooting_times <- function(si, lattice) {
  if (is.null(lattice$hung) || isTRUE(lattice$let_go)) {
    return(list(node = integer(), time = numeric()))
  }
  free <- which(!lattice$mesh$held)
  list(node = free, time = shot_reach(si, lattice)[free] / si$shooting$speed)
}
