# Points and lines of a lattice: where all points are, and which lines a rope or a cell has.

# Positions of all points that elements stand on, from those of the nodes: 3 x (nodes + tied
# points), m.
lattice_points <- function(lattice, position) {
  ties <- lattice$mesh$ties
  x <- matrix(position, 3L)
  if (!length(ties$first)) return(x)
  share <- rep(ties$share, each = 3L)
  cbind(x, (1 - share) * x[, ties$first] + share * x[, ties$second])
}

# Twine coordinates of the corners of cells: list(u, v), 4 x cells each.
cell_twine_places <- function(cells, which = seq_along(cells$rest)) {
  twine <- matrix(cells$twine, 8L)[, which, drop = FALSE]
  list(u = twine[c(1L, 3L, 5L, 7L), , drop = FALSE], v = twine[c(2L, 4L, 6L, 8L), , drop = FALSE])
}

# Area of cells in twine coordinates, which is the number of bars of each family inside.
cell_area <- function(u, v) {
  abs((u[3L, ] - u[1L, ]) * (v[4L, ] - v[2L, ]) - (u[4L, ] - u[2L, ]) * (v[3L, ] - v[1L, ])) / 2
}

# Mesh bars of one family in cells.
cell_bars <- function(cells, which = seq_along(cells$rest)) {
  at <- cell_twine_places(cells, which)
  cell_area(at$u, at$v) * cells$multiplicity[which]
}

# Whether cells (4 x n nodes or places) have three corners.
has_three_corners <- function(corner) corner[3L, ] == corner[4L, ]

# Corners of some cells of a lattice, 4 x n.
cell_corners <- function(lattice, which = seq_along(lattice$cell_part)) {
  matrix(lattice$mesh$cells$node, 4L)[, which, drop = FALSE]
}

# Middles of a lattice's cells, 3 x cells, m.
cell_middles <- function(lattice, points) {
  corner <- cell_corners(lattice)
  pointed <- has_three_corners(corner)
  share <- ifelse(pointed, 1 / 3, 1 / 4)
  total <- matrix(0, 3L, ncol(corner))
  for (k in 1:4) {
    of <- if (k < 4L) share else share * !pointed
    total <- total + points[, corner[k, ], drop = FALSE] * rep(of, each = 3L)
  }
  total
}

# Which cells of a lattice are of hexagonal meshes.
has_straight_bars <- function(lattice) lattice$mesh$cells$straight > 0

# The bar of a rope at its start, middle or end.
rope_bar <- function(lattice, rope, place) {
  bars <- rope_bars(lattice, rope)
  switch(place,
    start = bars[1],
    end = bars[length(bars)],
    middle = {
      rest <- lattice$mesh$bars$rest[bars]
      bars[which(cumsum(rest) >= sum(rest) / 2)[1]]
    }
  )
}

# The nodes that hold the ends of some bars: list(bar, node, share of the end that it holds).
bar_shares <- function(lattice, bars) {
  ties <- lattice$mesh$ties
  nodes <- lattice$nodes
  node <- matrix(lattice$mesh$bars$node, 2L)[, bars]
  bar <- rep(bars, each = 2L)
  tied <- node > nodes
  tie <- node[tied] - nodes
  list(
    bar = c(bar[!tied], bar[tied], bar[tied]),
    node = c(node[!tied], ties$first[tie], ties$second[tie]),
    share = c(rep(1, sum(!tied)), 1 - ties$share[tie], ties$share[tie])
  )
}

# Bars of a rope in order from its start.
rope_bars <- function(lattice, rope) {
  which(lattice$bar_part == which(lattice$parts$kind == "rope" & lattice$parts$name == rope))
}

# A line of a lattice stands for all the material around it, so it leaves the water over at least
# this share of its length. What is thinner would come and go with every millimetre, and a net that
# lies at the surface would not settle; the finer the lattice, the less it matters.
surface_share <- 0.05

# Height (m) over which lines of these diameters and lengths leave the water.
surface_height <- function(diameter, length) pmax(diameter, surface_share * length)

# Numbers among all points, nodes first: tied ones are drawn as -1, -2, ...
point_number <- function(node, nodes) {
  tied <- node < 0L
  node[tied] <- nodes - node[tied]
  node
}

# Sums of x over groups 1..n, numbered by `group`.
sum_by <- function(x, group, n) group_sums(as.double(x), as.integer(group), as.integer(n))
