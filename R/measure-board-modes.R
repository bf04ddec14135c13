# Growth rate (1/s) below which flutter causes no warning: such motions grow more slowly than the
# manoeuvres of a tow.
slowest_reported <- 0.002

# Returns the table "board_modes" of a state.
board_mode_table <- function(state) {
  found <- if (length(state$si$otter_boards)) {
    engine_body_modes(state$mesh$model, as.double(state$position), as.double(state$velocity))
  }
  growth <- as.double(found$growth)
  frequency <- as.double(found$frequency)
  swings <- frequency > 0
  data.frame(
    board = board_of_nodes(state, found$node),
    period_s = ifelse(swings, 2 * pi / frequency, NA_real_), growth_per_s = growth,
    decay_s = ifelse(growth < 0, -1 / growth, NA_real_),
    damping = -growth / sqrt(growth^2 + frequency^2),
    condition = ifelse(!as.logical(found$certain), NA_character_,
      ifelse(growth > 0, ifelse(swings, "flutters", "diverges"),
        ifelse(swings, "swings", "creeps")))
  )
}

board_of_nodes <- function(state, nodes) {
  boards <- state$si$otter_boards
  of <- lapply(boards, function(board) state$mesh$points[board$points])
  vapply(nodes, function(node) {
    names(boards)[which(vapply(of, function(points) node %in% points, NA))[1L]]
  }, "", USE.NAMES = FALSE)
}
