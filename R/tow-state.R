# A moment of a trajectory, in the vessel's own axes.

#' A moment of a tow
#'
#' The state of a towed gear at one of the times that its trajectory keeps, as seen from the vessel:
#' x aft, y to starboard, from the point that was the plan's origin at the start. Everything that
#' reads a settled state reads it: [measures()], `summary()`, `plot()`, [view()].
#'
#' @param trajectory From [tow()].
#' @param time s, or a text with a unit; the nearest time that is kept counts.
#' @return A `codend_state` with the fields of a settled one and `time` (s) and `velocity` (3 x
#'   nodes, m/s, relative to the vessel). Its net forces are what moves the gear, so they do not
#'   vanish.
#' @export
state_at <- function(trajectory, time) {
  check_is_trajectory(trajectory)
  k <- which.min(abs(trajectory$time - schedule_number(time, "time", "time")))
  now <- as.list(trajectory$conditions[k, ])
  now$factor <- attr(trajectory$conditions, "factor")[, k]
  now$parted <- trajectory$parted[, k]
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
  state
}

# From axes over the ground to those of a vessel on a course (rad).
to_vessel <- function(course) {
  rbind(c(cos(course), -sin(course), 0), c(sin(course), cos(course), 0), c(0, 0, 1))
}

# Conditions of every kept time: a data frame of time, x, y (m, the vessel over the ground), x_rate,
# y_rate, speed (m/s), course (rad), heave (m), and per growing part its length (m) or share; their
# factors are the attribute "factor", a row per part.
conditions_table <- function(trajectory) {
  curves <- trajectory$curves
  plan <- trajectory$plan
  t <- trajectory$time
  speed <- curve_at(curves$speed, t, after = TRUE)
  course <- curve_at(curves$course, t, after = TRUE)
  table <- data.frame(
    time = t, x = curve_at(plan$track$x, t), y = curve_at(plan$track$y, t),
    x_rate = -speed * cos(course), y_rate = speed * sin(course), speed = speed, course = course,
    heave = curve_at(curves$heave, t)
  )
  factor <- matrix(0, length(plan$parts), length(t))
  for (k in seq_along(plan$parts)) {
    part <- plan$parts[[k]]
    factor[k, ] <- if (is.null(part$winch)) {
      curve_at(part$factor, t)
    } else {
      trajectory$winch_length[k, ] / part$winch$full_length
    }
    full <- trajectory$si$ropes[[part$name]]$length
    table[[part$name]] <- factor[k, ] * first_of(full, 1)
  }
  attr(table, "factor") <- factor
  table
}

# The same of one time before a trajectory is there.
conditions_at <- function(what, time) {
  start <- list(time = time, curves = what$curves, plan = what$plan, si = what$si)
  start$winch_length <- vapply(what$plan$parts, function(part) {
    if (is.null(part$winch)) 0 else part$winch$length
  }, 0)
  start$winch_length <- matrix(start$winch_length, ncol = 1L)
  table <- conditions_table(start)
  c(as.list(table), list(factor = attr(table, "factor")[, 1L], parted = integer()))
}

# The gear's numbers at one time: towing speed, warps and current as they are, in the vessel's axes.
si_at <- function(what, now) {
  si <- what$si
  si$towing$speed <- now$speed
  for (part in what$plan$parts) {
    if (!is.null(si$ropes[[part$name]])) si$ropes[[part$name]]$length <- now[[part$name]]
  }
  if (!is.null(si$catch)) {
    si$catch <- si_catch_share(si$catch, curve_at(what$curves$catch, now$time, after = TRUE))
  }
  if (length(what$plan$current_x)) {
    si$water$current$x <- vapply(what$plan$current_x, curve_at, 0, t = now$time, after = TRUE)
    si$water$current$y <- vapply(what$plan$current_y, curve_at, 0, t = now$time, after = TRUE)
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
  lattice$engine <- grown_engine(lattice$engine, what$plan$parts, now$factor,
    now$parted[now$parted > 0])
  lattice$engine$water$x <- si$water$current$x + now$speed
  lattice$engine$water$y <- si$water$current$y
  if (!is.null(now$wake)) lattice$engine$wake <- now$wake
  if (length(now$catch_front)) lattice <- set_catch_front(lattice, now$catch_front[1L])
  if (!is.null(lattice$engine$ground)) {
    lattice$engine$ground <- ground_from_vessel(lattice$engine$ground, now)
  }
  lattice
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
