# A gear that is shot settles from the shape in which it sinks: none that it is laid out in leads
# there, since its lines and netting are slack nearly everywhere.

# It sinks for so long (s) at a time, at most so often, and then settles; steps may err by this (m).
sinking_time <- 900
most_sinkings <- 4L
sinking_accuracy <- 0.5

# As settle_level(); NULL where no shape that it sank in led to balance.
settle_shot <- function(gear, si, nodes, netting, progress) {
  plan <- expand_plan(check_plan(gear$plan), gear$plan)
  # not its operation: what is hauled stays out
  plan$tow <- NULL
  sinking <- as_gear(plan)
  shot <- si$ropes[[si$shooting$rope]]$length / si$shooting$speed
  for (k in seq_len(most_sinkings)) {
    until <- shot + k * sinking_time
    sinking <- tryCatch(
      tow(sinking, until = until, every = until, accuracy = sinking_accuracy, nodes = nodes,
        netting = netting),
      codend_error_not_converged = function(e) NULL
    )
    if (is.null(sinking)) return(NULL)
    shape <- state_shape(state_at(sinking, until))
    found <- settle_level(si, nodes, netting, shape, near_steps, progress)
    if (found$report$converged) return(found)
  }
  NULL
}
