# A crude first shape, so that nobody gives coordinates.
#
# The gear is divided as coarsely as its seams allow. On that skeleton ropes and the lengthwise
# lines of panels are strings, the crosswise lines weak strings, pulled by weight, lift and a rough
# drag; the engine finds string tensions that bring the lengths near their own (force densities,
# H.-J. Schek, Comput. Methods Appl. Mech. Eng. 3:115, 1974). The shape is then
# carried from the skeleton to the lattice.
#
# frame: the division's frame, where it was made for cells all over; else the skeleton's is new.
# lattice: list(nodes, division, ropes, points, panels), see build_lattice().
# supports: function(skeleton) that tells which of its nodes are held where; open: how wide netting
# wants to hang, as a share of its stretched width.
lay_out <- function(si, lattice, panels, chains, frame = NULL,
                    supports = function(skeleton) gear_supports(si, skeleton),
                    open = nominal_hanging_ratio) {
  no_bars <- logical(length(si$panels))
  if (is.null(frame)) frame <- division_frame(chains, linked = !no_bars)
  # What is fastened to the middle of a pole must not start at its end.
  segments <- vapply(si$ropes, function(rope) {
    if (!is.null(rope$along)) return(0L)
    if (rope$strut) as.integer(first_of(rope$segments, 1L)) else 1L
  }, 0L)
  skeleton <- divide(si, frame, rep.int(1L, length(frame$pieces$edge)), segments, no_bars)
  place <- skeleton_positions(si, skeleton, panels, supports(skeleton), open)
  old <- list(
    nodes = skeleton$nodes, division = skeleton, ropes = skeleton$ropes, points = skeleton$points,
    panels = rep(list(list(netting = "cells")), length(si$panels))
  )
  carry_positions(panels, lattice, old, place)
}

# Positions (3 x n) of the skeleton's nodes.
skeleton_positions <- function(si, skeleton, panels, supports, open) {
  for (name in names(si$points)) {
    near <- si$points[[name]]$near
    node <- skeleton$points[[name]]
    if (is.null(near) || supports$held[node]) next
    supports$held[node] <- TRUE
    supports$position[, node] <- near
  }
  strings <- mapply(c, skeleton_strings(si, skeleton, panels, open), board_strings(si, skeleton),
    SIMPLIFY = FALSE)
  load <- skeleton_load(si, skeleton, panels, supports$load)
  if (si$water$free_surface) load <- floated(load)
  # Nothing pulls on a weightless gear at rest: let it hang.
  total <- max(sqrt(colSums(load^2)), 1e-9)
  load[3, ] <- load[3, ] - 1e-3 * total * !supports$held
  keep <- strings$first != strings$second & strings$rest > 0
  ends <- rbind(strings$first, strings$second)[, keep, drop = FALSE]
  found <- engine_lay_out(
    supports$held, as.vector(supports$position), as.vector(ends), strings$rest[keep],
    strings$strength[keep] * total, as.vector(load)
  )
  found <- matrix(found, 3L)
  # What floats stays at the surface.
  if (si$water$free_surface) found[3, ] <- pmin(found[3, ], 0)
  for (board in si$otter_boards) {
    nodes <- skeleton$points[board$points]
    found[, nodes] <- upright_board(board, rowMeans(found[, nodes]))
  }
  found
}

# Loads at a free surface, where floats lift no more than hangs from them.
floated <- function(load) {
  up <- load[3, ] > 0
  lifted <- sum(load[3, up])
  hanging <- -sum(load[3, !up])
  if (lifted > hanging) load[3, up] <- load[3, up] * hanging / lifted
  load
}

# Strings between the points of boards, as skeleton_strings().
board_strings <- function(si, skeleton) {
  pairs <- rbind(c(1L, 2L), c(2L, 3L), c(3L, 1L))
  nodes <- lapply(si$otter_boards, function(board) matrix(skeleton$points[board$points][pairs], 3L))
  rest <- lapply(si$otter_boards, function(board) {
    sqrt(colSums((board$attachment[, pairs[, 2]] - board$attachment[, pairs[, 1]])^2))
  })
  list(
    first = as.integer(unlist(lapply(nodes, function(n) n[, 1]))),
    second = as.integer(unlist(lapply(nodes, function(n) n[, 2]))),
    rest = as.double(unlist(rest)), strength = rep(1, 3L * length(nodes))
  )
}

# The skeleton's strings: list(first, second, rest (m), strength (of 1)).
skeleton_strings <- function(si, skeleton, panels, open) {
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
      ifelse(square, 1, open)[panel],
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
  twine <- panel_bars(panels) * cell_twine_with_knots(panels) / size
  on_panels <- line_load(twine[panel], panels$mass_per_length[panel],
    panels$volume_per_length[panel], twine_width(panels)[panel])

  runs <- lapply(names(si$pieces), function(name) {
    run <- piece_run(si, skeleton, name)
    if (is.null(run)) skeleton$places[[si$pieces[[name]]$at]] else run$node
  })
  on_pieces <- lapply(seq_along(runs), function(k) {
    piece <- si$pieces[[k]]
    way <- lift_directions[[if (is.na(piece$lift_direction)) "up" else piece$lift_direction]]
    lift <- push * piece$lift_area * way$sign
    force <- piece$number * c(
      push * piece$drag_area, if (way$to == "sideways") lift else 0,
      (if (way$to == "up") lift else 0) + push * piece$upward_lift_area -
        gear_gravity * (piece$mass - density * piece$volume)
    )
    n <- length(runs[[k]])
    matrix(force / n, n, 3L, byrow = TRUE)
  })
  on_boards <- lapply(si$otter_boards, function(board) {
    lift <- push * board$area * 1.2 * board$side
    up <- is_kite(board)
    force <- c(
      push * board$area * 0.5, if (up) 0 else lift,
      (if (up) lift else 0) - gear_gravity * (board$mass - density * board$volume)
    )
    matrix(force / 3, 3L, 3L, byrow = TRUE)
  })
  runs <- c(runs, lapply(si$otter_boards, function(board) unname(skeleton$points[board$points])))
  force <- do.call(rbind, c(list(on_ropes, on_ropes, on_panels), on_pieces, unname(on_boards)))
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
