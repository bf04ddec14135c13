# A state's lines: every bar, and in every netting cell its two families of twine and
# the straight bars of hexagonal meshes, as one table.

# Positions of all points that elements stand on: 3 x (nodes + tied points), m.
state_points <- function(state) lattice_points(state$lattice, state$position)

# Returns a data frame with a row per line: part (row of lattice$parts), element (number of the bar
# or cell), family (bar, u, v or straight), tension (N, of one line), length and rest (m, of one
# line) and lines (how many run in parallel). A cell's bars of one family count as parallel
# lines of one bar's length, so that lines x rest is always a length of twine or rope.
state_lines <- function(state) {
  lattice <- state$lattice
  # A board's struts are no lines of the gear.
  bar <- which(lattice$parts$kind[lattice$bar_part] != "piece")
  bars <- lapply(lattice$mesh$bars[c("rest", "multiplicity")], `[`, bar)
  cells <- lattice$mesh$cells
  in_cell <- cell_bars(cells)
  cell <- seq_along(cells$rest)
  hexagon <- which(cells$straight > 0)
  number <- length(cell)
  list2DF(list(
    part = c(lattice$bar_part[bar], lattice$cell_part, lattice$cell_part,
      lattice$cell_part[hexagon]),
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

# Middles of elements of as many corners: 3 x elements, m.
element_middles <- function(points, node, corners) {
  first <- seq.int(0L, by = corners, length.out = length(node) %/% corners)
  total <- points[, node[first + 1L], drop = FALSE]
  for (k in seq_len(corners - 1L) + 1L) total <- total + points[, node[first + k], drop = FALSE]
  total / corners
}

bars_of_part <- function(state, part) which(state$lattice$bar_part == part)

# Nodes at the ends of some bars: 2 x bars.
bar_ends <- function(state, bars) {
  node <- state$lattice$mesh$bars$node
  rbind(node[2L * bars - 1L], node[2L * bars])
}
