# Random tows: random gears (random-gears.R) whose speed, course, warps, current, heave and waves
# change over time. The number of a tow is its seed and gives the same tow on every machine.

# Returns tow number `number`: list(gear, schedule (NULL: the plan's), until (s), changes (names)).
# `minutes`: range of its duration. Gears that are shot or laid follow their plan's schedule.
random_tow <- function(number, minutes = c(1, 20), kind = NULL) {
  gear <- random_gear(number, kind)
  until <- 60 * as.numeric(drawn(minutes[1L], minutes[2L]))
  si <- codend:::gear_si(gear)
  changes <- list()
  change <- function(name, chance, value) {
    value <- if (stats::runif(1) < chance) value
    if (!is.null(value)) changes[[name]] <<- value
  }
  planned <- !is.null(si$shooting) || !is.null(si$laid)
  if (!planned && "moved" %in% codend:::held_points(si)) {
    change("speed", 0.6, random_change(si$towing$speed * c(1, stats::runif(2, 0.6, 1.4)), until))
    change("course", 0.4, random_turn(until))
    change("warp_out", 0.4, random_warps(si, until))
    change("heave", 0.2, list(amplitude = as.numeric(drawn(0.1, 1.5)),
      period = as.numeric(drawn(5, 15))))
  }
  if (!planned) change("current", 0.4, random_current(si, until))
  waves <- list(height = drawn(0.2, 3, "m"), period = drawn(6, 12, "s"),
    toward = drawn(1, 359, "deg"))
  waved <- if (stats::runif(1) < 0.3) {
    tryCatch(update(gear, water.waves = waves), codend_error = function(e) NULL)
  }
  list(gear = if (is.null(waved)) gear else waved, until = until,
    schedule = if (!planned) do.call(codend::tow_schedule, changes),
    changes = c(if (planned) "as planned", names(changes), if (!is.null(waved)) "waves"))
}

# Returns a table over time: values[1], then linear changes to the other values at random times.
random_change <- function(values, until) {
  time <- sort(stats::runif(2L * length(values) - 2L, 0, until))
  times <- c(2L, rep(2L, length(values) - 2L), 1L)
  data.frame(time = c(0, time), value = rep(values, times = times))
}

# A turn of up to half a circle, at 0.2 to 2 deg/s.
random_turn <- function(until) {
  rate <- as.numeric(drawn(0.2, 2)) * pi / 180
  angle <- min(rate * 0.8 * until, stats::runif(1, 0.3, pi))
  begin <- stats::runif(1, 0, until - angle / rate)
  data.frame(time = c(0, begin, begin + angle / rate),
    value = sample(c(-1, 1), 1L) * c(0, 0, angle))
}

# Warps that are paid out from a part of their length, or hauled, at 0.2 to 2 m/s.
random_warps <- function(si, until) {
  long <- vapply(si$ropes[codend:::warp_ropes(si)], `[[`, 0, "length")
  if (!length(long)) return(NULL)
  moved <- min(as.numeric(drawn(0.2, 2)) * 0.7 * until, 0.7 * min(long))
  begin <- stats::runif(1, 0, 0.2) * until
  end <- begin + 0.7 * until
  out <- stats::runif(1) < 0.5
  lapply(as.list(long), function(whole) {
    value <- if (out) whole - moved * c(1, 1, 0) else whole - moved * c(0, 0, 1)
    data.frame(time = c(0, begin, end), value = value)
  })
}

# A current that changes speed and direction at every depth of the plan's current.
random_current <- function(si, until) {
  current <- si$water$current
  turn <- stats::runif(1, -1, 1)
  factor <- stats::runif(1, 0.3, 1.5)
  more <- stats::runif(1, 0, 0.2)
  layers <- lapply(seq_along(current$depth), function(k) {
    speed <- sqrt(current$x[k]^2 + current$y[k]^2)
    toward <- atan2(current$y[k], current$x[k])
    list(speed = random_change(c(speed, factor * speed + more), until),
      toward = random_change(toward + c(0, turn), until))
  })
  if (length(layers) == 1L) layers[[1L]] else layers
}

# Returns the trajectory of a random tow, or the error. `seconds`: limit of its CPU time; `...`:
# further arguments of tow().
run_random_tow <- function(one, nodes, seconds, ...) {
  setTimeLimit(cpu = seconds, transient = TRUE)
  on.exit(setTimeLimit())
  tryCatch(
    suppressWarnings(codend::tow(one$gear, one$schedule, until = one$until, nodes = nodes, ...)),
    error = identity
  )
}
