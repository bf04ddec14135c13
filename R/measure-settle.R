# Runs the engine's solver for a gear (src/engine/measure/settled_gear.hpp).

# Settles a gear through coarser levels or from an initial shape.
#
# `from`: NULL or an initial shape, list(mesh, position = 3 x points, strain, settled).
# Its `strain` covers all lines or is NULL; `settled` is NULL unless the shape is an equilibrium.
# `through_levels`: TRUE to settle coarser levels first.
# `beside`: NULL, or node counts of known meshes. The gear is then settled on one extra mesh if
# these are insufficient for error estimates; otherwise the function returns NULL.
#
# Returns list(mesh, position, strain, report, levels = list of list(nodes, values in SI)).
settle_numbers <- function(si, nodes, netting, from = NULL, through_levels = TRUE,
                           progress = settle_progress(), beside = NULL) {
  asked <- requested_mesh_size(si, nodes, netting)
  # if only the water differs, the mesh stays the same
  known <- !through_levels && is.null(beside) &&
    identical(asked, from$mesh$counts$asked) && differ_in_conditions(si, from$settled)
  numbers <- numbers_to_settle(si, netting, if (through_levels) measure_request(si))
  report <- engine_settle_gear(
    numbers, asked$nodes, if (!is.null(from)) initial_shape(si, asked, from), through_levels,
      !known,
    settle_tolerance, settle_iterations, progress,
    function(found) check_mesh(si, found$twine, found$encloses, found$division),
    beside
  )
  if (!length(report)) return(NULL)
  asked$nodes <- report$asked
  if (report$full_bag > 0) abort_catch_volume(si, report$full_bag)
  if (known) {
    mesh <- mesh_in(si, from, report$wake)
    if (!is.null(si$catch)) mesh <- set_catch_front(mesh, report$blocked)
  } else {
    mesh <- new_mesh(si, asked, report$blocked, report$mesh)
  }
  levels <- lapply(report$levels, function(level) {
    list(nodes = level$nodes, values = valid_answers(si, level$measures)$values)
  })
  found <- list(
    mesh = mesh, position = report$position, strain = report$strain, levels = levels
  )
  told <- c("position", "strain", "wake", "levels", "mesh", "asked", "blocked", "full_bag")
  c(found, list(report = name_parts(report[setdiff(names(report), told)], mesh)))
}

# Returns the numbers of a gear and the requested measures for the engine
# (src/engine/measure/measured_gear.hpp).
numbers_to_settle <- function(si, netting, measured) {
  c(mesh_numbers(si, netting), list(
    questions = questions_of(si, list(parts = part_table(si)), measured),
    blocked = planned_front(si), volume = max(0, si$catch$volume, na.rm = TRUE)
  ))
}

# Returns an initial shape in the engine's format, for a gear with the mesh settings `asked`.
initial_shape <- function(si, asked, from) {
  mesh <- from$mesh
  model <- mesh$model
  bars <- model$bars
  cells <- model$cells
  before <- mesh$counts$asked
  list(
    position = as.double(from$position), strain = as.double(from$strain),
    map = part_map(si, mesh),
    lines = list(
      part_count = nrow(mesh$parts), bar_node = bars$node,
      cell_node = cells$node, bar_part = mesh$bar_part, cell_part = mesh$cell_part,
      bar_rest = bars$rest, cell_straight = cells$straight
    ),
    nodes = first_of(before$nodes, 0),
    counts = if (!is.null(before)) mesh$counts[mesh_counts],
    bars = as.logical(before$bars), same_meshes = identical(asked$meshes, before$meshes),
    wake_sheets = model$wake_sheets, wake = as.double(model$wake),
    blocked = as.double(first_of(mesh$catch$blocked, 0)), settled = !is.null(from$settled),
    drag_growth = drag_growth(si, from$settled)
  )
}
