#' Convert a measured current for a plan
#'
#' Converts the current of a profiler (ADCP), a mooring or an ocean model to the plan field
#' `water.current`: one speed and direction per depth in the axes of the gear. Use it in
#' `update(gear, water.current = )`.
#'
#' Rows of equal depth are averaged as vectors, so the table may be a whole log. Compass bearings
#' are converted to the angles of plans: 0 deg is aft and 90 deg is to starboard. A current on the
#' bow therefore flows towards 0 deg.
#'
#' @param table A data frame with `depth` (m below the surface, 0 or more) and the current over
#'   ground. Its columns are `eastward` and `northward` (m/s), or `speed` (m/s) and `toward`
#'   (direction of flow, rad clockwise from north). A unit may follow the name: `toward_deg`. Values
#'   may also be strings with a unit or objects of the package units. [read_currents()] and
#'   [read_sensor_log()] return such tables. Rows with `NA` are ignored.
#' @param course Towing direction, or heading of a held gear: a number in rad clockwise from north,
#'   or a string such as `"230 deg"`. Default 0.
#' @param least Minimum number of readings at a depth. Default 1.
#' @return A list with one element per depth, from the surface down. Each element is a list of the
#'   strings `depth` (m), `speed` (m/s) and `toward` (deg). Wrong arguments are an error of class
#'   `codend_error_argument`.
#' @seealso [read_currents()] for files of ocean models, [update()][update.codend_gear] to change
#'   the plan.
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
  bearing <- quantity_number(course, "angle", "course")
  check_count("least", least)
  east <- if (is.null(table$eastward)) table$speed * sin(table$toward) else table$eastward
  north <- if (is.null(table$northward)) table$speed * cos(table$toward) else table$northward
  whole <- is.finite(table$depth) & is.finite(east) & is.finite(north)
  wrong <- which(whole & (table$depth < 0 | sqrt(east^2 + north^2) > fastest_current))
  if (length(wrong)) {
    row <- wrong[1L]
    speed <- sqrt(east[row]^2 + north[row]^2)
    abort_argument("Row {row} of {.arg table} has {figures(speed)} m/s at a depth of
      {figures(table$depth[row])} m; depths must be 0 or more, and currents at most
      {fastest_current} m/s. Check the units (m, m/s) and the sign: depths are positive downwards.")
  }
  depth <- sort(unique(table$depth[whole]))
  at <- factor(table$depth[whole], depth)
  enough <- as.vector(table(at)) >= least
  if (!any(enough)) {
    abort_argument("{.arg table} has no depth with at least {least} reading{?s} of the current.")
  }
  # The gear's x is aft and its y to starboard.
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

# Upper limit of currents, m/s; the strongest known current (Saltstraumen) reaches about 10.
fastest_current <- 11

# Columns of a current table with their dimension.
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
