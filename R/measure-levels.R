# What measures are compared with for their errors: the same gear on other lattices.

# Lattices whose nodes differ by less than this factor say too little of each other, as in
# src/engine/measure/measure_errors.cpp.
least_ratio <- 1.5

# The levels of a state: what its measures are compared with for their errors. Levels are measured,
# and one more is settled where they say too little, when errors are first asked for: a change of a
# gear that is looked at once needs neither.
#
# A list of `coarser`, the levels that the gear was settled through, as list(nodes, values in SI);
# `complete`, whether no other level may be settled; `netting`, as in settle(), for that one;
# `base`, the state of another gear whose levels count instead, or NULL; and `found`, an environment
# that keeps what was computed, `levels`, from coarse to fine, and `values`, measures of the state,
# and until then `strain`, of its lines as the solver left it (NULL: by their lengths).
new_levels <- function(coarser = list(), netting = NULL, complete = FALSE, base = NULL,
                       strain = NULL) {
  found <- new.env(parent = emptyenv())
  found$strain <- strain
  list(coarser = coarser, complete = complete, netting = netting, base = base, found = found)
}

# The levels of a state that settle_numbers() found; netting: as in settle(); from: the state it
# began from, or NULL.
state_levels <- function(state, found, netting, from) {
  if (length(found$levels) || is.null(from$levels)) {
    return(new_levels(found$levels, netting, strain = found$strain))
  }
  growth <- state$lattice$nodes / from$lattice$nodes
  if (identical(from$si, state$si) && max(growth, 1 / growth) >= least_ratio) {
    return(levels_with(from))
  }
  new_levels(base = first_of(from$levels$base, from))
}

# A state's levels and the state itself as the last of them.
levels_with <- function(state) {
  level <- level_of(state)
  new_levels(c(levels_of(state, level$values), list(level)), complete = TRUE)
}

# A state as a level of others.
level_of <- function(state) list(nodes = state$lattice$nodes, values = state_values(state)$values)

# Finds the levels of a state of its own gear, once. Returns the state of the one that was settled
# for it, or NULL.
find_levels <- function(state) {
  levels <- state$levels
  if (!is.null(levels$found$levels)) return(NULL)
  extra <- if (!levels$complete) extra_state(state, levels)
  known <- c(levels$coarser, if (!is.null(extra)) list(level_of(extra)))
  levels$found$levels <- known[order(vapply(known, `[[`, 0, "nodes"))]
  extra
}

# The state on one more lattice, where the coarser ones say too little of errors; else NULL.
extra_state <- function(state, levels) {
  free <- undivided(state$si)
  shape <- state_shape(state)
  shape$strain <- first_of(levels$found$strain, shape$strain)
  levels$found$strain <- NULL
  started <- cpu_clock()
  found <- tryCatch(
    settle_numbers(free, state$lattice$nodes, levels$netting, shape, FALSE,
      beside = vapply(levels$coarser, `[[`, 0, "nodes")),
    codend_error = function(e) NULL
  )
  if (is.null(found)) return(NULL)
  found$report$cpu_seconds <- cpu_clock() - started
  new_state(state$gear, free, found$lattice, found$position, found$report)
}

# The levels of a state of its own gear, coarse to fine.
own_levels <- function(state) {
  find_levels(state)
  state$levels$found$levels
}

# Measures of a state that others began from, SI, computed once.
base_values <- function(state) {
  found <- state$levels$found
  if (is.null(found$values)) found$values <- state_values(state)$values
  found$values
}
