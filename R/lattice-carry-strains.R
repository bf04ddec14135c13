# Strains carried from one lattice to another of the same parts: with a carried shape alone the
# strains of stiff lines would be those of its interpolation.

# Strains of all lines of a lattice, in the engine's order (see engine_order()), from those of
# another, whose ropes and families of twine each have theirs along and across them.
carry_strains <- function(panels, to, from, strain) {
  if (identical(to$engine$bars$node, from$engine$bars$node) &&
    identical(to$engine$cells$node, from$engine$cells$node)) {
    return(strain)
  }
  lines <- line_places(panels, to)
  old <- line_places(panels, from)
  # Lines in rows: those whose middles lie equally deep. Rows that reach less than half as far
  # across as others, of twines cut at the sides, say nothing of the middle.
  deep <- round(old$t * 1e6)
  order <- order(old$family, deep, old$s)
  start <- c(TRUE, diff(old$family[order]) != 0 | diff(deep[order]) != 0)
  row <- cumsum(start)
  end <- c(which(start)[-1L] - 1L, length(order))
  reach <- old$s[order][end] - old$s[order][start]
  widest <- stats::ave(reach, old$family[order][start], FUN = max)
  long <- reach >= widest / 2
  order <- order[long[row]]
  row <- match(row[long[row]], which(long))
  first <- !duplicated(row)
  family <- old$family[order]
  rows <- list(
    panel = family[first], t = (deep[order] / 1e6)[first], row = row, s = old$s[order],
    x = matrix(strain[order], 1L)
  )
  known <- lines$family %in% family
  carried <- numeric(length(known))
  carried[known] <- on_rows(
    list(panel = lines$family[known], s = lines$s[known], t = lines$t[known]), rows
  )
  carried
}

# Where the middles of all lines lie: list(family = number of the rope or family of twine, the same
# in every lattice of these parts, s, t = fractions across and deep, of ropes along them and 0).
line_places <- function(panels, lattice) {
  ropes <- length(lattice$ropes)
  bars <- lattice$engine$bars
  part <- lattice$bar_part
  t <- numeric(length(part))
  second <- logical(length(part))
  begun <- stats::ave(bars$rest, part, FUN = cumsum)
  s <- (begun - bars$rest / 2) / stats::ave(bars$rest, part, FUN = sum)
  of_panels <- which(part > ropes & part <= ropes + length(lattice$panels))
  if (length(of_panels)) {
    of_bars <- which(vapply(lattice$panels, function(p) p$netting == "bars", NA))
    known <- bar_places(panels, of_bars, lattice$panels)
    known$node <- point_number(known$node, lattice$nodes)
    panel <- part[of_panels] - ropes
    ends <- lapply(1:2, function(end) {
      at <- match_places(panel, bars$node[2L * (of_panels - 1L) + end], known)
      lapply(known[c("s", "t", "i", "j")], `[`, at)
    })
    s[of_panels] <- (ends[[1]]$s + ends[[2]]$s) / 2
    t[of_panels] <- (ends[[1]]$t + ends[[2]]$t) / 2
    across <- ends[[2]]$i - ends[[1]]$i
    deep <- ends[[2]]$j - ends[[1]]$j
    second[of_panels] <- across * deep < 0 | across == 0
  }
  corners <- lattice$engine$cells$node
  panel <- lattice$cell_part - ropes
  known <- grid_places(lattice$division)
  corner <- match_places(rep(panel, each = 4L), corners, known)
  middle <- function(x) colMeans(matrix(x[corner], 4L))
  of_cells <- list(s = middle(known$s), t = middle(known$t))
  family <- 2 * lattice$cell_part
  beyond <- 2 * (ropes + length(lattice$panels))
  list(
    family = engine_order(lattice, 2 * part + second, family, family + 1, family + beyond),
    s = engine_order(lattice, s, of_cells$s, of_cells$s, of_cells$s),
    t = engine_order(lattice, t, of_cells$t, of_cells$t, of_cells$t)
  )
}

# What is known of all lines in the engine's order: of bars, then of the u and the v twines of plain
# cells, then of the straight bars and the u and v twines of hexagonal ones; u, v, straight: of
# all cells.
engine_order <- function(lattice, bars, u, v, straight) {
  hexagonal <- lattice$engine$cells$straight > 0
  c(bars, u[!hexagonal], v[!hexagonal], straight[hexagonal], u[hexagonal], v[hexagonal])
}

# The part that every line of a lattice is of, in the engine's order.
line_part <- function(lattice) {
  of_cells <- lattice$cell_part
  as.integer(engine_order(lattice, lattice$bar_part, of_cells, of_cells, of_cells))
}

# Numbers of the places of nodes in their panels.
match_places <- function(panel, node, places) {
  span <- max(places$node, 0) + 1
  match(panel * span + node, places$panel * span + places$node)
}
