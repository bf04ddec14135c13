# Class `codend_state`: plain data; mesh and forces are computed when first used.

# Creates a state. `si`: numbers of the gear; `position`: 3 x nodes [m]; `report`: solver's report;
# `velocity`: 3 x nodes [m/s], or NULL at rest.
#
# Fields: `gear`, `report`, `position`, `velocity` (NULL at rest), `si` (NULL: as in the plan).
# `mesh`: see mesh_recipe(). `levels` or `compared`: see levels_of(). `time`, `step_accuracy`:
# moments of a tow only. `handle`: caches computed_state(); empty in another process and after
# readRDS().
new_state <- function(gear, si, mesh, position, report, velocity = NULL) {
  state <- list(gear = plain_gear(gear), report = report, position = matrix(position, 3L))
  if (any(velocity != 0)) state$velocity <- matrix(velocity, 3L)
  if (!identical(si, gear_si(gear))) state$si <- si
  mesh$start <- state$position
  state$recipe <- mesh_recipe(mesh)
  state$handle <- engine_handle()
  state <- structure(state, class = "codend_state")
  engine_fill_handle(state$handle, evaluated(gear, si, mesh, state))
  state
}

plain_gear <- function(gear) {
  gear$checked <- NULL
  gear
}

# Returns the computed fields of a state: list(gear with its check, si, mesh, velocity, forces).
computed_state <- function(state) {
  handle_value(.subset2(state, "handle"), function() {
    gear <- .subset2(state, "gear")
    gear$checked <- gear_checked(gear)
    si <- first_of(.subset2(state, "si"), gear_si(gear))
    mesh <- mesh_of_recipe(si, .subset2(state, "recipe"), .subset2(state, "position"))
    evaluated(gear, si, mesh, state)
  })
}

# Returns the cached value of a handle, or computes and caches it.
handle_value <- function(handle, compute) {
  value <- engine_handle_value(handle)
  if (is.null(value)) {
    value <- compute()
    engine_fill_handle(handle, value)
  }
  value
}

evaluated <- function(gear, si, mesh, state) {
  position <- .subset2(state, "position")
  velocity <- first_of(.subset2(state, "velocity"), 0 * position)
  found <- engine_evaluate(mesh$model, as.double(position), as.double(velocity))
  three <- function(x) matrix(x, 3L)
  c(
    list(gear = gear, si = si, mesh = mesh, velocity = velocity, force = three(found$force)),
    found[line_fields],
    list(forces = lapply(found$forces, three), boards = found$plates)
  )
}

# Returns positions and forces of a state in the engine's format.
shape_of <- function(state) {
  lapply(setNames(nm = c("position", computed_fields)), function(name) state[[name]])
}

#' @export
`[[.codend_state` <- function(x, i, ...) {
  # the stored gear lacks its check
  value <- if (!identical(i, "gear")) .subset2(x, i)
  if (is.null(value) && i %in% computed_fields) computed_state(x)[[i]] else value
}

line_fields <- paste0(c("bar", "u", "v", "straight"), rep(c("_tension", "_length"), each = 4L))
computed_fields <- c("gear", "si", "mesh", "velocity", "force", line_fields, "forces", "boards")

# Returns the element forces that the engine reports: one row per force with `name`, `kind` of
# element and `cause` ("flow", "ground" or "surface"). `cause`: filter.
reported_forces <- function(cause = NULL) {
  table <- list2DF(engine_forces())
  if (is.null(cause)) table else table[table$cause == cause, ]
}

# Returns the total force from one cause: 3 numbers [N].
total_force <- function(state, cause) {
  rowSums(vapply(state$forces[reported_forces(cause)$name], rowSums, numeric(3)))
}

# Returns the force of the flow on all elements of a kind such as "bars": 3 x elements [N].
flow_force <- function(state, kind) {
  by_flow <- reported_forces("flow")
  Reduce(`+`, state$forces[by_flow$name[by_flow$kind == kind]])
}

# Returns the same for whole cells, including screen and blended forces.
cell_flow_force <- function(state) {
  force <- flow_force(state, "cells")
  for (kind in names(state$mesh$on_cell)) {
    on <- state$mesh$on_cell[[kind]]
    # screen elements between bars come last and belong to no cell
    force[, on] <- force[, on] + flow_force(state, kind)[, seq_along(on)]
  }
  force
}
