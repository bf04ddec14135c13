# A state: where every node is and what every element carries, with the gear that it belongs to.

# velocity: 3 per node, m/s, relative to the vessel.
new_state <- function(gear, si, lattice, position, report,
                      velocity = numeric(length(position))) {
  found <- engine_evaluate(lattice$engine, position, velocity)
  three <- function(x) matrix(x, 3L)
  structure(
    list(
      gear = gear, si = si, lattice = lattice, report = report,
      position = three(position), velocity = three(velocity),
      force = three(found$force),
      bar_tension = found$bar_tension, bar_length = found$bar_length,
      u_tension = found$u_tension, u_length = found$u_length,
      v_tension = found$v_tension, v_length = found$v_length,
      straight_tension = found$straight_tension, straight_length = found$straight_length,
      forces = lapply(found$forces, three), boards = found$plates
    ),
    class = "codend_state"
  )
}

# The forces on elements that the engine reports, from its own table: a data frame with a row per
# force, `name`, `kind` of element and `cause` ("flow", "ground" or "surface"). cause: of this
# one alone.
reported_forces <- function(cause = NULL) {
  table <- list2DF(engine_forces())
  if (is.null(cause)) table else table[table$cause == cause, ]
}

# Sum of all forces on a gear from one cause, 3 numbers, N.
total_force <- function(state, cause) {
  rowSums(vapply(state$forces[reported_forces(cause)$name], rowSums, numeric(3)))
}

# Force of the flow on every element of a kind such as "bars" (3 x elements, N).
flow_force <- function(state, kind) {
  by_flow <- reported_forces("flow")
  Reduce(`+`, state$forces[by_flow$name[by_flow$kind == kind]])
}

# The same on the whole of every cell, with what acts on it as a screen or blended.
cell_flow_force <- function(state) {
  force <- flow_force(state, "cells")
  for (kind in names(state$lattice$on_cell)) {
    on <- state$lattice$on_cell[[kind]]
    # those of sheets between bars follow
    force[, on] <- force[, on] + flow_force(state, kind)[, seq_along(on)]
  }
  force
}
