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

# Warns of boards that do not fly or that flutter. `swings`: see warn_of_doubts().
warn_of_boards <- function(state, swings) {
  if (!length(state$si$otter_boards)) return(invisible())
  flutter <- if (swings) fluttering_modes(state)
  if (NROW(flutter)) {
    worst <- flutter[1L, ]
    cli::cli_warn(
      c("{.field {worst$board}} flutters: after a small disturbance it oscillates with a period of
        {figures(worst$period_s)} s, and the amplitude grows by a factor of e in
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
      "stalled" = sprintf("its angle of attack is %.0f deg, but its lift is largest at %.0f deg",
        board$attack_deg, board$stall_deg),
      "back-winded" = sprintf("the flow hits its outer face, at %.0f deg", board$attack_deg),
      "fallen over" = sprintf("it heels by %.0f deg", board$heel_deg)
    )
    cli::cli_warn(
      "{name} {.field {board$board}} is {board$condition}: {reason}.",
      class = c(paste0("codend_warning_board_", kind), "codend_warning"), call = NULL
    )
  }
}
