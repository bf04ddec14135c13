# A crude first shape, so that nobody gives coordinates.
#
# The gear is divided as coarsely as its seams allow. On that skeleton ropes and the lengthwise
# lines of panels are strings, the crosswise lines weak strings, pulled by weight, lift and a rough
# drag; the engine finds string tensions that bring the lengths near their own (force densities,
# H.-J. Schek, Comput. Methods Appl. Mech. Eng. 3:115, 1974). The lattice's nodes are then placed on
# the skeleton by their mesh coordinates.
#
# frame: the division's frame, where it was made for triangles all over; else the skeleton's is new.
lay_out <- function(si, division, lattice, frame = NULL) {
  loose <- function(parts, fields) lapply(parts, function(p) p[setdiff(names(p), fields)])
  coarse <- si
  coarse$panels <- loose(si$panels, c("columns", "rows"))
  coarse$ropes <- loose(si$ropes, "segments")
  bars <- logical(length(si$panels))
  if (is.null(frame)) frame <- division_frame(coarse, linked = !bars)
  skeleton <- divide_at(coarse, frame, bars, Inf)
  place <- skeleton_positions(coarse, skeleton, frame)

  start <- matrix(NA_real_, 3L, lattice$engine$nodes)
  for (r in names(si$ropes)) {
    nodes <- skeleton$ropes[[r]]
    at <- division$ropes[[r]]
    start[, at$node] <- t(apply(place[, nodes$node, drop = FALSE], 1L, function(x) {
      stats::approx(nodes$at, x, at$at, ties = "ordered", rule = 2)$y
    }))
  }
  for (p in seq_along(si$panels)) {
    e <- 4L * (p - 1L)
    on_panel <- skeleton_sheet(skeleton, p, place)
    drawn <- lattice$panels[[p]]
    if (drawn$netting == "triangles") {
      s <- rep(division$fractions[[e + 1L]], ncol(drawn$grid))
      t <- rep(division$fractions[[e + 3L]], each = nrow(drawn$grid))
      start[, as.vector(drawn$grid)] <- on_panel(s, t)
    } else {
      for (k in 1:4) {
        f <- division$fractions[[e + k]]
        zero <- 0 * f
        start[, division$edge_nodes[[e + k]]] <- switch(k,
          on_panel(f, zero), on_panel(f, zero + 1), on_panel(zero, f), on_panel(zero + 1, f)
        )
      }
      panel <- si$panels[[p]]
      mine <- drawn$node > division$nodes
      j <- drawn$j[mine]
      left <- panel_left(panel, j)
      width <- pmax(panel_right(panel, j) - left, 1e-9)
      start[, drawn$node[mine]] <- on_panel(
        pmin(pmax((drawn$i[mine] - left) / width, 0), 1), j / panel$deep
      )
    }
  }
  for (name in names(division$points)) {
    start[, division$points[[name]]] <- place[, skeleton$points[[name]]]
  }
  start
}

# Bilinear positions on a panel's skeleton: function(s, t) of fractions across and deep.
skeleton_sheet <- function(skeleton, p, place) {
  e <- 4L * (p - 1L)
  across <- skeleton$fractions[[e + 1L]]
  deep <- skeleton$fractions[[e + 3L]]
  grid <- skeleton$grids[[p]]
  function(s, t) {
    c <- findInterval(s, across, all.inside = TRUE)
    r <- findInterval(t, deep, all.inside = TRUE)
    fs <- (s - across[c]) / (across[c + 1L] - across[c])
    ft <- (t - deep[r]) / (deep[r + 1L] - deep[r])
    corner <- function(dc, dr) place[, grid[cbind(c + dc, r + dr)], drop = FALSE]
    weigh <- function(x, w) x * rep(w, each = 3L)
    weigh(corner(0L, 0L), (1 - fs) * (1 - ft)) + weigh(corner(1L, 0L), fs * (1 - ft)) +
      weigh(corner(0L, 1L), (1 - fs) * ft) + weigh(corner(1L, 1L), fs * ft)
  }
}

