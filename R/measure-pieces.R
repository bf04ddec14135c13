# Returns a data frame: one row per piece at a point (hooks, floats, weights). Pieces that are
# spread along a rope are omitted. Columns: part, role, number (of pieces there), x_m, y_m, z_m, and
# depth_m below the surface.
piece_table <- function(state) {
  pieces <- Filter(function(piece) !is.null(piece$at), state$si$pieces)
  place <- vapply(pieces, `[[`, "", "at")
  at <- state$position[, state$mesh$places[place], drop = FALSE]
  data.frame(
    part = as.character(names(pieces)),
    role = vapply(pieces, `[[`, "", "role", USE.NAMES = FALSE),
    number = vapply(pieces, function(piece) as.double(piece$number), 0, USE.NAMES = FALSE),
    x_m = at[1, ], y_m = at[2, ], z_m = at[3, ], depth_m = -at[3, ] + 0
  )
}
