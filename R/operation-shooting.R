# A gear that is shot hangs slack nearly everywhere: only coarsely divided does it settle from
# a crude layout, in hundreds of steps, and its shape is carried from there from level to level.
#
# Where that does not lead to balance it settles from the shape in which it sinks, coarsely divided
# too: fine slack netting flutters, which costs a march thousands of steps and leaves nothing behind
# in a shape at rest.

# It sinks for so long (s) at a time, at most so often, with so many nodes; steps may err by this
# (m).
sinking_time <- 900
most_sinkings <- 2L
sinking_nodes <- 250
sinking_accuracy <- 0.5

# As settle_numbers(), of the last of its trials.
settle_shot <- function(gear, si, nodes, netting, progress) {
  settle_from <- function(shape) settle_numbers(si, nodes, netting, shape, progress = progress)
  found <- settle_from(NULL)
  if (found$report$converged) return(found)
  shot <- si$ropes[[si$shooting$rope]]$length / si$shooting$speed
  until <- shot + seq_len(most_sinkings) * sinking_time
  # without a schedule: what is hauled in its plan's operation stays out
  sinking <- shot_trajectory(
    gear, undivided(si), list(), until[most_sinkings], min(nodes, sinking_nodes), "cells"
  )
  for (time in until) {
    sinking <- tryCatch(
      march_trajectory(sinking, time, time, tow_method("bdf2", sinking_accuracy, NULL)),
      codend_error_not_converged = function(e) NULL
    )
    if (is.null(sinking)) return(found)
    found <- settle_from(last_shape(sinking))
    if (found$report$converged) return(found)
  }
  found
}

# The shape of a trajectory's last moment, to carry over; its strains are those of a motion.
last_shape <- function(trajectory) {
  position <- trajectory$position[, , length(trajectory$time)]
  list(lattice = trajectory$lattice, position = lattice_points(trajectory$lattice, position))
}
