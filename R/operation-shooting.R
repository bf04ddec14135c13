# Equilibrium of a gear with a section `shooting`.
#
# Such a gear is slack nearly everywhere. From a crude layout it converges only on a coarse mesh. If
# that fails, the gear first sinks on a coarse mesh, because fine slack netting flutters and costs
# thousands of time steps.

# Duration of one sinking phase (s), maximum number of phases, nodes, and accuracy of steps.
sinking_time <- 900
most_sinkings <- 2L
sinking_nodes <- 250
sinking_accuracy <- 0.5

# Returns the result of settle_numbers() for the last attempt.
settle_shot <- function(gear, si, nodes, netting, progress) {
  settle_from <- function(shape) settle_numbers(si, nodes, netting, shape, progress = progress)
  found <- settle_from(NULL)
  if (found$report$converged) return(found)
  shot <- si$ropes[[si$shooting$rope]]$length / si$shooting$speed
  until <- shot + seq_len(most_sinkings) * sinking_time
  # an empty schedule keeps hauled ropes at full length
  sinking <- shot_trajectory(
    gear, undivided(si), list(), until[most_sinkings], min(nodes, sinking_nodes), "cells"
  )
  for (time in until) {
    sinking <- tryCatch(
      integrate_trajectory(sinking, time, time, tow_method("tr_bdf2", sinking_accuracy, NULL)),
      codend_error_not_converged = function(e) NULL
    )
    if (is.null(sinking)) return(found)
    found <- settle_from(last_shape(sinking))
    if (found$report$converged) return(found)
  }
  found
}

# Returns the last shape of a trajectory as an initial shape. Strains are omitted, because the gear
# was moving.
last_shape <- function(trajectory) {
  position <- trajectory$position[, , length(trajectory$time)]
  list(mesh = trajectory$mesh, position = mesh_points(trajectory$mesh, position))
}
