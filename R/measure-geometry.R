# Measures of shape that a plan may ask for.

# Position (x, y, z, m) of a place such as "point", "panel.upper_left" or "rope.middle".
place_position <- function(state, place) state$position[, state$lattice$place(place)]

# Second place minus first, m.
apart <- function(state, pair) {
  place_position(state, pair[[2]]) - place_position(state, pair[[1]])
}

define_measure("spread", "m",
  "Horizontal distance between two places, as an acoustic sensor tells it, or the mean over several
  pairs. In a straight tow that is the distance across it; in a turn, where one door runs ahead of
  the other, it stays that of the doors from each other.",
  sensor = "Acoustic sensors on both doors or wing ends tell the slant distance between them from
  where they are fastened, which is some decimetres from the place named here; it wavers as the
  doors swing.",
  asks_pairs, function(state, measure) measure_spread(state, measure)
)

measure_spread <- function(state, measure) {
  mean(vapply(measure$pairs, function(pair) sqrt(sum(apart(state, pair)[1:2]^2)), 0))
}

define_measure("height", "m",
  "Height of the first place above the second, negative where it lies below. The height of a net's
  mouth is that of the head line's centre above the footrope's.",
  sensor = "A trawl eye or scanner on the head line tells the distance straight down to the
  footrope, or to the sea bed where its beam meets that first.",
  asks_pair, function(state, measure) measure_height(state, measure)
)

measure_height <- function(state, measure) -apart(state, measure$pairs[[1]])[3]

define_measure("length", "m", "Straight distance between two places.",
  asks_pair, function(state, measure) measure_length(state, measure)
)

measure_length <- function(state, measure) sqrt(sum(apart(state, measure$pairs[[1]])^2))

define_measure("depth", "m", "Depth of a place below the water surface, or the mean over several.",
  sensor = "A pressure sensor, its zero set at the surface.",
  asks_places, function(state, measure) measure_depth(state, measure)
)

measure_depth <- function(state, measure) {
  -mean(vapply(measure$place, function(place) place_position(state, place)[3], 0))
}

define_measure("sinking_speed", "m/s", "Downward speed of a place; 0 in a settled state.",
  sensor = "The change of a depth sensor's reading in time.",
  asks_place, function(state, measure) measure_sinking_speed(state, measure)
)

measure_sinking_speed <- function(state, measure) {
  -state$velocity[3, state$lattice$place(measure$place)] + 0
}

define_measure("clearance", "m", "Height of a place above the sea bed, across it.",
  sensor = "A height sensor on the head line, looking down; it is the distance to the first echo,
  which may be the footrope.",
  asks_place_over_ground, function(state, measure) measure_clearance(state, measure)
)

measure_clearance <- function(state, measure) {
  height_above_ground(state$si$ground, cbind(place_position(state, measure$place)))
}

define_measure("area", "m2",
  "Area enclosed by ropes end to end, seen level and from right ahead of them: along x in a straight
  tow, along the net's own heading in a turn. A gap between two ropes is closed by a straight
  line.",
  sensor = "A scanning sonar on the head line shows the outline; from height and spread alone it is
  mostly overestimated, as the outline is no rectangle.",
  asks_ropes, function(state, measure) measure_area(state, measure)
)

measure_area <- function(state, measure) {
  sqrt(sum(outline_area(rope_outline(state, measure$ropes))^2))
}

# Areas within a closed outline (3 x n, m) as seen along x and along y, m2, signed: the horizontal
# part of its vector area.
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

# Area within a closed polygon by its corners (shoelace formula), positive where they turn from x to
# y.
polygon_area <- function(x, y) {
  after <- c(seq_along(x)[-1], 1L)
  sum(x * y[after] - x[after] * y) / 2
}

define_measure("angle", "deg",
  "Direction of a rope's bar at a place, from start to end: below the horizontal (declination,
  negative when it rises) or, in plan view, out of the vessel's centre line (divergence, 0 to 180),
  in a turn too.",
  sensor = "Declination: an inclinometer on the warp near the block, which the warp's own weight
  makes steeper than farther down. Divergence: the distance of the warps apart at the blocks and a
  metre or two behind them.",
  asks_rope_angle, function(state, measure) measure_angle(state, measure)
)

measure_angle <- function(state, measure) {
  bar <- rope_bar(state$lattice, measure$rope, measure$place)
  ends <- state$lattice$engine$bars$node[2L * bar + c(-1L, 0L)]
  d <- state$position[, ends[2]] - state$position[, ends[1]]
  switch(measure$angle,
    declination = atan2(-d[3], sqrt(d[1]^2 + d[2]^2)),
    divergence = atan2(abs(d[2]), d[1])
  )
}
