# Returns values of all lines in the engine's order: bars, then u and v twines of plain cells, then
# straight bars and u and v twines of hexagonal cells. `u`, `v`, `straight`: values of all cells;
# `hexagonal`: TRUE for cells with hexagonal meshes.
engine_order <- function(hexagonal, bars, u, v, straight) {
  c(bars, u[!hexagonal], v[!hexagonal], straight[hexagonal], u[hexagonal], v[hexagonal])
}

# Returns the part of each line of a mesh, in the engine's order.
line_part <- function(mesh) {
  cells <- mesh$cell_part
  as.integer(
    engine_order(has_straight_bars(mesh), mesh$bar_part, cells, cells, cells)
  )
}
