# Netting as elements: triangles on a panel's grid, or equivalent bars on its twines. Both put the
# same twine, knots, mass and projected area into the water, and both meet at the panel's edges.
#
# Mesh coordinates of a panel: i meshes across (from the left end of the upper edge), j meshes deep.
# Twine coordinates: diamond and turned meshes u = i + j, v = j - i; square meshes u = i, v = j; one
# unit is one bar.

panel_left <- function(panel, j) {
  panel$taper_left * (panel$upper - panel$lower) * j / panel$deep
}

panel_right <- function(panel, j) {
  panel$upper - panel$taper_right * (panel$upper - panel$lower) * j / panel$deep
}

# Bars of one family in a panel (as many of the other), and knots, in the plan.
panel_bars <- function(panel) {
  area <- (panel$upper + panel$lower) / 2 * panel$deep
  if (panel$orientation == "square") area else 2 * area
}

# What a panel's elements depend on besides how it is divided.
panel_shape <- c(
  "mesh_size", "upper", "lower", "deep", "taper_left", "taper_right", "orientation"
)

# Elements of every panel; panels that are alike (the sides of a trawl) are divided once.
#
# division: of a panel of bars list(lambda, segments), of triangles list(across, deep).
divide_panels <- function(panels, division, bars) {
  found <- known <- list()
  for (p in seq_along(panels)) {
    key <- list(bars[[p]], division[[p]], panels[[p]][panel_shape])
    same <- 0L
    for (k in seq_along(known)) {
      if (identical(known[[k]], key)) {
        same <- k
        break
      }
    }
    known[[p]] <- key
    found[[p]] <- if (same) {
      found[[same]]
    } else if (bars[[p]]) {
      bar_elements(panels[[p]], division[[p]][[1]], division[[p]][[2]])
    } else {
      triangle_elements(panels[[p]], division[[p]][[1]], division[[p]][[2]])
    }
  }
  found
}

# Triangles of a panel whose columns lie at the fractions `across` and rows at `deep`.
#
# Returns list(corner = three places in the panel's grid for each triangle, twine = u and v at each
# of these, rest, multiplicity, bars = number of bars of one family inside).
triangle_elements <- function(panel, across, deep) {
  columns <- length(across) - 1L
  rows <- length(deep) - 1L
  j <- rep(deep * panel$deep, each = columns + 1L)
  i <- panel_left(panel, j) + rep(across, rows + 1L) * (panel_right(panel, j) - panel_left(panel, j))
  square <- panel$orientation == "square"
  u <- if (square) i else i + j
  v <- if (square) j else j - i

  cell_c <- rep.int(seq_len(columns) - 1L, rows)
  a <- cell_c + rep(seq_len(rows) - 1L, each = columns) * (columns + 1L) + 1L
  # The diagonal changes sides at the panel's middle line, so that a panel's mirror image is
  # divided as its mirror image; a middle column carries both diagonals at half weight.
  side <- 2L * cell_c + 1L - columns
  falling <- a[side <= 0L]
  rising <- a[side >= 0L]
  below <- columns + 1L
  corner <- rbind(
    c(falling, falling, rising, rising + 1L),
    c(falling + 1L, falling + below + 1L, rising + 1L, rising + below + 1L),
    c(falling + below + 1L, falling + below, rising + below, rising + below)
  )
  weight <- rep.int(1, ncol(corner))
  middle <- c(rep.int(side[side <= 0L] == 0L, 2L), rep.int(side[side >= 0L] == 0L, 2L))
  weight[middle] <- 0.5
  first <- corner[1L, ]
  second <- corner[2L, ]
  third <- corner[3L, ]
  area <- (u[second] - u[first]) * (v[third] - v[first]) -
    (u[third] - u[first]) * (v[second] - v[first])
  area <- abs(area)
  keep <- area > 1e-9 * max(area)
  corner <- as.vector(corner[, keep])
  list(
    corner = corner, twine = as.vector(rbind(u[corner], v[corner])),
    rest = rep.int(panel$mesh_size / 2, sum(keep)), multiplicity = weight[keep],
    bars = area[keep] / 2 * weight[keep]
  )
}

