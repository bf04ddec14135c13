# The vessel's track over the ground, from its speed and course.

# Between these times (s) a turning vessel's track is one cubic; at 1 degree a second and 3 m/s that
# is 1e-8 m off.
track_step <- 0.25

# A track has knots at its multiples, s. So its pieces, to their last bits, are the same however far
# a tow goes, and a tow that goes on is one that never stopped.
track_span <- 600

# speed (m/s), course (rad, to starboard of the start, which heads towards -x): curves.
# Returns curves x and y (m) of the vessel's origin.
vessel_track <- function(speed, course, until) {
  last <- (floor(until / track_span) + 1) * track_span
  knots <- c(seq(0, last, by = track_span), speed$time, course$time, turning_knots(course, last))
  knots <- sort(unique(knots[knots >= 0 & knots <= last]))
  n <- length(knots)
  velocity <- function(t, after) {
    v <- curve_at(speed, t, after)
    c <- curve_at(course, t, after)
    rbind(-v * cos(c), v * sin(c))
  }
  begin <- velocity(knots[-n], TRUE)
  end <- velocity(knots[-1L], FALSE)
  h <- diff(knots)
  # Gauss's three points, so that a cubic of these ends and rates is right to its own order
  at <- c(0.5 - sqrt(0.15), 0.5, 0.5 + sqrt(0.15))
  weight <- c(5, 8, 5) / 18
  moved <- 0
  for (k in 1:3) {
    moved <- moved + weight[k] * velocity(knots[-n] + at[k] * h, TRUE)
  }
  moved <- sweep(moved, 2L, h, "*")
  curve <- function(row) {
    reached <- c(0, cumsum(moved[row, ]))
    list(time = knots, begin = reached[-n], end = reached[-1L], begin_rate = begin[row, ],
      end_rate = end[row, ])
  }
  list(x = curve(1L), y = curve(2L))
}

# Knots within the pieces of a course on which it turns.
turning_knots <- function(course, last) {
  turns <- course$begin_rate != 0 | course$end_rate != 0
  knots <- seq(0, last, by = track_step)
  piece <- findInterval(knots, course$time)
  knots[c(FALSE, turns, FALSE)[piece + 1L]]
}
