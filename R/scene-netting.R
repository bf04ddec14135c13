# The netting of a state as surfaces for the viewer: points with their mesh coordinates, between
# which the viewer draws the twines of the real meshes. A panel of cells is a grid of its points;
# one of equivalent bars is a cloud of them, which the viewer divides into triangles.

# limit: of cells and points of clouds together.
# Returns list(panels = a list of list(part, columns, rows (0 of a cloud), point = numbers of the
# state's points, mesh = twine coordinates u and v of each (see cell_elements())), u, v = mean
# tension (N) of the twines along u and v, of every cell of grids (across first) and every point of
# clouds (NA where no twine of the family ends), panel after panel, at = the corners of those places
# (4 x places; of a point four times itself), panel = their panel's number).
netting_surfaces <- function(state, limit = drawn_lines) {
  drawn <- state$lattice$panels
  part <- netting_parts(state)
  of_bars <- vapply(drawn, function(p) p$netting == "bars", NA)
  block <- block_to_draw(lapply(drawn[!of_bars], `[[`, "grid"), limit)
  places <- panel_places(panel_table(state$si$panels), state$lattice$division, drawn)
  made <- lapply(seq_along(drawn), function(p) {
    if (of_bars[p]) {
      cloud_surface(state, p, part[p], places)
    } else {
      grid_surface(state, p, part[p], block, places)
    }
  })
  join <- function(field) unlist(lapply(made, `[[`, field), use.names = FALSE)
  list(
    panels = lapply(made, `[`, c("part", "columns", "rows", "point", "mesh")),
    u = as.double(join("u")), v = as.double(join("v")), at = matrix(as.integer(join("at")), 4L),
    panel = rep.int(seq_along(made), vapply(made, function(m) length(m$u), 0L))
  )
}

grid_surface <- function(state, p, part, block, places) {
  name <- names(state$lattice$panels)[p]
  blocks <- panel_blocks(state, name, part, block)
  grid <- state$lattice$panels[[p]]$grid
  coarse <- grid[blocks$columns, blocks$rows, drop = FALSE]
  # of the nodes of grids panel_places() tells first, each grid in its order
  mine <- which(places$panel == p)[seq_along(grid)]
  kept <- mine[as.vector(matrix(seq_along(grid), nrow(grid))[blocks$columns, blocks$rows])]
  corner <- function(c, r) {
    as.vector(coarse[seq_len(nrow(coarse) - 1L) + c, seq_len(ncol(coarse) - 1L) + r])
  }
  list(
    part = part, columns = nrow(coarse), rows = ncol(coarse), point = as.vector(coarse),
    mesh = twine_coordinates(state$si$panels[[name]], places$s[kept], places$t[kept]),
    u = blocks$u, v = blocks$v,
    at = rbind(corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1))
  )
}

# The knots and middles of bars of a panel, with the nodes on its edges.
cloud_surface <- function(state, p, part, places) {
  name <- names(state$lattice$panels)[p]
  drawn <- state$lattice$panels[[p]]
  panel <- state$si$panels[[name]]
  on_edges <- which(places$panel == p)
  node <- point_number(drawn$node, state$lattice$engine$nodes)
  left <- panel_left(panel, drawn$j)
  s <- (drawn$i - left) / pmax(panel_right(panel, drawn$j) - left, 1e-9)
  point <- c(node, point_number(places$node[on_edges], state$lattice$engine$nodes))
  s <- c(pmin(pmax(s, 0), 1), places$s[on_edges])
  t <- c(drawn$j / panel$deep, places$t[on_edges])
  kept <- which(!duplicated(round(s * 1e6) + 1e7 * round(t * 1e6)))
  point <- point[kept]
  bars <- bars_of_part(state, part)
  ends <- bar_ends(state, bars)
  family <- bar_twines(state, name, ends)$family
  # u twines run along u
  mean_at <- function(which) {
    on <- which(family == which)
    tension <- rep(state$bar_tension[bars[on]], each = 2L)
    at <- match(as.vector(ends[, on]), point)
    good <- !is.na(at)
    weighted_means(tension[good], rep(1, sum(good)), at[good], length(point))
  }
  u <- mean_at(1L)
  v <- mean_at(2L)
  mesh <- twine_coordinates(panel, s[kept], t[kept])
  list(
    part = part, columns = 0L, rows = 0L, point = point,
    mesh = rbind(
      on_drawn_twines(mesh[1L, ], match(ends[, family == 2L], point), drawn$lambda),
      on_drawn_twines(mesh[2L, ], match(ends[, family == 1L], point), drawn$lambda)
    ),
    u = ifelse(is.nan(u), NA, u), v = ifelse(is.nan(v), NA, v),
    at = matrix(rep(point, each = 4L), 4L)
  )
}

# A twine coordinate of the points of a cloud turned so that equivalent twines (on: points on those
# across the coordinate) lie at whole numbers, with as many twines between them as there are meshes:
# between twines that hang freely a mesh drawn would wave as none does.
on_drawn_twines <- function(coordinate, on, lambda) {
  phase <- Arg(mean(exp(2i * pi * coordinate[on[!is.na(on)]] / lambda))) / (2 * pi)
  max(1, floor(lambda + 1e-9)) * (coordinate / lambda - if (is.nan(phase)) 0 else phase)
}

# Twine coordinates u and v (2 x places) at shares across and deep of a panel.
twine_coordinates <- function(panel, s, t) {
  j <- t * panel$deep
  left <- panel_left(panel, j)
  i <- left + s * (panel_right(panel, j) - left)
  if (panel$orientation == "square") rbind(i, j) else rbind(i + j, j - i)
}
