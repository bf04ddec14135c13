# Points and lines of a lattice: where all points are, and which lines a rope or a triangle has.

# Positions of all points that elements stand on, from those of the nodes: 3 x (nodes + tied
# points), m.
lattice_points <- function(lattice, position) {
  ties <- lattice$engine$ties
  x <- matrix(position, 3L)
  if (!length(ties$first)) return(x)
  share <- rep(ties$share, each = 3L)
  cbind(x, (1 - share) * x[, ties$first] + share * x[, ties$second])
}

# Mesh bars of one family in triangles: half of |d|, the double area in twine coordinates.
triangle_bars <- function(triangles, which = seq_along(triangles$rest)) {
  at <- 6L * (which - 1L)
  u <- function(corner) triangles$twine[at + 2L * corner - 1L]
  v <- function(corner) triangles$twine[at + 2L * corner]
  u1 <- u(1L)
  v1 <- v(1L)
  d <- (u(2L) - u1) * (v(3L) - v1) - (u(3L) - u1) * (v(2L) - v1)
  abs(d) / 2 * triangles$multiplicity[which]
}

# Which triangles of a lattice are of hexagonal meshes.
has_straight_bars <- function(lattice) lattice$engine$triangles$straight > 0

# The bar of a rope at its start, middle or end.
rope_bar <- function(lattice, rope, place) {
  bars <- rope_bars(lattice, rope)
  switch(place,
    start = bars[1],
    end = bars[length(bars)],
    middle = {
      rest <- lattice$engine$bars$rest[bars]
      bars[which(cumsum(rest) >= sum(rest) / 2)[1]]
    }
  )
}

# Bars of a rope in order from its start.
rope_bars <- function(lattice, rope) {
  which(lattice$bar_part == which(lattice$parts$kind == "rope" & lattice$parts$name == rope))
}
