# Returns the corners of every free board, 3 x (4 per board), m: leading edge below and above,
# trailing edge above and below.
board_corners <- function(state) {
  do.call(cbind, c(list(matrix(0, 3L, 0L)), lapply(unname(state$si$otter_boards), function(board) {
    at <- state$position[, state$mesh$points[board$points], drop = FALSE]
    turn <- triad(at) %*% t(triad(board$attachment))
    corner <- rbind(
      c(0, 0, board$chord, board$chord), 0, c(-0.5, 0.5, 0.5, -0.5) * board$span
    )
    at[, 1L] + turn %*% (corner - board$attachment[, 1L])
  })))
}

# Returns three orthonormal axes, as columns, defined by three points.
triad <- function(points) {
  unit <- function(v) v / sqrt(sum(v^2))
  first <- unit(points[, 2L] - points[, 1L])
  other <- points[, 3L] - points[, 1L]
  second <- unit(other - sum(other * first) * first)
  cbind(first, second, c(
    first[2L] * second[3L] - first[3L] * second[2L],
    first[3L] * second[1L] - first[1L] * second[3L],
    first[1L] * second[2L] - first[2L] * second[1L]
  ))
}
