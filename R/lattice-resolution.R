# How finely a gear is divided: counts of elements on every piece of edge and every rope, and the
# grouping of meshes in panels of bars, all from one element length h.

# Netting hangs open to about this share of its stretched width, to begin with.
nominal_hanging_ratio <- 0.3
nominal_depth_ratio <- sqrt(1 - nominal_hanging_ratio^2)

# Pieces that a mesh bar is divided into at most unless its plan says how many: smaller ones are
# better spent on real meshes than on the bow of one bar (against any number of pieces the trawl's
# mouth is 0.2 % lower at 100,000 nodes), and so many slack ends of string would keep a solve from
# settling.
greatest_bar_segments <- 4

# Width and depth of panels, m, from which the counts of elements follow: list(width, depth). Cells
# of as many meshes across as deep follow the twines best, whatever shape they hang in, so both are
# stretched lengths by one factor, with which the area is that of netting at its nominal ratio.
even_size <- function(panels) {
  even <- mesh_unit(panels) *
    ifelse(is_square(panels), 1, sqrt(nominal_hanging_ratio * nominal_depth_ratio))
  list(width = even * pmax(panels$upper, panels$lower), depth = even * panels$deep)
}

# Twines of one family that end on each edge of panels at most, ungrouped, in the order of edges: an
# edge that runs i meshes across and j deep is crossed by |i - j| twines of one family and i + j of
# the other.
edge_twines <- function(panels) {
  lost <- abs(panels$upper - panels$lower)
  side <- function(taper) {
    ifelse(is_square(panels), pmax(lost * taper, panels$deep), lost * taper + panels$deep)
  }
  as.vector(rbind(panels$upper, panels$lower, side(panels$taper_left), side(panels$taper_right)))
}

# Segments of a rope beyond which only the cube root of more is worth its nodes beside netting. A
# rope is smooth between its ends, so that n segments leave an error of second order: less than
# 1 / n^2 of its length, where netting leaves percents. (Half as many segments in all ropes of a
# pair and of a bottom trawl of 1,500 nodes moved no spread or height by 0.01 %.)
ample_segments <- 48

# Element lengths this near the one that gives the nodes asked for, as a logarithm, are looked
# through, this many; nodes go with their square. Of fewer nodes no count is fitting.
fitting_range <- 0.08
fitting_tries <- 33L
least_fitting <- 500

# What the counts depend on besides h: the table of panels with more columns (bars ...), columns
# with an element per piece of an edge (panel ...) and columns with one per rope (own, length,
# segments).
resolution_table <- function(si, panels, pieces, bars) {
  size <- even_size(panels)
  panel <- (pieces$edge - 1L) %/% 4L + 1L
  across <- (pieces$edge - 1L) %% 4L < 2L
  share <- pieces$to - pieces$from
  of_side <- function(width, depth) {
    out <- depth[panel]
    out[across] <- width[panel][across]
    out
  }
  # NA stands for what a plan leaves open.
  segments <- vapply(si$ropes, function(r) {
    if (length(r$through)) return(length(r$through) + 1)
    if (is.null(r$segments)) NA_real_ else r$segments
  }, 0)
  c(panels, list(
    bars = bars, square = is_square(panels), size = size, area = size$width * size$depth,
    panel = panel, edge = pieces$edge, class = pieces$class,
    reach = share * of_side(size$width, size$depth),
    weight = share * (size$width * size$depth)[panel],
    asked = share * of_side(panels$columns, panels$rows),
    twines = share * edge_twines(panels)[pieces$edge],
    own = vapply(si$ropes, function(r) is.null(r$along), NA),
    length = vapply(si$ropes, `[[`, 0, "length"), segments = segments
  ))
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
  # A slack bar of many meshes would hang in a bight of its own length, which no mesh does.
  segments <- of$bar_segments
  open <- is.na(segments)
  segments[open] <- 1
  # The drag of whole sheets acts on knots: nothing would hold the points between them in place.
  single <- open & !by_columns & !by_rows & lambda <= 1 + 1e-9 & of$netting_drag == "twines"
  if (is.finite(h)) {
    wanted <- pmin(greatest_bar_segments, ceiling(lambda * of$mesh_size / 2 / (1.5 * h)))
    segments[single] <- wanted[single]
  }
  list(lambda = lambda, segments = as.integer(segments))
}

