# Start of a tow with the gear bunched at the surface along the vessel's track. Each node is
# released when the vessel passes it.

# Depth range of the bunched gear below the surface (m).
bunched_depth <- 0.5

shot_trajectory <- function(gear, si, given, until, nodes, netting) {
  what <- tow_start(gear, si, build_mesh(si, nodes, netting), given, until)
  position <- shot_position(si, what$mesh)
  add_start(what, position, c(0, 0, 0))
}

# Returns the position of each node along the rope [m].
shot_reach <- function(si, mesh) {
  pmin(pmax(mesh$hung[1, ], 0), si$ropes[[si$shooting$rope]]$length)
}

# Returns the initial positions, 3 x nodes [m].
shot_position <- function(si, mesh) {
  hung <- mesh$hung
  # floats get the same depth as weights
  depth <- abs(hung[3, ])
  on_way <- vessel_path(si$shooting, si$ropes[[si$shooting$rope]]$length, shot_reach(si, mesh))
  position <- rbind(on_way, -depth * min(1, bunched_depth / max(depth)))
  held <- mesh$model$held
  position[, held] <- mesh$start[, held]
  position
}

# Returns the release times of nodes: list(node, time [s]). Empty if the gear is not shot or is
# already in the water.
shooting_times <- function(si, mesh) {
  if (is.null(mesh$hung) || isTRUE(mesh$let_go)) {
    return(list(node = integer(), time = numeric()))
  }
  free <- which(!mesh$model$held)
  list(node = free, time = shot_reach(si, mesh)[free] / si$shooting$speed)
}
