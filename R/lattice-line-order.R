# The order in which the engine has the lines of a lattice.

# What is known of all lines in the engine's order: of bars, then of the u and the v twines of plain
# cells, then of the straight bars and the u and v twines of hexagonal ones; u, v, straight: of
# all cells.
engine_order <- function(lattice, bars, u, v, straight) {
  hexagonal <- lattice$mesh$cells$straight > 0
  c(bars, u[!hexagonal], v[!hexagonal], straight[hexagonal], u[hexagonal], v[hexagonal])
}

# The part that every line of a lattice is of, in the engine's order.
line_part <- function(lattice) {
  of_cells <- lattice$cell_part
  as.integer(engine_order(lattice, lattice$bar_part, of_cells, of_cells, of_cells))
}
