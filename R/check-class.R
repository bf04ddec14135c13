# What an argument must be: a gear, a state.

check_is_gear <- function(gear) {
  if (!inherits(gear, "codend_gear")) {
    cli::cli_abort(
      "{.arg gear} must be a gear ({.fn read_gear}, {.fn gear}), not {.cls {class(gear)}}.",
      class = c("codend_error_argument", "codend_error"), call = NULL
    )
  }
}

check_is_state <- function(state) {
  if (!inherits(state, "codend_state")) {
    cli::cli_abort(
      "{.arg state} must be a state, as {.fn settle} returns, not {.cls {class(state)}}.",
      class = c("codend_error_argument", "codend_error"), call = NULL
    )
  }
}
