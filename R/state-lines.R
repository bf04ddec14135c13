# A state's lines: every bar, and in every netting triangle its two families of twine, as one table.

# Positions of all points that elements stand on: 3 x (nodes + tied points), m.
state_points <- function(state) lattice_points(state$lattice, state$position)

lattice_points <- function(lattice, position) {
  ties <- lattice$engine$ties
  x <- matrix(position, 3L)
  if (!length(ties$first)) return(x)
  share <- rep(ties$share, each = 3L)
  cbind(x, (1 - share) * x[, ties$first] + share * x[, ties$second])
}

# Returns a data frame with a row per line: part (row of lattice$parts), element (number of the bar
# or triangle), family (bar, u or v), tension (N, of one line), length and rest (m, of one line) and
# lines (how many run in parallel). A triangle's bars of one family count as parallel lines of one
# bar's length, so that lines x rest is always a length of twine or rope.
state_lines <- function(state) {
  lattice <- state$lattice
  # A board's struts are no lines of the gear.
  bar <- which(lattice$parts$kind[lattice$bar_part] != "piece")
  bars <- lapply(lattice$engine$bars[c("rest", "multiplicity")], `[`, bar)
  triangles <- lattice$engine$triangles
  in_triangle <- triangle_bars(triangles)
  triangle <- seq_along(triangles$rest)
  data.frame(
    part = c(lattice$bar_part[bar], lattice$triangle_part, lattice$triangle_part),
    element = c(bar, triangle, triangle),
    family = rep(c("bar", "u", "v"), c(length(bar), length(triangle), length(triangle))),
    tension = c(state$bar_tension[bar], state$u_tension, state$v_tension),
    length = c(state$bar_length[bar], state$u_length, state$v_length),
    rest = c(bars$rest, triangles$rest, triangles$rest),
    lines = c(bars$multiplicity, in_triangle, in_triangle)
  )
}

# Mesh bars of one family in triangles: half of |d|, the double area in twine coordinates.
triangle_bars <- function(triangles, which = seq_along(triangles$rest)) {
  at <- 6L * (which - 1L)
  u <- function(corner) triangles$twine[at + 2L * corner - 1L]
  v <- function(corner) triangles$twine[at + 2L * corner]
  u1 <- u(1L)
  v1 <- v(1L)
  d <- (u(2L) - u1) * (v(3L) - v1) - (u(3L) - u1) * (v(2L) - v1)
  abs(d) / 2 * triangles$multiplicity[which]
}

# Middles of elements of as many corners: 3 x elements, m.
element_middles <- function(points, node, corners) {
  first <- seq.int(0L, by = corners, length.out = length(node) %/% corners)
  total <- points[, node[first + 1L], drop = FALSE]
  for (k in seq_len(corners - 1L) + 1L) total <- total + points[, node[first + k], drop = FALSE]
  total / corners
}
