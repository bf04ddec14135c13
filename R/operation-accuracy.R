# How finely a gear has to be divided for its main measures to be as accurate as is asked.

# How many times as many nodes one more lattice has, as in src/engine/measure/measure_errors.cpp.
extra_ratio <- 2.6
# From one lattice to the next at most so many times as many nodes, and at least.
most_growth <- 7
least_growth <- 2

# Divides a gear more finely until its main measures are as accurate as asked (a share).
settle_accurately <- function(state, accuracy, netting) {
  repeat {
    error <- main_error(measures(state))
    if (!is.finite(error) || error <= accuracy) return(state)
    nodes <- state$lattice$nodes
    growth <- min(max(nodes_for(1, error, accuracy), least_growth), most_growth)
    finer <- if (nodes * growth <= most_accurate_nodes) {
      settled_state(state$gear, nodes * growth, netting, state)
    }
    if (is.null(finer) || finer$lattice$nodes < least_ratio * nodes) {
      cli::cli_warn(
        "The main measures of {.val {state$si$name}} are within about {percent_text(error)}, not
        {percent_text(accuracy)}: {if (is.null(finer)) paste('more would take over',
        most_accurate_nodes, 'nodes') else 'its plan divides it no further'}.",
        class = c("codend_warning_accuracy", "codend_warning"), call = NULL
      )
      return(state)
    }
    finer$report$cpu_seconds <- finer$report$cpu_seconds + state$report$cpu_seconds
    state <- finer
  }
}

# Nodes that settle() begins with where it is asked for neither nodes nor accuracy. It goes on to
# extra_ratio times as many; what misses the usual accuracy then is reported.
usual_nodes <- 1500
# An error so many times the usual one is of netting that hangs in folds, which no lattice settles.
hopeless_error <- 20

# Nodes that were asked for where a state was settled; `usual_nodes` without one.
nodes_of <- function(state) {
  # what is no state is told by a check
  if (!inherits(state, "codend_state")) return(usual_nodes)
  first_of(state$lattice$counts$asked$nodes, usual_nodes)
}

# Divides a gear once more where its main measures miss the usual accuracy, as finely as the lattice
# that their error was found with, and notes in the report what was aimed at.
aim_accuracy <- function(state, netting) {
  extra <- find_levels(state)
  error <- main_error(measures(state))
  nodes <- state$lattice$nodes
  if (is.finite(error) && !is_reached(error, usual_accuracy) &&
    error < hopeless_error * usual_accuracy) {
    finer <- finer_state(state, netting, extra)
    # a plan may divide itself
    if (!is.null(finer) && finer$lattice$nodes >= least_ratio * nodes) {
      finer$report$cpu_seconds <- finer$report$cpu_seconds + state$report$cpu_seconds
      finer$levels <- levels_with(state)
      state <- finer
    }
  }
  state$report$accuracy_aimed_at <- usual_accuracy
  state
}

# The gear on the lattice that its error was found with (extra, or NULL), from there; NULL where
# that is no finer or does not settle.
finer_state <- function(state, netting, extra) {
  wanted <- min(usual_nodes * extra_ratio, fixed_nodes(state$si, netting))
  if (is.null(extra) || wanted < least_ratio * state$lattice$nodes) return(NULL)
  finer <- extra$lattice$nodes >= least_ratio * state$lattice$nodes
  # of a plan that leaves its division open it is the gear itself
  if (finer && identical(extra$si, state$si)) return(extra)
  tryCatch(
    settled_state(state$gear, wanted, netting, extra),
    codend_error_not_converged = function(e) NULL
  )
}

# An error is known to a tenth at best.
is_reached <- function(error, asked) error <= 1.1 * asked

# An accuracy as a share, of "1 %" or 0.01.
accuracy_share <- function(accuracy) {
  share <- given_si(accuracy, "number", "accuracy")
  if (!(is.finite(share) && share > 0 && share < 1)) {
    abort_argument(
      "{.arg accuracy} is {.val {accuracy}}; it must be a share of the main measures such as
      {.val 1 %}."
    )
  }
  share
}
