# Where pieces are.

# A row per piece at a place (hooks, floats, weights; not what is spread along a rope): part, role,
# number (how many sit there), position x_m, y_m, z_m and depth_m below the water surface.
piece_table <- function(state) {
  pieces <- Filter(function(piece) !is.null(piece$at), state$si$pieces)
  place <- vapply(pieces, `[[`, "", "at")
  at <- state$position[, state$lattice$places[place], drop = FALSE]
  data.frame(
    part = as.character(names(pieces)),
    role = vapply(pieces, `[[`, "", "role", USE.NAMES = FALSE),
    number = vapply(pieces, function(piece) as.double(piece$number), 0, USE.NAMES = FALSE),
    x_m = at[1, ], y_m = at[2, ], z_m = at[3, ], depth_m = -at[3, ] + 0
  )
}
