# Turn of each cubic piece of a track (rad). The error is 1e-8 m at 1 degree per second and 3 m/s.
track_turn <- 0.25 * pi / 180

# Spacing of fixed knots (s). They make the pieces independent of the end time, so that a continued
# tow is identical to an uninterrupted one.
track_span <- 600

# Returns curves x and y [m] of the vessel's origin. `speed`: curve [m/s]; `course`: curve [rad] to
# starboard of the initial heading, which is -x.
vessel_track <- function(speed, course, until) {
  last <- (floor(until / track_span) + 1) * track_span
  knots <- c(seq(0, last, by = track_span), speed$time, course$time, turning_knots(course))
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
  # three Gauss points match the order of a cubic with these end rates
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

# Returns knots within the turning pieces of a course.
turning_knots <- function(course) {
  length <- diff(course$time)
  turn <- pmax(abs(course$end - course$begin), abs(course$begin_rate) * length,
    abs(course$end_rate) * length)
  inside <- function(begin, length, pieces) begin + length * seq_len(max(pieces - 1, 0)) / pieces
  unlist(Map(inside, course$time[-length(course$time)], length, ceiling(turn / track_turn)))
}
