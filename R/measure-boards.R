# How free otter boards and kites stand in a state, and what is wrong with them.

# Beyond this heel (deg) a board lies on its side.
fallen_heel <- 45

#' Free otter boards and kites of a state
#'
#' @param state A state, from [settle()].
#' @return A data frame with a row per otter board whose attitude is free, and per kite or
#'   depressor: `board`, `attack_deg`, `stall_deg` (angle of attack of its polar's largest lift),
#'   `heel_deg` (positive where its upper edge leans outward; of a kite where its starboard end is
#'   high), `trim_deg` (positive where its leading edge is high), `lift_kN` (across the
#'   flow), `drag_kN`, `ground_load_kN` (upward force of the sea bed) and `condition`: `"flying"`,
#'   `"stalled"` (attack beyond that of the largest lift), `"back-winded"` (flow on the outer face)
#'   or `"fallen over"` (heel beyond 45 deg).
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
#' board_table(settle(flown))
#' @export
board_table <- function(state) {
  check_given("state")
  check_is_state(state)
  boards <- state$si$otter_boards
  found <- state$boards
  stall <- vapply(boards, stall_angle, 0, USE.NAMES = FALSE)
  attack <- in_unit(found$attack, "deg")
  heel <- in_unit(found$heel, "deg")
  condition <- rep("flying", length(boards))
  condition[attack > stall] <- "stalled"
  condition[attack < 0] <- "back-winded"
  condition[abs(heel) > fallen_heel] <- "fallen over"
  data.frame(
    board = as.character(names(boards)), attack_deg = attack, stall_deg = stall, heel_deg = heel,
    trim_deg = in_unit(found$trim, "deg"),
    lift_kN = in_unit(found$lift, "kN"), drag_kN = in_unit(found$drag, "kN"),
    ground_load_kN = if (is.null(state$si$ground)) {
      rep(0, length(boards))
    } else {
      in_unit(drop(state$si$ground$normal %*% state$forces$plate_ground_force), "kN")
    },
    condition = condition
  )
}

define_measure("attitude", "deg",
  "Angle of attack of a free otter board or kite, its heel (positive where its upper edge leans
  outward, so that its lift points down; of a kite where its starboard end is high) or trim
  (positive where its leading edge is high).",
  sensor = "Heel (roll) and trim (pitch): an inclinometer in a door sensor, each maker with its own
  signs and its zero as it is mounted. Attack: none at sea.",
  asks_board_angle, function(state, measure) measure_attitude(state, measure)
)

measure_attitude <- function(state, measure) {
  k <- match(measure$board, names(state$si$otter_boards))
  state$boards[[measure$angle]][k]
}

# Warns of boards that do not fly, or not for long; swings: see warn_of_doubts().
warn_of_boards <- function(state, swings) {
  if (!length(state$si$otter_boards)) return(invisible())
  flutter <- if (swings) fluttering_modes(state)
  if (NROW(flutter)) {
    worst <- flutter[1L, ]
    cli::cli_warn(
      c("{.field {worst$board}} flutters: pushed a little it swings with a period of
        {figures(worst$period_s)} s, and each swing is larger than the last, by a factor of e in
        {figures(1 / worst$growth_per_s)} s.",
        "i" = "See {.fn board_modes}, and {.fn tow} from this state."),
      class = c("codend_warning_board_flutter", "codend_warning"), call = NULL
    )
  }
  boards <- board_table(state)
  for (k in which(boards$condition != "flying")) {
    board <- boards[k, ]
    name <- if (is_kite(state$si$otter_boards[[k]])) "Kite" else "Otter board"
    kind <- gsub("[^a-z]", "_", board$condition)
    reason <- switch(board$condition,
      "stalled" = sprintf("it meets the flow at %.0f deg, and its lift is largest at %.0f deg",
        board$attack_deg, board$stall_deg),
      "back-winded" = sprintf("the flow meets its outer face, at %.0f deg", board$attack_deg),
      "fallen over" = sprintf("it heels by %.0f deg", board$heel_deg)
    )
    cli::cli_warn(
      "{name} {.field {board$board}} is {board$condition}: {reason}.",
      class = c(paste0("codend_warning_board_", kind), "codend_warning"), call = NULL
    )
  }
}
