# Schedules as text, as a table, and combined.

#' Change, combine and store schedules
#'
#' A schedule from [tow_schedule()] can be changed, combined with others, converted to a table, and
#' written to a plan.
#'
#' @section Schedules in plans:
#' `update(gear, tow = schedule)` stores a schedule in the section `tow` of a plan, instead of the
#' inputs there. `until`, `every`, `scheme` and `accuracy` of the section stay. [write_gear()]
#' writes the plan. `tow_schedule(plan = gear)` returns the identical schedule, and [tow()] uses it
#' if it gets no schedule. For a seine, it adds the hauling that follows from the plan. A plan
#' cannot hold functions.
#'
#' @param x,object A schedule.
#' @param ... For `update()`: arguments of [tow_schedule()] with new values, `NULL` to remove an
#'   input. For `c()`: further schedules. Not used otherwise.
#' @param row.names `NULL` (default) or names for the rows.
#' @param optional Not used.
#' @param n Largest number of inputs to print, by default 13.
#' @param until Last time at which functions are evaluated, s or string with a unit. `NULL`
#'   (default): the last time of all tables, or 60 s.
#' @return
#' - `c()` and `update()`: a schedule. `c()` raises an error of class `codend_error_argument` if two
#'   schedules define the same input.
#' - `as.data.frame()`: a data frame with a row per input and time. Columns: `time_s`, `input` (such
#'   as `speed` or `warp_out.port`), `value` and its `unit`, which is the unit of the schedule. It
#'   lists functions every 0.1 s, or at 5,001 times if `until` is above 500 s. It omits `control`,
#'   `breaking` and the response to waves.
#' @seealso [tow_schedule()], [tow()]; [codend_charts] for a chart.
#' @examples
#' faster <- tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot")))
#' turning <- tow_schedule(course = data.frame(time = c(60, 240), value = c("0 deg", "90 deg")))
#' both <- c(faster, turning)
#' as.data.frame(both)
#' update(both, speed = "3 knot")
#'
#' file <- tempfile(fileext = ".yaml")
#' write_gear(update(read_gear("midwater_trawl"), tow = both), file)
#' identical(tow_schedule(plan = file), both)
#' @name schedules
NULL

