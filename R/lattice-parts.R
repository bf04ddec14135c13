# Ropes, panels and pieces as elements of a lattice. In the table of parts ropes come first, then
# panels, then pieces; ropes and panels are also the engine's materials, in that order.

add_rope <- function(build, rope, along, part) {
  n <- length(along$node)
  rest <- diff(along$at) * rope$length
  # Where a laced edge is gathered in one point, its rope has no length left between nodes.
  apart <- along$node[-n] != along$node[-1L] & rest > 0
  rest <- rest[apart]
  ends <- rbind(along$node[-n], along$node[-1L])[, apart, drop = FALSE]
  m <- length(rest)
  build$add("bars", node = as.vector(ends), rest = rest, multiplicity = rep(1, m),
    material = rep(part, m), part = rep(part, m))
  half <- rep(rest / 2, each = 2L)
  build$add("masses", node = as.vector(ends), mass = half * rope$mass_per_length,
    volume = half * rope$volume_per_length)
}

# Knots as spheres; count: knots at each node.
add_knots <- function(build, panel, node, count, part) {
  if (panel$knot_diameter == 0) return(invisible())
  build$add("spheres", node = node, drag_area = pi / 4 * panel$knot_diameter^2 * count,
    diameter = rep(panel$knot_diameter, length(node)),
    added_mass = 0.5 * pi / 6 * panel$knot_diameter^3 * count, part = rep(part, length(node)))
}

add_triangle_panel <- function(build, panel, division, p, part) {
  grid <- division$grids[[p]]
  e <- 4L * (p - 1L)
  t <- triangle_elements(panel, grid, division$fractions[[e + 1L]], division$fractions[[e + 3L]])
  m <- length(t$rest)
  build$add("triangles", node = as.vector(t$node), twine = as.vector(t$twine), rest = t$rest,
    multiplicity = t$multiplicity, material = rep(part, m), part = rep(part, m))
  third <- rep(t$bars / 3, each = 3L)
  twine <- 2 * third * panel$mesh_size / 2
  build$add("masses", node = as.vector(t$node), mass = twine * panel$mass_per_length,
    volume = twine * panel$volume_per_length)
  knots <- rowsum(third, as.vector(t$node), reorder = FALSE)
  add_knots(build, panel, as.integer(rownames(knots)), as.vector(knots), part)
  list(netting = "triangles", grid = grid)
}

add_bar_panel <- function(build, panel, division, p, part, grouping) {
  found <- bar_elements(panel, grouping$lambda, grouping$segments)
  points <- found$points
  id <- integer(length(points$i))
  free <- points$edge == 0L
  id[free] <- build$new_nodes(sum(free))
  for (k in 1:4) {
    on <- which(points$edge == k)
    if (!length(on)) next
    f <- division$fractions[[4L * (p - 1L) + k]]
    nodes <- division$edge_nodes[[4L * (p - 1L) + k]]
    at <- pmin(pmax(points$fraction[on], 0), 1)
    cell <- pmin(findInterval(at, f, all.inside = TRUE), length(f) - 1L)
    share <- (at - f[cell]) / (f[cell + 1L] - f[cell])
    first <- nodes[cell]
    second <- nodes[cell + 1L]
    whole <- share < 1e-6 | share > 1 - 1e-6 | first == second
    id[on[whole]] <- ifelse(share > 0.5, second, first)[whole]
    if (any(!whole)) {
      id[on[!whole]] <- build$tie(first[!whole], second[!whole], share[!whole])
    }
  }
  inner <- length(found$bars$between$i)
  id <- c(id, build$new_nodes(inner))
  b <- found$bars
  ends <- rbind(id[b$from], id[b$to])
  keep <- ends[1, ] != ends[2, ]
  m <- sum(keep)
  build$add("bars", node = as.vector(ends[, keep]), rest = b$rest[keep],
    multiplicity = b$multiplicity[keep], material = rep(part, m), part = rep(part, m))
  half <- rep(b$rest * b$multiplicity / 2, each = 2L)
  build$add("masses", node = as.vector(ends), mass = half * panel$mass_per_length,
    volume = half * panel$volume_per_length)
  add_knots(build, panel, id[seq_along(points$i)], points$knots, part)
  list(
    netting = "bars", node = id, i = c(points$i, b$between$i), j = c(points$j, b$between$j)
  )
}

lift_directions <- list(
  up = c(0L, 1), down = c(0L, -1), starboard = c(1L, 1), port = c(1L, -1)
)

