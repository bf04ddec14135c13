# A gear that is shot settles from the shape in which it sinks: none that it is laid out in leads
# there, since its lines and netting are slack nearly everywhere.
#
# It sinks coarsely, and the shape that it sank in is carried from level to level like any other: slack
# netting flutters, the finer the faster, which costs hundreds of steps and leaves nothing behind in a
# shape at rest.

# It sinks for so long (s) at a time, at most so often, and then settles; steps may err by this (m).
sinking_time <- 900
most_sinkings <- 4L
sinking_accuracy <- 0.5

# As settle_level(); NULL where no shape that it sank in led to balance.
settle_shot <- function(gear, si, nodes, netting, progress) {
  shot <- si$ropes[[si$shooting$rope]]$length / si$shooting$speed
  until <- shot + seq_len(most_sinkings) * sinking_time
  # without a schedule: what is hauled in its plan's operation stays out
  sinking <- shot_trajectory(gear, undivided(si), list(), until[most_sinkings],
    min(nodes, coarsest_nodes), "triangles")
  method <- tow_method("bdf2", sinking_accuracy, NULL)
  for (time in until) {
    sinking <- tryCatch(
      march_trajectory(sinking, time, time, method),
      codend_error_not_converged = function(e) NULL
    )
    if (is.null(sinking)) return(NULL)
    found <- settle_level(
      si, nodes, netting, coarse_shape(si, nodes, netting, progress, last_shape(sinking)),
      near_steps, progress
    )
    if (found$report$converged) return(found)
  }
  NULL
}

# The shape of a trajectory's last moment, to carry over; its strains are those of a motion.
last_shape <- function(trajectory) {
  position <- trajectory$position[, , length(trajectory$time)]
  list(lattice = trajectory$lattice, position = lattice_points(trajectory$lattice, position))
}
