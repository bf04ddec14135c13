#' Tow a gear through time
#'
#' Marches a gear through time: from its steady state, while towing speed and course, warps,
#' currents and more change.
#'
#' @details
#' The motion is computed over the ground, where a turn brings in no forces of its own: water is
#' still but for its current, and the towing points (`held: moved` in the plan) move. x, y and z are
#' those of the plan at the start, x aft, y to starboard, z up, and stay where they are while the
#' vessel leaves.
#'
#' A gear that is not yet a state settles first, in the conditions of time 0, and what `schedule`
#' leaves out is taken from its plan's section `tow`, which has fields of the same names and lists
#' of `time` and `value` for tables. A state that is towed to no given time goes on in its plan's
#' section `tow` too, if that begins where the state is. Towed `until` a time it goes on as it is
#' but for `schedule`: then only `scheme` and `accuracy` of that section count. `codend tow
#' midwater_trawl`, in a shell, or `tow("midwater_trawl")` shoots the shipped trawl's warps, tows
#' it, turns by 90 degrees and hauls it back.
#'
#' A gear whose plan has a section `shooting` is not settled first: at time 0 it lies bunched within
#' half a metre below the surface, along the arc that the vessel runs while it shoots, and every
#' part of it waits there until the vessel has passed. A net is then where it would be when it
#' leaves the vessel, but what is not yet shot lies on the water instead of on deck.
#'
#' The discretisation error of its measures is what the same tow with other `nodes` shows, which is
#' marched first; so is that of a gear that is laid. Measures of all other tows have the errors, as
#' shares, of the gear as it settles.
#'
#' A gear whose plan has a section `laid`, as a demersal seine's assembly, starts at rest with its
#' ropes on the sea bed, along the way from corner to corner that the vessel ran, and its net as it
#' has settled. Friction holds what the ropes do not pull. A rope that was laid comes in at the
#' vessel: its bars shorten one after another, so that what lies farther out moves only as it is
#' pulled; neither `winch` nor `control` of a
#' schedule can steer it.
#'
#' A warp that is paid out keeps its bars, which all grow by one factor. That leaves out what the
#' passing of the warp itself through the water does: friction along it at its own speed next to the
#' towing speed, and a share m w^2 of its tension, 16 N for 4 kg/m at w = 2 m/s.
#'
#' With `shielding` the water behind netting slows as in [settle()], of which the settled state is a
#' state at rest: after every step the netting upstream of every point is found anew, and the speed
#' there follows as fast as water takes to pass half of the netting.
#'
#' No step of an implicit scheme is taken whose forces do not balance: what is left on any node is
#' at most a thousandth of the pulls, drags and loads on it. The work of supports, vessel, winches,
#' water and ground is held against what the gear gains in energy, in every run: `conditions` has
#' the imbalance by time. A run with an accuracy whose imbalance passes 2 % of the energy put
#' through, and what a tenth of that accuracy makes of the gear's weight, goes on in shorter steps;
#' where that does not help, it stops with an error of class `codend_error_energy`. Schemes that
#' damp remove energy from swings faster than their steps: a light pluck is gone in a minute at the
#' default accuracy. Peaks of tension where slack netting or ropes snap taut depend on the accuracy.
#'
#' Water that accelerates pushes what is in it: by its acceleration times the water that is
#' displaced (Froude and Krylov) and times the added mass, whose own acceleration is the gear's less
#' the water's. A current that changes with time does so, but not by jumps of its speed or its
#' direction, which happen at once. Behind netting that slows the water its acceleration is that of
#' the free flow, and a catch in netting, as heavy as water, is moved by the netting around it
#' alone.
#'
#' What lies on the sea bed sticks to it unless the plan says otherwise. Friction gives by the
#' plan's `slip_distance` before it slips: 10 mm, or a thousandth of the longest rope where that is
#' less. When what slips turns back it builds up over twice as much, so that over a way `s` back it
#' is a share of `2 slip_distance / s` less in the mean: 4 % over half a metre at 10 mm, all of it
#' where something swings by less than 20 mm.
#'
#' With `waves` in the plan's `water` they run over the gear: Airy's, of the water's depth,
#' stretched to the surface (Wheeler 1970), one or as many as stand for a spectrum, from a seed that
#' gives the same ones again. At time 0 the water is calm, and the waves rise over `rising`. What is
#' at the surface is in the water as deep as the waves have it there. Left out are forces of second
#' order, such as drift, and slamming; a current does not change the waves' length, and added mass
#' and drag are those of water without a surface, by the share that is immersed. `conditions` has
#' the elevation of the water at the vessel.
#'
#' @param gear A gear, from [read_gear()] or the constructors; the name or file of a plan; a state
#'   from [settle()], with which the motion starts; or a trajectory, to go on with in its own
#'   schedule.
#' @param schedule What changes with time, from [tow_schedule()]; what it leaves out is the plan's.
#' @param until Time to which to tow, s, or a text such as `"10 min"`; the plan's when `NULL`, and
#'   with a state then its whole section `tow`.
#' @param every Time between the states that are kept, s or text; a 200th of `until` when `NULL`.
#' @param scheme `"bdf2"` (when `NULL`), `"generalised_alpha"`, `"backward_euler"` (implicit, by
#'   Newton's method), `"substitution"` (the trapezoid by substitution, as Li et al. print it),
#'   `"symplectic_euler"` or `"rk4"` (explicit).
#' @param accuracy Largest error that one step of an implicit scheme may make: of any node's
#'   position, m, or text; 0.01 m when `NULL`. Or `list(position = , tension = )`, tension as a
#'   share of the gear's largest, which is judged only where it is given: on the safe side. It costs
#'   much on a purse seine that is shot, whose lines snap taut all the time. Steps are as long as
#'   that allows. In swings and waves that hardly lose energy the errors of steps add up, whatever
#'   the scheme: a warp that rings along its length is off by \resultMotionRingingWarp{} within 20 s
#'   at 0.01 m. Short steps of one length cure that. Errors of the steps of backward Euler add up
#'   everywhere. A tow by backward Euler with an accuracy says so by a warning of class
#'   `codend_warning_accuracy`.
#' @param step Length of all steps, s or text, instead of an accuracy; `NULL` for an explicit scheme
#'   is nine tenths of the longest that is surely stable.
#' @param nodes,netting As in [settle()], where `gear` is not yet a state.
#' @param file `NULL`, or a file ending in `.nc` that is written while the tow runs: every kept
#'   state is in it as soon as it is reached, so [read_result()] gives what a broken run had
#'   done. See [write_result()].
#' @return A trajectory of class `codend_trajectory`; see [as.data.frame.codend_trajectory()] for
#'   what it holds. Interrupted by the user it holds what was done, and `end` says so. A motion that
#'   comes to a stop, because no step down to 1e-7 s is found, is an error of class
#'   `codend_error_not_converged` that names the part and carries the `trajectory`.
#' @examples
#' faster <- tow("towed_cable", until = 60, every = 20, schedule = tow_schedule(
#'   speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot"))
#' ))
#' measures(state_at(faster, 60))
#' @export
tow <- function(gear, schedule = NULL, until = NULL, every = NULL, scheme = NULL,
                accuracy = NULL, step = NULL, nodes = 1500, netting = NULL, file = NULL) {
  check_given("gear")
  if (!is.null(file)) {
    check_netcdf()
    check_file_path(file, ".nc")
  }
  if (is.null(schedule)) schedule <- tow_schedule()
  if (!inherits(schedule, "codend_schedule")) {
    abort_schedule("schedule", "must be a schedule, from {.fn tow_schedule}.")
  }
  going_on <- inherits(gear, "codend_trajectory")
  if (is.character(gear)) gear <- read_gear(gear)
  planned <- if (going_on) {
    c(gear["every"], scheme = gear$method$scheme, accuracy = kept_accuracy(gear$method))
  } else if (inherits(gear, "codend_state")) {
    tow_section(gear$gear)[if (is.null(until)) TRUE else c("scheme", "accuracy")]
  } else {
    tow_section(check_is_gear(gear))
  }
  asked <- function(name, value) if (is.null(value)) planned[[name]] else value
  given <- unclass(with_planned(schedule, planned))
  method <- tow_method(
    first_of(asked("scheme", scheme), "bdf2"),
    first_of(asked("accuracy", accuracy), default_accuracy), step
  )
  warn_of_scheme(method)
  until <- asked("until", until)
  every <- asked("every", every)
  until <- tow_quantity(until, "until", "time")
  every <- if (is.null(every)) until / 200 else tow_quantity(every, "every", "time")
  before <- if (going_on) gear$given$control_every
  given$control_every <- first_of(given$control_every, first_of(before, usual_control_every))
  steered <- if (!is.null(given[["control"]])) given$control_every
  check_tow_times(until, c(every = every, control_every = steered))
  trajectory <- if (going_on) {
    continued_trajectory(with_last_moment(gear), given, until)
  } else if (inherits(gear, "codend_state")) {
    started_trajectory(gear, given, until, compared_lattices(gear))
  } else {
    settled_trajectory(gear, given, until, nodes, netting)
  }
  if (!going_on && starts_elsewhere(trajectory)) {
    trajectory$compared <- moments_elsewhere(gear, given, until, every, method, nodes, netting,
      trajectory$lattice$nodes)
  }
  record <- if (!is.null(file)) function(what, frames) record_trajectory(what, frames, file)
  march_trajectory(trajectory, until, every, method, measures, record)
}

