# Motion of a vessel at its towing points, from its response to waves or from a record.

# Degrees of freedom in the order of the engine's Swing, and their dimension.
swing_ways <- c(
  surge = "length", sway = "length", heave = "length", roll = "angle", pitch = "angle",
  yaw = "angle"
)

# Dimensions of the columns of `response` and `record`. Lengths per metre are dimensionless.
motion_dimensions <- list(
  response = c(period = "time", replace(swing_ways, swing_ways == "length", "number"),
    setNames(rep("angle", length(swing_ways)), paste0(names(swing_ways), "_lag"))),
  record = c(time = "time", swing_ways)
)

# Returns the input `swing` of the engine's track: list(centre [m], by_time, even, odd). `by_time`:
# six curves or empty; `even`, `odd`: six amplitudes per wave or empty. `given`: as `vessel_motion`
# of tow_schedule(); `waves`: waves of the gear, or NULL.
vessel_swing <- function(given, waves) {
  if (is.null(given)) return(NULL)
  known <- c("at", "response", "record", "rising")
  if (!is.list(given) || is.data.frame(given) || !length(given) || !all(names(given) %in% known) ||
    is.null(given$response) && is.null(given$record)) {
    abort_schedule("vessel_motion",
      "must be a list of {.field response} or {.field record}, {.field at} and {.field rising}.")
  }
  at <- first_of(given$at, c(0, 0, 0))
  if (length(at) != 3L) abort_schedule("vessel_motion$at", "must be three lengths: x, y and z.")
  centre <- vapply(1:3, function(k) {
    quantity_number(at[[k]], "length", sprintf("vessel_motion$at[%d]", k))
  }, 0)
  if (!is.null(given$response) && is.null(waves)) {
    abort_schedule("vessel_motion$response", "needs waves; the plan of this gear has no
      `water.waves`.")
  }
  answers <- if (!is.null(given$response)) wave_answers(given$response, waves)
  rising <- quantity_number(first_of(given$rising, 10), "time", "vessel_motion$rising")
  if (rising < 0) abort_schedule("vessel_motion$rising", "must not be below 0.")
  list(
    centre = centre,
    by_time = if (!is.null(given$record)) record_curves(given$record, rising) else list(),
    even = as.double(answers$even), odd = as.double(answers$odd)
  )
}

# Returns a table of a vessel's motion in SI with a column for each of `dimensions`, 0 if it is
# missing. `first`: name of the column that it needs.
swing_table <- function(table, first, dimensions, path) {
  if (is_text(table)) {
    if (!file.exists(table)) abort_file(table, "does not exist.", argument = path)
    table <- utils::read.csv(table, comment.char = "#")
  }
  known <- names(dimensions)
  if (is.data.frame(table)) table <- si_columns(table, dimensions, path)
  if (!is.data.frame(table) || nrow(table) == 0L || !first %in% names(table) ||
    !all(names(table) %in% known)) {
    abort_schedule(path, paste0(
      "must be a data frame or a CSV file with rows and the columns ", first, " and any of ",
      word_list(setdiff(known, first)), "."
    ))
  }
  if (!all(is.finite(unlist(table)))) abort_schedule(path, "has missing values.")
  table[setdiff(known, names(table))] <- 0
  table
}

# Returns amplitudes per metre of wave elevation, one column per wave. They are linear between the
# periods of the table and constant beyond them.
wave_answers <- function(table, waves) {
  path <- "vessel_motion$response"
  table <- swing_table(table, "period", motion_dimensions$response, path)
  period <- table$period
  if (is.unsorted(period, strictly = TRUE) || period[1L] <= 0) {
    abort_schedule(path, "must have positive periods in increasing order, without duplicates.")
  }
  of_waves <- 2 * pi / waves$frequency
  at <- function(values) {
    if (length(period) == 1L) return(rep(values, length(of_waves)))
    stats::approx(period, values, of_waves, rule = 2)$y
  }
  both <- lapply(names(swing_ways), function(way) {
    size <- table[[way]]
    lag <- table[[paste0(way, "_lag")]]
    # the phase of a wave decreases with time and is 0 at a crest
    list(even = at(size * cos(lag)), odd = at(-size * sin(lag)))
  })
  list(
    even = do.call(rbind, lapply(both, `[[`, "even")),
    odd = do.call(rbind, lapply(both, `[[`, "odd"))
  )
}

# Returns a record as six curves that start smoothly within `rising` seconds.
record_curves <- function(table, rising) {
  path <- "vessel_motion$record"
  table <- swing_table(table, "time", motion_dimensions$record, path)
  time <- table$time
  if (length(time) < 2L || is.unsorted(time, strictly = TRUE)) {
    abort_schedule(path, "must have at least two times in increasing order, without duplicates.")
  }
  if (time[1L] > 0) abort_schedule(path, "must start at time 0 or earlier.")
  share <- if (rising > 0) pmin(pmax(time / rising, 0), 1) else as.double(time > 0)
  lapply(names(swing_ways), function(way) {
    smooth_curve(time, share^2 * (3 - 2 * share) * table[[way]])
  })
}
