# Growth rate (1/s) below which flutter causes no warning: such motions grow more slowly than the
# manoeuvres of a tow.
slowest_reported <- 0.002

#' Stability of free otter boards and kites
#'
#' Computes the small motions of a settled gear in which a free otter board, kite or depressor takes
#' part. Each motion has a period, a growth rate and a verdict, such as `"flutters"`.
#'
#' @section Method:
#' The motions are eigenmodes of the gear's linearised equations of motion. They include mass, added
#' mass, and the drag and lift of all parts, as in [tow()]. The wake of the netting stays fixed.
#'
#' These motions are missing:
#' - motions faster than 10 rad/s;
#' - motions in which the board moves less than a tenth as far as the node that moves most;
#' - in a whole trawl, some swings with more than half of the critical damping.
#'
#' @section Model of a board:
#' A board is one rigid body with these properties:
#' - its mass acts at its centre of gravity, as in a plate of uniform thickness with 12 % camber;
#' - the added mass is that for a flat plate, at mid-chord and normal to its face (DNV-RP-C205), and
#'   for its rotation;
#' - moments resist the rotation as on a thin plate in steady flow.
#'
#' Lift and drag follow the angle of attack without delay. Flutter that is caused by such a delay is
#' therefore not detected.
#'
#' @param state A state, from [settle()].
#' @return A data frame with one row per motion, fastest growing first:
#'   - `board`: the board that moves most.
#'   - `period_s`: period; `NA` if the motion does not oscillate.
#'   - `growth_per_s`: growth rate; negative if the motion decays.
#'   - `decay_s`: time in which the motion falls to 1/e; `NA` if it grows.
#'   - `damping`: fraction of the critical damping.
#'   - `condition`: `"swings"` (oscillates and decays), `"creeps"` (decays without oscillation),
#'     `"flutters"` (oscillates and grows) or `"diverges"` (grows without oscillation). A growing
#'     motion whose residual in the gear's equations exceeds 2 % gets `NA`; check it with [tow()].
#' @seealso [settle()], which warns of flutter; [tow()] to compute the motion itself;
#'   [as.data.frame()][as.data.frame.codend_state] with `what = "boards"` for the attitude of
#'   boards.
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
#'   kite = kite(lift_direction = "up", chord = "1 m", span = "2 m", mass = "20 kg", volume = "0.03
#'   m3",
#'     polar = "flat_plate", attachments = list(port = list(aft = "0.1 m", starboard = "-0.6 m"),
#'       starboard = list(aft = "0.1 m", starboard = "0.6 m"), tail = list(aft = "0.8 m"))))
#' state <- settle(flown)
#' board_modes(state)
#' as.data.frame(state, what = "boards")
#' @export
board_modes <- function(state) {
  check_given("state")
  check_is_state(state)
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

# Returns the rows of board_modes() with noticeable flutter.
fluttering_modes <- function(state) {
  modes <- board_modes(state)
  modes[modes$condition %in% "flutters" & modes$growth_per_s > slowest_reported, ]
}
