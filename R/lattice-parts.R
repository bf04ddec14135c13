# Ropes, panels and pieces as elements of a lattice. In the table of parts ropes come first, then
# panels, then pieces; ropes and panels are also the engine's materials, in that order.

# A line of a lattice stands for all the material around it, so it leaves the water over at least
# this share of its length. What is thinner would come and go with every millimetre, and a net that
# lies at the surface would not settle; the finer the lattice, the less it matters.
surface_share <- 0.05

# Height (m) over which lines of these diameters and lengths leave the water.
surface_height <- function(diameter, length) pmax(diameter, surface_share * length)

add_rope <- function(build, rope, along, part) {
  n <- length(along$node)
  rest <- diff(along$at) * rope$length
  # Where a laced edge is gathered in one point, its rope has no length left between nodes.
  apart <- along$node[-n] != along$node[-1L] & rest > 0
  rest <- rest[apart]
  ends <- rbind(along$node[-n], along$node[-1L])[, apart, drop = FALSE]
  m <- length(rest)
  height <- surface_height(rope$diameter, rest)
  build$add("bars", node = as.vector(ends), rest = rest, multiplicity = rep(1, m),
    height = height, material = rep(part, m), part = rep(part, m))
  half <- rep(rest / 2, each = 2L)
  build$add("masses", node = as.vector(ends), mass = half * rope$mass_per_length,
    volume = half * rope$volume_per_length, height = rep(rope$diameter, 2L * m),
    surface = rep(height, each = 2L), area = half * rope$diameter)
}

# Knots at nodes of panels, with the mass of their twine, as spheres; count: joins of bars at each
# node. Those of a screen drag with it.
add_knots <- function(build, panels, parts, panel, node, count) {
  diameter <- panels$knot_diameter[panel]
  some <- diameter > 0
  joins <- 1 + (panels$straight_bar > 0)
  twine <- (count * (panels$knot_twine / joins)[panel])[some]
  build$add("masses", node = node[some],
    mass = twine * panels$mass_per_length[panel][some],
    volume = twine * panels$volume_per_length[panel][some], height = diameter[some],
    surface = surface_height(diameter, panels$mesh_size[panel] * sqrt(count))[some],
    area = numeric(sum(some)))
  build$add("spheres", node = node[some],
    drag_area = (pi / 4 * diameter^2 * count *
      (panels$netting_drag[panel] %in% c("twines", "blended")))[some],
    diameter = diameter[some], smooth = logical(sum(some)),
    added_mass = (0.5 * pi / 6 * diameter^3 * count)[some],
    height = surface_height(diameter, panels$mesh_size[panel] * sqrt(count))[some],
    part = parts[panel][some])
}

# Mass and volume of twine; length: m of it at each of these nodes of panels, extent: length (m) of
# the element that it is of.
add_twine <- function(build, panels, panel, node, length, extent) {
  diameter <- twine_width(panels)[panel]
  build$add("masses", node = node, mass = length * panels$mass_per_length[panel],
    volume = length * panels$volume_per_length[panel], height = diameter,
    surface = surface_height(diameter, extent), area = length * diameter)
}

