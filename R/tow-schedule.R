# What changes with time while a gear is towed, as users give it.

#' Schedule of a tow
#'
#' Describes what changes with time while [tow()] marches a gear: the towing speed and the course,
#' the warps, the current, the catch and more. What a schedule leaves out is taken from the section
#' `tow` of the gear's plan, and stays as in the plan where that leaves it out too.
#'
#' A number that changes with time is one of
#' - a constant: a number in SI, a text with a unit or an object of the package units;
#' - a data frame with the columns `time` and `value`: straight between its rows, the last value for
#'   good. Two rows of one time make a jump, which at time 0 follows the settled start;
#' - a function of time in s that gives SI. It is evaluated every 0.1 s and smooth between, up to
#'   where it jumps.
#'
#' @param speed Towing speed, m/s.
#' @param course Course to starboard of that at the start, rad; it starts at 0.
#' @param warp_out Length of warp out, m: one for all ropes of role `warp` or `purse_wire`, or a
#'   list of them by rope or by `port` and `starboard`. At least 1 m.
#' @param winch `list(speed_limit = , tension_limit = )` in m/s and N: warps follow `warp_out` no
#'   faster, and pay out where their tension at the vessel, at the very end, exceeds the limit.
#' @param control A function of `measures` (as [measures()] of the present state) and `time` that
#'   gives the speed at which warps are paid out, m/s: one number, or numbers named by rope.
#' @param control_every Time between calls of `control`, s or text; 10 s when `NULL`.
#' @param current `list(speed = , toward = )` (m/s, rad), or a list of one such per depth of the
#'   plan's current.
#' @param heave Height of the towing points above where the plan has them, m; a sea state is a
#'   function of time.
#' @param vessel_motion How the vessel swings about its way: `list(response = , record = , at = ,
#'   rising = )`. `response`: a data frame or CSV file with a row per `period` of waves (s) and any
#'   of the columns `surge` (forwards), `sway` (to starboard), `heave` (up), m per m of the waves'
#'   amplitude, `roll` (starboard down), `pitch` (bow up), `yaw` (bow to starboard), rad per m, and
#'   `surge_lag` to `yaw_lag`, rad after the crest at the plan's origin, which moves with the
#'   vessel; straight between periods. `record`: the same by `time` (s) in m and rad, smooth
#'   between, which rises over `rising` (10 s). `at`: x, y and z (m) of the place that turns are
#'   about, the plan's origin when left out.
#' @param catch Share of the plan's catch that is in the codend: of its pieces of role `catch`, and
#'   of the volume, mass or blocked meshes of a [catch] in netting, whose front is moved every 2 s
#'   to where the netting behind it holds that much. Such a catch is as heavy as water and is moved
#'   with the netting around it.
#' @param breaking Ropes that break: a list of `list(rope = , time = , place = )`, place `"start"`,
#'   `"middle"` or `"end"`; without a time, at the breaking load of the rope.
#' @return A schedule of class `codend_schedule`: a list of the arguments. [tow()] checks them
#'   against the gear. A wrong argument is an error of class `codend_error_argument`.
#' @seealso [track_schedule()] for the schedule of a vessel's track.
#' @examples
#' faster <- tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot")))
#' faster
#' tow("towed_cable", until = 60, every = 20, schedule = faster)
#' @export
tow_schedule <- function(speed = NULL, course = NULL, warp_out = NULL, winch = NULL,
                         control = NULL, control_every = NULL, current = NULL, heave = NULL,
                         vessel_motion = NULL, catch = NULL, breaking = NULL) {
  if (!is.null(control) && !is.function(control)) {
    abort_schedule("control", "must be a function of {.arg measures} and {.arg time}.")
  }
  given <- mget(names(formals()))
  given <- Map(given_value, given, names(given))
  given["winch"] <- list(checked_winch(given$winch))
  if (!is.null(control_every)) {
    given$control_every <- tow_quantity(given$control_every, "control_every", "time")
  }
  structure(given, class = "codend_schedule")
}

#' @export
print.codend_schedule <- function(x, ...) {
  given <- Filter(Negate(is.null), unclass(x))
  if (!length(given)) {
    cat("Tow schedule: nothing changes but what the gear's plan says\n")
    return(invisible(x))
  }
  cat("Tow schedule\n")
  cat(paste0("  ", format(names(given)), "  ", vapply(given, schedule_text, ""), "\n"), sep = "")
  invisible(x)
}

schedule_text <- function(value) {
  if (is.function(value)) {
    return(paste("function of", paste(names(formals(args(value))), collapse = " and ")))
  }
  if (is.data.frame(value) && all(c("time", "value") %in% names(value))) {
    rows <- paste(value$value, "at", value$time)
    rows <- if (length(rows) > 4L) c(rows[1L], "...", rows[length(rows)]) else rows
    return(paste(rows, collapse = ", "))
  }
  if (!is.list(value)) return(paste(value, collapse = ", "))
  if (is.null(names(value))) return(paste(length(value), "in a list"))
  single <- lengths(value) == 1L & vapply(value, is.atomic, NA)
  paste0(names(value), ifelse(single, paste(" =", value), ""), collapse = ", ")
}

# A schedule with what it leaves out taken from `planned`, a plan's section `tow`.
with_planned <- function(schedule, planned) {
  open <- names(Filter(is.null, unclass(schedule)))
  schedule[open] <- unclass(do.call(tow_schedule, planned[intersect(open, names(planned))]))[open]
  schedule
}

checked_winch <- function(winch) {
  if (is.null(winch)) return(NULL)
  known <- c("speed_limit", "tension_limit")
  if (!is.list(winch) || !length(winch) || !all(names(winch) %in% known)) {
    abort_schedule("winch", "must be a list of {.field speed_limit} and {.field tension_limit}.")
  }
  of <- c(speed_limit = "speed", tension_limit = "force")
  for (name in names(winch)) {
    winch[[name]] <- tow_quantity(winch[[name]], paste0("winch$", name), of[[name]])
  }
  winch
}

# A positive number in SI from a number or a text with a unit.
tow_quantity <- function(value, name, dimension) {
  value <- given_value(value, name)
  si <- given_si(value, dimension, name)
  if (!is.finite(si) || si <= 0) {
    abort_argument(
      "{.arg {name}} is {show_value(value)}; it must be a {dimension} greater than 0 (units:
      {unit_examples(dimension)})."
    )
  }
  si
}