# Time between calls of a control where the schedule gives none, s.
usual_control_every <- 10

# More than any tow needs, s and times, and few enough to be held.
most_tow_time <- 1e6
most_tow_times <- 1e6

check_tow_times <- function(until, every) {
  if (until > most_tow_time) {
    abort_argument("{.arg until} is {signif(until, 6)} s; it must be at most {most_tow_time} s.")
  }
  for (name in names(every)) {
    times <- until / every[[name]]
    if (times > most_tow_times) {
      abort_argument(
        "{.arg {name}} is {signif(every[[name]], 6)} s, which gives {signif(times, 2)} times up to
        {signif(until, 6)} s; it must be at least {until / most_tow_times} s."
      )
    }
  }
}

# The accuracy of a march that is gone on with; none where its steps had one length.
kept_accuracy <- function(method) {
  if (!is.null(method$accuracy) && method$accuracy > 0) {
    tension <- if (is.finite(method$tension_accuracy)) method$tension_accuracy
    list(c(list(position = method$accuracy), tension = tension))
  }
}

# How to march: list(scheme, accuracy (m, 0 for steps of one length), step, tolerance, least_step,
# most_step).
tow_method <- function(scheme, accuracy, step) {
  known <- engine_schemes()
  if (!is_text(scheme) || !scheme %in% known$name) {
    abort_argument("{.arg scheme} is {.val {scheme}}; it must be one of {.val {known$name}}.")
  }
  implicit <- known$adaptive[known$name == scheme]
  both <- tow_accuracy(accuracy)
  accuracy <- both$position
  adaptive <- implicit && is.null(step)
  list(
    scheme = scheme, accuracy = if (adaptive) accuracy else 0,
    step = if (is.null(step)) {
      # cut down by the march to what is accurate or stable
      if (implicit) 0.01 else 0.1
    } else {
      tow_quantity(step, "step", "time")
    },
    # Newton's method ends far below a step's own error, substitution at a share of its velocities
    tolerance = if (implicit) 0.05 * accuracy else 1e-6 * accuracy,
    tension_accuracy = both$tension,
    account = TRUE, energy_error = 0.1 * accuracy, least_step = 1e-7,
    most_step = if (adaptive) 60 else Inf
  )
}

