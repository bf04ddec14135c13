# How free otter boards and kites swing about where a state has them.

# Of a motion that grows or dies more slowly than this (1/s) nothing is said: over a tow's
# manoeuvres it does not show.
slowest_told <- 0.002

#' How free otter boards and kites swing
#'
#' The motions of a settled gear in which a free otter board, kite or depressor takes part: pushed a
#' little, the gear moves as a sum of them. They are eigenvalues of its equations of motion, with
#' mass and added mass, drag and lift of everything as in [tow()], where the state has it; that flow
#' slowed by netting follows the netting is left out. Motions that boards only follow, with less
#' than a tenth of the way of the node that moves most, and those faster than 10 rad/s are left out
#' too, and of a whole trawl's swings with more than half the critical damping some may be missing.
#'
#' A board is one rigid body: its mass about its own centre of gravity, as of a plate of one
#' thickness with a camber of 12 %; the added mass of a flat plate about mid-chord, across its face
#' (DNV-RP-C205) and of turning; and the moments against turning of a thin plate in a steady flow.
#' The angle of attack follows the flow without delay, so that flutter which comes from a delay is
#' not found.
#'
#' @param state A state, from [settle()].
#' @return A data frame with a row per motion, the one that grows fastest first: `board` (that moves
#'   most), `period_s` (`NA` where it does not swing), `growth_per_s` (rate at which it grows;
#'   negative where it dies), `decay_s` (time in which it falls to 1/e; `NA` where it grows),
#'   `damping` (share of the critical one) and `condition`: `"swings"`, `"creeps"` (dies without
#'   swinging), `"flutters"` (swings and grows) or `"diverges"` (grows without swinging);
#'   `NA` of a growing one that does not meet the gear's equations to 2 %: look at [tow()] then.
#' @examples
#' # a kite of 1 m by 2 m on two front lines and one behind
#' on_lines <- function(from, to, length) {
#'   rope(from, to, length = length, diameter = "5 mm", material = "hmpe", segments = 1)
#' }
#' flown <- gear("A kite on three lines", towing = list(speed = "2 m/s"),
#'   block_port = gear_point(position = c(0, -0.6, -100), held = "moved"),
#'   block_starboard = gear_point(position = c(0, 0.6, -100), held = "moved"),
#'   port = gear_point(), starboard = gear_point(), tail = gear_point(),
#'   front_port = on_lines("block_port", "port", "0.99 m"),
#'   front_starboard = on_lines("block_starboard", "starboard", "0.99 m"),
#'   rear_port = on_lines("block_port", "tail", "1.293 m"),
#'   rear_starboard = on_lines("block_starboard", "tail", "1.293 m"),
#'   kite = kite(pushes = "up", chord = "1 m", span = "2 m", mass = "20 kg", volume = "0.03 m3",
#'     polar = "flat_plate", attachments = list(port = list(aft = "0.1 m", starboard = "-0.6 m"),
#'       starboard = list(aft = "0.1 m", starboard = "0.6 m"), tail = list(aft = "0.8 m"))))
#' board_modes(settle(flown))
#' @export
board_modes <- function(state) {
  check_given("state")
  check_is_state(state)
  found <- if (length(state$si$otter_boards)) {
    engine_body_modes(state$lattice$mesh, as.double(state$position), as.double(state$velocity))
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
  of <- lapply(boards, function(board) state$lattice$points[board$points])
  vapply(nodes, function(node) {
    names(boards)[which(vapply(of, function(points) node %in% points, NA))[1L]]
  }, "", USE.NAMES = FALSE)
}

# The rows of board_modes() that tell of flutter which shows.
fluttering_modes <- function(state) {
  modes <- board_modes(state)
  modes[modes$condition %in% "flutters" & modes$growth_per_s > slowest_told, ]
}
