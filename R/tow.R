#' Tow a gear through time
#'
#' Marches a gear from its steady state through time.
#'
#' @details
#' The motion is computed over the ground: water stands still but for its current, and the towing
#' points move. x, y, z are those of the plan at the start (x aft, y to starboard, z up), and stay
#' where they are while the vessel leaves.
#'
#' @param gear A gear, from [read_gear()] or the constructors; the name or file of a plan; a state
#'   from [settle()], with which the motion starts; or a trajectory that was cut short, to go on with.
#' @param until Time to which to tow, s, or a text such as `"10 min"`.
#' @param every Time between the states that are kept, s or text; a 200th of `until` when `NULL`.
#' @param scheme `"bdf2"`, `"trapezoid"`, `"backward_euler"` (implicit, by Newton's method),
#'   `"substitution"` (the trapezoid by substitution, as Li et al. print it), `"symplectic_euler"` or
#'   `"rk4"` (explicit).
#' @param accuracy Largest error of any node's position that one step of an implicit scheme may make,
#'   m, or text. Steps are as long as that allows.
#' @param step Length of all steps, s or text, instead of an accuracy; `NULL` for an explicit scheme
#'   is nine tenths of the longest that is surely stable.
#' @param nodes,netting As in [settle()], where `gear` is not yet a state.
#' @return A trajectory of class `codend_trajectory`.
#' @export
tow <- function(gear, until, every = NULL, scheme = "bdf2", accuracy = 0.01, step = NULL,
                nodes = 1500, netting = NULL) {
  until <- tow_quantity(until, "until", "time")
  every <- if (is.null(every)) until / 200 else tow_quantity(every, "every", "time")
  control <- tow_control(scheme, accuracy, step)
  if (inherits(gear, "codend_trajectory")) {
    trajectory <- gear
  } else {
    state <- if (inherits(gear, "codend_state")) gear else settle(gear, nodes, netting)
    trajectory <- new_trajectory(state)
  }
  march_trajectory(trajectory, until, every, control)
}

tow_schemes <- c(
  "bdf2", "trapezoid", "backward_euler", "substitution", "symplectic_euler", "rk4"
)

tow_control <- function(scheme, accuracy, step) {
  if (!is_text(scheme) || !scheme %in% tow_schemes) {
    cli::cli_abort("{.arg scheme} is {.val {scheme}}; it must be one of {.val {tow_schemes}}.",
      class = c("codend_error_argument", "codend_error"), call = NULL)
  }
  implicit <- scheme %in% tow_schemes[1:3]
  accuracy <- tow_quantity(accuracy, "accuracy", "length")
  adaptive <- implicit && is.null(step)
  list(
    scheme = scheme, accuracy = if (adaptive) accuracy else 0,
    step = if (is.null(step)) {
      # cut down by the march to what is accurate or stable
      if (implicit) 0.01 else 0.1
    } else {
      tow_quantity(step, "step", "time")
    },
    # Newton's method ends far below a step's own error; substitution at a share of its velocities
    tolerance = if (implicit) 0.05 * accuracy else 1e-6 * accuracy,
    least_step = 1e-7, most_step = if (adaptive) 60 else Inf
  )
}

# A positive number in SI from a number or a text with a unit.
tow_quantity <- function(value, name, dimension) {
  si <- if (length(value) == 1L && (is_text(value) || is.numeric(value))) {
    quantity_si(value, dimension)
  } else {
    NA_real_
  }
  if (!is.finite(si) || si <= 0) {
    cli::cli_abort(
      "{.arg {name}} is {.val {value}}; it must be a {dimension} greater than 0 (units:
      {unit_examples(dimension)}).",
      class = c("codend_error_argument", "codend_error"), call = NULL
    )
  }
  si
}
