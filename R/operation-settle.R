#' Settle a gear
#'
#' Finds the steady state of a gear in its plan's conditions: the shape in which every node is in
#' balance. Nobody gives a starting shape: the gear is settled coarsely first, from a crude layout
#' of its own, and each shape is the start of the next finer one.
#'
#' The solver is a pseudo-transient Newton method with the full derivative of all forces. It ends
#' when the largest net force on any free node is at most 1e-8 of the largest tension in the gear
#' and at most 1e-6 of the largest force on any line of the parts (ropes, panels, boards) that meet
#' there, so that a warp's tension does not hide a light net. What rounding of the places makes is
#' left out of the latter; more than 1e-3 of it is no balance.
#'
#' Where the plan needs `shielding`, netting slows the water behind it: every sheet of netting
#' that the line straight upstream from a point crosses reduces the speed there. `loland`: by
#' `1 - 0.46 C_D` with `C_D = 0.33 Sn + 6.54 Sn^2 - 4.88 Sn^3` (Loland 1991, Current forces on and
#' flow through fish farms), whatever the angle; `cheng`: by
#' `(cos t + 0.05 - 0.38 Sn) / (cos t + 0.05)` with `t` from the netting's normal to the flow (Cheng
#' et al. 2020, Aquacultural Engineering 90:102070). `Sn` is the solidity of the netting in its
#' present shape, held at 0.5. Netting nearly along the flow (more than 70 to 80 deg from across it)
#' casts no wake of its own. A net that narrows aft has no netting straight upstream of most of its
#' panels, so a trawl is hardly shielded by this; a cage's rear half is. Shape and wake are found
#' in turn until no speed changes by more than 1e-5 of the free flow's (`wake_renewals` and
#' `wake_change` in the report).
#'
#' On the sea bed a state is one of steady sliding: what moves over the ground rubs on it with the
#' whole of its friction, against its way. What lies still over the ground has none, though it could
#' hold: which of the balances that friction allows a gear comes to rest in depends on how it got
#' there. [tow()] has friction that sticks.
#'
#' A demersal seine is settled as it is towed when its ropes have come together, with all of them
#' out: [tow()] gives the haul.
#'
#' A gear whose plan has a section `shooting` is settled with few nodes first, for as long as that
#' takes. Where that fails it is shot, sinks for a quarter of an hour or two as in [tow()], and is
#' settled from there. What is hauled during its operation stays out. In still water nothing holds
#' such a net open: it ends as a bundle below its floats.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param nodes About how many nodes the model should have. `NULL` seeks an error of 1 % in the
#'   main measures: it begins with 1,500 nodes and, where the estimated error is over 1 %, goes on
#'   to 3,900; the state prints what was reached. With `from` it is as many as were given there.
#' @param netting `"cells"` or `"bars"` for every panel, or `NULL` for each panel's own choice
#'   in the plan.
#' @param from A state to start from: of this gear, or of one with the same ropes, panels and
#'   points, at another speed, warp or design. Many times faster than to start anew where the change
#'   is small and as many `nodes` are used; where that start does not lead to balance, or netting
#'   holds another catch, the gear is settled anew.
#' @param accuracy Largest discretisation error of the main measures, such as `"1 %"`: the gear
#'   is divided more finely, from `nodes` on, until it is estimated to be reached. The main measures
#'   are the total drag, the spreads, heights, areas and volumes that the plan needs, and the
#'   volume and surface of a catch, each as a share of the largest of its kind; not a drag of less
#'   than 1 % of the gear's weights in water; of a gear without any of them its forces. What 100,000
#'   nodes or the plan's own division do not reach is a warning of class `codend_warning_accuracy`.
#'   `NULL` with `nodes` settles at these and reports the error that is left.
#' @return A state of class `codend_state`; see [as.data.frame.codend_state()] for what it holds.
#'   A gear that does not reach balance is an error of class `codend_error_not_converged`, which
#'   names the part and place of the worst imbalance, says what to try, and carries the solver's
#'   report as `report`.
#'   Free otter boards and kites, poles in compression and netting full of catch that settle in a
#'   balance which a small push would carry them away from are pushed and settled again
#'   (`perturbations` in the report counts how often); where none is found that lasts it is a
#'   warning of class `codend_warning_board_unstable`, or of poles alone
#'   `codend_warning_pole_unstable`, or of netting alone `codend_warning_catch_unstable`. That
#'   reports static stability only. One whose swings would grow is a warning of class
#'   `codend_warning_board_flutter`, where the gear is not settled `from` a state (which takes less
#'   time than to look for swings); see [board_modes()] and [findings()]. A free otter board that
#'   settles stalled, back-winded or fallen over is a warning of class
#'   `codend_warning_board_stalled`, `codend_warning_board_back_winded` or
#'   `codend_warning_board_fallen_over`; see [as.data.frame()][as.data.frame.codend_state].
#' @examples
#' state <- settle(read_gear("towed_cable"))
#' summary(state)
#' @export
settle <- function(gear, nodes = NULL, netting = NULL, from = NULL, accuracy = NULL) {
  check_given("gear")
  if (is.character(gear)) gear <- read_gear(gear)
  aims <- is.null(nodes) && is.null(from) && is.null(accuracy)
  if (is.null(nodes)) nodes <- nodes_of(from)
  check_settle_arguments(gear, nodes, netting)
  if (!is.null(accuracy)) accuracy <- accuracy_share(accuracy)
  state <- settled_state(gear, nodes, netting, from)
  if (!is.null(accuracy)) state <- settle_accurately(state, accuracy, netting)
  if (aims) state <- aim_accuracy(state, netting)
  warn_of_doubts(state, swings = is.null(from))
  state
}

