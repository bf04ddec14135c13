# Start of a tow from a state or from the end of a trajectory.

# `compared`: list(levels, values) for the errors of all moments, see compared_meshes(); or NULL.
started_trajectory <- function(state, given, until, compared = NULL) {
  state$mesh$let_go <- TRUE
  what <- tow_start(state$gear, state$si, state$mesh, given, until)
  what$compared <- compared
  if (!is.null(state$si$catch) && abs(curve_at(what$curves$catch, 0) - 1) > 1e-6) {
    abort_schedule("state", "has another catch than the start of the schedule; give the gear
      instead.")
  }
  for (part in what$schedule$growing) {
    if (abs(curve_at(part$factor, 0) - 1) > 1e-6) {
      abort_schedule("state", sprintf(
        "differs in %s from the start of the schedule; give the gear instead.", part$name
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
      "cannot be given for a trajectory, which continues with its own schedule.")
  }
  trajectory$given[intersect(new, lost)] <- given[intersect(new, lost)]
  trajectory$given$control_every <- given$control_every
  lost <- setdiff(lost, new)
  if (length(lost)) {
    abort_schedule(lost[1], "was a function, which files cannot store; give it again.")
  }
  if (until <= trajectory$memory$now$time) {
    abort_schedule("until", sprintf("is %s s; it must be after %s s, the end of the trajectory.",
      format(until), format(trajectory$memory$now$time)))
  }
  mesh <- trajectory$mesh
  mesh <- change_mesh(mesh, list(
    water = list(x = mesh$model$water$x + trajectory$si$towing$speed)
  ))
  fresh <- tow_start(trajectory$gear, trajectory$si, mesh, trajectory$given, until)
  trajectory[c("schedule", "curves", "breaks")] <- fresh[c("schedule", "curves", "breaks")]
  trajectory
}

# Placeholder for a function that files cannot store; is_lost() detects it in a schedule.
lost_function <- function() structure(list(), class = "codend_lost_function")

is_lost <- function(schedule) {
  inherits(schedule, "codend_lost_function") ||
    is.list(schedule) && any(vapply(schedule, is_lost, NA))
}

# Returns the mesh over the ground and the tow in the engine's format.
tow_start <- function(gear, si, mesh, given, until) {
  mesh <- change_mesh(mesh, c(
    list(water = list(x = mesh$model$water$x - si$towing$speed)),
    if (!is.null(si$ground)) list(ground = list(velocity = c(0, 0, 0)))
  ))
  c(
    list(gear = gear, si = si, mesh = mesh, given = given),
    scheduled_motion(si, mesh, given, until)
  )
}

# Returns a trajectory with the first moment only.
add_start <- function(what, position, velocity) {
  n <- what$mesh$nodes
  model <- what$mesh$model
  speed <- matrix(velocity, 3L, n)
  speed[, setdiff(which(model$held), what$schedule$motion$node)] <- 0
  motion <- list(
    time = 0, position = as.vector(position), velocity = as.vector(speed),
    acceleration = numeric(3L * n)
  )
  water <- model$water["x"]
  model <- changed_model(
    mesh_at(what, conditions_at(what, 0))$model, list(water = water, ground = model$ground)
  )
  found <- engine_evaluate(model, motion$position, motion$velocity)
  controls <- lapply(what$schedule$growing, `[[`, "control")
  of <- function(field) vapply(controls, function(one) if (is.null(one)) 0 else one[[field]], 0)
  done <- list(
    length = of("length"), since = of("since"), speed = of("speed"),
    target_speed = of("target_speed"), near_limit = rep(FALSE, length(controls)),
    broken = rep(0L, length(what$schedule$ruptures)),
    broken_at = rep(0, length(what$schedule$ruptures)),
    # initial contact points of sticking friction, see base/ground.hpp
    anchor = if (isTRUE(what$si$sticking)) found$ground_places else numeric()
  )
  frame <- list(
    now = motion, before = motion, steps = 0L, caution = 0L, step = NA_real_, done = done,
    bar_tension = found$bar_tension, u_tension = found$u_tension, v_tension = found$v_tension,
    straight_tension = found$straight_tension[has_straight_bars(what$mesh)],
    wake = model$wake, catch_front = catch_front(what$mesh, matrix(position, 3L)),
    energy = numeric(length(engine_energy_parts())), report = NULL
  )
  gather_trajectory(what, list(frame), "reached")
}
