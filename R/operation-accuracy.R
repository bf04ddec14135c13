# How finely a gear has to be divided for its main measures to be as accurate as is asked.

# Lattices whose nodes differ by less than this factor say too little of each other, and how many
# times as many one more has: as in src/engine/measure/measure_errors.cpp.
least_ratio <- 1.5
extra_ratio <- 2.6
# From one lattice to the next at most so many times as many nodes, and at least.
most_growth <- 7
least_growth <- 2

# The lattices that a state's measures may be compared with. They are measured, and one more is
# settled where these say too little, when their errors are first asked for: a change of a gear that
# is looked at once needs neither.
#
# found: as settle_numbers() gave it, with coarser levels that it was settled through; netting: as
# in settle(); from: the state it began from, or NULL.
# Returns list(own = function() that gives them coarse to fine, as list(nodes, values), extra =
# function() that gives the one more, a state, or NULL) and, where they are another gear's, values =
# function() that gives its measures. See levels_of().
state_levels <- function(state, found, netting, from) {
  if (length(found$levels) || is.null(from$levels)) {
    return(levels_through(state, found$levels, netting, found$strain))
  }
  growth <- state$lattice$nodes / from$lattice$nodes
  if (identical(from$si, state$si) && max(growth, 1 / growth) >= least_ratio) {
    return(levels_and(from))
  }
  list(own = from$levels$own, values = first_of(from$levels$values, values_of(from)))
}

# levels: the coarser ones, list(nodes, values) each; strain: of its lines as the solver left it, or
# NULL.
levels_through <- function(state, levels, netting, strain = NULL) {
  nodes <- state$lattice$nodes
  gear <- state$gear
  free <- undivided(state$si)
  shape <- state_shape(state)
  if (!is.null(strain)) shape$strain <- strain
  rm(state)
  extra <- once(function() {
    started <- cpu_clock()
    found <- tryCatch(
      settle_numbers(free, nodes, netting, shape, FALSE,
        beside = vapply(levels, `[[`, 0, "nodes")),
      codend_error = function(e) NULL
    )
    shape <<- NULL
    if (is.null(found)) return(NULL)
    found$report$cpu_seconds <- cpu_clock() - started
    new_state(gear, free, found$lattice, found$position, found$report)
  })
  own <- once(function() {
    levels <- c(levels, if (!is.null(extra())) list(level_of(extra())))
    levels[order(vapply(levels, `[[`, 0, "nodes"))]
  })
  list(own = own, extra = extra)
}

# A state as a level of others.
level_of <- function(state) list(nodes = state$lattice$nodes, values = state_values(state)$values)

# A state's levels, and the state itself as the last of them.
levels_and <- function(state) {
  force(state)
  list(own = once(function() {
    level <- level_of(state)
    c(levels_of(state, level$values), list(level))
  }))
}

# A function() that gives the measures of a state that another began from. Many may begin from one:
# the last one's are kept.
values_of <- function(state) {
  if (!identical(begun_from$state, state)) {
    values <- once(function() state_values(state)$values)
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
