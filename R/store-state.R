# A state on disk: NetCDF in the classic format, with the names and units of a trajectory's file.

#' States in files
#'
#' A state as a NetCDF file with names and units of the CF conventions, which most languages and
#' tools read. [read_state()] gives the same state back, to the last bit: to look at it later, or to
#' settle another design from it.
#'
#' @details
#' Dimensions are `node`, `bar`, `cell` and `part`. Per node there are `x`, `y`, `z` (m; x aft,
#' y to starboard, z up from the water surface), `x_force`, `y_force`, `z_force` (N, the net force:
#' on a held node the opposite of its support's), `held` and, of a state from a tow, velocities; per
#' bar `bar_tension` (N, of one line); per cell of netting `u_tension` and `v_tension` (N, of
#' one twine). `bar_node` and `cell_node` say which nodes they join, counted from 1, `bar_part`
#' and `cell_part` which of the parts in `part_name` they belong to. Numbers above that of the
#' last node are points that hang between two nodes. Per part there are `part_drag`, `part_side` and
#' `part_lift` (kN, hydrodynamic force along the flow, to starboard of it and up). Every measure is
#' a number of its own, under its name. The attribute `plan` is the gear's plan as text.
#'
#' What is named `kept_` serves [read_state()] alone: plain data that the model is put together
#' from. Reading evaluates nothing. The file ends in a checksum of all bytes before it; one that was
#' cut short or changed is an error of class `codend_error_file`, and so is one of an older format.
#'
#' NetCDF takes the package RNetCDF.
#'
#' A name that ends in `.json` gives the same numbers, with the measures, their errors and the plan,
#' as JSON by the schema `system.file("schema", "state.schema.json", package = "codend")`: for
#' languages without a reader of NetCDF. `read_state()` reads NetCDF alone.
#'
#' @param state A state, from [settle()] or [state_at()].
#' @param file Path of the file, ending in `.nc` or, for `write_state()`, `.json`. It is written
#'   whole or not at all.
#' @return `write_state()` gives `file`, invisibly; `read_state()` a state as [settle()] returns. A
#'   file that cannot be read or written is an error of class `codend_error_file`; a missing
#'   RNetCDF one of class `codend_error_package`.
#' @seealso [write_trajectory()] for tows, [write_vtk()] and [write_gltf()] for other programs.
#' @export
#' @examplesIf requireNamespace("RNetCDF", quietly = TRUE)
#' file <- tempfile(fileext = ".nc")
#' write_state(settle("towed_cable"), file)
#' faster <- update(read_gear("towed_cable"), towing.speed = "5 knot")
#' settle(faster, from = read_state(file))
write_state <- function(state, file) {
  check_given("state", "file")
  check_is_state(state)
  if (check_file_path(file, c(".nc", ".json")) == ".json") {
    return(write_file(file, function(path) write_state_json(state, path)))
  }
  check_netcdf()
  write_kept(file, function(nc) {
    numbers <- c(state_numbers(state), measure_numbers(state))
    numbers <- Filter(function(number) length(number$value) > 0L, numbers)
    lattice <- state$lattice
    sizes <- c(bar = length(lattice$bar_part), cell = length(lattice$cell_part))
    define_file(nc, numbers, sizes, lattice, state$gear,
      paste0(state$gear$plan$name, ", ", state_conditions(state)), "state", state_file_version)
    for (name in names(numbers)) put(nc, name, numbers[[name]]$value)
  })
}

#' @rdname write_state
#' @export
read_state <- function(file) {
  check_given("file")
  nc <- open_kept(file, "state", state_file_version)
  read_kept(nc, file, function(get) {
    what <- read_kept_numbers(get)
    places <- function(names) do.call(rbind, lapply(names, function(name) as.vector(get(name))))
    names <- rownames(node_variables)
    position <- as.vector(places(names[1:3]))
    velocity <- as.vector(places(names[4:6]))
    if (!length(velocity)) velocity <- numeric(length(position))
    sizes <- c(length(position), length(velocity)) == 3L * what$lattice$engine$nodes
    if (!all(sizes) || !all(is.finite(c(position, velocity)))) {
      stop("its places do not fit its model")
    }
    state <- new_state(what$gear, what$si, what$lattice, position, what$report, velocity,
      changed = !is.null(what$time))
    for (name in c("time", "compared", "step_accuracy")) state[[name]] <- what[[name]]
    if (length(what$levels)) state$levels <- new_levels(what$levels, complete = TRUE)
    state
  })
}

# Format 1 held objects of R.
state_file_version <- 7L

# The variables of a state's file, by name.
state_numbers <- function(state) {
  real <- function(value, across, unit, words) {
    file_variable("NC_DOUBLE", across, words, unit, value)
  }
  axis <- c("x", "y", "z")
  place <- c("place aft", "place to starboard", "height above the water surface")
  way <- c("aft", "to starboard", "upward")
  vectors <- lapply(1:3, function(k) {
    found <- list(
      real(state$position[k, ], "node", "m", place[k]),
      real(state$force[k, ], "node", "N", paste("net force", way[k])),
      real(if (!is.null(state$time)) state$velocity[k, ], "node", "m s-1",
        paste("velocity", way[k], "relative to the vessel"))
    )
    setNames(found, paste0(axis[k], c("", "_force", "_velocity")))
  })
  drag <- drag_table(state)
  kept <- list(
    gear = state$gear, si = state$si, lattice = state$lattice, report = state$report,
    time = state$time, compared = state$compared, step_accuracy = state$step_accuracy,
    levels = levels_of(state, plain_measures(measures(state)))
  )
  c(
    do.call(c, vectors),
    list(
      held = file_variable("NC_INT", "node", "1 where a node is held",
        value = as.integer(state$lattice$engine$held)),
      bar_tension = real(state$bar_tension, "bar", "N", "tension of one line"),
      u_tension = real(state$u_tension, "cell", "N", "tension of one twine along u"),
      v_tension = real(state$v_tension, "cell", "N", "tension of one twine along v"),
      part_drag = real(drag$drag_kN, "part", "kN", "hydrodynamic force along the flow"),
      part_side = real(drag$side_kN, "part", "kN",
        "hydrodynamic force to starboard of the flow"),
      part_lift = real(drag$lift_kN, "part", "kN", "hydrodynamic force upward")
    ),
    model_variables(state$lattice), kept_numbers(kept)
  )
}

measure_numbers <- function(state) {
  found <- measures(state)
  said <- measure_words(found)
  lapply(setNames(seq_along(found), names(found)), function(k) {
    file_variable("NC_DOUBLE", character(), said$words[k], cf_unit(said$unit[k]), found[[k]])
  })
}
