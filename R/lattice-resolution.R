# How finely a gear is divided: counts of elements on every piece of edge and every rope, and the
# grouping of meshes in panels of bars, all from one element length h.

# Netting hangs open to about this share of its stretched width; only sets element proportions.
nominal_hanging_ratio <- 0.3
nominal_depth_ratio <- sqrt(1 - nominal_hanging_ratio^2)

mesh_unit <- function(panel) if (panel$orientation == "square") panel$mesh_size / 2 else panel$mesh_size

# Open width and depth of a panel, m.
open_size <- function(panel) {
  if (panel$orientation == "square") {
    return(mesh_unit(panel) * c(max(panel$upper, panel$lower), panel$deep))
  }
  mesh_unit(panel) * c(
    nominal_hanging_ratio * max(panel$upper, panel$lower),
    nominal_depth_ratio * panel$deep
  )
}

# Meshes per equivalent mesh of a panel of bars (lambda), and segments per equivalent bar.
bar_grouping <- function(panel, h) {
  square <- panel$orientation == "square"
  across <- (panel$upper + panel$lower) / 2
  if (is_given(panel$columns)) {
    lambda <- max(panel$upper, panel$lower) / panel$columns
  } else if (is_given(panel$rows)) {
    lambda <- panel$deep / panel$rows
  } else {
    nodes_per_mesh <- if (square) 3 else 6
    cells <- max(3, prod(open_size(panel)) / (nodes_per_mesh * h^2))
    lambda <- max(1, sqrt(across * panel$deep / cells))
  }
  # Whole half-rows (whole rows of squares), so that the upper and the lower edge lie on knots.
  steps <- if (square) 1 else 2
  lambda <- steps * panel$deep / max(1, round(steps * panel$deep / lambda))
  bar <- lambda * panel$mesh_size / 2
  segments <- panel$bar_segments
  if (!is_given(panel$columns) && !is_given(panel$rows) && lambda <= 1 + 1e-9 && is.finite(h)) {
    segments <- max(segments, ceiling(bar / (1.5 * h)))
  }
  list(lambda = lambda, segments = as.integer(segments))
}

# bar_grouping() of every panel of bars, NULL for the others.
bar_groupings <- function(panels, bars, h) {
  groupings <- vector("list", length(panels))
  groupings[bars] <- lapply(panels[bars], bar_grouping, h = h)
  groupings
}

# Twines of one family that end on each edge of a panel at most, ungrouped: an edge that runs i
# meshes across and j deep is crossed by |i - j| twines of one family and i + j of the other.
edge_twines <- function(panel) {
  lost <- abs(panel$upper - panel$lower) * c(panel$taper_left, panel$taper_right)
  side <- if (panel$orientation == "square") pmax(lost, panel$deep) else lost + panel$deep
  c(panel$upper, panel$lower, side)
}

# Counts of every piece (integer vector) at element length h; grouping: `bar_grouping()` of every
# panel of bars there.
piece_counts <- function(panels, pieces, bars, h, grouping) {
  sizes <- vapply(panels, open_size, c(0, 0))
  panel <- (pieces$edge - 1L) %/% 4L + 1L
  across <- (pieces$edge - 1L) %% 4L < 2L
  share <- pieces$to - pieces$from
  wanted <- share * ifelse(across, sizes[1, panel], sizes[2, panel]) / h
  for (p in seq_along(panels)) {
    fixed <- function(side, count) {
      mine <- panel == p & across == side
      wanted[mine] <<- share[mine] * count
    }
    if (is_given(panels[[p]]$columns)) fixed(TRUE, panels[[p]]$columns)
    if (is_given(panels[[p]]$rows)) fixed(FALSE, panels[[p]]$rows)
  }
  count <- pmax(1L, as.integer(round(wanted)))
  if (any(bars)) {
    lambda <- rep(Inf, length(panels))
    lambda[bars] <- vapply(grouping[bars], function(g) g$lambda, 0)
    meshes <- unlist(lapply(panels, edge_twines))
    twines <- pmax(1L, as.integer(floor(share * meshes[pieces$edge] / lambda[panel] + 1e-9)))
    is_bar <- bars[panel]
    # Between panels of bars the coarser side rules, so that every node of the seam is held.
    only_bars <- !pieces$class %in% pieces$class[!is_bar]
    low <- tapply(twines, pieces$class, min)
    count[only_bars] <- low[as.character(pieces$class[only_bars])]
    count[is_bar & !only_bars] <- 1L
  }
  high <- tapply(count, pieces$class, max)
  unname(as.integer(high[as.character(pieces$class)]))
}

# Elements of every rope with its own nodes.
rope_counts <- function(ropes, h) {
  vapply(ropes, function(r) {
    if (!is.null(r$along)) return(0L)
    if (is_given(r$segments)) return(as.integer(r$segments))
    if (!is.finite(h)) return(1L)
    as.integer(max(4, round(r$length / (1.5 * h))))
  }, 0L)
}

# About how many nodes a division at h has.
count_nodes <- function(panels, ropes, pieces, bars, h) {
  groupings <- bar_groupings(panels, bars, h)
  count <- piece_counts(panels, pieces, bars, h, groupings)
  per_edge <- tapply(count, factor(pieces$edge, levels = seq_len(4L * length(panels))), sum)
  in_panels <- vapply(seq_along(panels), function(p) {
    e <- 4L * (p - 1L)
    if (!bars[p]) return(as.numeric(per_edge[e + 1L]) * per_edge[e + 3L])
    panel <- panels[[p]]
    grouping <- groupings[[p]]
    cells <- (panel$upper + panel$lower) / 2 * panel$deep / grouping$lambda^2
    square <- panel$orientation == "square"
    cells * (if (square) 1 + 2 * (grouping$segments - 1) else 2 + 4 * (grouping$segments - 1))
  }, 0)
  sum(in_panels) + sum(rope_counts(ropes, h))
}

# Element length h at which the gear has about `nodes` nodes.
element_length <- function(panels, ropes, pieces, bars, nodes) {
  size <- max(vapply(ropes, function(r) r$length, 0), unlist(lapply(panels, open_size)), 0.1)
  low <- log(size * 1e-6)
  high <- log(size * 10)
  for (step in seq_len(40L)) {
    middle <- (low + high) / 2
    if (count_nodes(panels, ropes, pieces, bars, exp(middle)) > nodes) low <- middle else high <- middle
    if (high - low < 1e-3) break
  }
  exp(high)
}

# Whether a plan gives an optional value.
is_given <- function(x) length(x) > 0L && !anyNA(x)
