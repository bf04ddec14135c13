# A crude first shape, so that nobody gives coordinates.
#
# The gear is divided as coarsely as its seams allow. On that skeleton ropes and the lengthwise
# lines of panels are strings, the crosswise lines weak strings, pulled by weight, lift and a rough
# drag; the engine finds string tensions that bring the lengths near their own (force densities,
# H.-J. Schek, Comput. Methods Appl. Mech. Eng. 3:115, 1974). The lattice's nodes are then placed on
# the skeleton by their mesh coordinates.
#
# frame: the division's frame, where it was made for triangles all over; else the skeleton's is new.
lay_out <- function(si, division, lattice, panels, chains, frame = NULL) {
  no_bars <- logical(length(si$panels))
  if (is.null(frame)) frame <- division_frame(chains, linked = !no_bars)
  own <- vapply(si$ropes, function(rope) is.null(rope$along), NA)
  skeleton <- divide(si, frame, rep.int(1L, length(frame$pieces$edge)), as.integer(own), no_bars)
  place <- skeleton_positions(si, skeleton, panels)

  start <- matrix(NA_real_, 3L, lattice$engine$nodes)
  on_ropes <- along_skeleton(rope_runs(division$ropes), rope_runs(skeleton$ropes))
  start[, on_ropes$node] <- between_places(place, on_ropes)
  on_panels <- over_skeleton(panel_places(panels, division, lattice$panels), skeleton)
  start[, on_panels$node] <- inside_cells(place, on_panels)
  start[, division$points] <- place[, skeleton$points]
  start
}

# Nodes of all ropes, one rope after the other, as those of edges (see divide()).
rope_runs <- function(ropes) {
  count <- as.integer(lengths(lapply(ropes, `[[`, "node")))
  list(
    node = as.integer(unlist(lapply(ropes, `[[`, "node"))),
    fraction = as.double(unlist(lapply(ropes, `[[`, "at"))),
    count = count, before = cumsum(count) - count
  )
}

# Nodes of ropes on the skeleton: list(node, from, to = nodes of the skeleton on both sides, share).
along_skeleton <- function(ropes, skeleton) {
  at <- ropes$fraction
  cell <- cell_of(at, rep.int(seq_along(ropes$count), ropes$count), skeleton)
  low <- skeleton$fraction[cell]
  high <- skeleton$fraction[cell + 1L]
  share <- (at - low) / (high - low)
  share[at <= low] <- 0
  share[at >= high] <- 1
  list(node = ropes$node, from = skeleton$node[cell], to = skeleton$node[cell + 1L], share = share)
}

between_places <- function(place, on) {
  from <- place[, on$from, drop = FALSE]
  to <- place[, on$to, drop = FALSE]
  found <- from + (to - from) * rep(on$share, each = 3L)
  found[, on$share == 1] <- to[, on$share == 1]
  found
}

# Where the nodes of panels lie on them: list(node, panel, s, t), s and t fractions across and deep.
panel_places <- function(panels, division, drawn) {
  bars <- vapply(drawn, function(panel) panel$netting == "bars", NA)
  panel <- rep.int(seq_along(bars), ifelse(bars, 0L, lengths(division$grids)))
  grid <- as.integer(unlist(division$grids))
  columns <- division$count[4L * panel - 3L]
  k <- sequence(lengths(division$grids[!bars])) - 1L
  on_grids <- list(
    node = grid, panel = panel,
    s = division$fraction[division$before[4L * panel - 3L] + k %% columns + 1L],
    t = division$fraction[division$before[4L * panel - 1L] + k %/% columns + 1L]
  )
  if (!any(bars)) return(on_grids)

  edge <- rep.int(seq_along(division$count), division$count)
  panel <- (edge - 1L) %/% 4L + 1L
  of_bars <- bars[panel]
  side <- ((edge - 1L) %% 4L + 1L)[of_bars]
  f <- division$fraction[of_bars]
  on_edges <- list(
    node = division$edge_node[of_bars], panel = panel[of_bars],
    s = ifelse(side <= 2L, f, side - 3), t = ifelse(side <= 2L, side - 1, f)
  )

  field <- function(name) unlist(lapply(drawn[bars], `[[`, name), use.names = FALSE)
  node <- field("node")
  own <- node > division$nodes
  panel <- rep.int(which(bars), lengths(lapply(drawn[bars], `[[`, "node")))[own]
  j <- field("j")[own]
  shape <- pick_panels(panels, panel, side_fields)
  left <- panel_left(shape, j)
  width <- panel_right(shape, j) - left
  width[width < 1e-9] <- 1e-9
  s <- (field("i")[own] - left) / width
  s[s < 0] <- 0
  s[s > 1] <- 1
  inside <- list(node = node[own], panel = panel, s = s, t = j / shape$deep)
  mapply(c, on_grids, on_edges, inside, SIMPLIFY = FALSE)
}

