#' Schedule of a tow
#'
#' Defines the inputs of [tow()] that change over time, such as speed, course, warps, current and
#' catch. All other inputs stay constant. The schedule replaces the one in the section `tow` of the
#' gear's plan; `tow_schedule(speed = , plan = gear)` changes only some of its inputs. Hauling of a
#' seine, which follows from the plan, remains.
#'
#' @section Values over time:
#' A changing value is a constant, a table or a function:
#' - Constant: a number in SI, a string with a unit, or an object of the package units. An angle
#'   without a unit is at most 2 pi (rad): write `"90 deg"`.
#' - Table: a data frame with columns `time` and `value`, linear between its rows. A unit may follow
#'   the name of a column (`value_deg`). The last value stays. Two rows with the same time define a
#'   jump. At time 0 the gear settles in the conditions before the jump.
#' - Function of time in s that returns SI. It is sampled every 0.1 s, and its jumps are located.
#'   The interpolant is smooth between them.
#'
#' @section Winch and controller:
#' - `winch`: the warps follow `warp_out` up to `speed_limit` (m/s). They pay out if the tension at
#'   their end on the vessel exceeds `tension_limit` (N).
#' - `control`: called every `control_every` with the [measures()] of the present state and the time
#'   (s). It returns the paying-out speed (m/s): one number, or one number per rope, by name.
#'
#' @section Vessel motion:
#' `vessel_motion` is `list(response = , record = , at = , rising = )` with `response` or `record`:
#' - `response`: response of the vessel to waves, a data frame or CSV file with one row per wave
#'   `period` (s). Columns: `surge` (forward), `sway` (starboard), `heave` (up) in m per m of wave
#'   amplitude; `roll` (starboard down), `pitch` (bow up), `yaw` (bow to starboard) in rad per m.
#'   `surge_lag` to `yaw_lag` are lags in rad after the crest at the plan's origin, which moves with
#'   the vessel. Values are linear between periods. Missing columns are 0.
#' - `record`: measured motion, with the same columns by `time` (s), in m and rad. It starts
#'   smoothly over `rising` (default 10 s).
#' - `at`: centre of rotation, x, y and z (m). Default: the plan's origin.
#'
#' @section Catch:
#' `catch` scales all pieces of role `catch`, and the volume, mass or blocked meshes of a [catch] in
#' netting. The front of such a catch moves every 2 s, so that the netting behind it encloses the
#' scheduled amount. The catch is as heavy as water and moves with the netting around it.
#'
#' @param speed Towing speed, m/s.
#' @param course Change of course to starboard since the start, rad; 0 at time 0.
#' @param warp_out Length of warp out, m, at least 1 m: one value for all ropes of role `warp` or
#'   `purse_wire`, or a list by rope or by `port` and `starboard`.
#' @param winch `list(speed_limit = , tension_limit = )` in m/s and N, see the section on winches.
#' @param control `NULL`, or a function of `measures` and `time` that returns paying-out speeds,
#'   m/s.
#' @param control_every Time between calls of `control`, s or string. `NULL` (default): 10 s.
#' @param current `list(speed = , toward = )` in m/s and rad, or a list with one such entry per
#'   depth of the plan's current.
#' @param heave Height of the towing points above the plan's position, m. For a regular swell, use
#'   `list(amplitude = , period = )` in m and s.
#' @param vessel_motion Motion of the vessel about its track, see the section on vessel motion.
#' @param catch Fraction of the plan's catch that is in the codend.
#' @param breaking Ropes that break: a list of `list(rope = , time = , position = )`, with position
#'   `"start"`, `"middle"` or `"end"`. Without a time, the rope breaks at its breaking load.
#' @param plan `NULL`, or a gear or the name or file of a plan: its planned schedule gives the
#'   inputs that are not given.
#' @return A schedule of class `codend_schedule`: a list of the arguments. [tow()] checks them
#'   against the gear. A wrong argument is an error of class `codend_error_argument`.
#' @seealso [tow()]; [schedules] to change, combine and store schedules;
#'   [codend_charts] for a chart; [track_schedule()] for the schedule of a vessel's
#'   track; `vignette("motion", "codend")`.
#' @examples
#' faster <- tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot")))
#' faster
#' tow("towed_cable", until = 60, every = 20, schedule = faster)
#'
#' # a trawl turns by 90 degrees in three minutes
#' tow_schedule(course = data.frame(time = c(60, 240), value = c("0 deg", "90 deg")))
#' @export
tow_schedule <- function(speed = NULL, course = NULL, warp_out = NULL, winch = NULL,
                         control = NULL, control_every = NULL, current = NULL, heave = NULL,
                         vessel_motion = NULL, catch = NULL, breaking = NULL, plan = NULL) {
  if (!is.null(control) && !is.function(control)) {
    abort_schedule("control", "must be a function of {.arg measures} and {.arg time}.")
  }
  given <- mget(schedule_inputs())
  given <- map_changes(Map(given_value, given, names(given)), plain_change)
  given["vessel_motion"] <- list(plain_motion(given$vessel_motion))
  given["breaking"] <- list(lapply(given$breaking, lapply, plain_values))
  if (!length(given$breaking)) given["breaking"] <- list(NULL)
  si_winch(given$winch)
  si_control_every(control_every)
  schedule <- structure(given, class = "codend_schedule")
  if (is.null(plan)) return(schedule)
  gear <- check_is_gear(if (is.character(plan)) read_gear(plan) else plan)
  with_planned(schedule, tow_section(gear))
}

