# Errors of a tow whose gear starts far from where it settles, shot or laid: the gear as it settles
# says little of them, so that the same tow is marched first on a coarser lattice, or on one little
# finer where none is coarser.

little_finer <- 1.6

starts_elsewhere <- function(trajectory) {
  !isTRUE(trajectory$lattice$let_go) && any(c("shooting", "laid") %in% names(trajectory$si))
}

# The measures of such a tow on another lattice at its kept times: list(time, nodes, measures,
# values = measures x times, SI); NULL where none comes to its end. own: nodes of the tow's lattice;
# the others as tow() has them.
moments_elsewhere <- function(gear, given, until, every, method, nodes, netting, own) {
  for (wanted in nodes * c(1 / extra_ratio, little_finer, little_finer^2)) {
    found <- tryCatch(
      {
        start <- settled_trajectory(gear, given, until, wanted, netting)
        ratio <- start$lattice$nodes / own
        if (max(ratio, 1 / ratio) >= least_ratio) {
          march_trajectory(start, until, every, method, measures)
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
      time = found$time, nodes = found$lattice$nodes, measures = names,
      values = vapply(moments, function(one) unname(one[names]), numeric(length(names)))
    ))
  }
}

# A trajectory that goes on: past the moments that it is compared at the errors are, as shares,
# those of the last one, whose measures are kept with them.
with_last_moment <- function(trajectory) {
  compared <- trajectory$compared
  if (!is.null(compared$time) && is.null(compared$last)) {
    time <- compared$time[length(compared$time)]
    trajectory$compared$last <- state_values(state_at(trajectory, time))$values
  }
  trajectory
}