# Places on the skeleton: list(node, a, b, c, d = the corners of its cell, the skeleton's nodes at
# (0, 0), (1, 0), (0, 1) and (1, 1) of it; s, t = fractions of the cell).
over_skeleton <- function(places, skeleton) {
  upper <- 4L * places$panel - 3L
  left <- upper + 2L
  column <- cell_of(places$s, upper, skeleton)
  row <- cell_of(places$t, left, skeleton)
  grid <- unlist(skeleton$grids)
  columns <- skeleton$count[upper]
  size <- lengths(skeleton$grids)
  corner <- (cumsum(size) - size)[places$panel] +
    (row - skeleton$before[left] - 1L) * columns + column - skeleton$before[upper]
  share <- function(x, cell) {
    low <- skeleton$fraction[cell]
    (x - low) / (skeleton$fraction[cell + 1L] - low)
  }
  list(
    node = places$node, a = grid[corner], b = grid[corner + 1L], c = grid[corner + columns],
    d = grid[corner + columns + 1L], s = share(places$s, column), t = share(places$t, row)
  )
}

# Bilinear positions (3 x n).
inside_cells <- function(place, on) {
  weigh <- function(corner, w) place[, corner, drop = FALSE] * rep(w, each = 3L)
  weigh(on$a, (1 - on$s) * (1 - on$t)) + weigh(on$b, on$s * (1 - on$t)) +
    weigh(on$c, (1 - on$s) * on$t) + weigh(on$d, on$s * on$t)
}

# Positions (3 x n) of the skeleton's nodes.
skeleton_positions <- function(si, skeleton, panels) {
  supports <- gear_supports(si, skeleton)
  strings <- skeleton_strings(si, skeleton, panels)
  load <- skeleton_load(si, skeleton, panels, supports$load)
  # Nothing pulls on a weightless gear at rest: let it hang.
  total <- max(sqrt(colSums(load^2)), 1e-9)
  load[3, ] <- load[3, ] - 1e-3 * total * !supports$held
  keep <- strings$first != strings$second & strings$rest > 0
  ends <- rbind(strings$first, strings$second)[, keep, drop = FALSE]
  found <- engine_lay_out(
    supports$held, as.vector(supports$position), as.vector(ends), strings$rest[keep],
    strings$strength[keep] * total, as.vector(load)
  )
  matrix(found, 3L)
}

# The skeleton's strings: list(first, second, rest (m), strength (of 1)).
skeleton_strings <- function(si, skeleton, panels) {
  ropes <- rope_runs(skeleton$ropes)
  first <- seq_along(ropes$node)[-(ropes$before + ropes$count)]
  length <- vapply(si$ropes, `[[`, 0, "length")
  on_ropes <- list(
    first = ropes$node[first], second = ropes$node[first + 1L],
    rest = (ropes$fraction[first + 1L] - ropes$fraction[first]) * rep.int(length, ropes$count - 1L),
    strength = rep.int(1, length(first))
  )
  upper <- 4L * seq_along(skeleton$grids) - 3L
  columns <- skeleton$count[upper]
  rows <- skeleton$count[upper + 2L]
  unit <- mesh_unit(panels)
  square <- is_square(panels)
  grid <- as.integer(unlist(skeleton$grids))
  before <- cumsum(columns * rows) - columns * rows
  step <- function(edge, k) {
    at <- skeleton$before[edge] + k + 1L
    skeleton$fraction[at + 1L] - skeleton$fraction[at]
  }

  # Down every column, then along every row, of one panel after the other.
  down <- columns * (rows - 1L)
  panel <- rep.int(seq_along(rows), down)
  k <- sequence(down) - 1L
  row <- k %% (rows[panel] - 1L)
  first <- before[panel] + row * columns[panel] + k %/% (rows[panel] - 1L) + 1L
  lengthwise <- list(
    panel = panel, first = grid[first], second = grid[first + columns[panel]],
    rest = step(upper[panel] + 2L, row) * panels$deep[panel] * unit[panel] *
      ifelse(square, 1, nominal_depth_ratio)[panel],
    strength = rep.int(1, length(panel))
  )
  across <- (columns - 1L) * rows
  panel <- rep.int(seq_along(rows), across)
  k <- sequence(across) - 1L
  column <- k %% (columns[panel] - 1L)
  row <- k %/% (columns[panel] - 1L)
  first <- before[panel] + row * columns[panel] + column + 1L
  deep <- skeleton$fraction[skeleton$before[upper[panel] + 2L] + row + 1L]
  meshes <- panels$upper[panel] + deep * (panels$lower - panels$upper)[panel]
  crosswise <- list(
    panel = panel, first = grid[first], second = grid[first + 1L],
    rest = step(upper[panel], column) * meshes * unit[panel] *
      ifelse(square, 1, nominal_hanging_ratio)[panel],
    strength = rep.int(0.02, length(panel))
  )
  order <- order(c(lengthwise$panel, crosswise$panel))
  columns <- setNames(names(on_ropes), names(on_ropes))
  lapply(columns, function(x) c(on_ropes[[x]], c(lengthwise[[x]], crosswise[[x]])[order]))
}

