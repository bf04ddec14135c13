# A state: plain data, from which its mesh and forces are computed when they are asked for.

# gear: with or without its check; si: the gear's numbers; position: 3 x nodes (m); report: the
# solver's; velocity: as position (m/s), or NULL where nothing moves.
#
# A codend_state is a list of `gear`, `report`, `position`, `velocity` (NULL at rest), `si` (NULL
# for the plan's), `mesh` (see mesh_recipe()), `levels` or `compared` (see levels_of()), `time` and
# `step_accuracy` of a moment of a tow, and `handle`, which holds what computed_state() gives and is
# empty in another process and after readRDS().
new_state <- function(gear, si, lattice, position, report, velocity = NULL) {
  state <- list(gear = plain_gear(gear), report = report, position = matrix(position, 3L))
  if (any(velocity != 0)) state$velocity <- matrix(velocity, 3L)
  if (!identical(si, gear_si(gear))) state$si <- si
  lattice$start <- state$position
  state$mesh <- mesh_recipe(lattice)
  state$handle <- engine_handle()
  state <- structure(state, class = "codend_state")
  engine_fill_handle(state$handle, evaluated(gear, si, lattice, state))
  state
}

# A gear without its check.
plain_gear <- function(gear) {
  gear$checked <- NULL
  gear
}

# What a state has beside its plain data: list(gear, with its check, si, lattice, velocity and the
# forces on everything).
computed_state <- function(state) {
  handle_value(.subset2(state, "handle"), function() {
    gear <- .subset2(state, "gear")
    gear$checked <- gear_checked(gear)
    si <- first_of(.subset2(state, "si"), gear_si(gear))
    lattice <- lattice_of_recipe(si, .subset2(state, "mesh"), .subset2(state, "position"))
    evaluated(gear, si, lattice, state)
  })
}

# What a handle holds; where it is empty it is filled with what compute() gives.
handle_value <- function(handle, compute) {
  value <- engine_handle_value(handle)
  if (is.null(value)) {
    value <- compute()
    engine_fill_handle(handle, value)
  }
  value
}

evaluated <- function(gear, si, lattice, state) {
  position <- .subset2(state, "position")
  velocity <- first_of(.subset2(state, "velocity"), 0 * position)
  found <- engine_evaluate(lattice$mesh, as.double(position), as.double(velocity))
  three <- function(x) matrix(x, 3L)
  c(
    list(gear = gear, si = si, lattice = lattice, velocity = velocity, force = three(found$force)),
    found[line_fields],
    list(forces = lapply(found$forces, three), boards = found$plates)
  )
}

# A state's places and forces as the engine reads them.
shape_of <- function(state) {
  lapply(setNames(nm = c("position", computed_fields)), function(name) state[[name]])
}

#' @export
`[[.codend_state` <- function(x, i, ...) {
  # the stored gear is without its check
  value <- if (!identical(i, "gear")) .subset2(x, i)
  if (is.null(value) && i %in% computed_fields) computed_state(x)[[i]] else value
}

line_fields <- paste0(c("bar", "u", "v", "straight"), rep(c("_tension", "_length"), each = 4L))
computed_fields <- c("gear", "si", "lattice", "velocity", "force", line_fields, "forces", "boards")

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