# Warns of a scheme whose errors add up to more than three times those of a step.
warn_of_scheme <- function(method) {
  if (method$scheme != "backward_euler" || method$accuracy == 0) return(invisible())
  cli::cli_warn(
    c("Errors of the steps of backward Euler add up: positions may be off by more than three times
        the accuracy of {figures(method$accuracy)} m.",
      "i" = "{.val bdf2} and {.val generalised_alpha} stay within that on gears that were tried."),
    class = c("codend_warning_accuracy", "codend_warning"), call = NULL
  )
}

# Errors that one step may make: list(position (m), tension (share of the gear's largest)).
tow_accuracy <- function(given) {
  if (!is.list(given)) given <- list(position = given)
  known <- c("position", "tension")
  if (!length(given) || is.null(names(given)) || !all(names(given) %in% known)) {
    abort_schedule("accuracy",
      "must be a length, or a list of {.field position} and {.field tension}.")
  }
  list(
    position = tow_quantity(first_of(given$position, default_accuracy), "accuracy$position",
      "length"),
    tension = if (is.null(given$tension)) Inf else {
      tow_quantity(given$tension, "accuracy$tension", "number")
    }
  )
}

# Of position, m. Tensions are judged where that is asked: since every step's forces balance they
# follow from positions, and the estimate of their error is on the safe side by far.
default_accuracy <- 0.01

