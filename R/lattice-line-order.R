# The order in which the engine has the lines of a lattice.

# What is known of all lines in the engine's order: of bars, then of the u and the v twines of plain
# cells, then of the straight bars and the u and v twines of hexagonal ones; u, v, straight: of
# all cells; hexagonal: which cells are of hexagonal meshes.
engine_order <- function(hexagonal, bars, u, v, straight) {
  c(bars, u[!hexagonal], v[!hexagonal], straight[hexagonal], u[hexagonal], v[hexagonal])
}

# The part that every line of a lattice is of, in the engine's order.
line_part <- function(lattice) {
  cells <- lattice$cell_part
  as.integer(
    engine_order(has_straight_bars(lattice), lattice$bar_part, cells, cells, cells)
  )
}
