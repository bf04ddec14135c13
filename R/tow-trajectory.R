# A trajectory: states of a gear at chosen times, over the ground, and what is needed to go on.

# What of a trajectory does not change as it is marched.
trajectory_constants <- c(
  "gear", "si", "lattice", "given", "schedule", "curves", "breaks", "compared",
  "method", "every"
)

# The constants of a trajectory, as a list.
constants_of <- function(trajectory) {
  kept <- intersect(setdiff(trajectory_constants, "lattice"), names(trajectory))
  c(unclass(trajectory)[kept], list(lattice = trajectory$lattice))
}

# A trajectory has the recipe of its lattice, and a handle that holds it, as a state has.
#' @export
`[[.codend_trajectory` <- function(x, i, ...) {
  if (!identical(i, "lattice")) return(.subset2(x, i))
  handle_value(.subset2(x, "handle"), function() {
    lattice_of_recipe(.subset2(x, "si"), .subset2(x, "mesh"))
  })
}

# What a march needs of the one before: see engine_tow().
memory_fields <- c("now", "before", "steps", "caution", "step", "done")

# what: the constants, as a list; frames: as the engine hands them over.
gather_trajectory <- function(what, frames, end) {
  last <- frames[[length(frames)]]
  each <- function(pick) matrix(as.double(unlist(lapply(frames, pick))), ncol = length(frames))
  n <- what$lattice$nodes
  three <- function(x) array(x, c(3L, n, length(frames)))
  out <- c(what, list(
    time = vapply(frames, function(f) f$now$time, 0),
    position = three(each(function(f) f$now$position)),
    velocity = three(each(function(f) f$now$velocity))
  ), frame_arrays(frames), list(
    end = end, report = last$report, memory = last[memory_fields]
  ))
  out$conditions <- conditions_table(out)
  out$lattice <- NULL
  out$mesh <- mesh_recipe(what$lattice)
  out$handle <- engine_handle()
  engine_fill_handle(out$handle, what$lattice)
  out$conditions$energy_imbalance <- energy_imbalance(out$energy)
  out$conditions$energy_put_through <- out$energy[match("put_through", engine_energy_parts()), ]
  structure(out, class = "codend_trajectory")
}

# Goes on with a trajectory until a time. measured: a function(state) of what the user's control is
# told; record: NULL, or a function(what, frames) that keeps frames and gives list(add =
# function(frame), close = function(end)) for those that follow.
march_trajectory <- function(trajectory, until, every, method, measured = NULL, record = NULL) {
  what <- constants_of(trajectory)
  what$method <- method
  what$every <- every
  past <- trajectory$memory
  if (is.na(past$step) || method$accuracy == 0) past$step <- method$step
  # of the start, which a tow that goes on has too
  past$energy <- trajectory$energy[, length(trajectory$time)]
  past$ordering <- as.vector(trajectory$position[, , 1L])
  stops <- tow_stops(past$now$time, until, every, what)
  frames <- new.env(parent = emptyenv())
  frames$list <- list()
  if (!is.null(record)) record <- record(what, trajectory_frames(trajectory))
  n <- length(trajectory$time)
  front <- trajectory$catch_front[, n]
  move_catch <- if (moves_catch(what)) catch_mover(what)
  refill <- function(frame) {
    moved <- move_catch(frame)
    front <<- moved$front
    moved
  }
  keep <- function(frame) {
    frame$catch_front <- front
    frames$list[[length(frames$list) + 1L]] <- frame
    if (!is.null(record)) record$add(frame)
  }
  end <- "interrupted"
  if (!is.null(record)) on.exit(record$close(end))
  report <- NULL
  tryCatch(
    {
      mesh <- marched_mesh(what, trajectory)
      report <- engine_tow(mesh, schedule_as_done(what$schedule, past$done), past, method,
        stops, keep, steerer(what, measured, function() front), refill,
        tow_progress(past$now$time, until))
      end <- report$end
    },
    interrupt = function(e) NULL,
    codend_error_file = function(e) {
      abort_unwritten(e$file, e$why,
        gather_trajectory(what, c(trajectory_frames(trajectory), frames$list), "interrupted"))
    }
  )
  out <- gather_trajectory(what, c(trajectory_frames(trajectory), frames$list), end)
  if (end == "stuck") abort_stuck(report, out)
  if (end == "unbalanced") abort_unbalanced(report, out)
  out
}

