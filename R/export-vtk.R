# Writes a state as an unstructured grid in VTK's XML format (`.vtu`), or a trajectory as a series
# (`.pvd`) with its grids in a folder of the same name. Returns `file`, invisibly.
write_vtk <- function(x, file) {
  if (inherits(x, "codend_state")) {
    return(write_file(file, function(path) write_state_vtu(x, path)))
  }
  folder <- sub("[.][^.]*$", "", file)
  check_series_folder(folder, file)
  names <- sprintf("%04d.vtu", seq_along(x$time))
  write_file(folder, function(path) {
    dir.create(path)
    for (k in seq_along(x$time)) write_state_vtu(ground_state(x, k), file.path(path, names[k]))
  })
  write_text(c(series_lines(x$time, file.path(basename(folder), names)), ""), file)
}

# A folder may be replaced only if it contains a series and no other files.
check_series_folder <- function(folder, file) {
  if (!file.exists(folder)) return(invisible())
  inside <- list.files(folder, all.files = TRUE, no.. = TRUE)
  if (!dir.exists(folder) || !all(grepl("^[0-9]+[.]vtu$", inside))) {
    abort_file(file, "needs an empty folder {.file {folder}} for its grids; it has other files.",
      folder = folder)
  }
}

series_lines <- function(time, files) {
  c(
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
    "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">", "<Collection>",
    sprintf("<DataSet timestep=\"%.15g\" part=\"0\" file=\"%s\"/>", time, escape_markup(files)),
    "</Collection>", "</VTKFile>"
  )
}

# Returns the state at the k-th saved time with positions and forces in ground axes. Measures remain
# as seen from the vessel.
ground_state <- function(trajectory, k) {
  state <- state_at(trajectory, trajectory$time[k])
  state$measured <- measures(state)
  turn <- t(to_vessel(trajectory$conditions$course[k]))
  state$force <- turn %*% state$force
  state$forces <- lapply(state$forces, function(force) turn %*% force)
  state$position <- trajectory$position[, , k]
  state$velocity <- trajectory$velocity[, , k]
  state
}

utf8_bytes <- function(text) charToRaw(enc2utf8(paste(text, collapse = "\n")))

write_state_vtu <- function(state, path) {
  points <- state_points(state)
  corners <- board_corners(state)
  grid <- vtk_cells(state, ncol(points))
  parts <- state$mesh$parts
  part <- grid$data$part
  cell_data <- c(
    list(
      part = part,
      kind = as.raw(match(parts$kind, c("rope", "netting", "piece"), 4L)[part])
    ),
    grid$data[names(grid$data) != "part"]
  )
  measured <- if (is.null(state$measured)) measures(state) else state$measured
  field_data <- c(
    as.list(measured),
    list(part_names = utf8_bytes(parts$name), plan = utf8_bytes(format(state$gear))),
    if (!is.null(state$time)) list(TimeValue = state$time)
  )
  write_vtu(path, cbind(points, corners), grid$cells,
    vtk_point_data(state, points, ncol(corners)), cell_data, field_data)
}

vtk_point_data <- function(state, points, corners) {
  model <- state$mesh$model
  n <- model$nodes
  none <- ncol(points) - n + corners
  filled <- function(vectors) cbind(vectors, matrix(0, 3L, none))
  knots <- which(state$mesh$parts$kind[state$mesh$sphere_part] == "netting")
  c(
    list(
      depth_m = 0 - c(points[3L, ], board_corners(state)[3L, ]), force_N = filled(state$force),
      held = c(model$held, logical(none))
    ),
    if (length(knots)) {
      drag <- sum_by_part(
        flow_force(state, "spheres")[, knots, drop = FALSE], model$spheres$node[knots],
        ncol(points) + corners
      )
      list(knot_drag_N = drag)
    },
    if (!is.null(state$time)) list(velocity_m_per_s = filled(state$velocity))
  )
}

# Returns list(cells (for `write_vtu()`), data). points: number of points, which the boards' corners
# follow, four each.
vtk_cells <- function(state, points) {
  mesh <- state$mesh
  model <- mesh$model
  pieces <- vtk_pieces(state)
  boards <- length(state$si$otter_boards)
  # A board is drawn as its plate, without its struts.
  bar <- which(mesh$parts$kind[mesh$bar_part] != "piece")
  ends <- matrix(model$bars$node, 2L)[, bar]
  netting <- cell_corners(mesh)
  corners <- 4L - has_three_corners(netting)
  cells <- ncol(netting)
  hexagonal <- model$cells$straight > 0
  count <- c(line = length(bar), cell = cells, vertex = length(pieces$node), quad = boards)
  spread <- function(bars = NaN, cells = NaN, rest = NaN) {
    c(rep_len(bars, count[1L]), rep_len(cells, count[2L]), rep_len(rest, sum(count[3:4])))
  }
  families <- 2 + hexagonal
  straight <- ifelse(hexagonal, state$straight_tension, NaN)
  slack <- (state$u_tension == 0) + (state$v_tension == 0) +
    (hexagonal & state$straight_tension == 0)
  zero <- function(n) matrix(0, 3L, n)
  data <- list(
    part = c(mesh$bar_part[bar], mesh$cell_part, pieces$part, mesh$board_part),
    tension_N = spread(
      state$bar_tension[bar], pmax(state$u_tension, state$v_tension, straight, na.rm = TRUE)
    )
  )
  if (cells) {
    data$u_tension_N <- spread(cells = state$u_tension)
    data$v_tension_N <- spread(cells = state$v_tension)
  }
  if (any(hexagonal)) data$straight_tension_N <- spread(cells = straight)
  data$lines <- spread(
    model$bars$multiplicity[bar], if (cells) model$frame$cells$bars, 0
  )
  data$slack <- spread(as.double(state$bar_tension[bar] == 0), slack / families, 0)
  data$drag_N <- cbind(flow_force(state, "bars")[, bar], cell_flow_force(state), pieces$force,
    flow_force(state, "plates"))
  if (!is.null(state$si$catch)) {
    on <- !is.na(mesh$catch$cell)
    data$catch_force_N <- cbind(
      zero(count[1L]), sum_by_part(
        flow_force(state, "pressure")[, on, drop = FALSE], mesh$catch$cell[on], cells
      ),
      zero(sum(count[3:4]))
    )
  }
  list(
    cells = list(
      corners = c(
        ends, netting[1:4 <= rep(corners, each = 4L)], pieces$node, points + seq_len(4L * boards)
      ),
      size = c(rep(2L, count[1L]), corners, rep(c(1L, 4L), count[3:4])),
      type = c(
        rep("line", count[1L]), ifelse(corners == 4L, "quad", "triangle"),
        rep(c("vertex", "quad"), count[3:4])
      )
    ),
    data = data
  )
}

# Returns the pieces, one row per piece and node: list(part, node, force = 3 x rows, N).
vtk_pieces <- function(state) {
  mesh <- state$mesh
  sphere <- which(mesh$parts$kind[mesh$sphere_part] == "piece")
  part <- mesh$sphere_part[sphere]
  node <- mesh$model$spheres$node[sphere]
  force <- flow_force(state, "spheres")[, sphere, drop = FALSE]
  at <- match(paste(mesh$lift_part, mesh$model$lifts$node), paste(part, node))
  force[, at] <- force[, at] + flow_force(state, "lifts")
  list(part = part, node = node, force = force)
}