schedule_inputs <- function() setdiff(names(formals(tow_schedule)), "plan")

# Inputs that change over time, and their dimension.
changing_inputs <- c(
  speed = "speed", course = "angle", warp_out = "length", heave = "length", catch = "number"
)
changing_current <- c(speed = "speed", toward = "angle")

# Applies `of(value, path, dimension)` to each quantity over time. `given`: the fields of a schedule
# or of a section `tow`. A list with names has a quantity per rope, a current without names a list
# per depth.
map_changes <- function(given, of) {
  each <- function(values, path, dimensions) {
    known <- intersect(names(Filter(Negate(is.null), values)), names(dimensions))
    values[known] <- Map(of, values[known], paste0(path, known), dimensions[known])
    values
  }
  by_rope <- is_named_list(given[["warp_out"]])
  given <- each(given, "", changing_inputs[c(TRUE, TRUE, !by_rope, TRUE, TRUE)])
  if (by_rope) {
    ropes <- setNames(nm = names(given$warp_out))
    given$warp_out <- each(given$warp_out, "warp_out.", replace(ropes, TRUE, "length"))
  }
  current <- given[["current"]]
  if (is_named_list(current)) {
    given$current <- each(current, "current.", changing_current)
  } else if (is.list(current)) {
    given$current <- Map(each, current, sprintf("current.%d.", seq_along(current)),
      list(changing_current))
  }
  given
}

is_named_list <- function(x) is.list(x) && !is.data.frame(x) && !is.null(names(x))

# TRUE for list(amplitude, period), a regular swell.
is_swell <- function(x) is_named_list(x) && all(c("amplitude", "period") %in% names(x))

# Returns a quantity over time without integers, units in names of columns, and names of rows.
plain_change <- function(value, path, dimension) {
  if (is.data.frame(value)) return(plain_rows(value, c(time = "time", value = dimension), path))
  if (is_swell(value)) lapply(value, plain_values) else plain_values(value)
}

plain_rows <- function(table, dimensions, path) {
  list2DF(lapply(with_named_units(table, function(name) dimensions[name], path), plain_values))
}

# Returns a list or vector of numbers and strings as one vector.
plain_values <- function(value) {
  number <- is.numeric(value) || is.list(value) && all(vapply(value, is.numeric, NA))
  if (number) return(as.double(unlist(value)))
  if (is.list(value)) as.character(unlist(value)) else value
}

plain_motion <- function(given) {
  if (!is_named_list(given)) return(given)
  for (name in intersect(names(motion_dimensions), names(given))) {
    table <- given[[name]]
    if (!is.data.frame(table)) next
    given[[name]] <- plain_rows(table, motion_dimensions[[name]], paste0("vessel_motion$", name))
  }
  numbers <- intersect(c("at", "rising"), names(given))
  given[numbers] <- lapply(given[numbers], plain_values)
  given
}

# Fills the gaps of a schedule from `planned`, the section `tow` of a plan.
with_planned <- function(schedule, planned) {
  open <- names(Filter(is.null, unclass(schedule)))
  schedule[open] <- unclass(do.call(tow_schedule, planned[intersect(open, names(planned))]))[open]
  schedule
}

# Returns the limits of a winch in SI.
si_winch <- function(winch) {
  if (is.null(winch)) return(NULL)
  known <- c("speed_limit", "tension_limit")
  if (!is.list(winch) || !length(winch) || !all(names(winch) %in% known)) {
    abort_schedule("winch", "must be a list of {.field speed_limit} and {.field tension_limit}.")
  }
  for (name in names(winch)) {
    path <- paste0("winch$", name)
    winch[[name]] <- quantity_number(winch[[name]], winch_limits[[name]], path, positive = TRUE)
  }
  winch
}

winch_limits <- c(speed_limit = "speed", tension_limit = "force")

# Default interval between calls of a control function (s).
usual_control_every <- 10

# Returns the interval between calls of a control function (s), or NULL.
si_control_every <- function(every) {
  if (!is.null(every)) quantity_number(every, "time", "control_every", positive = TRUE)
}
