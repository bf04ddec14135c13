# A state's lines: every bar, and in every netting triangle its two families of twine, as one table.

# Positions of all points that elements stand on: 3 x (nodes + tied points), m.
state_points <- function(state) {
  ties <- state$lattice$engine$ties
  x <- state$position
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
  bars <- lattice$engine$bars
  triangles <- lattice$engine$triangles
  in_triangle <- triangle_bars(triangles)
  triangle <- seq_along(triangles$rest)
  bar <- seq_along(bars$rest)
  data.frame(
    part = c(lattice$bar_part, lattice$triangle_part, lattice$triangle_part),
    element = c(bar, triangle, triangle),
    family = rep(c("bar", "u", "v"), c(length(bar), length(triangle), length(triangle))),
    tension = c(state$bar_tension, state$u_tension, state$v_tension),
    length = c(state$bar_length, state$u_length, state$v_length),
    rest = c(bars$rest, triangles$rest, triangles$rest),
    lines = c(bars$multiplicity, in_triangle, in_triangle)
  )
}

# Mesh bars of one family in every triangle: half of |d|, the double area in twine coordinates.
triangle_bars <- function(triangles) {
  if (!length(triangles$rest)) return(numeric())
  t <- matrix(triangles$twine, 6L)
  d <- (t[3, ] - t[1, ]) * (t[6, ] - t[2, ]) - (t[5, ] - t[1, ]) * (t[4, ] - t[2, ])
  abs(d) / 2 * triangles$multiplicity
}

# Middles of elements of as many corners: 3 x elements, m.
element_middles <- function(points, node, corners) {
  corner <- function(k) points[, node[seq_along(node) %% corners == k %% corners], drop = FALSE]
  Reduce(`+`, lapply(seq_len(corners), corner)) / corners
}