#' @rdname schedules
#' @export
update.codend_schedule <- function(object, ...) {
  new <- list(...)
  known <- schedule_inputs()
  wrong <- setdiff(first_of(names(new), rep("", length(new))), known)
  if (length(wrong)) {
    abort_argument("{.val {wrong[1L]}} is not an input of a schedule; the inputs are
      {.arg {known}}.")
  }
  given <- unclass(object)
  given[names(new)] <- new
  do.call(tow_schedule, given)
}

#' @rdname schedules
#' @export
c.codend_schedule <- function(...) {
  given <- lapply(list(...), function(one) Filter(Negate(is.null), unclass(one)))
  schedules <- vapply(list(...), inherits, NA, "codend_schedule")
  if (!all(schedules)) abort_schedule("...", "must be schedules from {.fn tow_schedule}.")
  all <- unlist(lapply(given, names))
  twice <- all[duplicated(all)]
  if (length(twice)) {
    abort_argument(c("Two of the schedules define {.field {twice[1L]}}.",
      i = "Remove it from one of them: {.code update(schedule, {twice[1L]} = NULL)}."))
  }
  do.call(tow_schedule, do.call("c", given))
}

# Returns the quantities over time: list(path, dimension, value) each. A limit of the winch is
# constant; a record of the vessel's motion has a quantity per column.
schedule_changes <- function(schedule) {
  found <- list()
  add <- function(value, path, dimension) {
    found[[length(found) + 1L]] <<- list(path = path, dimension = dimension, value = value)
    value
  }
  map_changes(unclass(schedule), add)
  winch <- schedule$winch
  for (name in names(winch)) add(winch[[name]], paste0("winch.", name), winch_limits[[name]])
  record <- schedule$vessel_motion$record
  if (is.data.frame(record)) {
    for (name in intersect(names(record), names(swing_ways))) {
      add(list2DF(list(time = record$time, value = record[[name]])),
        paste0("vessel_motion.", name), swing_ways[[name]])
    }
  }
  found
}

#' @rdname schedules
#' @export
as.data.frame.codend_schedule <- function(x, row.names = NULL, optional = FALSE, until = NULL,
                                          ...) {
  changes <- schedule_changes(x)
  until <- schedule_end(x, changes, until)
  table <- do.call(rbind, c(
    list(data.frame(time_s = numeric(), input = character(), value = numeric(),
      unit = character())),
    lapply(changes, change_rows, until)
  ))
  with_row_names(table, row.names)
}

# Returns the last time of a schedule (s).
schedule_end <- function(schedule, changes, until) {
  if (!is.null(until)) return(quantity_number(until, "time", "until", positive = TRUE))
  last <- last_time(schedule, changes)
  if (last > 0) last else 60
}

# Returns the last time of all tables of a schedule and of breaking ropes (s); 0 if there is none.
last_time <- function(schedule, changes = schedule_changes(schedule)) {
  tables <- Filter(is.data.frame, lapply(changes, `[[`, "value"))
  times <- lapply(tables, function(table) quantities_si(table$time, "time", "time"))
  max(0, unlist(times), break_times(schedule))
}

# Returns the scheduled times of breaking (s), named by rope.
break_times <- function(schedule) {
  events <- Filter(function(event) !is.null(event$time), schedule$breaking)
  times <- vapply(events, function(event) quantity_number(event$time, "time", "breaking$time"), 0)
  setNames(times, vapply(events, `[[`, "", "rope"))
}

# Largest number of intervals between listed values of a function. It resolves a swell over an hour.
most_sampled <- 5000L

change_rows <- function(change, until) {
  value <- change$value
  si <- function(x) quantities_si(x, change$dimension, change$path)
  unit <- change_unit(change)
  if (is_swell(value)) value <- swell(value)
  if (is.data.frame(value)) {
    time <- quantities_si(value$time, "time", paste0(change$path, ".time"))
    value <- si(value$value)
  } else if (is.function(value)) {
    time <- seq(0, until, length.out = min(ceiling(until / function_step), most_sampled) + 1)
    value <- vapply(time, function(t) si(value(t)), 0)
  } else {
    time <- 0
    value <- si(value)
  }
  if (nzchar(unit)) value <- in_unit(value, unit)
  data.frame(time_s = time, input = rep(change$path, length(time)), value = value,
    unit = rep(unit, length(time)))
}

# Returns the unit of a quantity over time as the user wrote it, or in SI.
change_unit <- function(change) {
  value <- change$value
  if (is_swell(value)) value <- value$amplitude
  if (is.data.frame(value)) value <- value$value
  if (change$dimension == "number") return("")
  unit <- if (is.character(value)) plain_unit(split_quantity(value[1L])[2L])
  if (length(unit) && nzchar(unit)) unit else names(plan_units[[change$dimension]])[1L]
}

# ---- text ----------------------------------------------------------------------------------------

# Largest number of printed times of one input.
printed_times <- 3L

#' @rdname schedules
#' @export
print.codend_schedule <- function(x, n = 13, ...) {
  lines <- schedule_lines(x)
  if (!length(lines)) {
    cat("Tow schedule: empty; only the plan's section `tow` applies\n")
    return(invisible(x))
  }
  check_rows(n)
  cat("Tow schedule\n")
  cat_rows(list(names(lines), unname(lines)), 1:2, n, "input")
  invisible(x)
}

# Returns a line per input, named by its path.
schedule_lines <- function(x) {
  changes <- schedule_changes(x)
  lines <- setNames(vapply(changes, change_text, ""), vapply(changes, `[[`, "", "path"))
  if (!is.null(x[["control"]])) {
    every <- written_quantity(first_of(x$control_every, usual_control_every), "time")
    inputs <- paste(names(formals(args(x[["control"]]))), collapse = " and ")
    lines[["control"]] <- sprintf("function of %s, every %s", inputs, every)
  }
  response <- x$vessel_motion$response
  if (is_text(response)) lines[["vessel_motion.response"]] <- response
  if (is.data.frame(response)) {
    ends <- written_quantity(response$period[c(1L, nrow(response))], "time")
    lines[["vessel_motion.response"]] <- sprintf("%s, for wave periods of %s to %s",
      word_list(intersect(names(swing_ways), names(response))), ends[1L], ends[2L])
  }
  for (event in x$breaking) {
    at <- if (is.null(event$time)) "at its breaking load" else {
      paste("at", written_quantity(event$time, "time"))
    }
    lines <- c(lines, breaking = sprintf("%s, %s, %s", event$rope,
      first_of(event$position, "middle"), at))
  }
  lines
}

change_text <- function(change) {
  value <- change$value
  text <- function(x) written_quantity(x, change$dimension)
  if (is.function(value)) return(paste("function of time (s), in", change_unit(change)))
  if (is_swell(value)) {
    return(sprintf("swell of amplitude %s and period %s", text(value$amplitude),
      written_quantity(value$period, "time")))
  }
  if (!is.data.frame(value)) return(text(value))
  time <- written_quantity(value$time, "time")
  n <- nrow(value)
  if (n <= printed_times) return(paste(text(value$value), "at", time, collapse = ", "))
  ends <- range(change_rows(change, 0)$value)
  shown <- trimws(paste(four_figures(ends), c("", change_unit(change))))
  sprintf("%s to %s, %d times from %s to %s", shown[1L], shown[2L], n, time[1L], time[n])
}

# Returns quantities as the user wrote them; numbers get their SI unit.
written_quantity <- function(x, dimension) {
  if (is.numeric(x)) vapply(x, format_si, "", dimension) else x
}
