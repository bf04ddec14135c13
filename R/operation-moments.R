# Errors of a tow that starts far from equilibrium (shot or laid gear). The settled gear cannot
# estimate them. The same tow is therefore computed on a second mesh: a coarser one, or a slightly
# finer one if the coarser tow fails.

little_finer <- 1.6

# Returns measures of the tow on another mesh at the saved times: list(time, nodes, measures, values
# = measures x times, SI). NULL: no other mesh reached the end. `own`: nodes of the tow's mesh;
# other arguments as in tow().
moments_elsewhere <- function(gear, given, until, every, method, nodes, netting, own) {
  for (wanted in nodes * c(1 / extra_ratio, little_finer, little_finer^2)) {
    found <- tryCatch(
      {
        start <- settled_trajectory(gear, given, until, wanted, netting)
        ratio <- start$mesh$nodes / own
        if (max(ratio, 1 / ratio) >= least_ratio) {
          integrate_trajectory(start, until, every, method, measures)
        }
      },
      codend_error = function(e) NULL
    )
    if (is.null(found)) next
    if (found$end == "interrupted") {
      stop(structure(class = c("interrupt", "condition"), list(message = "", call = NULL)))
    }
    moments <- lapply(found$time, function(time) state_values(state_at(found, time))$values)
    names <- unique(unlist(lapply(moments, names)))
    return(list(
      time = found$time, nodes = found$mesh$nodes, measures = names,
      values = vapply(moments, function(one) unname(one[names]), numeric(length(names)))
    ))
  }
}

# Stores the measures of the last compared moment. A continued tow uses its relative errors.
with_last_moment <- function(trajectory) {
  compared <- trajectory$compared
  if (!is.null(compared$time) && is.null(compared$last)) {
    time <- compared$time[length(compared$time)]
    trajectory$compared$last <- state_values(state_at(trajectory, time))$values
  }
  trajectory
}