# Weight, lift and a rough drag at the skeleton's nodes, 3 x n, N; load: those of the plan.
skeleton_load <- function(si, skeleton, panels, load) {
  density <- si$water$density
  speed <- si$towing$speed + si$water$current$x[1]
  push <- 0.5 * density * speed * abs(speed)
  # A line's weight, and the drag of a cylinder at about 20 degrees to the flow.
  line_load <- function(length, mass, volume, diameter) {
    cbind(0.1 * push * diameter * length, 0 * length,
      -gear_gravity * length * (mass - density * volume))
  }
  number <- function(field) vapply(si$ropes, `[[`, 0, field)
  ropes <- rope_runs(skeleton$ropes)
  first <- seq_along(ropes$node)[-(ropes$before + ropes$count)]
  rope <- rep.int(seq_along(ropes$count), ropes$count - 1L)
  half <- (ropes$fraction[first + 1L] - ropes$fraction[first]) * number("length")[rope] / 2
  on_ropes <- line_load(half, number("mass_per_length")[rope], number("volume_per_length")[rope],
    number("diameter")[rope])

  size <- lengths(skeleton$grids)
  panel <- rep.int(seq_along(size), size)
  twine <- 2 * panel_bars(panels) * panels$mesh_size / 2 / size
  on_panels <- line_load(twine[panel], panels$mass_per_length[panel],
    panels$volume_per_length[panel], panels$twine_diameter[panel])

  runs <- lapply(names(si$pieces), function(name) {
    run <- piece_run(si, skeleton, name)
    if (is.null(run)) skeleton$places[[si$pieces[[name]]$at]] else run$node
  })
  on_pieces <- lapply(seq_along(runs), function(k) {
    piece <- si$pieces[[k]]
    way <- lift_directions[[if (is.na(piece$lift_direction)) "up" else piece$lift_direction]]
    lift <- push * piece$lift_area * way[2]
    force <- piece$number * c(
      push * piece$drag_area, if (way[1] == 1) lift else 0,
      (if (way[1] == 0) lift else 0) - gear_gravity * (piece$mass - density * piece$volume)
    )
    n <- length(runs[[k]])
    matrix(force / n, n, 3L, byrow = TRUE)
  })
  force <- do.call(rbind, c(list(on_ropes, on_ropes, on_panels), on_pieces))
  node <- c(ropes$node[first], ropes$node[first + 1L], unlist(skeleton$grids), unlist(runs))
  part <- c(
    rope, rope, length(ropes$count) + panel,
    length(ropes$count) + length(size) + rep.int(seq_along(runs), lengths(runs))
  )
  # First each part's force on each node, then the sum over parts.
  order <- order(part)
  n <- ncol(load)
  key <- (part * n + node)[order]
  by_part <- rowsum(force[order, , drop = FALSE], key, reorder = FALSE)
  t(unname(rowsum(rbind(t(load), by_part), c(seq_len(n), (unique(key) - 1L) %% n + 1L),
    reorder = FALSE)))
}
