#' A measured current as a plan writes it
#'
#' Turns the current of a profiler (ADCP), a mooring or an ocean model into what
#' `update(gear, water.current = )` takes: one speed and direction for each depth, in the gear's
#' own axes. Rows of one depth are averaged as vectors, so a whole log may be given.
#'
#' Compass bearings are turned into the plan's angles: a plan has 0 deg aft and 90 deg to starboard,
#' so a current on the bow flows towards 0 deg.
#'
#' @param table A data frame with `depth` (m below the surface, 0 or more) and the current over
#'   ground, either as `eastward` and `northward` (m/s), or as `speed` (m/s) and `toward` (where it
#'   flows to, rad clockwise from north). [read_currents()] gives the first, [read_sensor_log()] of
#'   a profiler's log either. Rows with `NA` are left out.
#' @param course Where the gear is towed to, or what a held gear's bow points to: rad clockwise from
#'   north, or a text such as `"230 deg"`.
#' @param least Readings that a depth must have to count.
#' @return A list with `depth`, `speed` and `toward` in words for each depth, from the surface down:
#'   the field `water.current` of a plan. Wrong arguments are an error of class
#'   `codend_error_argument`.
#' @seealso [read_currents()] for files of ocean models.
#' @export
#' @examples
#' measured <- data.frame(depth = c(0, 20, 60), eastward = c(0.4, 0.3, 0.1), northward = 0)
#' cage <- update(read_gear("cage"), water.current = current_profile(measured, course = "270 deg"))
#' cage
current_profile <- function(table, course = 0, least = 1) {
  check_given("table")
  if (is.data.frame(table)) table <- si_columns(table, current_columns, "table")
  if (!is.data.frame(table) || !is.numeric(table$depth) || !has_current(table)) {
    abort_argument("{.arg table} must be a data frame of numbers with {.field depth}, and
      {.field eastward} and {.field northward} or {.field speed} and {.field toward}.")
  }
  bearing <- bearing_si(course)
  check_count("least", least)
  east <- if (is.null(table$eastward)) table$speed * sin(table$toward) else table$eastward
  north <- if (is.null(table$northward)) table$speed * cos(table$toward) else table$northward
  whole <- is.finite(table$depth) & is.finite(east) & is.finite(north)
  wrong <- which(whole & (table$depth < 0 | sqrt(east^2 + north^2) > fastest_current))
  if (length(wrong)) {
    row <- wrong[1L]
    speed <- sqrt(east[row]^2 + north[row]^2)
    abort_argument("{.arg table} has in row {row} {figures(speed)} m/s at a depth of
      {figures(table$depth[row])} m; depths must be 0 or more, and a current at most
      {fastest_current} m/s. Are they in m and m/s, and depths positive downwards?")
  }
  depth <- sort(unique(table$depth[whole]))
  at <- factor(table$depth[whole], depth)
  enough <- as.vector(table(at)) >= least
  if (!any(enough)) {
    abort_argument("{.arg table} has no depth with {least} reading{?s} of the current.")
  }
  # the gear's x is aft and its y to starboard
  x <- -tapply(east[whole] * sin(bearing) + north[whole] * cos(bearing), at, mean)
  y <- tapply(east[whole] * cos(bearing) - north[whole] * sin(bearing), at, mean)
  lapply(which(enough), function(k) {
    list(
      depth = paste(plain_number(depth[k]), "m"),
      speed = paste(plain_number(round(sqrt(x[[k]]^2 + y[[k]]^2), 4)), "m/s"),
      toward = paste(plain_number(round(in_unit(atan2(y[[k]], x[[k]]), "deg"), 2)), "deg")
    )
  })
}

# m/s: no current of the sea is faster (Saltstraumen, the strongest known, reaches about 10); what
# is, is in other units.
fastest_current <- 11

# Columns of a table of currents that may be units objects, by dimension.
current_columns <- c(
  depth = "length", eastward = "speed", northward = "speed", speed = "speed", toward = "angle"
)

has_current <- function(table) {
  all_numbers <- function(names) {
    all(vapply(names, function(name) is.numeric(table[[name]]), NA))
  }
  all_numbers(c("eastward", "northward")) || all_numbers(c("speed", "toward"))
}

plain_number <- function(x) with_plain_numbers(format(x, digits = 10, trim = TRUE))

bearing_si <- function(course) {
  si <- given_si(course, "angle", "course")
  if (!is.finite(si)) {
    abort_argument("{.arg course} is {show_value(course)}; it must be an angle clockwise from north
      (units: {unit_examples('angle')}).")
  }
  si
}
