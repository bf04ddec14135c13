# Errors of a tow. The same tow is computed twice on a coarser mesh: with the same accuracy, and
# with a tighter one. The error in time hardly depends on the mesh. The coarser mesh also gives the
# error of the mesh for gears that are shot or laid, which the settled gear cannot estimate.

# Nodes of the tow's mesh over the nodes of the coarser one, and the largest number of its nodes.
# Both limit its cost. A gear that is shot or laid has the ratio `extra_ratio`.
coarse_ratio <- 5
most_coarse_nodes <- 600
# Factors on the nodes if the tow on the coarser mesh fails and the start gives no errors.
finer_ratios <- c(1.6, 1.6^2)
# Factor on the accuracy. A fixed step is halved.
tighter <- 1 / 4

# Adds to `compared`, the start levels of a trajectory, the comparison of a tow from `gear` with its
# runs on another mesh: time, nodes, measures (names), and as measures x times in SI:
#
# - coarse: measures with the tow's accuracy;
# - time_error: standard error in time.
#
# Returns `compared` if no other mesh reaches the end. `own`: mesh of the tow; other arguments as in
# tow().
moments_elsewhere <- function(compared, gear, given, until, every, method, netting, own) {
  nodes <- own$counts$asked$nodes
  netting <- first_of(netting, netting_of(own))
  finer <- if (is.null(compared)) finer_ratios * nodes
  ratio <- if (is.null(compared)) extra_ratio else coarse_ratio
  for (wanted in c(min(nodes / ratio, most_coarse_nodes), finer)) {
    runs <- tryCatch(
      suppressWarnings({
        start <- settled_trajectory(gear, given, until, wanted, netting,
          levels = function(state) NULL)
        apart <- start$mesh$nodes / own$nodes
        if (!is.null(compared) || max(apart, 1 / apart) >= least_ratio) {
          lapply(list(coarse = method, tight = tighter_method(method)), function(how) {
            moments_of(integrate_trajectory(start, until, every, how, measures,
              progress = no_progress))
          })
        }
      }),
      codend_error = function(e) NULL
    )
    if (is.null(runs)) next
    names <- union(rownames(runs$coarse$values), rownames(runs$tight$values))
    values <- lapply(runs, function(run) {
      unname(run$values[match(names, rownames(run$values)), , drop = FALSE])
    })
    return(c(compared, runs$coarse[c("time", "nodes")], list(measures = names,
      coarse = values$coarse, time_error = time_errors(values$coarse, values$tight))))
  }
  compared
}

# Returns the kind of netting of all panels of a mesh, or NULL if they differ.
netting_of <- function(mesh) {
  bars <- mesh$counts$asked$bars
  if (all(bars)) "bars" else if (!any(bars)) "cells"
}

tighter_method <- function(method) {
  if (method$accuracy == 0) return(utils::modifyList(method, list(step = method$step / 2)))
  limits <- c("accuracy", "tolerance")
  method[limits] <- lapply(method[limits], `*`, tighter)
  method
}

# Returns the measures of a trajectory: list(time, nodes, values = measures x times, SI).
moments_of <- function(trajectory) {
  if (trajectory$end == "interrupted") {
    stop(structure(class = c("interrupt", "condition"), list(message = "", call = NULL)))
  }
  moments <- lapply(trajectory$time, function(time) state_values(state_at(trajectory, time))$values)
  names <- unique(unlist(lapply(moments, names)))
  values <- vapply(moments, function(one) unname(one[names]), numeric(length(names)))
  list(time = trajectory$time, nodes = trajectory$mesh$nodes,
    values = matrix(values, length(names), dimnames = list(names, NULL)))
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