# Positions (3 x n) of the skeleton's nodes.
skeleton_positions <- function(si, skeleton, frame) {
  supports <- gear_supports(si, skeleton)
  load <- supports$load
  density <- si$water$density
  speed <- si$towing$speed + si$water$current$x[1]
  push <- 0.5 * density * speed * abs(speed)
  give <- function(node, force) {
    s <- rowsum(t(force), node, reorder = FALSE)
    k <- as.integer(rownames(s))
    load[, k] <<- load[, k] + t(s)
  }
  # A line's weight, and the drag of a cylinder at about 20 degrees to the flow.
  line_load <- function(length, mass, volume, diameter) {
    rbind(0.1 * push * diameter * length, 0, -gear_gravity * length * (mass - density * volume))
  }
  ends <- rest <- strength <- list()
  string <- function(node, length, strong) {
    n <- length(node)
    ends[[length(ends) + 1L]] <<- rbind(node[-n], node[-1L])
    rest[[length(rest) + 1L]] <<- length
    strength[[length(strength) + 1L]] <<- rep(if (strong) 1 else 0.02, n - 1L)
  }
  for (r in names(si$ropes)) {
    rope <- si$ropes[[r]]
    at <- skeleton$ropes[[r]]
    length <- diff(at$at) * rope$length
    string(at$node, length, TRUE)
    half <- line_load(length / 2, rope$mass_per_length, rope$volume_per_length, rope$diameter)
    n <- length(at$node)
    give(c(at$node[-n], at$node[-1L]), cbind(half, half))
  }
  for (p in seq_along(si$panels)) {
    panel <- si$panels[[p]]
    grid <- skeleton$grids[[p]]
    e <- 4L * (p - 1L)
    across <- diff(skeleton$fractions[[e + 1L]])
    deep <- skeleton$fractions[[e + 3L]]
    square <- panel$orientation == "square"
    unit <- mesh_unit(panel)
    for (c in seq_len(nrow(grid))) {
      string(grid[c, ], diff(deep) * panel$deep * unit * (if (square) 1 else nominal_depth_ratio), TRUE)
    }
    for (r in seq_len(ncol(grid))) {
      meshes <- panel$upper + deep[r] * (panel$lower - panel$upper)
      string(grid[, r], across * meshes * unit * (if (square) 1 else nominal_hanging_ratio), FALSE)
    }
    twine <- 2 * panel_bars(panel) * panel$mesh_size / 2 / length(grid)
    force <- line_load(rep(twine, length(grid)), panel$mass_per_length, panel$volume_per_length,
      panel$twine_diameter)
    give(as.vector(grid), force)
  }
  for (k in names(si$pieces)) {
    piece <- si$pieces[[k]]
    run <- if (is.null(piece$along)) {
      list(node = skeleton$place(piece$at))
    } else if (piece$along$kind == "rope") {
      skeleton$ropes[[piece$along$name]]
    } else {
      skeleton$laced(frame$chains$run[[k]])
    }
    way <- lift_directions[[if (is.na(piece$lift_direction)) "up" else piece$lift_direction]]
    lift <- push * piece$lift_area * way[2]
    force <- piece$number * c(
      push * piece$drag_area, if (way[1] == 1) lift else 0,
      (if (way[1] == 0) lift else 0) - gear_gravity * (piece$mass - density * piece$volume)
    )
    n <- length(run$node)
    give(run$node, matrix(force / n, 3L, n))
  }
  # Nothing pulls on a weightless gear at rest: let it hang.
  total <- max(sqrt(colSums(load^2)), 1e-9)
  load[3, ] <- load[3, ] - 1e-3 * total * !supports$held
  ends <- do.call(cbind, ends)
  rest <- unlist(rest)
  strength <- unlist(strength)
  keep <- ends[1, ] != ends[2, ] & rest > 0
  found <- engine_lay_out(
    supports$held, as.vector(supports$position), as.vector(ends[, keep, drop = FALSE]),
    rest[keep], strength[keep] * total, as.vector(load)
  )
  matrix(found, 3L)
}