# Equivalent bars of a panel. Knots lie lambda bars apart along the twines; those within a quarter
# of an equivalent mesh of an edge are moved onto it, twines that cross an edge end there, and what
# lies on an edge is tied to the edge's nodes. Lengths at slanted edges are so only nearly right;
# multiplicities are scaled to the panel's exact length of twine.
#
# Returns list(lambda, points = knots and cut ends: i, j, edge 0 or 1..4 and the fraction along it,
# knots; between = i and j of the middles of bars, numbered on after the points; ends = two points
# for each bar, rest, multiplicity).
bar_elements <- function(panel, lambda, segments) {
  square <- panel$orientation == "square"
  rows <- max(1L, as.integer(round((if (square) 1 else 2) * panel$deep / lambda)))
  row_step <- panel$deep / rows
  # A knot at the left end of the upper edge, or midway where that fits the width better.
  meshes <- panel$upper / lambda
  half <- abs(meshes - round(meshes)) < 1e-6 && round(meshes) %% 2 == 1
  centre <- panel$upper / 2 + if (half) lambda / 2 else 0
  # Columns of knots, with two beyond the panel on either side.
  begin <- floor((min(0, panel_left(panel, panel$deep)) - centre) / lambda) - 2
  width <- as.integer(
    ceiling((max(panel$upper, panel_right(panel, panel$deep)) - centre) / lambda) + 3 - begin
  )

  q <- rep(0:rows, each = width)
  odd <- if (square) 0L else q %% 2L
  i <- centre + lambda * (rep.int(begin + seq_len(width) - 1, rows + 1L) + odd / 2)
  j <- q * row_step
  left <- panel_left(panel, j)
  right <- panel_right(panel, j)
  from_left <- i - left
  from_right <- right - i
  near <- lambda / 4 + 1e-9
  kept <- from_left >= -near & from_right >= -near
  on_left <- abs(from_left) <= near
  on_right <- abs(from_right) <= near & !on_left
  i[on_left] <- left[on_left]
  i[on_right] <- right[on_right]
  edge <- 3L * on_left + 4L * on_right
  index <- cumsum(kept)

  # Twines run to the next row; those of square meshes also along the row. No knot is kept at the
  # ends of a row, so none has a neighbour in another.
  before_last <- seq_len(width * rows - 1L)
  all <- seq_len(width * (rows + 1L) - 1L)
  to_u <- before_last + width + if (square) 0L else odd[before_last]
  from <- c(before_last, if (square) all else before_last)
  to <- c(to_u, if (square) all + 1L else to_u - 1L)
  from_kept <- kept[from]
  to_kept <- kept[to]
  whole <- from_kept & to_kept
  cut <- from_kept != to_kept
  inner <- to[cut]
  outer <- from[cut]
  starts <- from_kept[cut]
  inner[starts] <- from[cut][starts]
  outer[starts] <- to[cut][starts]
  from <- from[whole]
  to <- to[whole]
  # A twine on an edge, but for the upper and lower edge of diamond netting, belongs half to each
  # neighbour.
  along_edge <- edge[from] == edge[to] & edge[from] > 0L
  if (square) {
    along_edge <- along_edge | (q[from] == q[to] & (q[from] == 0L | q[from] == rows))
  }
  # Twines that leave: cut where they meet the side.
  loose <- edge[inner] == 0L
  inner <- inner[loose]
  outer <- outer[loose]
  leftwards <- i[outer] < left[outer]
  gap <- function(k) {
    across <- right[k] - i[k]
    across[leftwards] <- (i[k] - left[k])[leftwards]
    across
  }
  inside <- gap(inner)
  fraction <- inside / (inside - gap(outer))

  knots <- index[length(index)]
  point_i <- c(i[kept], i[inner] + fraction * (i[outer] - i[inner]))
  point_j <- c(j[kept], j[inner] + fraction * (j[outer] - j[inner]))
  point_edge <- c(edge[kept], 4L - leftwards)
  point_edge[point_edge == 0L & point_j <= 1e-9 * panel$deep] <- 1L
  point_edge[point_edge == 0L & point_j >= panel$deep * (1 - 1e-9)] <- 2L
  first <- c(index[from], index[inner])
  second <- c(index[to], knots + seq_along(inner))
  used <- logical(length(point_i))
  used[first] <- used[second] <- TRUE
  place <- cumsum(used)
  points <- list(i = point_i[used], j = point_j[used], edge = point_edge[used])
  points$fraction <- points$j / panel$deep
  level <- points$edge <= 2L
  left <- panel_left(panel, points$j[level])
  across <- panel_right(panel, points$j[level]) - left
  across[across < 1e-300] <- 1e-300
  points$fraction[level] <- (points$i[level] - left) / across

  rest <- c(rep.int(1, length(from)), fraction) * lambda * panel$mesh_size / 2
  multiplicity <- lambda * c(1 - 0.5 * along_edge, rep.int(1, length(inner)))
  exact <- 2 * panel_bars(panel) * panel$mesh_size / 2
  multiplicity <- multiplicity * exact / sum(multiplicity * rest)
  # A knot on an edge belongs half to the neighbour.
  knot_weight <- 1 - 0.5 * (points$edge > 0L)
  points$knots <- panel_bars(panel) * knot_weight / sum(knot_weight)
  c(
    list(lambda = lambda, points = points),
    split_bars(points, place[first], place[second], rest, multiplicity, segments)
  )
}

# Bars cut into equal segments by points of their own (the middles of the mesh bars).
split_bars <- function(points, first, second, rest, multiplicity, segments) {
  if (segments == 1L) {
    return(list(ends = as.vector(rbind(first, second)), rest = rest, multiplicity = multiplicity))
  }
  bars <- length(first)
  inner <- matrix(length(points$i) + seq_len(bars * (segments - 1L)), segments - 1L, bars)
  chain <- rbind(first, inner, second)
  share <- seq_len(segments - 1L) / segments
  middle <- function(x) as.vector(outer(1 - share, x[first]) + outer(share, x[second]))
  list(
    between = list(i = middle(points$i), j = middle(points$j)),
    ends = as.vector(rbind(as.vector(chain[-(segments + 1L), ]), as.vector(chain[-1L, ]))),
    rest = rep(rest / segments, each = segments),
    multiplicity = rep(multiplicity, each = segments)
  )
}
