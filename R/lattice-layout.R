# A crude first shape, so that nobody gives coordinates.
#
# The gear is divided as coarsely as its seams allow. On that skeleton ropes and the lengthwise
# lines of panels are strings, the crosswise lines weak strings, pulled by weight, lift and a rough
# drag; the engine finds string tensions that bring the lengths near their own (force densities,
# H.-J. Schek, Comput. Methods Appl. Mech. Eng. 3:115, 1974). The lattice's nodes are then placed on
# the skeleton by their mesh coordinates.
#
# frame: the division's frame, where it was made for triangles all over; else the skeleton's is new.
lay_out <- function(si, division, lattice, chains, frame = NULL) {
  no_bars <- logical(length(si$panels))
  if (is.null(frame)) frame <- division_frame(chains, linked = !no_bars)
  own <- vapply(si$ropes, function(rope) is.null(rope$along), NA)
  skeleton <- divide(si, frame, rep.int(1L, length(frame$pieces$edge)), as.integer(own), no_bars)
  place <- skeleton_positions(si, skeleton)

  start <- matrix(NA_real_, 3L, lattice$engine$nodes)
  if (length(si$ropes)) {
    on <- join_columns(lapply(names(si$ropes), function(r) {
      along_skeleton(division$ropes[[r]], skeleton$ropes[[r]])
    }))
    start[, on$node] <- between_places(place, on)
  }
  if (length(si$panels)) {
    on <- join_columns(lapply(seq_along(si$panels), function(p) {
      over_skeleton(lattice_places(si$panels[[p]], division, lattice$panels[[p]], p), skeleton, p)
    }))
    start[, on$node] <- inside_cells(place, on)
  }
  points <- names(division$points)
  start[, division$points] <- place[, skeleton$points[points]]
  start
}

# Lists of columns of the same names as one.
join_columns <- function(parts) {
  columns <- names(parts[[1L]])
  lapply(setNames(columns, columns), function(column) unlist(lapply(parts, `[[`, column)))
}

# A rope's nodes on its skeleton: list(node, from, to = nodes of the skeleton on both sides, share).
along_skeleton <- function(rope, skeleton) {
  cell <- cell_of(rope$at, skeleton$at)
  low <- skeleton$at[cell]
  high <- skeleton$at[cell + 1L]
  share <- (rope$at - low) / (high - low)
  share[rope$at <= low] <- 0
  share[rope$at >= high] <- 1
  list(node = rope$node, from = skeleton$node[cell], to = skeleton$node[cell + 1L], share = share)
}

between_places <- function(place, on) {
  from <- place[, on$from, drop = FALSE]
  to <- place[, on$to, drop = FALSE]
  found <- from + (to - from) * rep(on$share, each = 3L)
  found[, on$share == 1] <- to[, on$share == 1]
  found
}

# The cell between breaks that each x lies in.
cell_of <- function(x, breaks) {
  if (length(breaks) == 2L) return(rep.int(1L, length(x)))
  findInterval(x, breaks, all.inside = TRUE)
}

# Where a panel's nodes lie on it: list(node, s, t), fractions across and deep.
lattice_places <- function(panel, division, drawn, p) {
  f <- division$fractions[4L * (p - 1L) + 1:4]
  if (drawn$netting == "triangles") {
    return(list(
      node = as.vector(drawn$grid), s = rep(f[[1]], ncol(drawn$grid)),
      t = rep(f[[3]], each = nrow(drawn$grid))
    ))
  }
  own <- drawn$node > division$nodes
  j <- drawn$j[own]
  left <- panel_left(panel, j)
  width <- panel_right(panel, j) - left
  width[width < 1e-9] <- 1e-9
  s <- (drawn$i[own] - left) / width
  s[s < 0] <- 0
  s[s > 1] <- 1
  list(
    node = c(unlist(division$edge_nodes[4L * (p - 1L) + 1:4]), drawn$node[own]),
    s = c(f[[1]], f[[2]], 0 * f[[3]], 0 * f[[4]] + 1, s),
    t = c(0 * f[[1]], 0 * f[[2]] + 1, f[[3]], f[[4]], j / panel$deep)
  )
}

# Places on a panel's skeleton: list(node, a, b, c, d = the corners of its cell, the skeleton's
# nodes at (0, 0), (1, 0), (0, 1) and (1, 1) of it; s, t = fractions of the cell).
over_skeleton <- function(places, skeleton, p) {
  across <- skeleton$fractions[[4L * (p - 1L) + 1L]]
  deep <- skeleton$fractions[[4L * (p - 1L) + 3L]]
  grid <- skeleton$grids[[p]]
  column <- cell_of(places$s, across)
  row <- cell_of(places$t, deep)
  corner <- (row - 1L) * nrow(grid) + column
  list(
    node = places$node,
    a = grid[corner], b = grid[corner + 1L],
    c = grid[corner + nrow(grid)], d = grid[corner + nrow(grid) + 1L],
    s = (places$s - across[column]) / (across[column + 1L] - across[column]),
    t = (places$t - deep[row]) / (deep[row + 1L] - deep[row])
  )
}

