# The data of a gear in a shared page: arrays, and input of the page's scripts (web/src/share).

# Returns a list for JSON: `head` and `body` of packed arrays, and input of the scripts. `left_out`
# has the reason for each field without a slider. `misfit` is the largest error of the sliders'
# series.
shared_model <- function(state, fields) {
  measured <- shared_measures(state)
  series <- slider_series(state, fields, measured$standard)
  shape <- with_meshes(scene_shape(state))
  filler <- series$filler
  index <- sort(unique(unlist(lapply(series$terms, `[[`, "index"))))
  touched <- filler$names[unique(as.integer(filler$array[index]))]
  arrays <- c(filler$base, first_shape(state))
  # the page fills only doubles
  arrays[touched] <- lapply(arrays[touched], as.double)
  keep <- function(x) {
    name <- paste0("series/", length(arrays))
    arrays[[name]] <<- x
    name
  }
  scene <- shared_scene(state, shape, keep)
  # positions in the concatenation of the arrays that sliders change
  place <- cumsum(filler$array %in% filler$array[index])
  terms <- lapply(series$terms, function(term) {
    list(of = I(term$of - 1L), nodes = lapply(unname(term$nodes), I),
      index = keep(place[term$index] - 1L), change = keep(as.vector(term$change)))
  })
  packed <- packed_arrays(arrays)
  boards <- state$si$otter_boards
  list(
    head = packed$head, body = packed$body, tolerance = settle_tolerance,
    steps = settle_iterations,
    fields = lapply(unname(series$fields), function(field) {
      list(paths = I(field$paths), whole = field$whole, value = field$value, lower = field$lower,
        upper = field$upper)
    }),
    terms = terms, touched = I(touched), order = measured$order, scene = scene,
    names = I(vapply(gsub("_", " ", state$mesh$parts$name), capital, "", USE.NAMES = FALSE)),
    boards = I(vapply(gsub("_", " ", names(boards)), capital, "", USE.NAMES = FALSE)),
    fallen_heel = fallen_heel, knot = plan_units$speed[["knot"]],
    conditions = list(
      waves = wave_conditions(state), still = still_conditions(state),
      water = state$si$water$density > 0
    ),
    left_out = series$left_out, misfit = series$misfit
  )
}

# Returns the arrays of the shape from which a page starts.
first_shape <- function(state) {
  shape <- state_shape(state)
  # not rounded: from a nearby shape, slack netting may settle in a different shape
  from <- initial_shape(state$si, state$mesh$counts$asked, shape)
  arrays <- flat_arrays(from, "from.")
  arrays[["from.strain"]] <- single_floats(few_figures(shape$strain, 13))
  arrays
}