settle_gear <- function(gear, nodes, netting, from) {
  state <- settled_state(gear, nodes, netting, from)
  warn_of_doubts(state, swings = FALSE)
  state
}

# As settle_gear(), without its warnings.
settled_state <- function(gear, nodes, netting, from) {
  started <- cpu_clock()
  si <- gear_si(gear)
  if (!is.null(from)) check_same_parts(si, from)
  progress <- settle_progress()
  found <- NULL
  if (!is.null(from) && !has_other_catch(si, from$si)) {
    found <- settle_numbers(si, nodes, netting, state_shape(from), FALSE, progress)
  }
  if (!isTRUE(found$report$converged)) {
    found <- if (is.null(si$shooting)) {
      settle_numbers(si, nodes, netting, progress = progress)
    } else {
      settle_shot(gear, si, nodes, netting, progress)
    }
  }
  report <- found$report
  report$cpu_seconds <- cpu_clock() - started
  if (!report$converged) {
    advice <- unsettled_advice(gear, si, found)
    abort_unsettled(report, found$lattice, found$position, advice)
  }
  state <- new_state(gear, si, found$lattice, found$position, report)
  state$levels <- state_levels(state, found, netting, from)
  state
}

check_settle_arguments <- function(gear, nodes, netting) {
  if (!inherits(gear, "codend_gear")) {
    abort_argument("{.arg gear} must be a gear or the name of a plan, not {.cls {class(gear)}}.")
  }
  if (!is_plain_number(nodes) || nodes < 1) {
    abort_argument("{.arg nodes} is {.val {nodes}}; it must be one number, 1 or more.")
  }
  if (!is.null(netting) && !(is.character(netting) && length(netting) == 1L &&
    netting %in% c("cells", "bars"))) {
    abort_argument(
      "{.arg netting} is {.val {netting}}; it must be {.val cells}, {.val bars} or NULL."
    )
  }
  check_lattice_size(gear_si(gear), nodes, netting)
}

# A balance that does not last, boards that do not fly, and laws outside what they were measured
# for.
# swings: whether to look for swings of boards that grow, which in a whole trawl takes longer than
# to settle it from a state.
warn_of_doubts <- function(state, swings) {
  warn_of_instability(state)
  warn_of_boards(state, swings)
  warn_of_laws(state)
}
