# Where a tow starts from: a state, or a trajectory that goes on.

# compared: measures of the state and of its gear's other lattices, by which the errors of all
# moments are known: list(levels, values), or NULL.
started_trajectory <- function(state, given, until, compared = NULL) {
  state$lattice$let_go <- TRUE
  what <- tow_start(state$gear, state$si, state$lattice, given, until)
  what$compared <- compared
  if (!is.null(state$si$catch) && abs(curve_at(what$curves$catch, 0) - 1) > 1e-6) {
    abort_schedule("gear", "is a state whose catch is not what the schedule begins with.")
  }
  for (part in what$schedule$growing) {
    if (abs(curve_at(part$factor, 0) - 1) > 1e-6) {
      abort_schedule("gear", sprintf(
        "is a state whose %s is not what the schedule begins with; give the gear, to settle so.",
        part$name
      ))
    }
  }
  add_start(what, state$position, c(-state$si$towing$speed, 0, 0))
}

continued_trajectory <- function(trajectory, given, until) {
  lost <- names(Filter(is_lost, trajectory$given))
  new <- names(Filter(Negate(is.null), given[names(given) != "control_every"]))
  if (length(setdiff(new, lost))) {
    abort_schedule(setdiff(new, lost)[1],
      "is given for a trajectory, which goes on in its own schedule.")
  }
  planned <- tow_section(trajectory$gear)[setdiff(lost, new)]
  planned <- planned[!vapply(planned, is.null, NA)]
  trajectory$given[names(planned)] <- planned
  trajectory$given[intersect(new, lost)] <- given[intersect(new, lost)]
  trajectory$given$control_every <- given$control_every
  lost <- setdiff(lost, c(new, names(planned)))
  if (length(lost)) {
    abort_schedule(lost[1], "was a function, which a file does not keep; give it again.")
  }
  if (until <= trajectory$memory$now$time) {
    abort_schedule("until", sprintf("is %s s; the trajectory is already at %s s.", format(until),
      format(trajectory$memory$now$time)))
  }
  lattice <- trajectory$lattice
  lattice <- change_lattice(lattice, list(
    water = list(x = lattice$mesh$water$x + trajectory$si$towing$speed)
  ))
  fresh <- tow_start(trajectory$gear, trajectory$si, lattice, trajectory$given, until)
  trajectory[c("schedule", "curves", "breaks")] <- fresh[c("schedule", "curves", "breaks")]
  trajectory
}

# What stands for a function that was not kept, and whether a schedule is or holds one.
lost_function <- function() structure(list(), class = "codend_lost_function")

is_lost <- function(schedule) {
  inherits(schedule, "codend_lost_function") ||
    is.list(schedule) && any(vapply(schedule, is_lost, NA))
}

# The lattice over the ground, and the tow in the engine's terms.
tow_start <- function(gear, si, lattice, given, until) {
  lattice <- change_lattice(lattice, c(
    list(water = list(x = lattice$mesh$water$x - si$towing$speed)),
    if (!is.null(si$ground)) list(ground = list(velocity = c(0, 0, 0)))
  ))
  c(
    list(gear = gear, si = si, lattice = lattice, given = given),
    scheduled_motion(si, lattice, given, until)
  )
}

# A trajectory of one moment.
add_start <- function(what, position, velocity) {
  n <- what$lattice$nodes
  mesh <- what$lattice$mesh
  speed <- matrix(velocity, 3L, n)
  speed[, setdiff(which(mesh$held), what$schedule$motion$node)] <- 0
  motion <- list(
    time = 0, position = as.vector(position), velocity = as.vector(speed),
    acceleration = numeric(3L * n), algorithmic_acceleration = numeric(3L * n)
  )
  water <- mesh$water["x"]
  mesh <- changed_mesh(
    lattice_at(what, conditions_at(what, 0))$mesh, list(water = water, ground = mesh$ground)
  )
  found <- engine_evaluate(mesh, motion$position, motion$velocity)
  controls <- lapply(what$schedule$growing, `[[`, "control")
  of <- function(field) vapply(controls, function(one) if (is.null(one)) 0 else one[[field]], 0)
  done <- list(
    length = of("length"), since = of("since"), speed = of("speed"),
    target_speed = of("target_speed"), near_limit = rep(FALSE, length(controls)),
    broken = rep(0L, length(what$schedule$ruptures)),
    broken_at = rep(0, length(what$schedule$ruptures)),
    # what lies on the ground sticks where it is: see base/ground.hpp
    anchor = if (isTRUE(what$si$sticking)) found$ground_places else numeric()
  )
  frame <- list(
    now = motion, before = motion, steps = 0L, caution = 0L, step = NA_real_, done = done,
    bar_tension = found$bar_tension, u_tension = found$u_tension, v_tension = found$v_tension,
    straight_tension = found$straight_tension[has_straight_bars(what$lattice)],
    wake = mesh$wake, catch_front = catch_front(what$lattice, matrix(position, 3L)),
    energy = numeric(length(engine_energy_parts())), report = NULL
  )
  gather_trajectory(what, list(frame), "reached")
}