# Counts of every piece (integer vector) at element length h.
piece_counts <- function(of, h, grouping) {
  count <- at_least_one(round(wanted_counts(of, h)))
  if (any(of$bars)) {
    is_bar <- of$bars[of$panel]
    twines <- at_least_one(floor(of$twines / grouping$lambda[of$panel] + 1e-9))
    # Between panels of bars the coarser side rules, so that every node of the seam is held.
    with_cells <- logical(length(count))
    with_cells[of$class[!is_bar]] <- TRUE
    only_bars <- !with_cells[of$class]
    falling <- order(twines, decreasing = TRUE)
    low <- integer(length(count))
    low[of$class[falling]] <- twines[falling]
    count[only_bars] <- low[of$class][only_bars]
    count[is_bar & !only_bars] <- 1L
  }
  class_largest(of, count)
}

# Elements that every piece would have were they no whole numbers.
wanted_counts <- function(of, h) {
  wanted <- of$reach / h
  asked <- !is.na(of$asked)
  wanted[asked] <- of$asked[asked]
  wanted
}

# Of numbers of every piece the largest of its class.
class_largest <- function(of, x) {
  # The last of a class to be put in its place is the largest.
  rising <- order(x)
  high <- x
  high[of$class[rising]] <- x[rising]
  high[of$class]
}

# What is larger than any lattice stays a whole number.
at_least_one <- function(x) as.integer(pmin(pmax(x, 1), most_nodes))

# Elements of every rope with its own nodes.
rope_counts <- function(of, h) {
  wanted <- of$length / (1.5 * h)
  if (length(of$bars)) {
    long <- which(wanted > ample_segments)
    wanted[long] <- ample_segments * (wanted[long] / ample_segments)^(1 / 3)
  }
  count <- if (is.finite(h)) pmax(4, round(wanted)) else rep(1, length(of$length))
  given <- !is.na(of$segments)
  count[given] <- of$segments[given]
  count[!of$own] <- 0
  as.integer(count)
}

# About how many nodes a division at h has: one number per panel and one per rope.
node_counts <- function(of, h) {
  grouping <- bar_grouping(of, h)
  count <- as.double(piece_counts(of, h, grouping))
  # pieces are in the order of edges
  reached <- c(0, cumsum(count))[c(1L, cumsum(tabulate(of$edge, 4L * length(of$bars))) + 1L)]
  per_edge <- matrix(diff(reached), 4L)
  # hexagonal netting has an inner node in either half of a cell
  in_panels <- per_edge[1L, ] * per_edge[3L, ] * ifelse(of$straight_bar > 0, 3, 1)
  cells <- (of$upper + of$lower) / 2 * of$deep / grouping$lambda^2
  inner <- grouping$segments - 1
  in_bars <- cells * ifelse(of$square, 1 + 2 * inner, 2 + 4 * inner)
  in_panels[of$bars] <- in_bars[of$bars]
  c(in_panels, rope_counts(of, h))
}

count_nodes <- function(of, h) sum(node_counts(of, h))

# Whether the plan itself says how every panel and rope is divided.
is_divided <- function(of) {
  of_cells <- !of$bars[of$panel]
  grouped <- !is.na(of$rows) | !is.na(of$columns)
  !anyNA(of$segments[of$own]) && all(grouped[of$bars]) && !anyNA(of$asked[of_cells])
}

# Element length h at which the gear has about `nodes` nodes, a sixth more or less, and its counts
# are nearly whole.
element_length <- function(of, nodes) {
  h <- counted_length(of, nodes)
  fits <- length(of$bars) && !any(of$bars) && !is_divided(of) && nodes >= least_fitting
  if (!fits) return(h)
  tried <- h * exp(c(0, seq(-fitting_range, fitting_range, length.out = fitting_tries)))
  off <- vapply(tried, function(h) log(count_nodes(of, h) / nodes), 0)
  near <- abs(off) <= max(2 * fitting_range, abs(off[1L]))
  tried[near][which.min(vapply(tried[near], function(h) rounding(of, h), 0))]
}

# How far whole numbers of cells are from what h asks for: the root mean square of the logarithm of
# their ratio over all edges, by the netting along them. Panels of few rows turn from cells wider
# than deep to deeper than wide where a count goes up, which moves a trawl's mouth by a percent; so
# lattices are chosen where counts are nearly whole.
rounding <- function(of, h) {
  wanted <- pmax(class_largest(of, wanted_counts(of, h)), 1)
  off <- log(piece_counts(of, h, NULL) / wanted)
  sqrt(sum(of$weight * off^2) / sum(of$weight))
}

# The greatest element length with at most so many nodes.
counted_length <- function(of, nodes) {
  size <- max(of$length, unlist(of$size), 0.1)
  if (is_divided(of)) return(size)
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
