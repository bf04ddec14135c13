# Mesh refinement until the main measures reach a required accuracy.

# Ratio of node counts for an extra mesh, as in src/engine/measure/measure_errors.cpp.
extra_ratio <- 2.6
# Limits of the ratio of node counts from one mesh to the next.
most_growth <- 7
least_growth <- 2

# Settles a gear on the mesh that the arguments of settle() define, without warnings about the gear.
accurate_state <- function(gear, nodes, netting, accuracy, from = NULL) {
  accuracy <- accuracy_share(accuracy)
  state <- settled_state(gear, requested_nodes(gear, nodes, from), netting, from, any_catch = TRUE)
  if (!is.null(accuracy)) return(settle_accurately(state, accuracy, netting))
  if (is.null(nodes) && is.null(from)) refine_to_accuracy(state, netting) else state
}

# Refines the mesh of a gear until the main measures have the required relative accuracy.
settle_accurately <- function(state, accuracy, netting) {
  repeat {
    error <- main_error(measures(state))
    if (!is.finite(error) || error <= accuracy) return(state)
    nodes <- state$mesh$nodes
    growth <- min(max(nodes_for(1, error, accuracy), least_growth), most_growth)
    finer <- if (nodes * growth <= most_accurate_nodes) {
      settled_state(state$gear, nodes * growth, netting, state)
    }
    if (is.null(finer) || finer$mesh$nodes < least_ratio * nodes) {
      warn_as("accuracy", "The main measures of {.val {state$si$name}} are within about
        {percent_text(error)}, not {percent_text(accuracy)}: {if (is.null(finer)) paste('a smaller
        error needs more than', most_accurate_nodes, 'nodes') else 'its plan fixes the segments'}.")
      return(state)
    }
    finer$report$cpu_seconds <- finer$report$cpu_seconds + state$report$cpu_seconds
    state <- finer
  }
}

# Initial number of nodes of each net if settle() gets neither `nodes` nor `accuracy`. It refines
# the mesh once, by up to `extra_ratio`.
nodes_per_net <- 1500

# Returns the initial number of nodes of a gear. A gear without nets counts as one net.
usual_nodes <- function(gear) nodes_per_net * net_count(gear)

net_count <- function(gear) max(1L, length(gear_si(gear)$nets))

# Above this multiple of the usual error refinement is useless: the netting hangs in folds.
hopeless_error <- 20

# Returns the requested number of nodes of a state.
nodes_of <- function(state) {
  first_of(state$mesh$counts$asked$nodes, usual_nodes(state$gear))
}

# Returns the number of nodes for a gear: `nodes` if given, else as for the state `from`.
requested_nodes <- function(gear, nodes, from = NULL) {
  if (!is.null(nodes)) return(nodes)
  # a later check reports a state of the wrong class
  if (inherits(from, "codend_state")) nodes_of(from) else usual_nodes(gear)
}

# Refines the mesh once if the main measures miss the usual accuracy. Stores the target accuracy in
# the report.
refine_to_accuracy <- function(state, netting) {
  extra <- find_levels(state)
  error <- main_error(measures(state))
  nodes <- state$mesh$nodes
  # Errors are not known more precisely than 10 %.
  if (is.finite(error) && error > 1.1 * usual_accuracy && error < hopeless_error * usual_accuracy) {
    finer <- finer_state(state, netting, extra)
    # the plan may prescribe the mesh
    if (!is.null(finer) && finer$mesh$nodes >= least_ratio * nodes) {
      finer$report$cpu_seconds <- finer$report$cpu_seconds + state$report$cpu_seconds
      finer$levels <- levels_with(state)
      state <- finer
    }
  }
  state$report$accuracy_aimed_at <- usual_accuracy
  state
}

# Returns the state on the mesh that was used for the error estimate (`extra`, or NULL). NULL: that
# mesh is not finer, or the solver does not converge.
finer_state <- function(state, netting, extra) {
  wanted <- min(nodes_of(state) * extra_ratio, fixed_nodes(state$si, netting))
  if (is.null(extra) || wanted < least_ratio * state$mesh$nodes) return(NULL)
  finer <- extra$mesh$nodes >= least_ratio * state$mesh$nodes
  # `extra` ignores mesh settings of the plan; reuse it only if there are none
  if (finer && identical(extra$si, state$si)) return(extra)
  tryCatch(
    settled_state(state$gear, wanted, netting, extra),
    codend_error_not_converged = function(e) NULL
  )
}

# Converts an accuracy such as "1 %" or 0.01 to a fraction; NULL stays NULL.
accuracy_share <- function(accuracy) {
  if (is.null(accuracy)) return(NULL)
  share <- given_si(accuracy, "number", "accuracy")
  if (!(is.finite(share) && share > 0 && share < 1)) {
    abort_argument(
      "{.arg accuracy} is {describe_value(accuracy)}; it must be a relative error of the main
      measures, such as {.val 1 %}."
    )
  }
  share
}