# run: list(node, at) of the nodes that the piece is spread over, or NULL where it sits at a place.
add_piece <- function(build, piece, run, place, density, part) {
  if (is.null(run)) {
    node <- place(piece$at)
    n <- piece$number
  } else if (piece$end_to_end) {
    # One piece at each end of the share; one between two nodes is shared by them.
    at <- seq(piece$share[1], piece$share[2], length.out = piece$number)
    cell <- findInterval(at, run$at, all.inside = TRUE)
    second <- (at - run$at[cell]) / pmax(run$at[cell + 1L] - run$at[cell], 1e-300)
    n <- numeric(length(run$node))
    for (k in seq_along(at)) {
      n[cell[k] + 0:1] <- n[cell[k] + 0:1] + c(1 - second[k], second[k])
    }
    # a piece at a node leaves rounding at the next
    some <- n > 1e-9
    node <- run$node[some]
    n <- n[some]
  } else {
    # Each node takes the stretch halfway to its neighbours, cut to the piece's share of the rope.
    middle <- (run$at[-1L] + run$at[-length(run$at)]) / 2
    from <- pmax(c(0, middle), piece$share[1])
    to <- pmin(c(middle, 1), piece$share[2])
    inside <- to > from
    node <- run$node[inside]
    n <- piece$number * ((to - from) / diff(piece$share))[inside]
  }
  k <- length(node)
  build$add("masses", node = node, mass = n * piece$mass, volume = n * piece$volume)
  build$add("spheres", node = node, drag_area = n * piece$drag_area, diameter = rep(0, k),
    added_mass = if (density > 0) n * piece$added_mass / density else 0 * n, part = rep(part, k))
  if (piece$lift_area != 0) {
    way <- lift_directions[[piece$lift_direction]]
    build$add("lifts", node = node, lift_area = n * piece$lift_area * way[2],
      direction = rep(as.integer(way[1]), k), part = rep(part, k))
  }
}

# Which nodes are held, where they are, and the plan's loads: list(held, position 3 x n, load 3 x n).
gear_supports <- function(si, division) {
  held <- logical(division$nodes)
  position <- matrix(0, 3L, division$nodes)
  load <- matrix(0, 3L, division$nodes)
  for (name in names(si$points)) {
    point <- si$points[[name]]
    node <- division$points[[name]]
    load[, node] <- load[, node] + point$load
    if (is_given(point$held)) {
      held[node] <- TRUE
      position[, node] <- point$position
    }
  }
  for (name in names(division$held_edges)) {
    edge <- division$held_edges[[name]]
    inner <- -c(1L, length(edge$node))
    node <- edge$node[inner]
    if (any(held[node])) {
      path <- paste0("seams.", name, ".held_between")
      abort_plan(
        sprintf(
          paste(
            "Plan field `%s` runs through a place that is held already: end the seam there and",
            "hold the rest by another seam."
          ),
          path
        ),
        path, edge$between
      )
    }
    first <- si$points[[edge$between[1]]]$position
    second <- si$points[[edge$between[2]]]$position
    held[node] <- TRUE
    position[, node] <- first + outer(second - first, edge$at[inner])
  }
  list(held = held, position = position, load = load)
}

# The lattice must hold the plan's twine: an error names the panel where it does not.
check_totals <- function(lattice, si) {
  e <- lattice$engine
  length_of <- numeric(nrow(lattice$parts))
  add <- function(part, value) {
    if (!length(part)) return()
    s <- rowsum(value, part)
    k <- as.integer(rownames(s))
    length_of[k] <<- length_of[k] + s
  }
  add(lattice$bar_part, e$bars$rest * e$bars$multiplicity)
  if (length(e$triangles$rest)) {
    t <- matrix(e$triangles$twine, 6L)
    d <- abs((t[3, ] - t[1, ]) * (t[6, ] - t[2, ]) - (t[5, ] - t[1, ]) * (t[4, ] - t[2, ]))
    add(lattice$triangle_part, d * e$triangles$multiplicity * e$triangles$rest)
  }
  for (p in seq_along(si$panels)) {
    planned <- 2 * panel_bars(si$panels[[p]]) * si$panels[[p]]$mesh_size / 2
    built <- length_of[length(si$ropes) + p]
    if (abs(built - planned) > 1e-6 * planned) {
      cli::cli_abort(
        "Panel {.field {names(si$panels)[p]}} has {signif(planned, 6)} m of twine in the plan and
        {signif(built, 6)} m in the lattice.",
        class = c("codend_error_lattice", "codend_error")
      )
    }
  }
}
