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

# Twines of one family that end on each edge of a panel at most, ungrouped: an edge that runs i
# meshes across and j deep is crossed by |i - j| twines of one family and i + j of the other.
edge_twines <- function(panel) {
  lost <- abs(panel$upper - panel$lower) * c(panel$taper_left, panel$taper_right)
  side <- if (panel$orientation == "square") pmax(lost, panel$deep) else lost + panel$deep
  c(panel$upper, panel$lower, side)
}

# What the counts depend on besides h: a list of columns with an element per panel (upper ...), per
# piece of an edge (panel ...) and per rope (own, length, segments). NA stands for what a plan leaves
# open.
resolution_table <- function(si, pieces, bars) {
  panels <- si$panels
  number <- function(of, field) {
    vapply(of, function(x) if (is_given(x[[field]])) as.double(x[[field]]) else NA_real_, 0)
  }
  sizes <- vapply(panels, open_size, c(0, 0))
  columns <- number(panels, "columns")
  rows <- number(panels, "rows")
  panel <- (pieces$edge - 1L) %/% 4L + 1L
  across <- (pieces$edge - 1L) %% 4L < 2L
  side <- cbind(panel, 2L - across)
  share <- pieces$to - pieces$from
  list(
    bars = bars, columns = columns, rows = rows,
    square = vapply(panels, function(p) p$orientation == "square", NA),
    upper = number(panels, "upper"), lower = number(panels, "lower"),
    deep = number(panels, "deep"), mesh_size = number(panels, "mesh_size"),
    bar_segments = number(panels, "bar_segments"),
    area = apply(sizes, 2L, prod),
    panel = panel, edge = pieces$edge, class = pieces$class,
    reach = share * t(sizes)[side], asked = share * cbind(columns, rows)[side],
    twines = share * unlist(lapply(panels, edge_twines))[pieces$edge],
    own = vapply(si$ropes, function(r) is.null(r$along), NA),
    length = number(si$ropes, "length"), segments = number(si$ropes, "segments")
  )
}

# Meshes per equivalent mesh (lambda) of every panel were it of bars, and segments per equivalent
# bar.
bar_grouping <- function(of, h) {
  across <- (of$upper + of$lower) / 2
  nodes_per_mesh <- ifelse(of$square, 3, 6)
  cells <- pmax(3, of$area / (nodes_per_mesh * h^2))
  lambda <- pmax(1, sqrt(across * of$deep / cells))
  by_rows <- !is.na(of$rows)
  lambda[by_rows] <- (of$deep / of$rows)[by_rows]
  by_columns <- !is.na(of$columns)
  lambda[by_columns] <- (pmax(of$upper, of$lower) / of$columns)[by_columns]
  # Whole half-rows (whole rows of squares), so that the upper and the lower edge lie on knots.
  steps <- ifelse(of$square, 1, 2)
  lambda <- steps * of$deep / pmax(1, round(steps * of$deep / lambda))
  segments <- of$bar_segments
  single <- !by_columns & !by_rows & lambda <= 1 + 1e-9
  if (is.finite(h)) {
    bar <- lambda * of$mesh_size / 2
    segments[single] <- pmax(segments, ceiling(bar / (1.5 * h)))[single]
  }
  list(lambda = lambda, segments = as.integer(segments))
}

# Counts of every piece (integer vector) at element length h.
piece_counts <- function(of, h, grouping) {
  wanted <- of$reach / h
  asked <- !is.na(of$asked)
  wanted[asked] <- of$asked[asked]
  count <- at_least_one(round(wanted))
  if (any(of$bars)) {
    is_bar <- of$bars[of$panel]
    twines <- at_least_one(floor(of$twines / grouping$lambda[of$panel] + 1e-9))
    # Between panels of bars the coarser side rules, so that every node of the seam is held.
    with_triangles <- logical(length(count))
    with_triangles[of$class[!is_bar]] <- TRUE
    only_bars <- !with_triangles[of$class]
    falling <- order(twines, decreasing = TRUE)
    low <- integer(length(count))
    low[of$class[falling]] <- twines[falling]
    count[only_bars] <- low[of$class][only_bars]
    count[is_bar & !only_bars] <- 1L
  }
  # The last of a class to be put in its place is the largest.
  rising <- order(count)
  high <- integer(length(count))
  high[of$class[rising]] <- count[rising]
  high[of$class]
}

at_least_one <- function(x) {
  x <- as.integer(x)
  x[x < 1L] <- 1L
  x
}

# Elements of every rope with its own nodes.
rope_counts <- function(of, h) {
  count <- if (is.finite(h)) pmax(4, round(of$length / (1.5 * h))) else rep(1, length(of$length))
  given <- !is.na(of$segments)
  count[given] <- of$segments[given]
  count[!of$own] <- 0
  as.integer(count)
}

# About how many nodes a division at h has.
count_nodes <- function(of, h) {
  grouping <- bar_grouping(of, h)
  count <- piece_counts(of, h, grouping)
  # pieces are in the order of edges
  reached <- c(0, cumsum(count))[c(1L, cumsum(tabulate(of$edge, 4L * length(of$bars))) + 1L)]
  per_edge <- matrix(diff(reached), 4L)
  in_panels <- per_edge[1L, ] * per_edge[3L, ]
  cells <- (of$upper + of$lower) / 2 * of$deep / grouping$lambda^2
  in_bars <- cells * ifelse(of$square, 1 + 2 * (grouping$segments - 1), 2 + 4 * (grouping$segments - 1))
  in_panels[of$bars] <- in_bars[of$bars]
  sum(in_panels) + sum(rope_counts(of, h))
}

# Element length h at which the gear has about `nodes` nodes.
element_length <- function(si, of, nodes) {
  size <- max(of$length, unlist(lapply(si$panels, open_size)), 0.1)
  low <- log(size * 1e-6)
  high <- log(size * 10)
  for (step in seq_len(40L)) {
    middle <- (low + high) / 2
    if (count_nodes(of, exp(middle)) > nodes) low <- middle else high <- middle
    if (high - low < 1e-3) break
  }
  exp(high)
}

# Whether a plan gives an optional value.
is_given <- function(x) length(x) > 0L && !anyNA(x)
