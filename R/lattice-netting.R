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

triangle_elements <- function(panel, grid, across, deep) {
  columns <- nrow(grid) - 1L
  rows <- ncol(grid) - 1L
  j <- rep(deep * panel$deep, each = columns + 1L)
  i <- panel_left(panel, j) + rep(across, rows + 1L) * (panel_right(panel, j) - panel_left(panel, j))
  square <- panel$orientation == "square"
  u <- if (square) i else i + j
  v <- if (square) j else j - i

  at <- function(c, r) r * (columns + 1L) + c + 1L
  cell_c <- rep(seq_len(columns) - 1L, rows)
  cell_r <- rep(seq_len(rows) - 1L, each = columns)
  a <- at(cell_c, cell_r)
  b <- at(cell_c + 1L, cell_r)
  c <- at(cell_c, cell_r + 1L)
  d <- at(cell_c + 1L, cell_r + 1L)
  # The diagonal changes sides at the panel's middle line, so that a panel's mirror image is
  # divided as its mirror image; a middle column carries both diagonals at half weight.
  side <- 2L * cell_c + 1L - columns
  falling <- side < 0L
  rising <- side > 0L
  both <- side == 0L
  corner <- rbind(
    cbind(a, b, d)[falling | both, , drop = FALSE], cbind(a, d, c)[falling | both, , drop = FALSE],
    cbind(a, b, c)[rising | both, , drop = FALSE], cbind(b, d, c)[rising | both, , drop = FALSE]
  )
  weight <- rep(1, nrow(corner))
  weight[c(rep(both[falling | both], 2L), rep(both[rising | both], 2L))] <- 0.5
  area <- (u[corner[, 2]] - u[corner[, 1]]) * (v[corner[, 3]] - v[corner[, 1]]) -
    (u[corner[, 3]] - u[corner[, 1]]) * (v[corner[, 2]] - v[corner[, 1]])
  keep <- abs(area) > 1e-9 * max(abs(area))
  corner <- corner[keep, , drop = FALSE]
  list(
    node = matrix(grid[t(corner)], 3L),
    twine = rbind(
      u[corner[, 1]], v[corner[, 1]], u[corner[, 2]], v[corner[, 2]], u[corner[, 3]], v[corner[, 3]]
    ),
    rest = rep(panel$mesh_size / 2, nrow(corner)),
    multiplicity = weight[keep],
    bars = abs(area[keep]) / 2 * weight[keep]
  )
}

