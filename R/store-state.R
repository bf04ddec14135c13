# States as NetCDF (classic format), with the same names and units as trajectories.

write_state <- function(state, file) {
  check_netcdf()
  numbers <- c(state_numbers(state), measure_numbers(state), restored_variables(state))
  numbers <- Filter(function(number) length(number$value) > 0L, numbers)
  mesh <- state$mesh
  sizes <- c(bar = length(mesh$bar_part), cell = length(mesh$cell_part))
  title <- paste0(state$gear$plan$name, ", ", state_conditions(state))
  write_file(file, function(path) {
    fill_netcdf(path, function(nc) {
      define_file(nc, numbers, sizes, mesh, state$gear, title, "state")
      for (name in names(numbers)) put(nc, name, numbers[[name]]$value)
    })
    seal_file(path)
  })
}

read_state <- function(nc, file) {
  read_saved(nc, file, function(get) {
    what <- read_saved_variables(get)
    places <- function(names) do.call(rbind, lapply(names, function(name) as.vector(get(name))))
    names <- rownames(node_variables)
    position <- as.vector(places(names[1:3]))
    velocity <- as.vector(places(names[4:6]))
    if (!length(velocity)) velocity <- numeric(length(position))
    mesh <- mesh_of_recipe(what$si, what$recipe, position)
    sizes <- c(length(position), length(velocity)) == 3L * mesh$nodes
    if (!all(sizes) || !all(is.finite(c(position, velocity)))) {
      stop("its positions do not fit its model")
    }
    state <- new_state(what$gear, what$si, mesh, position, what$report, velocity)
    for (name in c("time", "compared", "step_accuracy")) state[[name]] <- what[[name]]
    if (length(what$levels)) state$levels <- new_levels(what$levels, complete = TRUE)
    state
  })
}

# Returns the variables of nodes, elements and parts.
state_numbers <- function(state) {
  real <- function(value, across, unit, words) {
    file_variable("NC_DOUBLE", across, words, unit, value)
  }
  axis <- c("x", "y", "z")
  place <- c("position aft", "position to starboard", "height above the water surface")
  way <- c("aft", "to starboard", "upward")
  vectors <- lapply(1:3, function(k) {
    found <- list(
      real(state$position[k, ], "node", "m", place[k]),
      real(state$force[k, ], "node", "N", paste("net force", way[k])),
      real(if (!is.null(state$time)) state$velocity[k, ], "node", "m s-1",
        paste("velocity", way[k], "relative to the vessel"))
    )
    setNames(found, paste0(axis[k], c("_m", "_force_N", "_velocity_m_per_s")))
  })
  drag <- part_force_table(state)
  c(
    do.call(c, vectors),
    list(
      held = file_variable("NC_INT", "node", "1 where a node is held",
        value = as.integer(state$mesh$model$held)),
      bar_tension_N = real(state$bar_tension, "bar", "N", "tension of one line"),
      u_tension_N = real(state$u_tension, "cell", "N", "tension of one twine along u"),
      v_tension_N = real(state$v_tension, "cell", "N", "tension of one twine along v"),
      straight_tension_N = real(state$straight_tension[has_straight_bars(state$mesh)],
        "hexagonal_cell", "N", "tension of one straight bar"),
      drag_kN = real(drag$drag_kN, "part", "kN", "hydrodynamic force along the flow"),
      side_kN = real(drag$side_kN, "part", "kN", "hydrodynamic force to starboard of the flow"),
      lift_kN = real(drag$lift_kN, "part", "kN", "hydrodynamic force upward"),
      weight_in_water_kN = real(drag$weight_in_water_kN, "part", "kN", "weight minus buoyancy")
    ),
    model_variables(state$mesh)
  )
}

# Returns variables that read_state() needs to restore the state exactly.
restored_variables <- function(state) {
  plain <- c("si", "recipe", "report", "time", "compared", "step_accuracy")
  saved_variables(c(
    Filter(Negate(is.null), lapply(setNames(nm = plain), function(name) .subset2(state, name))),
    list(gear = state$gear, levels = levels_of(state, plain_measures(measures(state))))
  ))
}

# Returns the measures as variables, with their errors.
measure_numbers <- function(state) {
  found <- measures(state)
  said <- measure_labels(found)
  lapply(setNames(seq_along(found), names(found)), function(k) {
    file_variable("NC_DOUBLE", character(), said$words[k], cf_unit(said$unit[k]), found[[k]],
      attr(found, "error")[[k]])
  })
}
