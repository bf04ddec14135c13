# The netting of a state as surfaces for the viewer: points with their mesh coordinates, between
# which the viewer draws the twines of the real meshes. A panel of cells is a grid of its points;
# one of equivalent bars is a cloud of them, which the viewer divides into triangles.

# What netting is drawn by: list(drawn = the lattice's panels, part = the number of each, of_bars =
# whether it is, block = cells drawn as one, places, clouds = of those of bars or NULL).
netting_to_draw <- function(state, limit) {
  drawn <- state$lattice$panels
  part <- netting_parts(state)
  of_bars <- netting_of_bars(state)
  block <- block_to_draw(lapply(drawn[!of_bars], `[[`, "grid"), limit)
  places <- panel_places(panel_table(state$si$panels), state$lattice$division, drawn)
  clouds <- if (any(of_bars)) netting_clouds(what_clouds_are_of(state), part, places)
  list(
    drawn = drawn, part = part, of_bars = of_bars, block = block, places = places, clouds = clouds
  )
}

# limit: of cells and points of clouds together.
# Returns list(panels = a list of list(part, columns, rows (0 of a cloud), point = numbers of the
# state's points, mesh = twine coordinates u and v of each (see netting.hpp), down, full = as
# caught_netting() has them), u, v = mean
# tension (N) of the twines along u and v, of every cell of grids (across first) and every point of
# clouds (NA where no twine of the family ends), panel after panel, at = the corners of those places
# (4 x places; of a point four times itself), panel = their panel's number, groups = as
# netting_groups() returns them).
netting_surfaces <- function(state, limit = drawn_lines) {
  draw <- netting_to_draw(state, limit)
  made <- lapply(seq_along(draw$part), function(p) {
    if (draw$of_bars[p]) draw$clouds[[p]] else {
      grid_surface(state, p, draw$part[p], draw$block, draw$places)
    }
  })
  groups <- netting_groups(state, draw)
  tension <- function(way, of_cells) {
    of <- groups[[way]]
    of_bars <- seq_along(of$element) <= of$split
    tension <- c(state$bar_tension[of$element[of_bars]], of_cells[of$element[!of_bars]])
    mean <- weighted_means(tension, of$weight, of$group, of$count)
    ifelse(is.nan(mean), NA, mean)
  }
  twines <- drawn_twines(state$si)
  list(
    panels = lapply(seq_along(made), function(p) {
      c(made[[p]][c("part", "columns", "rows", "point", "mesh")],
        list(scale = twines$scale[p], offset = twines$offset[, p]),
        caught_netting(state, names(state$lattice$panels)[p]))
    }),
    u = tension("u", state$u_tension), v = tension("v", state$v_tension),
    at = matrix(as.integer(unlist(lapply(made, `[[`, "at"))), 4L),
    panel = rep.int(seq_along(made), vapply(made, function(one) ncol(one$at), 0L)), groups = groups
  )
}

# What shows the tension of each place of such surfaces along u and v: of each way list(element =
# bars of clouds, `split` of them, then cells, group = the place of each, weight, count = places).
netting_groups <- function(state, draw) {
  each <- lapply(seq_along(draw$part), function(p) {
    if (draw$of_bars[p]) {
      cloud <- draw$clouds[[p]]
      ends <- lapply(cloud[c("u", "v")], function(on) {
        list(element = on$bar, group = on$at, weight = rep(1, length(on$at)))
      })
      return(c(list(count = length(cloud$point)), ends))
    }
    of <- block_cells(state, names(draw$drawn)[p], draw$part[p], draw$block)
    cells <- list(element = of$cell, group = of$block, weight = of$weight)
    list(count = of$count, u = cells, v = cells)
  })
  count <- vapply(each, `[[`, 0L, "count")
  before <- cumsum(c(0L, count))[seq_along(count)]
  bars_first <- order(!draw$of_bars)
  lapply(c(u = "u", v = "v"), function(way) {
    ways <- lapply(each, `[[`, way)[bars_first]
    join <- function(field) unlist(lapply(ways, `[[`, field))
    size <- lengths(lapply(ways, `[[`, "element"))
    list(
      element = join("element"), group = join("group") + rep.int(before[bars_first], size),
      weight = join("weight"), count = sum(count), split = sum(size[draw$of_bars[bars_first]])
    )
  })
}

