check_is_gear <- function(gear) {
  if (!inherits(gear, "codend_gear")) {
    abort_argument(
      "{.arg gear} must be a gear ({.fn read_gear}, {.fn gear}), not {.cls {class(gear)}}."
    )
  }
  invisible(gear)
}

check_is_settled <- function(state) {
  check_is_state(state)
  if (!is.null(state$time) || !isTRUE(state$report$converged)) {
    abort_argument("{.arg state} must be a settled state ({.fn settle}), not a moment of a tow.")
  }
}

# name: the argument as the user typed it.
check_is_state <- function(state, name = "state") {
  if (!inherits(state, "codend_state")) {
    abort_argument(
      "{.arg {name}} must be a state, as {.fn settle} returns, not {.cls {class(state)}}."
    )
  }
}
