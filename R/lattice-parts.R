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

# Adds all panels and returns what the views draw of each.
#
# grouping: `bar_grouping()` of all panels; ropes: number of parts before the panels.
add_panels <- function(build, panels, division, bars, grouping, ropes) {
  shapes <- lapply(panels, `[`, panel_shape)
  divided <- lapply(seq_along(panels), function(p) {
    e <- 4L * (p - 1L)
    if (bars[p]) {
      list(grouping$lambda[p], grouping$segments[p])
    } else {
      list(division$fractions[[e + 1L]], division$fractions[[e + 3L]])
    }
  })
  found <- divide_panels(shapes, divided, bars)
  drawn <- lapply(seq_along(panels), function(p) {
    add <- if (bars[p]) add_bar_panel else add_triangle_panel
    add(build, panels[[p]], found[[p]], division, p, ropes + p)
  })
  setNames(drawn, names(panels))
}

add_triangle_panel <- function(build, panel, found, division, p, part) {
  grid <- division$grids[[p]]
  m <- length(found$rest)
  node <- grid[found$corner]
  build$add("triangles", node = node, twine = found$twine, rest = found$rest,
    multiplicity = found$multiplicity, material = rep.int(part, m), part = rep.int(part, m))
  third <- rep(found$bars / 3, each = 3L)
  twine <- 2 * third * panel$mesh_size / 2
  build$add("masses", node = node, mass = twine * panel$mass_per_length,
    volume = twine * panel$volume_per_length)
  if (panel$knot_diameter > 0) {
    add_knots(build, panel, unique(node), as.vector(rowsum(third, node, reorder = FALSE)), part)
  }
  list(netting = "triangles", grid = grid)
}

add_bar_panel <- function(build, panel, found, division, p, part) {
  points <- found$points
  id <- integer(length(points$i))
  free <- points$edge == 0L
  id[free] <- build$new_nodes(sum(free))
  for (k in 1:4) {
    on <- which(points$edge == k)
    if (!length(on)) next
    f <- division$fractions[[4L * (p - 1L) + k]]
    nodes <- division$edge_nodes[[4L * (p - 1L) + k]]
    at <- points$fraction[on]
    at[at < 0] <- 0
    at[at > 1] <- 1
    cell <- cell_of(at, f)
    share <- (at - f[cell]) / (f[cell + 1L] - f[cell])
    first <- nodes[cell]
    second <- nodes[cell + 1L]
    whole <- share < 1e-6 | share > 1 - 1e-6 | first == second
    nearest <- first
    beyond <- share > 0.5
    nearest[beyond] <- second[beyond]
    id[on[whole]] <- nearest[whole]
    if (!all(whole)) {
      id[on[!whole]] <- build$tie(first[!whole], second[!whole], share[!whole])
    }
  }
  inner <- length(found$between$i)
  id <- c(id, build$new_nodes(inner))
  ends <- id[found$ends]
  second <- seq.int(2L, by = 2L, length.out = length(found$rest))
  keep <- ends[second - 1L] != ends[second]
  half <- rep(found$rest * found$multiplicity / 2, each = 2L)
  build$add("masses", node = ends, mass = half * panel$mass_per_length,
    volume = half * panel$volume_per_length)
  if (!all(keep)) ends <- ends[rep(keep, each = 2L)]
  m <- sum(keep)
  build$add("bars", node = ends, rest = found$rest[keep],
    multiplicity = found$multiplicity[keep], material = rep.int(part, m), part = rep.int(part, m))
  add_knots(build, panel, id[seq_along(points$i)], points$knots, part)
  list(
    netting = "bars", node = id, i = c(points$i, found$between$i), j = c(points$j, found$between$j),
    lambda = found$lambda
  )
}

lift_directions <- list(
  up = c(0L, 1), down = c(0L, -1), starboard = c(1L, 1), port = c(1L, -1)
)

# The nodes that a piece is spread over: list(node, at), or NULL where it sits at a place.
piece_run <- function(si, division, name) {
  along <- si$pieces[[name]]$along
  if (is.null(along)) return(NULL)
  if (along$kind == "rope") division$ropes[[along$name]] else division$runs[[name]]
}

add_piece <- function(build, piece, run, places, density, part) {
  if (is.null(run)) {
    node <- places[[piece$at]]
    share <- 1
  } else {
    # Each node takes the stretch halfway to its neighbours, cut to the piece's share of the rope.
    middle <- (run$at[-1L] + run$at[-length(run$at)]) / 2
    from <- pmax(c(0, middle), piece$share[1])
    to <- pmin(c(middle, 1), piece$share[2])
    inside <- to > from
    node <- run$node[inside]
    share <- ((to - from) / diff(piece$share))[inside]
  }
  n <- piece$number * share
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
  list(held = held, position = position, load = load)
}

# The lattice must hold the plan's twine: an error names the panel where it does not.
check_totals <- function(lattice, si) {
  bars <- lattice$engine$bars
  triangles <- lattice$engine$triangles
  parts <- nrow(lattice$parts)
  built <- sum_by(bars$rest * bars$multiplicity, lattice$bar_part, parts) +
    sum_by(2 * triangle_bars(triangles) * triangles$rest, lattice$triangle_part, parts)
  for (p in seq_along(si$panels)) {
    planned <- 2 * panel_bars(si$panels[[p]]) * si$panels[[p]]$mesh_size / 2
    held <- built[length(si$ropes) + p]
    if (abs(held - planned) > 1e-6 * planned) {
      cli::cli_abort(
        "Panel {.field {names(si$panels)[p]}} has {signif(planned, 6)} m of twine in the plan and
        {signif(held, 6)} m in the lattice.",
        class = c("codend_error_lattice", "codend_error")
      )
    }
  }
}
