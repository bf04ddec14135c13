# A trajectory: states of a gear at chosen times, over the ground, and what is needed to go on.

# A trajectory of one moment, the start: a settled state seen from the ground.
new_trajectory <- function(state) {
  lattice <- state$lattice
  towed <- state$si$towing$speed
  n <- lattice$engine$nodes
  velocity <- matrix(c(-towed, 0, 0), 3L, n)
  lattice$engine$water$x <- state$si$water$current$x
  motion <- list(
    time = 0, position = as.vector(state$position), velocity = as.vector(velocity),
    acceleration = numeric(3L * n)
  )
  frame <- list(
    now = motion, before = motion, steps = 0L, step = NA_real_,
    bar_tension = state$bar_tension, u_tension = state$u_tension, v_tension = state$v_tension,
    report = NULL
  )
  gather_trajectory(
    list(gear = state$gear, si = state$si, lattice = lattice, control = NULL), list(frame), "reached"
  )
}

# what: the gear, si, lattice and control; frames: as the engine hands them over.
gather_trajectory <- function(what, frames, end) {
  last <- frames[[length(frames)]]
  each <- function(pick) {
    matrix(as.double(unlist(lapply(frames, pick))), ncol = length(frames))
  }
  n <- what$lattice$engine$nodes
  three <- function(x) array(x, c(3L, n, length(frames)))
  structure(
    c(what, list(
      time = vapply(frames, function(f) f$now$time, 0),
      position = three(each(function(f) f$now$position)),
      velocity = three(each(function(f) f$now$velocity)),
      bar_tension = each(function(f) f$bar_tension),
      u_tension = each(function(f) f$u_tension),
      v_tension = each(function(f) f$v_tension),
      end = end, report = last$report,
      memory = last[c("now", "before", "steps", "step")]
    )),
    class = "codend_trajectory"
  )
}

# Goes on with a trajectory until a time.
march_trajectory <- function(trajectory, until, every, control) {
  begun <- trajectory$memory$now$time
  count <- max(1, ceiling((until - begun) / every - 1e-9))
  times <- pmin(begun + every * seq_len(count), until)
  frames <- new.env(parent = emptyenv())
  frames$list <- list()
  keep <- function(frame) frames$list[[length(frames$list) + 1L]] <- frame
  past <- trajectory$memory
  if (is.na(past$step)) past$step <- control$step
  end <- "interrupted"
  report <- NULL
  tryCatch(
    {
      report <- engine_tow(trajectory$lattice$engine, past, control, times, keep,
        tow_progress(begun, until))
      end <- report$end
    },
    interrupt = function(e) NULL
  )
  what <- trajectory[c("gear", "si", "lattice")]
  what$control <- control
  out <- gather_trajectory(what, c(trajectory_frames(trajectory), frames$list), end)
  if (end == "stuck") abort_stuck(report, out)
  out
}

# The frames that a trajectory was gathered from.
trajectory_frames <- function(trajectory) {
  count <- length(trajectory$time)
  lapply(seq_len(count), function(k) {
    now <- list(
      time = trajectory$time[k], position = as.vector(trajectory$position[, , k]),
      velocity = as.vector(trajectory$velocity[, , k])
    )
    frame <- list(
      now = now, bar_tension = trajectory$bar_tension[, k],
      u_tension = trajectory$u_tension[, k], v_tension = trajectory$v_tension[, k]
    )
    if (k == count) {
      frame[c("now", "before", "steps", "step")] <- trajectory$memory
      frame$report <- trajectory$report
    }
    frame
  })
}

# A function(time, steps) that shows simulated time, step and time left once a run has taken two
# seconds.
tow_progress <- function(begun, until) {
  if (!cli::is_dynamic_tty()) return(function(time, steps) NULL)
  started <- proc.time()[["elapsed"]]
  bar <- NULL
  frame <- parent.frame()
  function(time, steps) {
    if (is.null(bar)) {
      if (proc.time()[["elapsed"]] - started < 2) return(NULL)
      bar <<- cli::cli_progress_bar(
        total = until - begun, .envir = frame, format = paste(
          "{cli::pb_bar} Towing: {cli::pb_status} [{cli::pb_elapsed}], {cli::pb_eta} left"
        )
      )
    }
    cli::cli_progress_update(
      set = time - begun, id = bar, .envir = frame,
      status = sprintf("%.1f of %.1f s, step %.0f", time, until, steps)
    )
  }
}

abort_stuck <- function(report, trajectory) {
  where <- describe_node(trajectory$lattice, report$worst_node)
  cli::cli_abort(
    c(
      "The motion stands still at {signif(report$time, 6)} s: no step down to 1e-7 s was found.",
      "x" = "Worst at {where}. What is done is the condition's {.field trajectory}."
    ),
    class = c("codend_error_not_converged", "codend_error"), report = report,
    trajectory = trajectory, call = NULL
  )
}
