# What a shared page holds of a gear: its arrays, and what the page's scripts (inst/share) read of
# them.

# A state with sliders, as list(head = what of the arrays is where, body = their bytes as text, and
# what the scripts take), which becomes JSON; left_out: words of sliders that do not fit, by field;
# misfit: how far series of sliders are from lattices.
shared_model <- function(state, fields) {
  measured <- shared_measures(state)
  series <- slider_series(state, fields, measured$standard)
  shape <- with_meshes(scene_shape(state))
  arrays <- series$base
  keep <- function(x) {
    name <- paste0("series/", length(arrays))
    arrays[[name]] <<- x
    name
  }
  scene <- shared_scene(state, shape, keep)
  terms <- lapply(series$terms, function(term) {
    list(
      of = I(term$of - 1L), array = term$array, index = keep(term$index),
      pattern = keep(as.vector(term$pattern)), series = keep(as.vector(term$series)),
      rows = nrow(term$series), columns = ncol(term$series)
    )
  })
  shape_now <- state_shape(state)
  arrays <- c(arrays, list(
    # exact: from a start close to it slack netting may settle otherwise
    "start/position" = as.double(state$position),
    "start/strain" = single_floats(few_figures(shape_now$strain, 13)),
    "start/part" = line_part(state$lattice) - 1L
  ))
  wake <- state$lattice$mesh$wake
  if (length(wake)) arrays[["start/wake"]] <- as.double(wake)
  # what a page fills is a double
  for (name in unique(vapply(terms, `[[`, "", "array"))) arrays[[name]] <- as.double(arrays[[name]])
  packed <- packed_arrays(arrays)
  boards <- state$si$otter_boards
  list(
    head = packed$head, body = packed$body, nodes = state$lattice$nodes,
    tolerance = settle_tolerance, steps = settle_iterations,
    fields = lapply(series$fields, told_field), terms = terms,
    programs = measured$programs, order = I(names(measured$programs)), scene = scene,
    bag = if (!is.null(state$si$catch)) if (is.na(state$si$catch$volume)) "front" else "volume",
    names = I(vapply(gsub("_", " ", state$lattice$parts$name), capital, "", USE.NAMES = FALSE)),
    boards = I(vapply(gsub("_", " ", names(boards)), capital, "", USE.NAMES = FALSE)),
    fallen_heel = fallen_heel, knot = plan_units$speed[["knot"]],
    conditions = list(
      waves = wave_conditions(state), still = still_conditions(state),
      water = state$si$water$density > 0
    ),
    left_out = series$left_out, misfit = series$misfit
  )
}

told_field <- function(field) {
  list(
    name = field$name, label = field$label, unit = field$unit, whole = field$whole,
    value = field$value, lower = field$lower, upper = field$upper, step = slider_step(field)
  )
}