# Panels as cells. panels: a table; numbers, parts: which panels and parts of the gear they are.
# Both return what the views draw of each panel.
add_cell_panels <- function(build, panels, numbers, parts, division) {
  along <- function(side) {
    edges <- 4L * (numbers - 1L) + side
    count <- division$count[edges]
    list(fraction = division$fraction[sequence(count, division$before[edges] + 1L)], count = count)
  }
  found <- cell_elements(panels, along(1L), along(3L))
  node <- matrix(unlist(division$grids[numbers])[found$corner], 4L)
  part <- parts[found$panel]
  hexagonal <- which(found$straight > 0)
  inner <- integer(length(found$rest))
  inner[hexagonal] <- build$new_nodes(length(hexagonal))
  # The side of a square of its netting, stretched.
  extent <- (found$rest + found$straight) *
    sqrt((1 + has_three_corners(found$corner)) * found$bars / found$multiplicity)
  build$add("cells", node = as.vector(node), twine = as.vector(rbind(
    found$u[1L, ], found$v[1L, ], found$u[2L, ], found$v[2L, ],
    found$u[3L, ], found$v[3L, ], found$u[4L, ], found$v[4L, ]
  )), rest = found$rest, straight = found$straight, inner = inner,
    multiplicity = found$multiplicity,
    height = surface_height(twine_width(panels)[found$panel], extent),
    material = part, part = part)
  add_cell_sheets(build, panels, found, node, part)
  # Of three corners the last stands twice.
  share <- corner_shares(found$u, found$v)
  kept <- which(share > 0)
  node <- node[kept]
  bars <- (share * rep(found$bars, each = 4L))[kept]
  panel <- rep(found$panel, each = 4L)[kept]
  # Half of the twine of hexagonal netting, and a knot of each cell, belong to the inner node.
  twine <- bars * cell_twine(panels)[panel] * (1 - 0.5 * (rep(inner, each = 4L)[kept] > 0L))
  add_twine(build, panels, panel, node, twine, rep(extent, each = 4L)[kept])
  of_hexagons <- found$panel[hexagonal]
  add_twine(build, panels, of_hexagons, inner[hexagonal],
    found$bars[hexagonal] / 2 * cell_twine(panels)[of_hexagons], extent[hexagonal])
  add_knots(build, panels, parts, of_hexagons, inner[hexagonal], found$bars[hexagonal])
  # A node of two panels has knots of both.
  knotted <- which(panels$knot_diameter[panel] > 0)
  key <- panel[knotted] * as.double(division$nodes) + node[knotted]
  first <- knotted[!duplicated(key)]
  add_knots(build, panels, parts, panel[first], node[first],
    as.vector(rowsum(bars[knotted], key, reorder = FALSE)))
  .mapply(
    function(...) list(netting = "cells", ...), list(
      grid = division$grids[numbers],
      cell = split_runs(found$cell, tabulate(found$panel, length(numbers)))
    ), NULL
  )
}

# Sheets of cells that slow the water behind them: triangles, halved as hexagonal netting is.
add_cell_sheets <- function(build, panels, found, node, part) {
  some <- which(panels$shielding[found$panel] != "none")
  pointed <- has_three_corners(found$corner[, some, drop = FALSE])
  three <- some[pointed]
  four <- some[!pointed]
  place <- function(cells, corners) 4L * rep(cells - 1L, each = corners) + seq_len(corners)
  halved <- half_cells(matrix(place(four, 4L), 4L), found$side[four])
  corner <- cbind(matrix(place(three, 3L), 3L), halved$corner[1:3, , drop = FALSE])
  of <- (corner[1L, ] - 1L) %/% 4L + 1L
  u <- matrix(found$u[corner], 3L)
  v <- matrix(found$v[corner], 3L)
  bars <- triangle_area(u, v) * c(found$multiplicity[three], halved$multiplicity)
  build$add("wake_sheets", node = node[corner], part = part[of],
    law = panels$shielding[found$panel][of],
    twine_area = bars * (2 * found$rest[of] + found$straight[of]) *
      twine_width(panels)[found$panel[of]])
}

add_bar_panels <- function(build, panels, numbers, parts, division, grouping) {
  elements <- if (division$nodes > most_remembered_nodes) bar_elements else bar_elements_again
  found <- elements(panels[panel_shape_fields], grouping)
  points <- found$points
  bars <- found$bars
  id <- integer(length(points$i))
  between <- integer(length(bars$between$i))
  free <- which(points$edge == 0L)
  # Nodes of each panel follow each other: its knots, then the middles of its bars.
  order <- order(c(points$panel[free], bars$between$panel))
  own <- integer(length(order))
  own[order] <- build$new_nodes(length(order))
  id[free] <- own[seq_along(free)]
  between <- own[length(free) + seq_along(between)]

  edge <- 4L * (numbers[points$panel] - 1L) + points$edge
  on <- which(points$edge > 0L)
  id[on] <- edge_points(build, division, edge[on], points$fraction[on])

  ends <- bars$ends
  inner <- ends < 0L
  ends[!inner] <- id[ends[!inner]]
  ends[inner] <- between[-bars$ends[inner]]
  if (any(panels$shielding != "none")) {
    add_bar_wake_sheets(build, panels, parts, bars, ends, grouping$segments)
  }
  half <- rep(bars$rest * bars$multiplicity / 2, each = 2L)
  add_twine(build, panels, rep(bars$panel, each = 2L), ends, half, rep(bars$rest, each = 2L))
  second <- seq.int(2L, by = 2L, length.out = length(bars$rest))
  keep <- ends[second - 1L] != ends[second]
  part <- parts[bars$panel[keep]]
  build$add("bars", node = ends[rep(keep, each = 2L)], rest = bars$rest[keep],
    multiplicity = bars$multiplicity[keep],
    height = surface_height(
      twine_width(panels)[bars$panel[keep]], bars$rest[keep]
    ), material = part, part = part)
  add_knots(build, panels, parts, points$panel, id, points$knots)
  add_bar_sheets(build, panels, numbers, parts, division, points, id, grouping$lambda)

  of <- c(points$panel, bars$between$panel)
  order <- order(of)
  by_panel <- function(x) split_runs(x[order], tabulate(of, length(numbers)))
  .mapply(
    function(...) list(netting = "bars", ...), list(
      node = by_panel(c(id, between)), i = by_panel(c(points$i, bars$between$i)),
      j = by_panel(c(points$j, bars$between$j)), lambda = grouping$lambda,
      segments = grouping$segments
    ), NULL
  )
}

