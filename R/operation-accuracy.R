# How finely a gear has to be divided for its main measures to be as accurate as is asked.

# From one lattice to the next at most so many times as many nodes, and at least.
most_growth <- 7
least_growth <- 2

# The lattices that a state's measures may be compared with. They are measured, and one more is
# settled where these say too little, when their errors are first asked for: a change of a gear that
# is looked at once needs neither.
#
# levels: coarser ones of this gear that it was settled through; netting: as in settle(); from: the
# state it began from, or NULL.
# Returns list(own = function() that gives them coarse to fine, as list(nodes, values), extra =
# function() that gives the one more, a state, or NULL) and, where they are another gear's, values =
# function() that gives its measures. See levels_of().
state_levels <- function(state, levels, netting, from) {
  if (length(levels) || is.null(from$levels)) return(levels_through(state, levels, netting))
  growth <- state$lattice$nodes / from$lattice$nodes
  if (identical(from$si, state$si) && max(growth, 1 / growth) >= least_ratio) {
    return(levels_and(from))
  }
  list(own = from$levels$own, values = first_of(from$levels$values, values_of(from)))
}

# levels: the coarser ones, list(nodes, values) each.
levels_through <- function(state, levels, netting) {
  nodes <- state$lattice$nodes
  gear <- state$gear
  # such a lattice is not settled once more
  wanted <- if (nodes <= many_nodes) extra_nodes(state$si, nodes, vapply(levels, `[[`, 0, "nodes"))
  free <- if (length(wanted)) undivided(state$si)
  shape <- if (length(wanted)) state_shape(state)
  rm(state)
  extra <- once(function() {
    found <- if (length(wanted)) extra_level(free, wanted, netting, shape)
    shape <<- NULL
    if (is.null(found)) return(NULL)
    new_state(gear, free, found$lattice, found$position, list(converged = TRUE))
  })
  own <- once(function() {
    one_more <- extra()
    if (!is.null(one_more)) {
      values <- plain_measures(measures(one_more))
      levels <- c(levels, list(list(nodes = one_more$lattice$nodes, values = values)))
    }
    levels[order(vapply(levels, `[[`, 0, "nodes"))]
  })
  list(own = own, extra = extra)
}

# Nodes of the lattice that is settled to know the error of one of so many, in the order in which
# they are tried; none where the levels that there are do. Coarser lattices of netting share what
# all coarse ones have: of `enough_nodes` and less they report a fifth of what is left.
extra_nodes <- function(si, nodes, levels) {
  levels <- levels[pmax(levels / nodes, nodes / levels) >= least_ratio]
  enough <- if (length(si$panels)) min(enough_nodes, nodes) else 0
  if (any(levels >= enough)) return(numeric())
  finer <- nodes * extra_ratio * c(1, 1.5, 0.7)
  coarser <- nodes / extra_ratio * c(1, 0.7)
  if (nodes <= most_made_finer) c(finer, coarser) else c(coarser, finer)
}

enough_nodes <- 1200
# A lattice of more nodes is compared with a coarser one, which takes less time.
most_made_finer <- 2500
extra_ratio <- 2.6

# The first of lattices of so many nodes that settles from a shape, as settle_numbers() gives it, or
# NULL.
extra_level <- function(si, wanted, netting, shape) {
  for (nodes in wanted) {
    found <- tryCatch(
      settle_numbers(si, nodes, netting, shape, through_levels = FALSE),
      codend_error = function(e) NULL
    )
    if (!isTRUE(found$report$converged)) next
    ratio <- found$lattice$nodes / shape$lattice$nodes
    if (max(ratio, 1 / ratio) >= least_ratio) return(found)
  }
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
  error <- main_error(measures(state))
  nodes <- state$lattice$nodes
  if (is.finite(error) && !is_reached(error, usual_accuracy) &&
    error < hopeless_error * usual_accuracy) {
    finer <- finer_state(state, netting)
    # a plan may divide itself
    if (!is.null(finer) && finer$lattice$nodes >= least_ratio * nodes) {
      finer$report$cpu_seconds <- finer$report$cpu_seconds + state$report$cpu_seconds
      finer$levels <- levels_and(state)
      state <- finer
    }
  }
  state$report$accuracy_aimed_at <- usual_accuracy
  state
}

# The gear on the lattice that its error was found with, from there; NULL where that is no finer or
# does not settle.
finer_state <- function(state, netting) {
  extra <- state$levels$extra()
  wanted <- min(usual_nodes * extra_ratio, fixed_nodes(state$si, netting))
  if (is.null(extra) || wanted < least_ratio * state$lattice$nodes) return(NULL)
  tryCatch(
    settled_state(state$gear, wanted, netting, extra),
    codend_error_not_converged = function(e) NULL
  )
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
