#' Compute the equilibrium of a gear
#'
#' Computes the steady state of a gear in the conditions of its plan. In this equilibrium the net
#' force on every node is zero.
#'
#' No initial guess is needed. The solver starts with a coarse mesh and a crude layout. Each
#' solution is the initial guess on the next finer mesh.
#'
#' @section Number of nodes and accuracy:
#' The main measures define the accuracy:
#' - the total drag;
#' - the spreads, heights, areas and volumes that the plan defines;
#' - the volume and surface of a catch.
#'
#' The error of each main measure is relative to the largest measure of its kind. Drag below 1 % of
#' the gear's weights in water is not a main measure. A gear without main measures uses its forces.
#'
#' The arguments `nodes` and `accuracy` work together:
#' - Neither is given: the solver starts with 1,500 nodes for each net. It refines the mesh once, to
#'   at most 3,900 nodes for each net, if the estimated error exceeds 1 %. The printed state shows
#'   the result.
#' - Only `nodes`: the solver uses this number and reports the error.
#' - `accuracy`: the solver refines the mesh, from `nodes` on, until the estimated error reaches it.
#'   It stops with a warning at 100,000 nodes, or if the plan prescribes a coarser mesh.
#'
#' @section Convergence:
#' The solver is a pseudo-transient Newton method with exact derivatives of all forces. The residual
#' is the largest net force on a free node. Two criteria must be met:
#' - The residual is at most 1e-8 of the largest tension in the gear.
#' - At each node it is at most 1e-6 of the largest force on any line of the parts that meet there
#'   (ropes, panels, boards). A warp with a high tension can therefore not hide errors in a light
#'   net.
#'
#' Rounding error in the node positions is subtracted from the residual in the second criterion. The
#' solver rejects a state if rounding alone exceeds 1e-3 of this force.
#'
#' @section Wakes of netting:
#' If the plan has `shielding`, netting slows the water behind it. Each sheet of netting straight
#' upstream of a point multiplies the speed there by a factor:
#' - `loland`: `1 - 0.46 C_D` at any angle, with `C_D = 0.33 Sn + 6.54 Sn^2 - 4.88 Sn^3` (Loland
#'   1991, Current forces on and flow through fish farms).
#' - `cheng`: `(cos t + 0.05 - 0.38 Sn) / (cos t + 0.05)`, with the angle `t` from the netting's
#'   normal to the flow (Cheng et al. 2020, Aquacultural Engineering 90:102070).
#'
#' `Sn` is the solidity of the netting in its present shape, limited to 0.5. Netting with `t` above
#' 70 to 80 deg has no wake.
#'
#' The rear half of a cage is shielded. A trawl is hardly shielded: it narrows aft, so most of its
#' panels have no netting straight upstream.
#'
#' Shape and wake are computed alternately until all speeds change by less than 1e-5 of the free
#' flow. The report has `wake_renewals` and `wake_change`.
#'
#' @section Sea bed:
#' The result is a state of steady sliding:
#' - Parts that move over the sea bed have full sliding friction, opposite to their motion.
#' - Parts at rest have no friction, although static friction could hold them. Static friction
#'   allows many equilibria, which depend on the loading history. Use [tow()] to include it.
#'
#' @section Seines and shot gears:
#' - A demersal seine settles in its towing phase: the ropes are together and all of their length is
#'   out. Use [tow()] for the haul.
#' - A gear with a section `shooting` first settles on a coarse mesh. If that fails, it is shot and
#'   sinks for a quarter or half an hour as in [tow()], and settles from there. Ropes that are
#'   hauled during its operation keep their full length. In still water no force opens such a net:
#'   it ends as a bundle below its floats.
#'
#' @section Initial state:
#' With `from`, a small change takes only a few iterations if the number of nodes stays the same.
#' If the solver does not converge from the initial state, it starts again from its positions, with
#' a small tension in all slack lines that it reduces slowly.
#'
#' @section Several equilibria:
#' A codend with a catch can have a round and a flat equilibrium, and both can be stable. Without
#' `from` the solver starts from a round codend. It usually finds the round equilibrium, except for
#' a catch of a few meshes. With `from` it follows the equilibrium of the initial state, also to
#' another catch. To reach the flat one, settle the codend with a small catch, then increase
#' `catch.blocked_meshes` in steps of one mesh, each from the last state. Studies ([vary()],
#' [find_value()]) only start from states with the same catch.
#'
#' @section Errors and warnings:
#' If the solver does not converge, an error of class `codend_error_not_converged` names the part
#' and position of the largest residual and suggests remedies. Its field `report` is the solver's
#' report.
#'
#' Some equilibria are unstable: a small push moves the gear away from them. The solver then pushes
#' the gear and settles it again; `perturbations` in the report counts these pushes. It warns if it
#' finds no stable equilibrium:
#' - `codend_warning_board_unstable`: free otter boards or kites;
#' - `codend_warning_pole_unstable`: poles in compression;
#' - `codend_warning_catch_unstable`: netting around a catch.
#'
#' Further warnings:
#' - `codend_warning_board_flutter`: a board oscillates with growing amplitude, see the
#'   board modes of [as.data.frame()][as.data.frame.codend_state].
#'   Skipped with `from`, because the check takes longer than the solution.
#' - `codend_warning_board_stalled`, `codend_warning_board_back_winded`,
#'   `codend_warning_board_fallen_over`: a free otter board or kite has a wrong attitude, see
#'   [as.data.frame()][as.data.frame.codend_state].
#' - `codend_warning_drag_model`: a drag model is used outside its tested range.
#' - `codend_warning_accuracy`: the mesh limit prevents the required accuracy.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param nodes Approximate number of nodes of the whole gear. `NULL` (default) chooses it for an
#'   error of 1 % in the main measures; with `from` it is the number requested for that state.
#' @param netting `"cells"` or `"bars"` for all panels, or `NULL` (default) for the choice of the
#'   plan.
#' @param from A state as the initial guess, or `NULL` (default). Its gear needs the same ropes,
#'   panels and points; speed, lengths and other values may differ.
#' @param accuracy Largest relative discretisation error of the main measures, such as `"1 %"`, or
#'   `NULL` (default). See the section on accuracy.
#' @return A state of class `codend_state`, which [as.data.frame.codend_state()] documents. Use
#'   [measures()] and [summary()][summary.codend_state] to read it.
#' @seealso [measures()], [findings()] and [plot()][plot.codend_state] for the result; [tow()] for
#'   motion; [vary()] for many designs; `vignette("when-it-does-not-settle", "codend")` for
#'   remedies.
#' @examples
#' state <- settle("midwater_trawl", nodes = 300)
#' summary(state)
#'
#' # the same trawl at a higher speed, from the first state
#' faster <- settle(update(state$gear, towing.speed = "4.5 knot"), from = state)
#' measures(faster)[["total_drag_kN"]]
#' @export
settle <- function(gear, nodes = NULL, netting = NULL, from = NULL, accuracy = NULL) {
  check_given("gear")
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting, from)
  state <- accurate_state(gear, nodes, netting, accuracy, from)
  warn_of_doubts(state, swings = is.null(from))
  state
}

