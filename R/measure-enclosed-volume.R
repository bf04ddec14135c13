# Volume of water that a net hanging from the surface encloses.

define_measure("enclosed_volume", "m3",
  "Volume of water that netting hanging from the surface encloses, down to a surface from a rope,
  such as the lead line, to that rope's middle. A gap between the two ends of the net is closed by
  an upright wall.",
  asks_rope, function(state, measure) measure_enclosed_volume(state, measure)
)

# By Gauss's theorem, the integral of z n_z over what bounds the water: the netting, and under it a
# surface from the lower rope to that rope's middle. What closes the rest, the surface of the water
# (z = 0) and upright walls from the float line to the surface and between the net's two ends, adds
# nothing.
measure_enclosed_volume <- function(state, measure) {
  lattice <- state$lattice
  cells <- lattice$engine$cells
  if (!length(cells$rest)) {
    abort_argument(
      "The enclosed volume is that of netting of cells; this gear has none
      ({.code netting: cells})."
    )
  }
  corners <- cell_corners(lattice)
  triangles <- cell_triangles(has_three_corners(corners))
  node <- matrix(corners[triangles$corner + 4L * rep(triangles$cell - 1L, each = 3L)], 3L)
  weight <- triangles$weight * cells$multiplicity[triangles$cell]
  x <- state_points(state)
  corner <- lapply(1:3, function(k) x[, node[k, ], drop = FALSE])
  netting <- sum(weight * upward_moment(corner[[1]], corner[[2]], corner[[3]]))
  rope <- lattice$ropes[[measure$rope]]$node
  rope <- rope[c(TRUE, diff(rope) != 0)]
  after <- c(rope[-1L], rope[1L])
  middle <- matrix(rowMeans(x[, rope, drop = FALSE]), 3L, length(rope))
  # Both wind the same way where the rope runs against the triangles that it borders.
  way <- if (runs_along(node, rope)) -1 else 1
  abs(netting + way * sum(upward_moment(x[, rope], x[, after], middle)))
}

# The integral of z n_z over triangles: their mean height times their area seen from above.
upward_moment <- function(a, b, c) {
  area <- ((b[1, ] - a[1, ]) * (c[2, ] - a[2, ]) - (b[2, ] - a[2, ]) * (c[1, ] - a[1, ])) / 2
  area * (a[3, ] + b[3, ] + c[3, ]) / 3
}

# Whether the first triangle that borders a run of nodes has its corners in the run's direction.
runs_along <- function(node, run) {
  place <- matrix(match(node, run), 3L)
  border <- which(colSums(!is.na(place)) == 2L)
  for (k in border) {
    at <- place[, k]
    step <- (at[c(2L, 3L, 1L)] - at)
    step <- step[!is.na(step)]
    if (abs(step) == 1L) return(step > 0)
  }
  FALSE
}
