# How finely a gear has to be divided for its main measures to be as accurate as is asked.

# From one lattice to the next at most so many times as many nodes, and at least; and most nodes.
most_growth <- 7
least_growth <- 2
most_accurate_nodes <- 1e5

# The lattices that a state's measures may be compared with, coarse to fine: list(nodes, values).
# found: as settle_level() gives it, through levels of this gear; from: the state it began from, or
# NULL.
state_levels <- function(state, found, from) {
  shape <- found$from
  levels <- list()
  while (!is.null(shape$si)) {
    level <- new_state(
      state$gear, shape$si, shape$lattice,
      as.vector(shape$position[, seq_len(shape$lattice$nodes)]), list()
    )
    level <- list(nodes = shape$lattice$nodes, values = plain_measures(measures(level)))
    levels <- c(list(level), levels)
    shape <- shape$coarser
  }
  if (length(levels) || is.null(from)) return(levels)
  growth <- state$lattice$nodes / from$lattice$nodes
  if (identical(from$si, state$si) && max(growth, 1 / growth) >= least_ratio) {
    own <- list(nodes = from$lattice$nodes, values = plain_measures(measures(from)))
    return(c(from$levels, list(own)))
  }
  # without levels to carry neither state is measured
  carry_levels(from$levels, plain_measures(measures(from)), plain_measures(measures(state)))
}

# Divides a gear more finely until its main measures are as accurate as asked (a share).
settle_accurately <- function(state, accuracy, netting) {
  repeat {
    error <- main_error(measures(state))
    if (!is.finite(error) || error <= accuracy) return(state)
    nodes <- state$lattice$nodes
    # An error of first order falls with the square root of the nodes.
    growth <- min(max((error / accuracy)^2, least_growth), most_growth)
    finer <- if (nodes * growth <= most_accurate_nodes) {
      settled_state(state$gear, nodes * growth, netting, state, settle_iterations)
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

# An accuracy as a share, of "1 %" or 0.01.
accuracy_share <- function(accuracy) {
  one <- is_text(accuracy) || (is.numeric(accuracy) && length(accuracy) == 1L)
  share <- if (one) quantity_si(accuracy, "number") else NA_real_
  if (!(is.finite(share) && share > 0 && share < 1)) {
    abort_argument(
      "{.arg accuracy} is {.val {accuracy}}; it must be a share of the main measures such as
      {.val 1 %}."
    )
  }
  share
}