# Equivalent bars of a panel. Knots lie lambda bars apart along the twines; those within a quarter
# of an equivalent mesh of an edge are moved onto it, twines that cross an edge end there, and what
# lies on an edge is tied to the edge's nodes. Lengths at slanted edges are so only nearly right;
# multiplicities are scaled to the panel's exact length of twine.
#
# Returns points (knots and cut ends: i, j, edge 0 or 1..4 and the fraction along it, knots) and the
# bars between them, with the middles of bars as further points `between`.
bar_elements <- function(panel, lambda, segments) {
  square <- panel$orientation == "square"
  rows <- max(1L, as.integer(round((if (square) 1 else 2) * panel$deep / lambda)))
  row_step <- panel$deep / rows
  # A knot at the left end of the upper edge, or midway where that fits the width better.
  meshes <- panel$upper / lambda
  half <- abs(meshes - round(meshes)) < 1e-6 && round(meshes) %% 2 == 1
  centre <- panel$upper / 2 + if (half) lambda / 2 else 0
  reach <- ceiling((max(panel$upper, panel$lower) + panel$deep) / lambda) + 2L

  q <- rep(0:rows, each = 2L * reach + 1L)
  p <- rep(-reach:reach, rows + 1L)
  i <- centre + lambda * (p + if (square) 0 else (q %% 2L) / 2)
  j <- q * row_step
  left <- panel_left(panel, j)
  right <- panel_right(panel, j)
  inside <- pmin(i - left, right - i)
  near <- lambda / 4
  kept <- inside >= -near - 1e-9
  edge <- ifelse(abs(i - left) <= near + 1e-9, 3L, ifelse(abs(i - right) <= near + 1e-9, 4L, 0L))
  i[edge == 3L] <- left[edge == 3L]
  i[edge == 4L] <- right[edge == 4L]
  index <- integer(length(p))
  index[kept] <- seq_len(sum(kept))
  width <- 2L * reach + 1L
  here <- seq_along(p)

  # Twines run to the next row; those of square meshes also along the row.
  step_u <- if (square) width else width + (q %% 2L)
  step_v <- if (square) 1L else width + (q %% 2L) - 1L
  pair <- function(step, last_row) {
    from <- here[(if (last_row) q <= rows else q < rows)]
    to <- from + (if (length(step) == 1L) step else step[from])
    ok <- to >= 1L & to <= length(p)
    ok[ok] <- abs(p[to[ok]] - p[from[ok]]) <= 1L
    list(from = from[ok], to = to[ok])
  }
  u <- pair(step_u, FALSE)
  v <- pair(step_v, square)
  from <- c(u$from, v$from)
  to <- c(u$to, v$to)
  some <- kept[from] | kept[to]
  from <- from[some]
  to <- to[some]
  # A twine on the edge of square netting belongs half to each neighbour.
  on_edge <- function(k) edge[k] > 0L | (square & (q[k] == 0L | q[k] == rows))

  whole <- kept[from] & kept[to]
  along_edge <- whole & on_edge(from) & on_edge(to) &
    ((edge[from] == edge[to] & edge[from] > 0L) |
      (square & q[from] == q[to] & (q[from] == 0L | q[from] == rows)))
  points <- list(i = i[kept], j = j[kept], edge = edge[kept])
  # Twines that leave: cut where they meet the side.
  starts_inside <- kept[from]
  inner <- ifelse(starts_inside, from, to)
  outer <- ifelse(starts_inside, to, from)
  cut <- !whole & edge[inner] == 0L
  inner <- inner[cut]
  outer <- outer[cut]
  side <- ifelse(i[outer] < left[outer], 3L, 4L)
  gap <- function(k) ifelse(side == 3L, i[k] - left[k], right[k] - i[k])
  fraction <- gap(inner) / (gap(inner) - gap(outer))
  bars <- list(
    from = c(index[from[whole]], index[inner]),
    to = c(index[to[whole]], length(points$i) + seq_along(inner)),
    length = c(rep(1, sum(whole)), fraction),
    weight = c(ifelse(along_edge[whole], 0.5, 1), rep(1, length(inner)))
  )
  points$i <- c(points$i, i[inner] + fraction * (i[outer] - i[inner]))
  points$j <- c(points$j, j[inner] + fraction * (j[outer] - j[inner]))
  points$edge <- c(points$edge, side)
  points$edge[points$edge == 0L & points$j <= 1e-9 * panel$deep] <- 1L
  points$edge[points$edge == 0L & points$j >= panel$deep * (1 - 1e-9)] <- 2L
  points$fraction <- ifelse(points$edge <= 2L,
    (points$i - panel_left(panel, points$j)) /
      pmax(panel_right(panel, points$j) - panel_left(panel, points$j), 1e-300),
    points$j / panel$deep
  )
  used <- sort(unique(c(bars$from, bars$to)))
  points <- lapply(points, function(x) x[used])
  bars$from <- match(bars$from, used)
  bars$to <- match(bars$to, used)
  bars$rest <- bars$length * lambda * panel$mesh_size / 2
  exact <- 2 * panel_bars(panel) * panel$mesh_size / 2
  bars$multiplicity <- lambda * bars$weight
  bars$multiplicity <- bars$multiplicity * exact / sum(bars$multiplicity * bars$rest)
  # A knot on an edge belongs half to the neighbour.
  knot_weight <- ifelse(points$edge > 0L, 0.5, 1)
  points$knots <- panel_bars(panel) * knot_weight / sum(knot_weight)
  list(points = points, bars = split_bars(points, bars, segments))
}

# Bars cut into equal segments by nodes of their own (the middles of the mesh bars).
split_bars <- function(points, bars, segments) {
  n <- length(points$i)
  m <- length(bars$from)
  if (segments == 1L) return(c(bars, list(between = NULL)))
  inner <- matrix(n + seq_len(m * (segments - 1L)), segments - 1L, m)
  chain <- rbind(bars$from, inner, bars$to)
  share <- seq_len(segments - 1L) / segments
  list(
    from = as.vector(chain[-(segments + 1L), ]),
    to = as.vector(chain[-1L, ]),
    rest = rep(bars$rest / segments, each = segments),
    multiplicity = rep(bars$multiplicity, each = segments),
    between = list(
      i = as.vector(outer(1 - share, points$i[bars$from]) + outer(share, points$i[bars$to])),
      j = as.vector(outer(1 - share, points$j[bars$from]) + outer(share, points$j[bars$to]))
    )
  )
}
