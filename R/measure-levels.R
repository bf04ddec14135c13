# Mesh levels: measures of the same gear on other meshes, for error estimates.

# Meshes are comparable if their node counts differ by at least this factor. Same value as in
# src/engine/measure/measure_errors.cpp.
least_ratio <- 1.5

# Returns the mesh levels of a state. Measuring them, and settling an extra mesh if needed, waits
# until errors are first required: many quick changes need no errors.
#
# `coarser`: levels of the solver, list(nodes, values in SI).
# `complete`: TRUE if no extra mesh may be settled.
# `netting`: argument of settle() for the extra mesh.
# `base`: state of another gear whose levels replace these, or NULL.
# `found`: environment that caches `levels` (coarse to fine) and `values` (measures of the state).
# `found$strain`: strains of all lines before the levels exist; NULL: computed from lengths.
new_levels <- function(coarser = list(), netting = NULL, complete = FALSE, base = NULL,
                       strain = NULL) {
  found <- new.env(parent = emptyenv())
  found$strain <- strain
  list(coarser = coarser, complete = complete, netting = netting, base = base, found = found)
}

# Returns the mesh levels of a state from settle_numbers(). `netting`: as in settle(); `from`: the
# start state, or NULL.
state_levels <- function(state, found, netting, from) {
  if (length(found$levels) || is.null(from$levels)) {
    return(new_levels(found$levels, netting, strain = found$strain))
  }
  growth <- state$mesh$nodes / from$mesh$nodes
  if (identical(from$si, state$si) && max(growth, 1 / growth) >= least_ratio) {
    return(levels_with(from))
  }
  new_levels(base = first_of(from$levels$base, from))
}

# Returns a state's levels with the state itself as the last level.
levels_with <- function(state) {
  level <- level_of(state)
  new_levels(c(levels_of(state, level$values), list(level)), complete = TRUE)
}

level_of <- function(state) list(nodes = state$mesh$nodes, values = state_values(state)$values)

# Computes the levels of a state once. Returns the state on the extra mesh, or NULL.
find_levels <- function(state) {
  levels <- state$levels
  if (!is.null(levels$found$levels)) return(NULL)
  extra <- if (!levels$complete) extra_state(state, levels)
  known <- c(levels$coarser, if (!is.null(extra)) list(level_of(extra)))
  levels$found$levels <- known[order(vapply(known, `[[`, 0, "nodes"))]
  extra
}

# Returns the state on an extra mesh if the coarser levels are insufficient for errors; else NULL.
extra_state <- function(state, levels) {
  free <- undivided(state$si)
  shape <- state_shape(state)
  shape$strain <- first_of(levels$found$strain, shape$strain)
  levels$found$strain <- NULL
  started <- cpu_clock()
  found <- tryCatch(
    settle_numbers(free, state$mesh$nodes, levels$netting, shape, FALSE,
      beside = vapply(levels$coarser, `[[`, 0, "nodes")),
    codend_error = function(e) NULL
  )
  if (is.null(found)) return(NULL)
  found$report$cpu_seconds <- cpu_clock() - started
  new_state(state$gear, free, found$mesh, found$position, found$report)
}

own_levels <- function(state) {
  find_levels(state)
  state$levels$found$levels
}

# Returns the measures of a start state (SI), computed once.
base_values <- function(state) {
  found <- state$levels$found
  if (is.null(found$values)) found$values <- state_values(state)$values
  found$values
}