settle_gear <- function(gear, nodes, netting, from) {
  state <- settled_state(gear, nodes, netting, from)
  warn_of_doubts(state)
  state
}

# Same as settle_gear(), without its warnings. `any_catch`: TRUE to start from a state with another
# catch too. Studies do not, so that their results are independent of the order of designs.
settled_state <- function(gear, nodes, netting, from, any_catch = FALSE) {
  started <- cpu_clock()
  si <- gear_si(gear)
  if (!is.null(from)) check_same_parts(si, from)
  progress <- settle_progress()
  found <- NULL
  if (!is.null(from) && (any_catch || !has_other_catch(si, from$si))) {
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
    abort_unsettled(report, found$mesh, found$position, advice)
  }
  state <- new_state(gear, si, found$mesh, found$position, report)
  state$levels <- state_levels(state, found, netting, from)
  state
}

check_settle_arguments <- function(gear, nodes, netting, from = NULL) {
  if (!inherits(gear, "codend_gear")) {
    abort_argument("{.arg gear} must be a gear or the name of a plan, not {.cls {class(gear)}}.")
  }
  nodes <- requested_nodes(gear, nodes, from)
  if (!is_plain_number(nodes) || nodes < 1) {
    abort_argument("{.arg nodes} is {describe_value(nodes)}; it must be one number, 1 or more.")
  }
  if (!is.null(netting) && !(is.character(netting) && length(netting) == 1L &&
    netting %in% c("cells", "bars"))) {
    abort_argument(
      "{.arg netting} is {describe_value(netting)}; it must be {.val cells}, {.val bars} or NULL."
    )
  }
  check_mesh_size(gear_si(gear), nodes, netting)
}

# Warns of unstable equilibria, boards that do not fly, and drag models outside their range.
# `swings`: TRUE to check for flutter, which for a whole trawl takes longer than settling it from a
# state.
warn_of_doubts <- function(state, swings = FALSE) {
  warn_of_instability(state)
  warn_of_boards(state, swings)
  warn_of_drag_models(state)
}
