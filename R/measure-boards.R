# Heel (deg) beyond which a board counts as fallen over.
fallen_heel <- 45

# Returns a data frame: one row per free otter board, kite and depressor.
# as.data.frame.codend_state() documents its columns.
board_table <- function(state) {
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
