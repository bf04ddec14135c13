# A moment of a trajectory, in the vessel's own axes.

#' A moment of a tow
#'
#' The state of a towed gear at one of the times that its trajectory keeps, as seen from the vessel:
#' x aft, y to starboard, from the point that was the plan's origin at the start. Everything that
#' reads a settled state reads it: [measures()], `summary()`, `plot()`, [view_3d()].
#'
#' @param trajectory From [tow()].
#' @param time s, or a text with a unit; the nearest time that is kept counts.
#' @return A `codend_state` with the fields of a settled one and `time` (s) and `velocity` (3 x
#'   nodes, m/s, relative to the vessel). Its net forces are what moves the gear, so they do not
#'   vanish.
#' @examples
#' faster <- tow("towed_cable", until = 40, every = 20,
#'   schedule = tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot"))))
#' measures(state_at(faster, 40))
#' @export
state_at <- function(trajectory, time) {
  check_given("trajectory", "time")
  check_is_trajectory(trajectory)
  wanted <- schedule_number(time, "time", "time")
  ends <- range(trajectory$time)
  # times are multiples of a step, to rounding
  if (wanted < ends[1L] - 1e-6 || wanted > ends[2L] + 1e-6) {
    abort_argument("{.arg time} is {.val {time}}; the tow was kept from {ends[1]} s to {ends[2]}
      s.")
  }
  k <- which.min(abs(trajectory$time - wanted))
  now <- conditions_at(trajectory, trajectory$time[k], trajectory$winch_length[, k])
  now$broken <- trajectory$broken[, k]
  now$wake <- trajectory$wake[, k]
  now$catch_front <- trajectory$catch_front[, k]
  si <- si_at(trajectory, now)
  lattice <- lattice_at(trajectory, now)
  turned <- to_vessel(now$course)
  state <- new_state(
    trajectory$gear, si, lattice,
    as.vector(turned %*% (trajectory$position[, , k] - c(now$x, now$y, 0))),
    c(list(converged = TRUE, iterations = trajectory$report$iterations, residual = NA_real_),
      trajectory$report["steps"]),
    as.vector(turned %*% (trajectory$velocity[, , k] - c(now$x_rate, now$y_rate, 0)))
  )
  state$time <- trajectory$time[k]
  state$compared <- compared_at(trajectory, state$time)
  state$step_accuracy <- first_of(trajectory$method$accuracy, 0)
  state
}

# What the measures of a moment are compared with, as compared_lattices() gives it.
compared_at <- function(trajectory, time) {
  compared <- trajectory$compared
  if (is.null(compared$time)) return(compared)
  k <- which.min(abs(compared$time - time))
  level <- list(nodes = compared$nodes, values = setNames(compared$values[, k], compared$measures))
  list(levels = list(level), values = if (time > compared$time[k] + 1e-6) compared$last)
}

# From axes over the ground to those of a vessel on a course (rad).
to_vessel <- function(course) {
  rbind(c(cos(course), -sin(course), 0), c(sin(course), cos(course), 0), c(0, 0, 1))
}

# Conditions of every kept time: a data frame of time, x, y (m, the vessel over the ground), x_rate,
# y_rate, speed (m/s), course (rad), heave (m), in waves the elevation of the water there (m), and
# per growing part its length (m) or share.
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
  waves <- what$lattice$mesh$water$waves
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

# The same of one time as a list, with the current over the ground (m/s along x and y, by depth)
# where the schedule has one, and what the winches have out (winch_length, m, by growing part).
# before: at a jump those before it.
conditions_at <- function(what, time, winch_length = winches_at_start(what$schedule),
                          before = FALSE) {
  # the engine tells what is after a jump; so early (s) is before it and otherwise the same
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

# The gear's numbers at one time: towing speed, warps and current as they are, in the vessel's axes.
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

# The lattice at one time, in the vessel's axes.
lattice_at <- function(what, now) {
  lattice <- what$lattice
  si <- si_at(what, now)
  ropes <- intersect(vapply(what$schedule$growing, `[[`, "", "name"), names(what$si$ropes))
  lattice$built_lengths <- c(
    lattice$built_lengths, vapply(setdiff(ropes, names(lattice$built_lengths)), function(rope) {
      what$si$ropes[[rope]]$length
    }, 0)
  )
  mesh <- lattice$mesh
  changes <- scheduled_fields(mesh, what$schedule, now)
  changes$water <- list(x = si$water$current$x + now$speed, y = si$water$current$y)
  changes$water$waves <-
    waves_from_vessel(mesh$water$waves, now$time, c(now$x, now$y), now$course)
  if (!is.null(now$wake)) changes$wake <- now$wake
  if (!is.null(si$ground)) changes$ground <- ground_from_vessel(mesh$ground, now)
  if (length(now$catch_front)) lattice <- set_catch_front(lattice, now$catch_front[1L])
  change_lattice(lattice, changes)
}

# Fields of a mesh that follow from its growing parts at one time and from its broken bars.
scheduled_fields <- function(mesh, schedule, now) {
  if (!length(schedule$growing) && !any(now$broken > 0)) return(list())
  still <- numeric(length(now$winch_length))
  broken <- integer(length(schedule$ruptures))
  broken[seq_along(now$broken)] <- as.integer(now$broken)
  done <- list(
    length = now$winch_length, since = still + now$time, speed = still, target_speed = still,
    near_limit = still > 0, broken = broken, broken_at = 0 * broken
  )
  found <- engine_scheduled(mesh, schedule_as_done(schedule, done), now$time)
  c(found[c("mass", "load")], list(
    bars = found[c("rest", "multiplicity")], spheres = found[c("drag_area", "added_mass")],
    volumes = found["buoyancy"]
  ))
}

# The sea bed in the vessel's axes, where it passes by at the towing speed.
ground_from_vessel <- function(ground, now) {
  ground$height <- ground$height - sum(ground$normal * c(now$x, now$y, 0))
  ground$normal <- drop(to_vessel(now$course) %*% ground$normal)
  passing <- c(now$speed, 0, 0)
  ground$velocity <- passing - sum(passing * ground$normal) * ground$normal
  ground
}

check_is_trajectory <- function(trajectory) {
  if (!inherits(trajectory, "codend_trajectory")) {
    abort_schedule("trajectory", "must be a trajectory, as {.fn tow} returns.")
  }
}
