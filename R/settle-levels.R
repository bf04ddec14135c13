# What settling is held to, and shapes that it begins from.

# Largest net force at the end, as a share of the largest tension, and most steps of a level.
settle_tolerance <- 1e-8
settle_iterations <- 300L

# Nodes, about, of a gear whose plan divides every panel and rope itself; Inf where it leaves one
# open.
fixed_nodes <- function(si, netting) {
  count <- engine_node_counts(gear_numbers(si, netting), 1)
  if (count$divided) sum(count$nodes) else Inf
}

# A gear whose plan says nothing of how finely it is divided. Poles keep their segments: divided
# otherwise a strut would kink.
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

# A solver's report with the names of parts for their numbers; NA for none.
name_parts <- function(report, lattice) {
  for (of in c("worst_part", "rounding_part")) {
    report[[of]] <- lattice$parts$name[replace(report[[of]], report[[of]] == 0L, NA)]
  }
  report
}

# How many times the drag of a gear that was settled (NULL: none) it has at its speed now: drag
# grows with the square of the speed, and most lines pull against drag.
drag_growth <- function(si, settled) {
  speeds <- c(si$towing$speed, settled$towing$speed)
  if (length(speeds) == 2L && all(speeds > 0)) (speeds[1] / speeds[2])^2 else 1
}

# Whether a shape to begin with was settled on the same lattice, whatever its numbers.
settled_alike <- function(lattice, from) {
  same <- function(kind) {
    identical(lattice$mesh[[kind]]$node, from$lattice$mesh[[kind]]$node)
  }
  !is.null(from$settled) && lattice$nodes == from$lattice$nodes && same("bars") && same("cells")
}

# A state's shape, to carry over.
state_shape <- function(state) {
  mesh <- state$lattice$mesh
  cells <- mesh$cells
  strain <- engine_order(
    cells$straight > 0, state$bar_length / mesh$bars$rest - 1, state$u_length / cells$rest - 1,
    state$v_length / cells$rest - 1, state$straight_length / cells$straight - 1
  )
  list(
    lattice = state$lattice, position = state_points(state), strain = strain,
    # at a time of a tow nothing is settled
    settled = if (is.null(state$time)) state$si
  )
}

# Stops unless a state's gear has the parts of this one.
check_same_parts <- function(si, from) {
  check_is_state(from)
  kind <- odd_parts(si, from)
  if (is.null(kind)) return(invisible())
  here <- names(si[[kind]])
  there <- names(from$si[[kind]])
  odd <- c(setdiff(here, there), setdiff(there, here))
  abort_argument(
    "{.arg from} must be a state of a gear with the same {kind}; they differ by {.val {odd}}."
  )
}

# The first kind of parts of which a gear has others than that of a state, or NULL.
odd_parts <- function(si, from) {
  Find(function(kind) !identical(names(si[[kind]]), names(from$si[[kind]])),
    c("ropes", "panels", "points", "otter_boards"))
}
