# Limits of the solver and initial shapes.

# Largest residual relative to the largest tension, and maximum number of iterations per level.
settle_tolerance <- 1e-8
settle_iterations <- 800L

# Returns the approximate number of nodes if the plan prescribes the mesh of every part; else Inf.
fixed_nodes <- function(si, netting) {
  count <- engine_node_counts(gear_numbers(si, netting), 1)
  if (count$divided) sum(count$nodes) else Inf
}

# Removes the mesh settings of a plan. Poles keep their segments, because a strut with other
# segments would kink.
undivided <- function(si) {
  si$ropes <- lapply(si$ropes, function(rope) {
    if (!rope$strut) rope["segments"] <- list(NULL)
    rope
  })
  si$panels <- lapply(si$panels, function(panel) {
    panel[c("columns", "rows")] <- list(NULL)
    panel
  })
  si
}

# Replaces part numbers in a solver's report by names; 0 becomes NA.
name_parts <- function(report, mesh) {
  for (of in c("worst_part", "rounding_part")) {
    report[[of]] <- mesh$parts$name[replace(report[[of]], report[[of]] == 0L, NA)]
  }
  report
}

# Returns the ratio of the drag at the present speed to the drag of the settled gear. Drag grows
# with speed squared, and most line tensions follow it.
drag_growth <- function(si, settled) {
  speeds <- c(si$towing$speed, settled$towing$speed)
  if (length(speeds) == 2L && all(speeds > 0)) (speeds[1] / speeds[2])^2 else 1
}

# TRUE if an initial shape was settled on the same mesh; element properties may differ.
has_same_mesh <- function(mesh, from) {
  same <- function(kind) {
    identical(mesh$model[[kind]]$node, from$mesh$model[[kind]]$node)
  }
  !is.null(from$settled) && mesh$nodes == from$mesh$nodes && same("bars") && same("cells")
}

state_shape <- function(state) {
  model <- state$mesh$model
  cells <- model$cells
  strain <- engine_order(
    cells$straight > 0, state$bar_length / model$bars$rest - 1, state$u_length / cells$rest - 1,
    state$v_length / cells$rest - 1, state$straight_length / cells$straight - 1
  )
  list(
    mesh = state$mesh, position = state_points(state), strain = strain,
    # a moment of a tow is not an equilibrium
    settled = if (is.null(state$time)) state$si
  )
}

# Stops unless both gears have the same parts.
check_same_parts <- function(si, from) {
  check_is_state(from, "from")
  kind <- odd_parts(si, from)
  if (is.null(kind)) return(invisible())
  here <- names(si[[kind]])
  there <- names(from$si[[kind]])
  odd <- c(setdiff(here, there), setdiff(there, here))
  abort_argument(
    "{.arg from} must be a state of a gear with the same {kind}; the differences are {.val {odd}}."
  )
}

# Returns the first kind of parts that differs between a gear and a state, or NULL.
odd_parts <- function(si, from) {
  Find(function(kind) !identical(names(si[[kind]]), names(from$si[[kind]])),
    c("ropes", "panels", "points", "otter_boards"))
}
