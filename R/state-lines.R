# Table of all lines of a state: bars, and in each netting cell two families of twine and the
# straight bars of hexagonal meshes.

# Returns positions of all points of elements: 3 x (nodes + tied points) [m].
state_points <- function(state) mesh_points(state$mesh, state$position)

# Returns a data frame: one row per line. `part`: row of `mesh$parts`; `element`: number of the
# bar or cell; `family`: bar, u, v or straight. `tension`, `length`, `rest`: tension [N], length and
# rest length [m] of one line. `lines`: number of parallel lines; `lines * rest` is the total length
# of twine or rope.
state_lines <- function(state) {
  mesh <- state$mesh
  # the struts of a board are not lines of the gear
  bar <- which(mesh$parts$kind[mesh$bar_part] != "piece")
  bars <- lapply(mesh$model$bars[c("rest", "multiplicity")], `[`, bar)
  cells <- mesh$model$cells
  in_cell <- mesh$model$frame$cells$bars
  cell <- seq_along(cells$rest)
  hexagon <- which(cells$straight > 0)
  number <- length(cell)
  list2DF(list(
    part = c(mesh$bar_part[bar], mesh$cell_part, mesh$cell_part,
      mesh$cell_part[hexagon]),
    element = c(bar, cell, cell, hexagon),
    family = rep(c("bar", "u", "v", "straight"),
      c(length(bar), number, number, length(hexagon))),
    tension = c(state$bar_tension[bar], state$u_tension, state$v_tension,
      state$straight_tension[hexagon]),
    length = c(state$bar_length[bar], state$u_length, state$v_length,
      state$straight_length[hexagon]),
    rest = c(bars$rest, cells$rest, cells$rest, cells$straight[hexagon]),
    lines = c(bars$multiplicity, in_cell, in_cell, in_cell[hexagon])
  ))
}

# Returns centres of elements with the same number of corners: 3 x elements [m].
element_middles <- function(points, node, corners) {
  first <- seq.int(0L, by = corners, length.out = length(node) %/% corners)
  total <- points[, node[first + 1L], drop = FALSE]
  for (k in seq_len(corners - 1L) + 1L) total <- total + points[, node[first + k], drop = FALSE]
  total / corners
}

bars_of_part <- function(state, part) which(state$mesh$bar_part == part)

# Returns the end nodes of bars: 2 x bars.
bar_ends <- function(state, bars) {
  node <- state$mesh$model$bars$node
  rbind(node[2L * bars - 1L], node[2L * bars])
}
