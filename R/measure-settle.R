# Settling in the engine (src/engine/measure/settled_gear.hpp): a gear through coarser levels of
# it, or from a shape.

# Settles a gear. from: a shape to begin from, list(lattice, position = 3 x points, strain = of
# every line or NULL, settled = the gear's numbers where it is a balance), or NULL; through_levels:
# whether coarser levels are settled before; beside: NULL, or nodes of lattices: then the gear is
# settled on one more where these say too little of the errors with so many nodes, else NULL is
# returned. Returns list(lattice, position, strain, report, levels = list(nodes, values =
# measures in SI) of the coarser levels).
settle_numbers <- function(si, nodes, netting, from = NULL, through_levels = TRUE,
                           progress = settle_progress(), beside = NULL) {
  asked <- asked_division(si, nodes, netting)
  # where the water alone is another one the lattice is known
  known <- !through_levels && is.null(beside) &&
    identical(asked, from$lattice$counts$asked) && differ_in_conditions(si, from$settled)
  numbers <- numbers_to_settle(si, netting, if (through_levels) asked_of(si))
  report <- engine_settle_gear(
    numbers, asked$nodes, if (!is.null(from)) begun_shape(si, asked, from), through_levels, !known,
    settle_tolerance, settle_iterations, progress,
    function(found) check_lattice(si, found$twine, found$encloses, found$division),
    beside
  )
  if (!length(report)) return(NULL)
  asked$nodes <- report$asked
  if (report$full_bag > 0) abort_catch_volume(si, report$full_bag)
  if (known) {
    lattice <- lattice_in(si, from, report$wake)
    if (!is.null(si$catch)) lattice <- set_catch_front(lattice, report$blocked)
  } else {
    lattice <- new_lattice(si, asked, report$blocked, report$lattice)
  }
  levels <- lapply(report$levels, function(level) {
    list(nodes = level$nodes, values = told_answers(si, level$measures)$values)
  })
  found <- list(
    lattice = lattice, position = report$position, strain = report$strain, levels = levels
  )
  told <- c("position", "strain", "wake", "levels", "lattice", "asked", "blocked", "full_bag")
  c(found, list(report = name_parts(report[setdiff(names(report), told)], lattice)))
}

# The numbers that the engine settles a gear from (src/engine/measure/measured_gear.hpp), with the
# measures that it is asked for.
numbers_to_settle <- function(si, netting, measured) {
  c(lattice_numbers(si, netting), list(
    questions = questions_of(si, list(parts = part_table(si)), measured),
    blocked = planned_front(si), volume = max(0, si$catch$volume, na.rm = TRUE)
  ))
}

# A shape to begin from as the engine reads it, for a gear that is to be divided as asked.
begun_shape <- function(si, asked, from) {
  lattice <- from$lattice
  mesh <- lattice$mesh
  bars <- mesh$bars
  cells <- mesh$cells
  before <- lattice$counts$asked
  list(
    position = as.double(from$position), strain = as.double(from$strain),
    map = part_map(si, lattice),
    lines = list(
      part_count = nrow(lattice$parts), bar_node = bars$node,
      cell_node = cells$node, bar_part = lattice$bar_part, cell_part = lattice$cell_part,
      bar_rest = bars$rest, cell_straight = cells$straight
    ),
    nodes = first_of(before$nodes, 0),
    counts = if (!is.null(before)) lattice$counts[lattice_counts],
    bars = as.logical(before$bars), same_meshes = identical(asked$meshes, before$meshes),
    wake_sheets = mesh$wake_sheets, wake = as.double(mesh$wake),
    blocked = as.double(first_of(lattice$catch$blocked, 0)), settled = !is.null(from$settled),
    drag_growth = drag_growth(si, from$settled)
  )
}