# Wake sheets between equivalent bars: half a mesh below every knot where two of them begin, and
# half a mesh above every knot where two end; each panel's twine is spread evenly over its sheets.
# ends: points at both ends of every segment of a bar; segments: of the bars of every panel.
add_bar_wake_sheets <- function(build, panels, parts, bars, ends, segments) {
  ends <- matrix(ends, 2L)
  segments <- segments[bars$panel]
  first <- cumsum(c(TRUE, diff(bars$panel) != 0))
  place <- sequence(tabulate(first)) - 1L
  begins <- which(place %% segments == 0L)
  from <- ends[1L, begins]
  to <- ends[2L, begins + segments[begins] - 1L]
  panel <- bars$panel[begins]
  pairs <- function(knot, other) {
    order <- order(panel, knot)
    n <- length(order)
    same <- which(knot[order][-1L] == knot[order][-n] & panel[order][-1L] == panel[order][-n])
    list(
      node = rbind(knot[order[same]], other[order[same]], other[order[same + 1L]]),
      panel = panel[order[same]]
    )
  }
  below <- pairs(from, to)
  above <- pairs(to, from)
  node <- cbind(below$node, above$node)
  of <- c(below$panel, above$panel)
  area <- 2 * panel_bars(panels) * panels$mesh_size / 2 * twine_width(panels)
  build$add("wake_sheets", node = as.vector(node), part = parts[of], law = panels$shielding[of],
    twine_area = (area / tabulate(of, length(area)))[of])
}

# Of a plan's directions of lift the engine's and the sign.
lift_directions <- list(
  up = list(to = "up", sign = 1), down = list(to = "up", sign = -1),
  starboard = list(to = "sideways", sign = 1), port = list(to = "sideways", sign = -1)
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
  build$add("masses", node = node, mass = n * piece$mass, volume = n * piece$volume,
    height = rep(piece$height, k), surface = rep(piece$height, k), area = n * piece$height^2)
  build$add("spheres", node = node, drag_area = n * piece$drag_area,
    diameter = rep(piece$smooth_diameter, k), smooth = rep(piece$smooth_diameter > 0, k),
    added_mass = if (density > 0) n * piece$added_mass / density else 0 * n,
    height = rep(piece$height, k), part = rep(part, k))
  if (piece$lift_area != 0) {
    way <- lift_directions[[piece$lift_direction]]
    build$add("lifts", node = node, lift_area = n * piece$lift_area * way$sign,
      direction = rep(way$to, k), height = rep(piece$height, k), part = rep(part, k))
  }
  if (piece$upward_lift_area != 0) {
    build$add("lifts", node = node, lift_area = n * piece$upward_lift_area,
      direction = rep("up", k), height = rep(piece$height, k), part = rep(part, k))
  }
}

# Which nodes are held, where they are, and the plan's loads: list(held, position and load 3 x n).
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
# panels: the table; ropes: how many parts come before the panels.
check_totals <- function(lattice, panels, ropes) {
  bars <- lattice$engine$bars
  cells <- lattice$engine$cells
  parts <- nrow(lattice$parts)
  held <- sum_by(bars$rest * bars$multiplicity, lattice$bar_part, parts) +
    sum_by(cell_bars(cells) * (2 * cells$rest + cells$straight),
      lattice$cell_part, parts)
  planned <- panel_bars(panels) * cell_twine(panels)
  held <- held[ropes + seq_along(planned)]
  wrong <- which(abs(held - planned) > 1e-6 * planned)[1L]
  if (is.na(wrong)) return(invisible())
  abort_lattice(
    "Panel {.field {lattice$parts$name[ropes + wrong]}} has {signif(planned[wrong], 6)} m of twine
    in the plan and {signif(held[wrong], 6)} m in the lattice."
  )
}
