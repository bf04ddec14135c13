#' Simulate the motion of a gear
#'
#' Computes the motion of a gear over time while towing speed, course, warps, currents and more
#' change by a schedule. Time integration starts from the steady state, a given state or the end of
#' a trajectory.
#'
#' @section Start of the motion:
#' - A gear, or the name of a plan: it settles first in the conditions of time 0. Without
#'   `schedule`, the section `tow` of its plan applies; it has fields of the same names.
#' - A state without `schedule` and `until`: the section `tow` of its plan applies, if its first
#'   values match the state.
#' - A state with `until`: all conditions stay constant except those in `schedule`. Only `scheme`
#'   and `accuracy` come from the plan.
#' - A trajectory: it continues with its own schedule.
#'
#' `tow("midwater_trawl")`, or `codend tow midwater_trawl` in a shell, simulates a whole tow: it
#' shoots the warps, tows, turns by 90 degrees and hauls. A progress bar appears after two seconds.
#' If the package progressr is loaded, it reports the progress in percent instead.
#'
#' @section Coordinates:
#' The motion is computed over the ground. x points aft, y to starboard and z up, with the origin of
#' the plan at time 0. The axes stay there while the vessel moves. The water is at rest except for
#' its current and waves. The vessel moves the towing points (`held: moved` in the plan).
#'
#' @section Shooting a gear:
#' A gear with a section `shooting` does not settle first. At time 0 it lies bunched within half a
#' metre below the surface, along the arc of the vessel's track. Each part stays there until the
#' vessel has passed. Netting that is not yet shot therefore lies on the water instead of on deck.
#'
#' @section Ropes laid on the sea bed:
#' A gear with a section `laid`, such as a demersal seine, starts at rest. Its ropes lie on the sea
#' bed along the vessel's track, from corner to corner. Its net has the settled shape. Friction
#' holds all parts that the ropes do not pull.
#'
#' Laid ropes come in at the vessel: their bars shorten one after another. The outer parts move only
#' when pulled. `winch` and `control` of a schedule cannot be used with these ropes.
#'
#' @section Warps:
#' All bars of a warp lengthen by the same factor when it is paid out. Two effects of its motion
#' along itself are neglected:
#' - the friction that this motion adds to the friction from towing;
#' - the tension `m w^2` for a mass `m` per length and a speed `w`, such as 16 N for 4 kg/m at 2
#'   m/s.
#'
#' @section Water:
#' - Wakes: with `shielding`, netting slows the water behind it as in [settle()]. The netting
#'   upstream of each point is updated after each step. The speed lags by the time that the water
#'   needs to pass half of the netting.
#' - Accelerating currents: water pushes by its acceleration times the displaced mass (Froude-Krylov
#'   force). Added mass acts on the acceleration relative to the water. A jump in the current causes
#'   no such force.
#' - Behind netting, the water's acceleration is that in the free flow. A catch in netting is as
#'   heavy as water and moves only with the netting around it.
#'
#' @section Waves:
#' Waves need a field `waves` in the section `water` of the plan. They follow Airy's theory for
#' finite depth with Wheeler stretching (Wheeler 1970). Several waves represent a spectrum; the same
#' seed gives the same waves. The water is calm at time 0, and the waves grow over the time
#' `rising`. `conditions` has the water level at the vessel.
#'
#' Immersion follows the local water level. Neglected are:
#' - second-order forces such as drift, and slamming;
#' - the effect of a current on the wavelength;
#' - the effect of the surface on added mass and drag, which are only scaled by the immersed
#'   fraction.
#'
#' @section Friction on the sea bed:
#' Parts on the sea bed stick to it, unless the plan turns `sticking` off. Friction builds up
#' elastically over the plan's `slip_distance` before a part slips. Its default is 10 mm, or 1/1000
#' of the longest rope if that is less.
#'
#' After a reversal, friction rebuilds over `2 * slip_distance`. Over a return distance `s` the mean
#' friction is lower by the fraction `2 * slip_distance / s`: 4 % over 0.5 m with 10 mm. It vanishes
#' for oscillations of less than 20 mm.
#'
#' @section Time schemes:
#' - `"tr_bdf2"` (default): implicit, by Newton's method, with a step length that follows from
#'   `accuracy`. It is of second order and removes only oscillations that are faster than its steps
#'   (Bank et al. 1985; Hosea and Shampine 1996).
#' - With fixed short steps: `"substitution"` (trapezoidal rule by substitution, as in Li et al.),
#'   `"symplectic_euler"` and `"rk4"` (both explicit).
#'
#' `every` does not change the motion: states within a step result from an extra, shorter step.
#'
#' @section Accuracy:
#' `accuracy` limits the position error of each step in one of two ways:
#' - A length, by default 0.01 m. This suits tows, whose motions are damped by the water.
#' - A percentage, for motions that keep swinging. The error of a step is at most a tenth of the
#'   accuracy times the distance that the fastest part travels in the step, relative to the mean of
#'   the gear. Errors below 1e-5 of the accuracy times the size of the gear are ignored.
#'
#' Errors of steps accumulate in oscillations with little damping. At the default, such oscillations
#' die within minutes. At `"0.1 %"`, a pendulum keeps its amplitude within 1 % over 1,000 periods, a
#' limit that is tested. [findings()] warns if the scheme has removed much energy.
#'
#' Peaks of tension depend on the accuracy where slack netting or ropes snap taut. Use
#' `list(position = , tension = )` to limit tension errors too, as a fraction of the largest tension
#' in the gear. This criterion is conservative. It costs much time when a purse seine is shot,
#' because its lines snap taut all the time.
#'
#' A continued tow equals an uninterrupted one within this accuracy, because steps end at `until`.
#'
#' Implicit steps are accepted only if the residual at each node is below 0.1 % of the forces on it.
#' [findings()] reports steps below 1 ms; below 0.1 microseconds the run stops with an error.
#'
#' Each run checks its energy: the work of vessel, supports, winches, water and ground must equal
#' the energy that the gear gains. `conditions` has the imbalance over time. In a step it is at most
#' 2 % of the kinetic and elastic energy plus the work in the step. A step above this limit is
#' repeated with a shorter length. If that fails, the run stops with an error of class
#' `codend_error_energy`. [summary()][summary.codend_trajectory] lists the energy that the scheme
#' removes. [findings()] warns if it exceeds 5 % of the energy that water and dampers remove.
#'
#' @section Errors in time and from the mesh:
#' The tow also runs twice on a coarser mesh: with the same accuracy and with a quarter of it (half
#' of a fixed `step`).
#'
#' - The difference of both runs gives the error in time of each measure at each time.
#' - The relative error of the mesh is the one of the settled gear. For gears that are shot or laid,
#'   which start far from equilibrium, it follows from the coarser mesh.
#'
#' A continued tow keeps the relative errors of its last time. Usual errors of time steps apply to
#' tows with `control` or from a moment of another tow, to interrupted tows and to files written
#' during a tow. `make tow-errors` compares the errors with true errors.
#'
#' @param state A state from [settle()]; a gear, or the name or file of a plan; or a trajectory to
#'   continue.
#' @param schedule Changes over time, from [tow_schedule()], instead of those in the section `tow`
#'   of the plan. `NULL` (default): the plan's schedule.
#' @param until End time, s, or a string such as `"10 min"`. `NULL` (default): the last time of
#'   `schedule`. Without such a time: as in the plan.
#' @param every Time between saved states, s or string, at most `until`. `NULL` (default): as in the
#'   plan, or `until / 200`.
#' @param scheme Name of the time scheme, see the section on schemes. `NULL` (default): as in the
#'   plan, or `"tr_bdf2"`.
#' @param accuracy Largest position error of one implicit step, m, or string; or a percentage such
#'   as `"0.1 %"`; or a list with a tension limit, see the section on accuracy. `NULL` (default): as
#'   in the plan, or 0.01 m.
#' @param step Fixed step length, s or string, instead of an accuracy. `NULL` (default): adaptive
#'   for implicit schemes, 0.9 of the longest stable step for the others.
#' @param nodes,netting As in [settle()], for a gear that is not yet a state. By default the gear is
#'   first settled on up to 3 meshes for an error of 1 %; a gear that is shot has 1,500 nodes.
#' @param file `NULL` (default), or a file ending in `.nc`. Each saved state is written at once, so
#'   [read_result()] can read an interrupted run. See [write_result()].
#' @return A trajectory of class `codend_trajectory`, which [as.data.frame.codend_trajectory()]
#'   documents. If the user interrupts the run, it holds the states so far, and `end` is
#'   `"interrupted"`. If no step down to 1e-7 s is found, the error has class
#'   `codend_error_not_converged`; it names the part, and its field `trajectory` holds the states so
#'   far.
#' @seealso [tow_schedule()], [state_at()], [plot()][plot.codend_trajectory] and
#'   [summary()][summary.codend_trajectory]; `vignette("motion", "codend")` for examples.
#' @examples
#' state <- settle("midwater_trawl", nodes = 300)
#' faster <- tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "4.5 knot")))
#' trajectory <- tow(state, faster, until = 60, every = 20)
#' measures(state_at(trajectory, 60))[["total_drag_kN"]]
#' @export
tow <- function(state, schedule = NULL, until = NULL, every = NULL, scheme = NULL,
                accuracy = NULL, step = NULL, nodes = NULL, netting = NULL, file = NULL) {
  check_given("state")
  if (!is.null(file)) {
    check_netcdf()
    check_file_path(file, ".nc")
  }
  if (is.null(schedule)) schedule <- tow_schedule()
  if (!inherits(schedule, "codend_schedule")) {
    abort_schedule("schedule", "must be a schedule from {.fn tow_schedule}.")
  }
  going_on <- inherits(state, "codend_trajectory")
  if (is.character(state)) state <- read_gear(state)
  planned <- if (going_on) {
    c(state["every"], scheme = state$method$scheme, accuracy = continued_accuracy(state$method))
  } else if (inherits(state, "codend_state")) {
    unscheduled_section(state$gear, schedule)[if (is.null(until)) TRUE else c("scheme", "accuracy")]
  } else {
    unscheduled_section(check_is_gear(state), schedule)
  }
  asked <- function(name, value) if (is.null(value)) planned[[name]] else value
  given <- unclass(with_planned(schedule, planned))
  method <- tow_method(
    first_of(asked("scheme", scheme), "tr_bdf2"),
    first_of(asked("accuracy", accuracy), default_accuracy), step
  )
  # a tow may be shorter than the interval in the plan
  shortened <- is.null(every)
  until <- asked("until", until)
  every <- asked("every", every)
  duration <- until
  until <- quantity_number(until, "time", "until", positive = TRUE)
  if (is.null(every)) every <- until / 200
  shown <- show_value(every)
  every <- quantity_number(every, "time", "every", positive = TRUE)
  if (every > until && !shortened) {
    abort_argument("{.arg every} is {shown}; it must be at most {.arg until},
      {show_value(duration)}.")
  }
  every <- min(every, until)
  before <- if (going_on) state$given$control_every
  given$control_every <- first_of(si_control_every(given$control_every),
    first_of(before, usual_control_every))
  steered <- if (!is.null(given[["control"]])) given$control_every
  check_tow_times(until, c(every = every, control_every = steered), duration)
  trajectory <- if (going_on) {
    continued_trajectory(with_last_moment(state), given, until)
  } else if (inherits(state, "codend_state")) {
    started_trajectory(state, given, until, compared_meshes(state))
  } else {
    settled_trajectory(state, given, until, nodes, netting)
  }
  elsewhere <- function() {
    moments_elsewhere(trajectory$compared, trajectory$gear, given, until, every, method, netting,
      trajectory$mesh)
  }
  # A moment of a tow as the start has no equal on another mesh. Without levels of the start, a file
  # needs the comparison at once.
  comparable <- !going_on && is.null(state[["time"]])
  first <- comparable && is.null(trajectory$compared)
  if (first) trajectory$compared <- elsewhere()
  record <- if (!is.null(file)) function(what, frames) record_trajectory(what, frames, file)
  towed <- integrate_trajectory(trajectory, until, every, method, measures, record)
  # a controller that stores data must not run again
  if (comparable && !first && is.null(given[["control"]]) && towed$end == "reached") {
    towed$compared <- tryCatch(elsewhere(), interrupt = function(e) trajectory$compared)
  }
  towed
}

# Upper limits of the duration (s) and of the number of saved times, to bound memory.
most_tow_time <- 1e6
most_tow_times <- 1e6

# `until`, `every`: s; `duration`: `until` as the user typed it.
check_tow_times <- function(until, every, duration = until) {
  if (until > most_tow_time) {
    most <- format_like(most_tow_time, "time", duration)
    abort_argument("{.arg until} is {show_value(duration)}; it must be at most {most}.")
  }
  for (name in names(every)) {
    times <- until / every[[name]]
    if (times > most_tow_times) {
      abort_argument(
        "{.arg {name}} is {signif(every[[name]], 6)} s, which gives {signif(times, 2)} times in
        {signif(until, 6)} s; it must be at least {until / most_tow_times} s."
      )
    }
  }
}

# Returns the accuracy of a trajectory for its continuation; NULL for fixed steps.
continued_accuracy <- function(method) {
  if (!is.null(method$accuracy) && method$accuracy > 0) {
    tension <- if (is.finite(method$tension_accuracy)) method$tension_accuracy
    position <- if (isTRUE(method$relative)) paste(100 * method$accuracy, "%") else method$accuracy
    list(c(list(position = position), tension = tension))
  }
}

# Returns the settings of the time integration: list(scheme, accuracy (m, or a ratio if `relative`;
# 0 for fixed steps), relative, step, tolerance, least_step, most_step, ...).
tow_method <- function(scheme, accuracy, step) {
  known <- engine_schemes()
  if (!is_text(scheme) || !scheme %in% known$name) {
    abort_argument("{.arg scheme} is {describe_value(scheme)}; it must be one of
      {.val {known$name}}.")
  }
  implicit <- known$adaptive[known$name == scheme]
  both <- tow_accuracy(accuracy)
  adaptive <- implicit && is.null(step)
  list(
    scheme = scheme, accuracy = if (adaptive) both$position else 0, relative = both$relative,
    step = if (is.null(step)) {
      # 0: the engine chooses it; it shortens 0.1 s for stability
      if (implicit) 0 else 0.1
    } else {
      quantity_number(step, "time", "step", positive = TRUE)
    },
    # Newton iterations end far below the step error; `substitution` compares velocities
    tolerance = (if (implicit) 0.05 else 1e-6) * (if (both$relative) 0.01 else both$position),
    tension_accuracy = both$tension,
    account = TRUE, least_step = 1e-7, most_step = if (adaptive) 60 else Inf
  )
}

# Returns the limits for one step: list(position (m, or a ratio if `relative`), relative, tension
# (fraction of the largest tension)).
tow_accuracy <- function(given) {
  if (!is.list(given)) given <- list(position = given)
  known <- c("position", "tension")
  if (!length(given) || is.null(names(given)) || !all(names(given) %in% known)) {
    abort_schedule("accuracy",
      "must be a length, a percentage, or a list of {.field position} and {.field tension}.")
  }
  position <- first_of(given$position, default_accuracy)
  relative <- is_text(position) && grepl("%|percent", position)
  list(
    position = quantity_number(position, if (relative) "number" else "length",
      "accuracy$position", positive = TRUE),
    relative = relative,
    tension = if (is.null(given$tension)) Inf else {
      quantity_number(given$tension, "number", "accuracy$tension", positive = TRUE)
    }
  )
}

# Position error (m). Tension errors are not limited by default: positions determine tensions in
# equilibrium, and the estimate is very conservative.
default_accuracy <- 0.01

# Returns a trajectory that starts from the equilibrium at time 0, or from the shot or laid gear.
# `levels(state)`: returns mesh levels of the settled gear.
settled_trajectory <- function(gear, given, until, nodes, netting, levels = compared_meshes) {
  check_settle_arguments(gear, nodes, netting)
  si <- gear_si(gear)
  if (!is.null(si$shooting)) {
    return(shot_trajectory(gear, si, given, until, requested_nodes(gear, nodes), netting))
  }
  if (!is.null(si$laid)) {
    state <- settle(gear, nodes, netting)
    what <- tow_start(state$gear, state$si, state$mesh, given, until)
    return(add_start(what, laid_position(state), c(0, 0, 0)))
  }
  planned <- tryCatch(
    accurate_state(gear, nodes, netting, NULL), codend_error_not_converged = function(e) NULL
  )
  nodes <- requested_nodes(gear, nodes, planned)
  what <- tow_start(gear, si, build_mesh(si, nodes, netting), given, until)
  now <- conditions_at(what, 0, before = 0 %in% what$breaks)
  first <- si_at(what, now)
  if (identical(first, si) && !length(what$schedule$growing) && now$heave == 0) {
    state <- if (is.null(planned)) settle(gear, nodes, netting) else planned
    warn_of_doubts(state, swings = TRUE)
    return(started_trajectory(state, given, until, levels(state)))
  }
  # A short warp gets few bars, so its shape is transferred to the mesh of the full warp.
  progress <- settle_progress()
  found <- settle_numbers(first, nodes, netting, progress = progress)
  if (found$report$converged) {
    found$mesh$counts <- NULL
    shape <- list(
      mesh = found$mesh, position = mesh_points(found$mesh, found$position)
    )
    what <- tow_start(gear, si, build_mesh(si, nodes, netting, shape), given, until)
  }
  if (!is.null(si$catch)) {
    what$mesh <- set_catch_front(what$mesh, found$mesh$catch$blocked)
  }
  moved <- what$schedule$motion$node
  what$mesh$start[3, moved] <- what$mesh$start[3, moved] + now$heave
  start <- mesh_at(what, now)
  settled <- engine_settle(
    start$model, as.double(what$mesh$start), if (found$report$converged) "near" else "crude",
    numeric(), line_part(start), settle_tolerance, settle_iterations, progress
  )
  settled <- name_parts(settled, start)
  if (!settled$converged) abort_unsettled(settled, start, settled$position)
  what$mesh$model <- changed_model(what$mesh$model, settled["wake"])
  # assume the relative errors from the gear in its plan's conditions
  if (!is.null(planned)) what$compared <- levels(planned)
  add_start(what, settled$position, c(-now$speed, 0, 0))
}