# A trajectory that starts where the gear settles in the conditions of time 0, or where it is shot.
settled_trajectory <- function(gear, given, until, nodes, netting) {
  check_settle_arguments(gear, nodes, netting)
  si <- gear_si(gear)
  if (!is.null(si$shooting)) return(shot_trajectory(gear, si, given, until, nodes, netting))
  if (!is.null(si$laid)) {
    return(laid_trajectory(settle(gear, nodes, netting), given, until))
  }
  what <- tow_start(gear, si, build_lattice(si, nodes, netting), given, until)
  now <- conditions_at(what, 0, before = 0 %in% what$breaks)
  first <- si_at(what, now)
  if (identical(first, si) && !length(what$schedule$growing) && now$heave == 0) {
    state <- settle(gear, nodes, netting)
    return(started_trajectory(state, given, until, compared_lattices(state)))
  }
  # A warp that is still short has few bars of its own: its shape is carried over to all of them.
  progress <- settle_progress()
  found <- settle_numbers(first, nodes, netting, progress = progress)
  if (found$report$converged) {
    found$lattice$counts <- NULL
    shape <- list(
      lattice = found$lattice, position = lattice_points(found$lattice, found$position)
    )
    what <- tow_start(gear, si, build_lattice(si, nodes, netting, shape), given, until)
  }
  if (!is.null(si$catch)) {
    what$lattice <- set_catch_front(what$lattice, found$lattice$catch$blocked)
  }
  moved <- what$schedule$motion$node
  what$lattice$start[3, moved] <- what$lattice$start[3, moved] + now$heave
  start <- lattice_at(what, now)
  settled <- engine_settle(
    start$mesh, as.double(what$lattice$start), if (found$report$converged) "near" else "crude",
    numeric(), line_part(start), settle_tolerance, settle_iterations, progress
  )
  settled <- name_parts(settled, start)
  if (!settled$converged) abort_unsettled(settled, start, settled$position)
  what$lattice$mesh <- changed_mesh(what$lattice$mesh, settled["wake"])
  # its gear's errors, as shares, are those that it has as its plan's conditions settle it
  what$compared <- tryCatch(
    compared_lattices(settled_state(gear, nodes, netting, NULL)),
    codend_error_not_converged = function(e) NULL
  )
  add_start(what, settled$position, c(-now$speed, 0, 0))
}
