# How finely a gear has to be divided for its main measures to be as accurate as is asked.

# From one lattice to the next at most so many times as many nodes, and at least.
most_growth <- 7
least_growth <- 2

# The lattices that a state's measures may be compared with. They are measured when their errors are
# first asked for: a change of a gear that is looked at once needs neither.
#
# found: as settle_level() gives it, through levels of this gear; from: the state it began from, or
# NULL.
# Returns list(own = function() that gives them coarse to fine, as list(nodes, values)) and, where
# they are another gear's, values = function() that gives its measures; NULL where there are none.
# See levels_of().
state_levels <- function(state, found, from) {
  if (!is.null(found$from$si)) return(levels_through(state, found$from))
  if (is.null(from$levels)) return(NULL)
  growth <- state$lattice$nodes / from$lattice$nodes
  if (identical(from$si, state$si) && max(growth, 1 / growth) >= least_ratio) {
    return(levels_and(from))
  }
  list(own = from$levels$own, values = first_of(from$levels$values, values_of(from)))
}

# shape: the last of the coarser levels, each with the one before.
levels_through <- function(state, shape) {
  gear <- state$gear
  many <- state$lattice$nodes > many_nodes
  rm(state)
  own <- once(function() {
    levels <- list()
    while (!is.null(shape$si)) {
      level <- new_state(
        gear, shape$si, shape$lattice,
        as.vector(shape$position[, seq_len(shape$lattice$nodes)]), list()
      )
      level <- list(nodes = shape$lattice$nodes, values = plain_measures(measures(level)))
      levels <- c(list(level), levels)
      shape <- shape$coarser
    }
    levels
  })
  # large lattices are not kept for it
  if (many) own()
  list(own = own)
}

# A state's levels, and the state itself as the last of them.
levels_and <- function(state) {
  force(state)
  list(own = once(function() {
    values <- plain_measures(measures(state))
    c(levels_of(state, values), list(list(nodes = state$lattice$nodes, values = values)))
  }))
}

# A function() that gives the measures of a state that another began from. Many may begin from one:
# the last one's are kept.
values_of <- function(state) {
  if (!identical(begun_from$state, state)) {
    values <- once(function() plain_measures(measures(state)))
    if (state$lattice$nodes > many_nodes) return(values)
    begun_from$state <- state
    begun_from$values <- values
  }
  begun_from$values
}

begun_from <- new.env(parent = emptyenv())

# A function that finds something the first time that it is called.
once <- function(find) {
  force(find)
  found <- NULL
  function() {
    if (!is.null(find)) found <<- find()
    find <<- NULL
    found
  }
}

# Nodes of lattices that are not kept for what may never be asked.
many_nodes <- 1e5

# Divides a gear more finely until its main measures are as accurate as asked (a share).
settle_accurately <- function(state, accuracy, netting) {
  repeat {
    error <- main_error(measures(state))
    if (!is.finite(error) || error <= accuracy) return(state)
    nodes <- state$lattice$nodes
    growth <- min(max(nodes_for(1, error, accuracy), least_growth), most_growth)
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

# Nodes that settle() begins with, and most that it goes on to, where it is asked for neither nodes
# nor accuracy: with 4,000 all shipped gears together take twice as long as at 1,500
# (bench/results/netting.md). What misses the usual accuracy is told.
usual_nodes <- 1500
most_usual_nodes <- 4000
# An error so many times the usual one is of netting that hangs in folds, which no lattice settles.
hopeless_error <- 20

# Nodes that were asked for where a state was settled; `usual_nodes` without one.
nodes_of <- function(state) {
  # what is no state is told by a check
  if (!inherits(state, "codend_state")) return(usual_nodes)
  first_of(state$lattice$counts$asked$nodes, usual_nodes)
}

# Divides a gear once more where its main measures miss the usual accuracy, and notes in the report
# what was aimed at.
aim_accuracy <- function(state, netting) {
  error <- main_error(measures(state))
  nodes <- state$lattice$nodes
  wanted <- min(nodes_for(nodes, error, usual_accuracy), most_usual_nodes,
    fixed_nodes(state$si, netting))
  if (is.finite(error) && !is_reached(error, usual_accuracy) && wanted >= least_ratio * nodes &&
    error < hopeless_error * usual_accuracy) {
    finer <- tryCatch(
      settled_state(state$gear, wanted, netting, state, settle_iterations),
      codend_error_not_converged = function(e) NULL
    )
    # a plan may divide itself
    if (!is.null(finer) && finer$lattice$nodes >= least_ratio * nodes) {
      finer$report$cpu_seconds <- finer$report$cpu_seconds + state$report$cpu_seconds
      state <- finer
    }
  }
  state$report$accuracy_aimed_at <- usual_accuracy
  state
}

# An error is known to a tenth at best.
is_reached <- function(error, asked) error <= 1.1 * asked

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
