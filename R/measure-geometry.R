# Measures of shape that a plan asks for. Each takes a state and the measure as si_measure() gives
# it.

# Position (x, y, z, m) of a place such as "point", "panel.upper_left" or "rope.middle".
place_position <- function(state, place) state$position[, state$lattice$place(place)]

# Second place minus first, m.
apart <- function(state, pair) {
  place_position(state, pair[[2]]) - place_position(state, pair[[1]])
}

# Spread: horizontal distance between two places, whichever way the gear lies; the mean over several
# pairs. m.
measure_spread <- function(state, measure) {
  mean(vapply(measure$pairs, function(pair) sqrt(sum(apart(state, pair)[1:2]^2)), 0))
}

# Height of the first place above the second, m; negative when it lies below. Net mouth height is
# that of the head line's centre above the footrope's centre.
measure_height <- function(state, measure) -apart(state, measure$pairs[[1]])[3]

# Straight distance between two places, m.
measure_length <- function(state, measure) sqrt(sum(apart(state, measure$pairs[[1]])^2))

# Depth below the water surface, m.
measure_depth <- function(state, measure) -place_position(state, measure$place)[3]

# Downward speed of a place, m/s.
measure_sinking_speed <- function(state, measure) {
  -state$velocity[3, state$lattice$place(measure$place)] + 0
}

# Height above the sea bed, across it, m.
measure_clearance <- function(state, measure) {
  height_above_ground(state$si$ground, cbind(place_position(state, measure$place)))
}

# Area that ropes, end to end, enclose as seen level and from right ahead of them, m2.
measure_area <- function(state, measure) {
  sqrt(sum(outline_area(rope_outline(state, measure$ropes))^2))
}

# Areas within a closed outline (3 x n, m) as seen along x and along y, m2, signed: the horizontal part
# of its vector area.
outline_area <- function(outline) {
  c(polygon_area(outline[2, ], outline[3, ]), polygon_area(outline[3, ], outline[1, ]))
}

# Points (3 x n, m) along ropes put end to end: each rope continues from the end that was reached,
# by its own nearer end, whatever its direction; gaps are closed by straight lines.
rope_outline <- function(state, ropes) {
  left <- lapply(ropes, function(r) state$position[, state$lattice$ropes[[r]]$node, drop = FALSE])
  ends <- function(x) list(x[, 1], x[, ncol(x)])
  gap <- function(a, b) sum((a - b)^2)
  outline <- left[[1]]
  left <- left[-1]
  if (length(left)) {
    to_others <- vapply(ends(outline), function(e) {
      min(vapply(left, function(x) min(gap(e, x[, 1]), gap(e, x[, ncol(x)])), 0))
    }, 0)
    if (to_others[1] < to_others[2]) outline <- outline[, rev(seq_len(ncol(outline)))]
  }
  while (length(left)) {
    reached <- outline[, ncol(outline)]
    gaps <- vapply(left, function(x) vapply(ends(x), gap, 0, b = reached), c(0, 0))
    nearest <- which.min(gaps)
    k <- (nearest - 1L) %/% 2L + 1L
    next_rope <- left[[k]]
    if (nearest %% 2L == 0L) next_rope <- next_rope[, rev(seq_len(ncol(next_rope)))]
    outline <- cbind(outline, next_rope)
    left <- left[-k]
  }
  outline
}

# Area within a closed polygon by its corners (shoelace formula), positive where they turn from x to y.
polygon_area <- function(x, y) {
  after <- c(seq_along(x)[-1], 1L)
  sum(x * y[after] - x[after] * y) / 2
}

# Angle of a rope at a place, deg, in its direction from start to end: declination below the
# horizontal (negative when it rises), or divergence of its plan view from the vessel's centre line, x
# (0 to 180).
measure_angle <- function(state, measure) {
  bar <- rope_bar(state$lattice, measure$rope, measure$place)
  ends <- state$lattice$engine$bars$node[2L * bar + c(-1L, 0L)]
  d <- state$position[, ends[2]] - state$position[, ends[1]]
  radians <- switch(measure$angle,
    declination = atan2(-d[3], sqrt(d[1]^2 + d[2]^2)),
    divergence = atan2(abs(d[2]), d[1])
  )
  radians * 180 / pi
}
