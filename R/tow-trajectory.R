# Class `codend_trajectory`: states over the ground at saved times, and data to continue.

# Fields that stay constant during time integration.
trajectory_constants <- c(
  "gear", "si", "mesh", "given", "schedule", "curves", "breaks", "compared",
  "method", "every"
)

constants_of <- function(trajectory) {
  kept <- intersect(setdiff(trajectory_constants, "mesh"), names(trajectory))
  c(unclass(trajectory)[kept], list(mesh = trajectory$mesh))
}

# A trajectory stores the recipe of its mesh; a handle caches the mesh itself.
#' @export
`[[.codend_trajectory` <- function(x, i, ...) {
  if (!identical(i, "mesh")) return(.subset2(x, i))
  handle_value(.subset2(x, "handle"), function() {
    mesh_of_recipe(.subset2(x, "si"), .subset2(x, "recipe"))
  })
}

# Data for a continuation, see engine_tow().
memory_fields <- c("now", "before", "steps", "caution", "step", "done")

# `what`: list of constants; `frames`: snapshots from the engine.
gather_trajectory <- function(what, frames, end) {
  last <- frames[[length(frames)]]
  each <- function(pick) matrix(as.double(unlist(lapply(frames, pick))), ncol = length(frames))
  n <- what$mesh$nodes
  three <- function(x) array(x, c(3L, n, length(frames)))
  out <- c(what, list(
    time = vapply(frames, function(f) f$now$time, 0),
    position = three(each(function(f) f$now$position)),
    velocity = three(each(function(f) f$now$velocity))
  ), frame_arrays(frames), list(
    end = end, report = last$report, memory = last[memory_fields]
  ))
  out$conditions <- conditions_table(out)
  out$mesh <- NULL
  out$recipe <- mesh_recipe(what$mesh)
  out$handle <- engine_handle()
  engine_fill_handle(out$handle, what$mesh)
  out$conditions$energy_imbalance <- energy_imbalance(out$energy)
  out$conditions$energy_put_through <- out$energy[match("put_through", engine_energy_parts()), ]
  structure(out, class = "codend_trajectory")
}

# Continues a trajectory until a time. `measured`: function(state) that returns the input of the
# user's controller. `record`: NULL, or `function(what, frames)` that saves snapshots and returns
# list(add = function(frame), close = function(end)) for further ones. `progress(begun, until)`:
# returns a function(time, steps) that shows progress.
integrate_trajectory <- function(trajectory, until, every, method, measured = NULL, record = NULL,
                                 progress = tow_progress) {
  what <- constants_of(trajectory)
  what$method <- method
  what$every <- every
  past <- trajectory$memory
  if (is.na(past$step) || method$accuracy == 0) past$step <- method$step
  # the node ordering follows from the initial shape, for identical results after a continuation
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
      model <- model_at_time(what, trajectory)
      show <- progress(past$now$time, until)
      report <- engine_tow(model, schedule_as_done(what$schedule, past$done), past, method,
        stops, keep, steerer(what, measured, function() front), refill, show)
      end <- report$end
      if (end == "reached") show(until, report$steps)
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

# Returns the mesh at the last time of a trajectory.
model_at_time <- function(what, trajectory) {
  n <- length(trajectory$time)
  mesh <- what$mesh
  changes <- list(wake = trajectory$wake[, n])
  if (!is.null(what$si$catch)) {
    mesh <- set_catch_front(mesh, trajectory$catch_front[1L, n])
    changes$mass <- catch_masses(what$si, mesh, trajectory$catch_front[2L, n])
  }
  changed_model(mesh$model, changes)
}

# Returns the times at which steps must end, the events at these times, and further times to record.
tow_stops <- function(begun, until, every, what) {
  steps_to <- function(every) {
    first <- floor(begun / every + 1e-9) + 1
    times <- every * seq(first, max(first, ceiling(until / every - 1e-9)))
    pmin(times, until)
  }
  kept <- unique(steps_to(every))
  steered <- if (is.null(what$given[["control"]])) numeric() else steps_to(what$given$control_every)
  within <- function(times) times[times > begun & times <= until]
  broken <- within(what$breaks)
  filled <- if (moves_catch(what)) steps_to(catch_step) else numeric()
  bends <- unlist(lapply(what$curves[c("speed", "course", "heave")], curve_breaks, kinks = TRUE))
  time <- sort(unique(c(until, broken, within(bends), steered, filled)))
  list(
    time = time, kept = time %in% kept, broken = time %in% broken, steered = time %in% steered,
    filled = time %in% filled, recorded = setdiff(kept, time)
  )
}

# Returns the schedule with the present controlled lengths and broken ropes.
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
  # contact points of sticking friction, once time integration has begun
  schedule$sticking$anchor <- as.double(done$anchor)
  schedule
}

# Returns a function(frame) that calls the user's controller for the speed of each growing part
# [m/s]. `measured`: as in integrate_trajectory(); `front`: function that returns the front of the
# catch.
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
      abort_schedule("control", "must return one finite speed in m/s, or one for each warp by
        name.")
    }
    if (length(found) == 1L) rep(as.double(found), length(names)) else as.double(found[names])
  }
}

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

no_progress <- function(begun, until) function(time, steps) NULL

# Returns a function(time, steps) that shows progress once a run has taken two seconds, or reports
# percents to progressr.
tow_progress <- function(begun, until) {
  report <- progressr_steps(100, 0, parent.frame())
  if (!is.null(report)) {
    return(function(time, steps) report(floor(100 * (time - begun) / (until - begun))))
  }
  if (!cli::is_dynamic_tty()) return(no_progress(begun, until))
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
  where <- describe_node(trajectory$mesh, report$worst_node)
  abort_not_converged(
    c(
      "The tow stopped at {signif(report$time, 6)} s: no step down to 1e-7 s converged.",
      "x" = "Worst at {where}. The condition's {.field trajectory} has the completed part."
    ),
    report = report, trajectory = trajectory
  )
}

abort_unbalanced <- function(report, trajectory) {
  where <- describe_node(trajectory$mesh, report$worst_node)
  abort_as(c("energy", "not_converged"),
    c(
      "The tow stopped at {signif(report$time, 6)} s: the energy balance is wrong by more than 2 %
      of the energy present, even with short steps.",
      "x" = "Worst at {where}. The condition's {.field trajectory} has the completed part.",
      "i" = "Use a smaller {.arg accuracy}, or softer ropes in the plan."
    ),
    report = report, trajectory = trajectory, envir = environment()
  )
}
