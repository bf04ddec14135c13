#' State at a moment of a tow
#'
#' Returns the state of a towed gear at a saved time, as seen from the vessel. All functions for
#' settled states accept it, such as [measures()], `summary()`, `plot()` and [view_3d()].
#'
#' x points aft and y to starboard. The origin moves with the vessel; at time 0 it is the plan's
#' origin.
#'
#' @param trajectory A trajectory, from [tow()].
#' @param time Time, s, or a string with a unit. The nearest saved time is used.
#' @return A state of class `codend_state` with two further fields: `time` (s) and `velocity` (3 x
#'   nodes, m/s, relative to the vessel). The net forces accelerate the gear, so they are not 0.
#' @seealso [tow()], [measures()], [as.data.frame()][as.data.frame.codend_trajectory] for all times.
#' @examples
#' state <- settle("midwater_trawl", nodes = 300)
#' faster <- tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "4.5 knot")))
#' trajectory <- tow(state, faster, until = 40, every = 20)
#' measures(state_at(trajectory, "40 s"))[["total_drag_kN"]]
#' @export
state_at <- function(trajectory, time) {
  check_given("trajectory", "time")
  if (!inherits(trajectory, "codend_trajectory")) {
    abort_schedule("trajectory", "must be a trajectory, as {.fn tow} returns.")
  }
  wanted <- quantity_number(time, "time", "time")
  ends <- range(trajectory$time)
  # saved times are multiples of a step, with rounding errors
  if (wanted < ends[1L] - 1e-6 || wanted > ends[2L] + 1e-6) {
    abort_argument("{.arg time} is {.val {time}}; it must be between {ends[1]} s and {ends[2]} s,
      the times of the trajectory.")
  }
  k <- which.min(abs(trajectory$time - wanted))
  now <- conditions_at(trajectory, trajectory$time[k], trajectory$winch_length[, k])
  now$broken <- trajectory$broken[, k]
  now$wake <- trajectory$wake[, k]
  now$catch_front <- trajectory$catch_front[, k]
  si <- si_at(trajectory, now)
  mesh <- mesh_at(trajectory, now)
  turned <- to_vessel(now$course)
  state <- new_state(
    trajectory$gear, si, mesh,
    as.vector(turned %*% (trajectory$position[, , k] - c(now$x, now$y, 0))),
    c(list(converged = TRUE, iterations = trajectory$report$iterations, residual = NA_real_),
      trajectory$report["steps"]),
    as.vector(turned %*% (trajectory$velocity[, , k] - c(now$x_rate, now$y_rate, 0)))
  )
  state$time <- trajectory$time[k]
  state$compared <- compared_at(trajectory, state$time)
  state$step_accuracy <- first_of(trajectory$report$largest_error, 0)
  state
}

# Returns the comparison values for one moment: list(levels, values) of the start, see
# compared_meshes(), and from the runs on another mesh `coarse` (a level), `last` (values that it is
# carried from, or NULL) and `time_error` (SI), both by measure.
compared_at <- function(trajectory, time) {
  compared <- trajectory$compared
  if (is.null(compared$time)) return(compared)
  k <- which.min(abs(compared$time - time))
  at <- function(of) setNames(compared[[of]][, k], compared$measures)
  c(compared[c("levels", "values")], list(
    coarse = list(nodes = compared$nodes, values = at("coarse")),
    last = if (time > compared$time[k] + 1e-6) compared$last, time_error = at("time_error")
  ))
}

# Returns the rotation from ground axes to the axes of a vessel with this course [rad].
to_vessel <- function(course) {
  rbind(c(cos(course), -sin(course), 0), c(sin(course), cos(course), 0), c(0, 0, 1))
}

# Returns a data frame: one row per saved time. Vessel over the ground: x, y [m], x_rate, y_rate,
# speed [m/s], course [rad], heave [m]. In waves: elevation of the water there [m]. One column per
# growing part: its length [m] or fraction.
conditions_table <- function(trajectory) {
  scheduled_table(trajectory, trajectory$time,
    engine_schedule_at(trajectory$schedule, trajectory$time, as.double(trajectory$winch_length)))
}

scheduled_table <- function(what, time, found) {
  origin <- matrix(found$origin, 3L)
  velocity <- matrix(found$velocity, 3L)
  table <- data.frame(
    time = time, x = origin[1, ], y = origin[2, ], x_rate = velocity[1, ],
    y_rate = velocity[2, ], speed = curve_at(what$curves$speed, time, after = TRUE),
    course = found$heading, heave = origin[3, ]
  )
  waves <- what$mesh$model$water$waves
  if (!is.null(waves)) {
    table$elevation <- engine_elevation(waves, table$x, table$y, as.double(time))
  }
  growing <- what$schedule$growing
  factor <- matrix(found$factor, length(growing), length(time))
  for (k in seq_along(growing)) {
    name <- growing[[k]]$name
    table[[name]] <- first_of(table[[name]], 0) + factor[k, ] * growing[[k]]$whole
  }
  table
}

# Returns the same for one time as a list. It adds the scheduled current over the ground (m/s by
# depth) and `winch_length`, the paid-out length (m) by growing part. `before`: TRUE for values
# before a jump.
conditions_at <- function(what, time, winch_length = winches_at_start(what$schedule),
                          before = FALSE) {
  # the engine returns values after a jump; 1e-9 s earlier it is still before it
  if (before) time <- time - 1e-9
  found <- engine_schedule_at(what$schedule, time, as.double(winch_length))
  c(
    as.list(scheduled_table(what, time, found)), found[c("current_x", "current_y")],
    list(winch_length = winch_length, broken = integer())
  )
}

winches_at_start <- function(schedule) {
  vapply(schedule$growing, function(part) first_of(part$control$length, 0), 0)
}

# Returns the gear's numbers at one time, in the vessel's axes.
si_at <- function(what, now) {
  si <- what$si
  si$towing$speed <- now$speed
  for (part in what$schedule$growing) {
    if (!is.null(si$ropes[[part$name]])) si$ropes[[part$name]]$length <- now[[part$name]]
  }
  if (!is.null(si$catch)) {
    si$catch <- si_catch_share(si$catch, curve_at(what$curves$catch, now$time, after = TRUE))
  }
  if (length(now$current_x)) {
    si$water$current$x <- now$current_x
    si$water$current$y <- now$current_y
  }
  ground <- rbind(si$water$current$x, si$water$current$y)
  turned <- to_vessel(now$course)[1:2, 1:2] %*% ground
  si$water$current$x <- turned[1, ]
  si$water$current$y <- turned[2, ]
  if (!is.null(si$ground)) si$ground <- ground_from_vessel(si$ground, now)
  si
}

# Returns the mesh at one time, in the vessel's axes.
mesh_at <- function(what, now) {
  mesh <- what$mesh
  si <- si_at(what, now)
  ropes <- intersect(vapply(what$schedule$growing, `[[`, "", "name"), names(what$si$ropes))
  mesh$built_lengths <- c(
    mesh$built_lengths, vapply(setdiff(ropes, names(mesh$built_lengths)), function(rope) {
      what$si$ropes[[rope]]$length
    }, 0)
  )
  model <- mesh$model
  changes <- scheduled_fields(model, what$schedule, now)
  changes$water <- list(x = si$water$current$x + now$speed, y = si$water$current$y)
  changes$water$waves <-
    waves_from_vessel(model$water$waves, now$time, c(now$x, now$y), now$course)
  if (!is.null(now$wake)) changes$wake <- now$wake
  if (!is.null(si$ground)) changes$ground <- ground_from_vessel(model$ground, now)
  if (length(now$catch_front)) mesh <- set_catch_front(mesh, now$catch_front[1L])
  change_mesh(mesh, changes)
}

# Returns the fields of a mesh that depend on growing parts and broken bars at one time.
scheduled_fields <- function(model, schedule, now) {
  if (!length(schedule$growing) && !any(now$broken > 0)) return(list())
  still <- numeric(length(now$winch_length))
  broken <- integer(length(schedule$ruptures))
  broken[seq_along(now$broken)] <- as.integer(now$broken)
  done <- list(
    length = now$winch_length, since = still + now$time, speed = still, target_speed = still,
    near_limit = still > 0, broken = broken, broken_at = 0 * broken
  )
  found <- engine_scheduled(model, schedule_as_done(schedule, done), now$time)
  c(found[c("mass", "load")], list(
    bars = found[c("rest", "multiplicity")], spheres = found[c("drag_area", "added_mass")],
    volumes = found["buoyancy"]
  ))
}

# Returns the sea bed in the vessel's axes; it moves past at the towing speed.
ground_from_vessel <- function(ground, now) {
  ground$height <- ground$height - sum(ground$normal * c(now$x, now$y, 0))
  ground$normal <- drop(to_vessel(now$course) %*% ground$normal)
  passing <- c(now$speed, 0, 0)
  ground$velocity <- passing - sum(passing * ground$normal) * ground$normal
  ground
}