# Bilinear positions (3 x n).
inside_cells <- function(place, on) {
  weigh <- function(corner, w) place[, corner, drop = FALSE] * rep(w, each = 3L)
  weigh(on$a, (1 - on$s) * (1 - on$t)) + weigh(on$b, on$s * (1 - on$t)) +
    weigh(on$c, (1 - on$s) * on$t) + weigh(on$d, on$s * on$t)
}

# Positions (3 x n) of the skeleton's nodes.
skeleton_positions <- function(si, skeleton) {
  supports <- gear_supports(si, skeleton)
  strings <- skeleton_strings(si, skeleton)
  load <- skeleton_load(si, skeleton, supports$load)
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
skeleton_strings <- function(si, skeleton) {
  on_ropes <- lapply(names(si$ropes), function(r) {
    at <- skeleton$ropes[[r]]
    n <- length(at$node)
    list(first = at$node[-n], second = at$node[-1L],
      rest = (at$at[-1L] - at$at[-n]) * si$ropes[[r]]$length, strength = rep.int(1, n - 1L))
  })
  on_panels <- lapply(seq_along(si$panels), function(p) {
    panel <- si$panels[[p]]
    grid <- skeleton$grids[[p]]
    across <- skeleton$fractions[[4L * (p - 1L) + 1L]]
    deep <- skeleton$fractions[[4L * (p - 1L) + 3L]]
    columns <- length(across)
    rows <- length(deep)
    square <- panel$orientation == "square"
    unit <- mesh_unit(panel)
    down <- t(grid)
    meshes <- panel$upper + deep * (panel$lower - panel$upper)
    lengthwise <- (deep[-1L] - deep[-rows]) * panel$deep * unit *
      (if (square) 1 else nominal_depth_ratio)
    crosswise <- rep.int(across[-1L] - across[-columns], rows) * rep(meshes, each = columns - 1L) *
      unit * (if (square) 1 else nominal_hanging_ratio)
    list(
      first = c(down[-rows, ], grid[-columns, ]), second = c(down[-1L, ], grid[-1L, ]),
      rest = c(rep.int(lengthwise, columns), crosswise),
      strength = rep.int(c(1, 0.02), c((rows - 1L) * columns, (columns - 1L) * rows))
    )
  })
  join_columns(c(on_ropes, on_panels))
}

# Weight, lift and a rough drag at the skeleton's nodes, 3 x n, N; load: those of the plan.
skeleton_load <- function(si, skeleton, load) {
  density <- si$water$density
  speed <- si$towing$speed + si$water$current$x[1]
  push <- 0.5 * density * speed * abs(speed)
  # A line's weight, and the drag of a cylinder at about 20 degrees to the flow.
  line_load <- function(node, length, mass, volume, diameter) {
    list(node = node, x = 0.1 * push * diameter * length, y = 0 * length,
      z = -gear_gravity * length * (mass - density * volume))
  }
  on_ropes <- lapply(names(si$ropes), function(r) {
    rope <- si$ropes[[r]]
    at <- skeleton$ropes[[r]]
    n <- length(at$node)
    half <- (at$at[-1L] - at$at[-n]) * rope$length / 2
    line_load(c(at$node[-n], at$node[-1L]), c(half, half), rope$mass_per_length,
      rope$volume_per_length, rope$diameter)
  })
  on_panels <- lapply(seq_along(si$panels), function(p) {
    panel <- si$panels[[p]]
    grid <- skeleton$grids[[p]]
    twine <- 2 * panel_bars(panel) * panel$mesh_size / 2 / length(grid)
    line_load(as.vector(grid), rep.int(twine, length(grid)), panel$mass_per_length,
      panel$volume_per_length, panel$twine_diameter)
  })
  on_pieces <- lapply(names(si$pieces), function(k) {
    piece <- si$pieces[[k]]
    node <- piece_run(si, skeleton, k)$node
    if (is.null(node)) node <- skeleton$places[[piece$at]]
    way <- lift_directions[[if (is.na(piece$lift_direction)) "up" else piece$lift_direction]]
    lift <- push * piece$lift_area * way[2]
    n <- length(node)
    share <- function(force) rep.int(piece$number * force / n, n)
    list(
      node = node, x = share(push * piece$drag_area), y = share(if (way[1] == 1) lift else 0),
      z = share((if (way[1] == 0) lift else 0) -
        gear_gravity * (piece$mass - density * piece$volume))
    )
  })
  parts <- c(on_ropes, on_panels, on_pieces)
  given <- join_columns(parts)
  force <- cbind(given$x, given$y, given$z)
  # First each part's force on each node, then the sum over parts.
  n <- ncol(load)
  key <- rep.int(seq_along(parts) - 1L, lengths(lapply(parts, `[[`, "node"))) * n + given$node
  by_part <- rowsum(force, key, reorder = FALSE)
  t(unname(rowsum(rbind(t(load), by_part), c(seq_len(n), (unique(key) - 1L) %% n + 1L),
    reorder = FALSE)))
}
