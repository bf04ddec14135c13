# The volume that panels enclose.

define_measure("volume", "m3",
  "Volume within panels that follow each other around an opening, such as a cage's walls and bottom,
  closed by a lid from the rim of the opening to its middle.",
  sensor = "Depth sensors around the bottom ring of a cage, or cameras, show it in part.",
  asks_panels, function(state, measure) volume_within(state, measure$panels)
)

define_measure("volume_share", "%",
  "The volume within panels as a share of a volume `of`.",
  sensor = "As that of the volume.",
  asks_share, function(state, measure) volume_within(state, measure$panels) / measure$of
)

# Volume (m3) within panels. They must all be seen from the same side, from within or from without,
# with their upper edge up.
volume_within <- function(state, panels) {
  facets <- panel_facets(state, panels)
  lids <- panel_lids(state, panels)
  corners <- lapply(1:3, function(k) {
    cbind(facets$x[, facets$node[k, ], drop = FALSE], lids[[k]])
  })
  middle <- rowMeans(facets$x)
  abs(sum(do.call(triple_product, lapply(corners, `-`, middle))) / 6)
}

# The surface of panels as facets between their rows of places: list(x = 3 x places, node = 3 x
# facets, numbers of places, all facets seen from the same side).
panel_facets <- function(state, names) {
  rows <- panel_rows(panel_table(state$si$panels), state$lattice, state_points(state))
  kept <- which(rows$panel[rows$row] %in% match(names, names(state$si$panels)))
  row <- rows$row[kept]
  s <- rows$s[kept]
  of <- rows$panel[row]
  list(x = rows$x[, kept, drop = FALSE], node = row_facets(of, row, s))
}

# Lids over the openings that panels leave, as facets seen from the same side as theirs: three
# matrices of their corners (3 x facets).
panel_lids <- function(state, names) {
  lids <- panel_lid_nodes(state, names)
  x <- state$position
  middles <- vapply(split(seq_along(lids$from), lids$opening), function(k) {
    rowMeans(x[, lids$from[k], drop = FALSE])
  }, numeric(3))
  list(
    middles[, as.character(lids$opening), drop = FALSE], x[, lids$from, drop = FALSE],
    x[, lids$to, drop = FALSE]
  )
}

# The nodes that lids have two by two on their rims: list(from, to, opening = which lid each is of).
# Openings are bounded by edges that no seam joins to another of these panels or gathers.
panel_lid_nodes <- function(state, names) {
  joined <- unlist(lapply(state$si$seams, function(seam) {
    edges <- unlist(seam$edges, recursive = FALSE)
    edges <- Filter(function(edge) edge$panel %in% names, edges)
    if (length(edges) < 2L && is.null(seam$gathered_at)) return(NULL)
    vapply(edges, function(edge) edge_number(state$si$panels, edge$panel, edge$edge), 0L)
  }))
  all <- 4L * (rep(match(names, names(state$si$panels)), each = 4L) - 1L) + 1:4
  open <- setdiff(all, joined)
  division <- state$lattice$division
  before <- division$before[open]
  count <- division$count[open]
  first <- division$edge_node[sequence(count - 1L, before + 1L)]
  second <- division$edge_node[sequence(count - 1L, before + 2L)]
  # A lid's facets meet each edge of a panel against that panel's facets.
  turned <- rep((open - 1L) %% 4L %in% c(1L, 2L), count - 1L)
  from <- ifelse(turned, second, first)
  to <- ifelse(turned, first, second)
  list(from = from, to = to, opening = joined_labels(state$lattice$nodes, from, to)[from])
}

# Facets (3 x n) between the places of each row (in order of s) and the next one of the same panel.
# In the order of s each place of two rows makes one with the last ones met of its own and of the
# other row.
row_facets <- function(panel, row, s) {
  number <- cumsum(c(TRUE, diff(panel) != 0 | diff(row) != 0))
  of <- panel[!duplicated(number)]
  # strips between two rows, by the number of the upper one
  has_lower <- c(of[-1L] == of[-length(of)], FALSE)
  has_upper <- c(FALSE, has_lower[-length(of)])
  upper <- which(has_lower[number])
  lower <- which(has_upper[number])
  all <- c(upper, lower)
  strip <- c(number[upper], number[lower] - 1L)
  order <- order(strip, s[all])
  is_upper <- (seq_along(all) <= length(upper))[order]
  strip <- strip[order]
  all <- all[order]
  place <- seq_along(all)
  # the last place of a row before each, in its strip; 0: none
  first <- place[match(strip, strip)]
  last <- function(mine) {
    found <- c(0L, cummax(place * mine))[place]
    found * (found >= first)
  }
  before_upper <- last(is_upper)
  before_lower <- last(!is_upper)
  some <- which(before_upper > 0L & before_lower > 0L)
  rbind(all[before_upper[some]], all[before_lower[some]], all[some])
}
