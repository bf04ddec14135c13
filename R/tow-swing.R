# How a vessel swings at its towing points: by its response to waves, or by a record.

# In the order of the engine's Swing: ways of moving, and whether each is a length or an angle.
swing_ways <- c(
  surge = "length", sway = "length", heave = "length", roll = "angle", pitch = "angle",
  yaw = "angle"
)

# given: as tow()'s vessel_motion; waves: the gear's, or NULL. Returns what the engine's track has
# as `swing`: list(centre (m), by_time = six curves or none, even, odd = six answers per wave or
# none).
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
    schedule_number(at[[k]], sprintf("vessel_motion$at[%d]", k), "length")
  }, 0)
  if (!is.null(given$response) && is.null(waves)) {
    abort_schedule("vessel_motion$response", "answers to waves; this gear's water has none.")
  }
  answers <- if (!is.null(given$response)) wave_answers(given$response, waves)
  rising <- schedule_number(first_of(given$rising, 10), "vessel_motion$rising", "time")
  if (rising < 0) abort_schedule("vessel_motion$rising", "must not be below 0.")
  list(
    centre = centre,
    by_time = if (!is.null(given$record)) record_curves(given$record, rising) else list(),
    even = as.double(answers$even), odd = as.double(answers$odd)
  )
}

# A column of a table in SI; 0 where the table has none.
swing_column <- function(table, name, dimension, path) {
  if (is.null(table[[name]])) return(numeric(nrow(table)))
  vapply(seq_len(nrow(table)), function(k) {
    schedule_number(table[[name]][k], sprintf("%s$%s[%d]", path, name, k), dimension)
  }, 0)
}

checked_swing_table <- function(table, first, more, path) {
  if (is_text(table)) {
    if (!file.exists(table)) abort_file(table, "does not exist.")
    table <- utils::read.csv(table, comment.char = "#")
  }
  known <- c(first, names(swing_ways), more)
  if (!is.data.frame(table) || nrow(table) == 0L || !first %in% names(table) ||
    !all(names(table) %in% known)) {
    abort_schedule(path, paste0(
      "must be a data frame or a CSV file with rows and the columns ", first, " and any of ",
      word_list(setdiff(known, first)), "."
    ))
  }
  table
}

# Answers per metre of a wave's height above the mean, interpolated between the periods of a table
# and constant beyond them: matrices with a column per wave.
wave_answers <- function(table, waves) {
  path <- "vessel_motion$response"
  table <- checked_swing_table(table, "period", paste0(names(swing_ways), "_lag"), path)
  period <- swing_column(table, "period", "time", path)
  if (is.unsorted(period, strictly = TRUE) || period[1L] <= 0) {
    abort_schedule(path, "must list its periods in order, each once, above 0.")
  }
  of_waves <- 2 * pi / waves$frequency
  at <- function(values) {
    if (length(period) == 1L) return(rep(values, length(of_waves)))
    stats::approx(period, values, of_waves, rule = 2)$y
  }
  both <- lapply(names(swing_ways), function(way) {
    # lengths per metre are plain numbers
    dimension <- if (swing_ways[[way]] == "angle") "angle" else "number"
    size <- swing_column(table, way, dimension, path)
    lag <- swing_column(table, paste0(way, "_lag"), "angle", path)
    # a crest passes where the angle of a wave, which falls with time, is 0
    list(even = at(size * cos(lag)), odd = at(-size * sin(lag)))
  })
  list(
    even = do.call(rbind, lapply(both, `[[`, "even")),
    odd = do.call(rbind, lapply(both, `[[`, "odd"))
  )
}

# A record as six curves, which rise from nothing over a time (s).
record_curves <- function(table, rising) {
  path <- "vessel_motion$record"
  table <- checked_swing_table(table, "time", character(), path)
  time <- swing_column(table, "time", "time", path)
  if (length(time) < 2L || is.unsorted(time, strictly = TRUE)) {
    abort_schedule(path, "must list two times or more in order, each once.")
  }
  if (time[1L] > 0) abort_schedule(path, "must begin at time 0 or before.")
  share <- if (rising > 0) pmin(pmax(time / rising, 0), 1) else as.double(time > 0)
  lapply(names(swing_ways), function(way) {
    value <- swing_column(table, way, swing_ways[[way]], path)
    smooth_curve(time, share^2 * (3 - 2 * share) * value)
  })
}
