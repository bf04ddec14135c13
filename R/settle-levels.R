# Coarse to fine: a gear is settled with few nodes first, and each shape, carried to a finer
# lattice, is the start of the next.

# How many times as many nodes the next finer level has, and how many the coarsest.
level_ratio <- 7
coarsest_nodes <- 250
# Largest net force at the end, as a share of the largest tension, and most steps of a level.
settle_tolerance <- 1e-8
settle_iterations <- 300L

# The settled shape of the next coarser level, list(lattice, position = 3 x points, strain = of
# every line or NULL, si, coarser = the same of the level before or NULL), or `found`, a shape to
# begin with or NULL, where there is none. levels: nodes of the coarser levels, or NULL.
coarse_shape <- function(si, nodes, netting, progress, found = NULL, levels = NULL) {
  free <- undivided(si)
  nodes <- min(nodes, fixed_nodes(si, netting))
  if (is.null(levels)) levels <- if (length(si$panels)) coarse_levels(nodes) else nodes / 4
  for (level in levels) {
    coarse <- settle_level(
      free, level, if (level == coarsest_nodes) "cells" else netting, found, progress
    )
    if (!coarse$report$converged) next
    found <- list(
      lattice = coarse$lattice, position = lattice_points(coarse$lattice, coarse$position),
      # The coarsest lattice's are of no use.
      strain = if (level > coarsest_nodes) coarse$strain,
      si = free, coarser = if (!is.null(found$si)) found
    )
  }
  found
}

# Nodes of the levels below `nodes`, rising. Where the coarsest would be the only one and far off a
# second stands between: from the coarsest alone errors are told two to ten times too large, or, of
# what hardly changes by chance, too small.
coarse_levels <- function(nodes) {
  between <- nodes / level_ratio^seq_len(ceiling(log(nodes, level_ratio)))
  between <- between[between > 2 * coarsest_nodes]
  if (!length(between) && nodes >= 4 * coarsest_nodes) between <- sqrt(nodes * coarsest_nodes)
  c(if (nodes > 2 * coarsest_nodes) coarsest_nodes, rev(between))
}

# Nodes, about, of a gear whose plan divides every panel and rope itself; Inf where it leaves one
# open.
fixed_nodes <- function(si, netting) {
  open <- function(parts, ...) {
    any(vapply(parts, function(part) all(vapply(part[c(...)], is.null, NA)), NA))
  }
  own <- Filter(function(rope) is.null(rope$along) && !length(rope$through), si$ropes)
  if (open(own, "segments") || open(si$panels, "columns", "rows")) return(Inf)
  count <- engine_node_counts(gear_numbers(si, netting), 1)
  if (count$divided) sum(count$nodes) else Inf
}

# A gear whose plan says nothing of how finely it is divided. Poles keep their segments: divided
# otherwise a strut would kink.
undivided <- function(si) {
  si$ropes <- lapply(si$ropes, function(rope) {
    if (!rope$strut) rope$segments <- NULL
    rope
  })
  si$panels <- lapply(si$panels, function(panel) {
    panel$columns <- panel$rows <- NULL
    panel
  })
  si
}

# Settles one lattice: list(lattice, position, strain, report, from). from: a shape to carry over,
# or NULL; one that was settled on the same lattice is given up where it does not lead to balance
# at once.
settle_level <- function(si, nodes, netting, from, progress) {
  # A coarser level that is still to be settled is not of this one's time.
  force(from)
  started <- cpu_clock()
  lattice <- build_lattice(si, nodes, netting, from)
  begins <- if (is.null(from)) "crude" else if (settled_alike(lattice, from)) "settled" else "near"
  # The factors lie outside R's heap: nothing else makes R release what building left over.
  if (lattice$nodes > 1e5) gc(verbose = FALSE)
  seconds_lattice <- cpu_clock() - started
  strain <- if (!is.null(from$strain)) {
    drag_growth(si, from$settled) *
      carry_strains(panel_table(si$panels), lattice, from$lattice, from$strain)
  }
  solve <- function(lattice, from = NULL) {
    if (is.null(from)) from <- list(position = lattice$start, begins = begins, strain = strain)
    engine_settle(
      lattice$engine, as.double(from$position), first_of(from$begins, "settled"),
      as.double(from$strain), line_part(lattice), settle_tolerance, settle_iterations, progress
    )
  }
  settled <- if (is.null(si$catch) || is.na(si$catch$volume)) {
    list(lattice = lattice, report = solve(lattice))
  } else {
    if (!is.null(from)) lattice <- set_catch_front(lattice, from$lattice$catch$blocked)
    settle_catch(si, lattice, solve)
  }
  report <- settled$report
  found <- list(lattice = settled$lattice, position = report$position, strain = report$strain)
  found$lattice$engine$wake <- report$wake
  report$position <- report$strain <- report$wake <- NULL
  report$seconds_lattice <- seconds_lattice
  report <- name_parts(report, found$lattice)
  c(found, list(report = report, from = from))
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
    identical(lattice$engine[[kind]]$node, from$lattice$engine[[kind]]$node)
  }
  !is.null(from$settled) && lattice$nodes == from$lattice$nodes && same("bars") && same("cells")
}

# A state's shape, to carry over.
state_shape <- function(state) {
  engine <- state$lattice$engine
  cells <- engine$cells
  strain <- engine_order(
    state$lattice, state$bar_length / engine$bars$rest - 1, state$u_length / cells$rest - 1,
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