# Where a catch fills a panel: list(down = what u and v count for depth in meshes, full = the depth
# from which on it is full, NULL where nothing fills it).
caught_netting <- function(state, name) {
  panel <- state$si$panels[[name]]
  list(
    down = if (panel$orientation == "square") c(0, 1) else c(0.5, 0.5),
    full = if (name %in% state$si$catch$panels) panel$deep - state$lattice$catch$blocked
  )
}

grid_surface <- function(state, p, part, block, places) {
  name <- names(state$lattice$panels)[p]
  grid <- state$lattice$panels[[p]]$grid
  columns <- block_ends(nrow(grid), block)
  rows <- block_ends(ncol(grid), block)
  coarse <- grid[columns, rows, drop = FALSE]
  # of the nodes of grids panel_places() tells first, each grid in its order
  mine <- which(places$panel == p)[seq_along(grid)]
  kept <- mine[as.vector(matrix(seq_along(grid), nrow(grid))[columns, rows])]
  corner <- function(c, r) {
    as.vector(coarse[seq_len(nrow(coarse) - 1L) + c, seq_len(ncol(coarse) - 1L) + r])
  }
  list(
    part = part, columns = nrow(coarse), rows = ncol(coarse), point = as.vector(coarse),
    mesh = twine_coordinates(state$si$panels[[name]], places$s[kept], places$t[kept]),
    at = rbind(corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1))
  )
}

# What of a state tells how its clouds are joined, and no more: the tank settles the same lattice
# again and again.
what_clouds_are_of <- function(state) {
  lattice <- state$lattice
  list(
    si = list(panels = state$si$panels),
    lattice = list(
      panels = lattice$panels, bar_part = lattice$bar_part,
      nodes = lattice$nodes, mesh = list(bars = lattice$mesh$bars["node"])
    )
  )
}

# The clouds of the panels of bars of what what_clouds_are_of() gives, by panel.
netting_clouds <- remembered(new_netting_clouds)

new_netting_clouds <- function(of, part, places) {
  lapply(seq_along(of$lattice$panels), function(p) {
    if (of$lattice$panels[[p]]$netting == "bars") cloud_frame(of, p, part[p], places)
  })
}

# The knots and middles of bars of a panel, with the nodes on its edges: what a surface has that
# does not move, and for u and v the bars that end at its points, list(bar, at = at which).
cloud_frame <- function(of, p, part, places) {
  name <- names(of$lattice$panels)[p]
  drawn <- of$lattice$panels[[p]]
  panel <- of$si$panels[[name]]
  on_edges <- which(places$panel == p)
  node <- point_number(drawn$node, of$lattice$nodes)
  left <- panel_left(panel, drawn$j)
  s <- (drawn$i - left) / pmax(panel_right(panel, drawn$j) - left, 1e-9)
  point <- c(node, point_number(places$node[on_edges], of$lattice$nodes))
  s <- c(pmin(pmax(s, 0), 1), places$s[on_edges])
  t <- c(drawn$j / panel$deep, places$t[on_edges])
  kept <- which(!duplicated(round(s * 1e6) + 1e7 * round(t * 1e6)))
  point <- point[kept]
  bars <- bars_of_part(of, part)
  ends <- bar_ends(of, bars)
  family <- bar_twines(of, name, ends)$family
  # u twines run along u
  ending <- function(which) {
    on <- which(family == which)
    at <- match(as.vector(ends[, on]), point)
    good <- !is.na(at)
    list(bar = rep(bars[on], each = 2L)[good], at = at[good])
  }
  list(
    part = part, columns = 0L, rows = 0L, point = point,
    mesh = twine_coordinates(panel, s[kept], t[kept]),
    u = ending(1L), v = ending(2L), at = matrix(rep(point, each = 4L), 4L)
  )
}

# Twine coordinates u and v (2 x places) at shares across and deep of a panel.
twine_coordinates <- function(panel, s, t) {
  j <- t * panel$deep
  left <- panel_left(panel, j)
  i <- left + s * (panel_right(panel, j) - left)
  if (panel$orientation == "square") rbind(i, j) else rbind(i + j, j - i)
}
