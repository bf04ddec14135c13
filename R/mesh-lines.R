# Points and lines of a mesh: positions of all points, and the lines of ropes and cells.

# Returns the positions of all points from node positions: 3 x (nodes + tied points), m.
mesh_points <- function(mesh, position) {
  ties <- mesh$model$ties
  x <- matrix(position, 3L)
  if (!length(ties$first)) return(x)
  share <- rep(ties$share, each = 3L)
  cbind(x, (1 - share) * x[, ties$first] + share * x[, ties$second])
}

# TRUE for cells (4 x n nodes or positions) with three corners.
has_three_corners <- function(corner) corner[3L, ] == corner[4L, ]

# Returns the corners of some cells of a mesh, 4 x n.
cell_corners <- function(mesh, which = seq_along(mesh$cell_part)) {
  matrix(mesh$model$cells$node, 4L)[, which, drop = FALSE]
}

# Returns the centres of a mesh's cells, 3 x cells, m.
cell_middles <- function(mesh, points) {
  corner <- cell_corners(mesh)
  pointed <- has_three_corners(corner)
  share <- ifelse(pointed, 1 / 3, 1 / 4)
  total <- matrix(0, 3L, ncol(corner))
  for (k in 1:4) {
    of <- if (k < 4L) share else share * !pointed
    total <- total + points[, corner[k, ], drop = FALSE] * rep(of, each = 3L)
  }
  total
}

has_straight_bars <- function(mesh) mesh$model$cells$straight > 0

rope_bar <- function(mesh, rope, place) {
  bars <- rope_bars(mesh, rope)
  switch(place,
    start = bars[1],
    end = bars[length(bars)],
    middle = {
      rest <- mesh$model$bars$rest[bars]
      bars[which(cumsum(rest) >= sum(rest) / 2)[1]]
    }
  )
}

# Returns the nodes at the ends of bars: list(bar, node, share = weight of the node).
bar_shares <- function(mesh, bars) {
  ties <- mesh$model$ties
  nodes <- mesh$nodes
  node <- matrix(mesh$model$bars$node, 2L)[, bars]
  bar <- rep(bars, each = 2L)
  tied <- node > nodes
  tie <- node[tied] - nodes
  list(
    bar = c(bar[!tied], bar[tied], bar[tied]),
    node = c(node[!tied], ties$first[tie], ties$second[tie]),
    share = c(rep(1, sum(!tied)), 1 - ties$share[tie], ties$share[tie])
  )
}

# Returns the bars of a rope in order from its start.
rope_bars <- function(mesh, rope) {
  which(mesh$bar_part == which(mesh$parts$kind == "rope" & mesh$parts$name == rope))
}

# A line represents all material around it. Its transition out of the water therefore has at least
# this fraction of its length as height. A thinner transition would switch with every millimetre,
# and a net at the surface would not converge. The effect decreases with mesh refinement.
surface_share <- 0.05

# Returns the height (m) over which lines with a diameter and length leave the water.
surface_height <- function(diameter, length) pmax(diameter, surface_share * length)

# Returns indices among all points, nodes first. Tied points -1, -2, ... follow the nodes.
point_number <- function(node, nodes) {
  tied <- node < 0L
  node[tied] <- nodes - node[tied]
  node
}

sum_by <- function(x, group, n) group_sums(as.double(x), as.integer(group), as.integer(n))
