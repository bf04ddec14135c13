# What a shared page holds of a gear: its arrays, and what the page's scripts (inst/share) read of
# them.

# A state with sliders, as list(head = what of the arrays is where, body = their bytes as text, and
# what the scripts take), which becomes JSON; left_out: words of sliders that do not fit, by field;
# misfit: how far series of sliders are from the plan.
shared_model <- function(state, fields) {
  measured <- shared_measures(state)
  series <- slider_series(state, fields, measured$standard)
  shape <- with_meshes(scene_shape(state))
  filler <- series$filler
  index <- sort(unique(unlist(lapply(series$terms, `[[`, "index"))))
  touched <- filler$names[unique(as.integer(filler$array[index]))]
  arrays <- c(filler$base, first_shape(state))
  # what a page fills is a double
  arrays[touched] <- lapply(arrays[touched], as.double)
  keep <- function(x) {
    name <- paste0("series/", length(arrays))
    arrays[[name]] <<- x
    name
  }
  scene <- shared_scene(state, shape, keep)
  # a page has the arrays that sliders touch one after the other
  place <- cumsum(filler$array %in% filler$array[index])
  terms <- lapply(series$terms, function(term) {
    list(of = I(term$of - 1L), sizes = I(term$sizes), index = keep(place[term$index] - 1L),
      series = keep(as.vector(term$series)))
  })
  packed <- packed_arrays(arrays)
  boards <- state$si$otter_boards
  list(
    head = packed$head, body = packed$body, nodes = state$lattice$nodes,
    tolerance = settle_tolerance, steps = settle_iterations,
    fields = lapply(series$fields, told_field), terms = terms, touched = I(touched),
    programs = measured$programs, order = I(names(measured$programs)), scene = scene,
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

# The arrays of a state's shape that a page begins from.
first_shape <- function(state) {
  shape <- state_shape(state)
  # exact: from a start close to it slack netting may settle otherwise
  from <- begun_shape(state$si, state$lattice$counts$asked, shape)
  arrays <- flat_arrays(from, "from.")
  arrays[["from.strain"]] <- single_floats(few_figures(shape$strain, 13))
  arrays
}

told_field <- function(field) {
  list(
    name = field$name, label = field$label, unit = field$unit, whole = field$whole,
    value = field$value, lower = field$lower, upper = field$upper, step = slider_step(field)
  )
}
