# The vessel's track over the ground, from its speed and course.

# Between these times (s) a turning vessel's track is one cubic; at 1 degree a second and 3 m/s that
# is 1e-8 m off.
track_step <- 0.25

# speed (m/s), course (rad, to starboard of the start, which heads towards -x): curves.
# Returns curves x and y (m) of the vessel's origin.
vessel_track <- function(speed, course, until) {
  until <- until + 1  # what moves goes on moving at the end
  knots <- c(0, until, speed$time, course$time)
  turns <- any(course$begin_rate != 0 | course$end_rate != 0)
  if (turns || length(speed$time) > 1000L) knots <- c(knots, seq(0, until, by = track_step))
  knots <- sort(unique(knots[knots >= 0 & knots <= until]))
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
