# Quantities that change over time, as piecewise cubic polynomials for the engine.
#
# A curve is list(time, begin, end, begin_rate, end_rate). Piece k runs from time[k] to time[k + 1].
# Its values go from begin[k] to end[k], with derivatives begin_rate[k] and end_rate[k]. The curve
# is constant before the first and after the last time.

# Sampling interval of functions (s); the interpolant is smooth between jumps.
function_step <- 0.1

# Converts user input to a curve. `value`: number or string with unit, data frame of time and value,
# or function of time (s) that returns SI. `path`: name for error messages; `until`: end time (s).
schedule_curve <- function(value, path, dimension, until) {
  if (is.function(value)) return(function_curve(value, path, dimension, until))
  if (is.data.frame(value)) return(table_curve(value, path, dimension))
  constant_curve(quantity_number(value, dimension, path))
}

constant_curve <- function(value) {
  list(time = c(0, 1), begin = value, end = value, begin_rate = 0, end_rate = 0)
}

# Returns a piecewise linear curve; two rows with the same time define a jump.
table_curve <- function(table, path, dimension) {
  table <- si_columns(table, c(time = "time", value = dimension), path)
  time <- table$time
  value <- table$value
  if (!length(time) || !length(value)) {
    abort_schedule(path,
      "must be a data frame with rows and the columns {.field time} and {.field value}.")
  }
  missing <- which(!is.finite(time) | !is.finite(value))
  if (length(missing)) abort_schedule(path, "has a missing value in row {missing[1L]}.")
  if (is.unsorted(time)) abort_schedule(path, "must have its times in increasing order.")
  if (length(time) == 1L) return(constant_curve(value))
  straight_curve(time, value)
}

straight_curve <- function(time, value) {
  n <- length(time)
  if (time[n] == time[n - 1L]) {  # keep the value after a final jump
    time <- c(time, time[n] + 1)
    value <- c(value, value[n])
    n <- n + 1L
  }
  # jump at time 0: the first value applies before it
  if (time[1L] == time[2L] && n > 2L) {
    time <- c(time[1L] - 1, time)
    value <- c(value[1L], value)
    n <- n + 1L
  }
  piece <- which(diff(time) > 0)
  if (!length(piece)) return(constant_curve(value[n]))
  slope <- (diff(value) / diff(time))[piece]
  list(
    time = c(time[piece], time[n]), begin = value[piece], end = value[piece + 1L],
    begin_rate = slope, end_rate = slope
  )
}

function_curve <- function(value, path, dimension, until) {
  if (!length(formals(args(value)))) abort_schedule(path, "must be a function of time (s).")
  time <- seq(0, by = function_step, length.out = ceiling(until / function_step) + 3)
  at <- function(t) {
    y <- given_si(value(t), dimension, path)
    if (!is.finite(y)) {
      abort_schedule(path, sprintf("must return one finite %s; at %s s it does not.", dimension,
        format(t)))
    }
    y
  }
  found <- vapply(time, at, 0)
  join_curves(pieces_between(function_jumps(at, time, found), time, found))
}

# Locates jumps of a function between sampled times by bisection. Returns a list of list(before,
# after (times, s), from, to (values)).
function_jumps <- function(at, time, value) {
  change <- abs(diff(value))
  beside <- pmax(c(0, change[-length(change)]), c(change[-1L], 0))
  lapply(which(change > 2 * beside + 1e-9 * max(abs(value))), function(k) {
    before <- time[k]
    after <- time[k + 1L]
    from <- value[k]
    to <- value[k + 1L]
    while (after - before > 1e-9 * max(1, after)) {
      middle <- (before + after) / 2
      found <- at(middle)
      if (abs(found - from) > abs(to - found)) {
        after <- middle
        to <- found
      } else {
        before <- middle
        from <- found
      }
    }
    if (abs(to - from) > change[k] / 2) list(before = before, after = after, from = from, to = to)
  })
}

# Returns smooth curves between jumps.
pieces_between <- function(jumps, time, value) {
  jumps <- Filter(Negate(is.null), jumps)
  at <- vapply(jumps, `[[`, 0, "after")
  lapply(seq_len(length(jumps) + 1L), function(k) {
    inside <- time > c(-Inf, at)[k] + 1e-6 & time < c(at, Inf)[k] - 1e-6
    t <- time[inside]
    y <- value[inside]
    if (k > 1L) {
      t <- c(at[k - 1L], t)
      y <- c(jumps[[k - 1L]]$to, y)
    }
    if (k <= length(jumps)) {
      t <- c(t, at[k])
      y <- c(y, jumps[[k]]$from)
    }
    if (length(t) > 1L) smooth_curve(t, y)
  })
}

join_curves <- function(curves) {
  curves <- Filter(Negate(is.null), curves)
  each <- function(field) unlist(lapply(curves, `[[`, field))
  time <- unlist(lapply(curves, function(curve) curve$time[-length(curve$time)]))
  last <- curves[[length(curves)]]$time
  list(
    time = c(time, last[length(last)]), begin = each("begin"), end = each("end"),
    begin_rate = each("begin_rate"), end_rate = each("end_rate")
  )
}

# Interpolates with rates from neighbouring values (Catmull and Rom 1974).
smooth_curve <- function(time, value) {
  n <- length(time)
  slope <- diff(value) / diff(time)
  rate <- c(slope[1], (slope[-1] + slope[-length(slope)]) / 2, slope[n - 1L])
  list(
    time = time, begin = value[-n], end = value[-1L], begin_rate = rate[-n], end_rate = rate[-1L]
  )
}

# Evaluates a curve at times; `after`: use the value after a jump instead of before it.
curve_at <- function(curve, t, after = FALSE) {
  engine_curve_at(curve, as.double(t), after)
}

scale_curve <- function(curve, factor) {
  curve[-1L] <- lapply(curve[-1L], function(x) x * factor)
  curve
}

# Returns a piecewise linear curve, clamped to two bounds. The input must have no jumps.
clipped_curve <- function(curve, low, high) {
  time <- curve$time
  value <- c(curve$begin, curve$end[length(curve$end)])
  cross <- unlist(lapply(c(low, high), function(bound) {
    from <- value[-length(value)] - bound
    to <- value[-1L] - bound
    at <- which(from * to < 0)
    time[at] + diff(time)[at] * from[at] / (from[at] - to[at])
  }))
  all <- sort(unique(c(time, cross)))
  straight_curve(all, pmin(pmax(stats::approx(time, value, all)$y, low), high))
}

# Returns the times of jumps; with `kinks` also of jumps in the rate.
curve_breaks <- function(curve, kinks) {
  n <- length(curve$begin)
  differ <- function(a, b) abs(a - b) > 1e-9 * max(1, abs(a), abs(b))
  inner <- seq_len(n - 1L)
  broken <- differ(curve$end[inner], curve$begin[inner + 1L])
  if (kinks) broken <- broken | differ(curve$end_rate[inner], curve$begin_rate[inner + 1L])
  ends <- if (kinks) c(curve$begin_rate[1L], curve$end_rate[n]) != 0 else c(FALSE, FALSE)
  c(curve$time[1L][ends[1]], curve$time[inner + 1L][broken], curve$time[n + 1L][ends[2]])
}

abort_schedule <- function(path, problem) {
  abort_argument(paste0("{.arg {path}} ", problem))
}