# The mesh as the last of a trajectory's times left it.
marched_mesh <- function(what, trajectory) {
  n <- length(trajectory$time)
  lattice <- what$lattice
  changes <- list(wake = trajectory$wake[, n])
  if (!is.null(what$si$catch)) {
    lattice <- set_catch_front(lattice, trajectory$catch_front[1L, n])
    changes$mass <- catch_masses(what$si, lattice, trajectory$catch_front[2L, n])
  }
  changed_mesh(lattice$mesh, changes)
}

# Times at which steps end, and what happens there.
tow_stops <- function(begun, until, every, what) {
  steps_to <- function(every) {
    first <- floor(begun / every + 1e-9) + 1
    times <- every * seq(first, max(first, ceiling(until / every - 1e-9)))
    pmin(times, until)
  }
  kept <- unique(steps_to(every))
  steered <- if (is.null(what$given[["control"]])) numeric() else steps_to(what$given$control_every)
  broken <- what$breaks[what$breaks > begun & what$breaks <= until]
  filled <- if (moves_catch(what)) steps_to(catch_step) else numeric()
  time <- sort(unique(c(kept, broken, steered, filled)))
  list(
    time = time, kept = time %in% kept, broken = time %in% broken, steered = time %in% steered,
    filled = time %in% filled
  )
}

# The schedule with its controlled lengths and ropes as they are.
schedule_as_done <- function(schedule, done) {
  for (k in seq_along(schedule$growing)) {
    if (is.null(schedule$growing[[k]]$control)) next
    for (field in c("length", "since", "speed", "target_speed", "near_limit")) {
      schedule$growing[[k]]$control[[field]] <- done[[field]][k]
    }
  }
  for (k in seq_along(schedule$ruptures)) {
    schedule$ruptures[[k]]$broken <- done$broken[k]
    schedule$ruptures[[k]]$broken_at <- done$broken_at[k]
  }
  # where contacts stick, once a march has begun
  schedule$sticking$anchor <- as.double(done$anchor)
  schedule
}

# A function(frame) that asks the user's control for the speed of every growing part, m/s; measured:
# as in march_trajectory(); front: a function that gives the catch's.
steerer <- function(what, measured, front) {
  control <- what$given$control
  names <- vapply(what$schedule$growing, `[[`, "", "name")
  function(frame) {
    frame$catch_front <- front()
    now <- gather_trajectory(what, list(frame), "reached")
    found <- control(measured(state_at(now, frame$now$time)), frame$now$time)
    found <- vapply(given_value(found, "control"), given_si, 0, "speed", "control")
    good <- all(is.finite(found)) &&
      (length(found) == 1L || all(names %in% names(found)))
    if (!good) {
      abort_schedule("control", "must give one finite speed in m/s, or one for each warp by name.")
    }
    if (length(found) == 1L) rep(as.double(found), length(names)) else as.double(found[names])
  }
}

# The frames that a trajectory was gathered from.
trajectory_frames <- function(trajectory) {
  count <- length(trajectory$time)
  lapply(seq_len(count), function(k) {
    now <- list(
      time = trajectory$time[k], position = as.vector(trajectory$position[, , k]),
      velocity = as.vector(trajectory$velocity[, , k])
    )
    frame <- c(list(now = now), frame_of_arrays(trajectory, k))
    if (k == count) {
      frame[memory_fields] <- trajectory$memory
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
  abort_not_converged(
    c(
      "The motion stopped at {signif(report$time, 6)} s: no step down to 1e-7 s was found.",
      "x" = "Worst at {where}. What is done is the condition's {.field trajectory}."
    ),
    report = report, trajectory = trajectory
  )
}

abort_unbalanced <- function(report, trajectory) {
  where <- describe_node(trajectory$lattice, report$worst_node)
  abort_as(c("energy", "not_converged"),
    c(
      "The motion gains or loses energy at {signif(report$time, 6)} s that nothing puts in or takes
      out: more than 2 % of what is put through, however short the steps.",
      "x" = "Worst at {where}. What is done is the condition's {.field trajectory}.",
      "i" = "Use a smaller {.arg accuracy}, or another {.arg scheme}."
    ),
    report = report, trajectory = trajectory, envir = environment()
  )
}
