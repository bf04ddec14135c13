# Netting of a state as surfaces for the viewer: points with mesh coordinates, between which the
# viewer draws the twines of the real meshes. A panel of cells is a grid of its points. A panel of
# equivalent bars is a cloud of its points, which the viewer divides into triangles.

# Returns the data from which netting is drawn. `of_bars`: TRUE for panels of bars. `block`: cells
# drawn as a single cell. `clouds`: clouds of panels of bars, or NULL.
netting_to_draw <- function(state, limit) {
  drawn <- state$mesh$panels
  part <- netting_parts(state)
  of_bars <- netting_of_bars(state)
  block <- block_to_draw(lapply(drawn[!of_bars], `[[`, "grid"), limit)
  places <- panel_places(panel_table(state$si$panels), state$mesh$division, drawn)
  clouds <- if (any(of_bars)) netting_clouds(what_clouds_are_of(state), part, places)
  list(
    drawn = drawn, part = part, of_bars = of_bars, block = block, places = places, clouds = clouds
  )
}

# Returns the surfaces of netting. A location is a cell of a grid (across first) or a point of a
# cloud, panel after panel. limit: total number of cells and cloud points.
#
# `u`, `v`: mean tension (N) of the twines along u and v at each location, NA if no twine of the
# family ends there. `at`: corners of each location (4 x locations; a point is repeated). `panel`:
# panel of each location. `panels`: list by panel. Its `columns` and `rows` are 0 for a cloud,
# `point` are numbers of the state's points, and `mesh` their twine coordinates u and v (see
# netting.hpp).
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
        caught_netting(state, names(state$mesh$panels)[p]))
    }),
    u = tension("u", state$u_tension), v = tension("v", state$v_tension),
    at = matrix(as.integer(unlist(lapply(made, `[[`, "at"))), 4L),
    panel = rep.int(seq_along(made), vapply(made, function(one) ncol(one$at), 0L)), groups = groups
  )
}

# Returns the elements that define the tension of each location along u and v. `element`: bars of
# clouds (`split` is their number), then cells. `group`, `weight`: location and weight of each
# element. `count`: number of locations.
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

# Returns list(down, full). `down`: weights of u and v in the depth (meshes). `full`: depth from
# which the panel is full of catch, NULL without catch.
caught_netting <- function(state, name) {
  panel <- state$si$panels[[name]]
  list(
    down = if (panel$orientation == "square") c(0, 1) else c(0.5, 0.5),
    full = if (name %in% state$si$catch$panels) panel$deep - state$mesh$catch$blocked
  )
}

grid_surface <- function(state, p, part, block, places) {
  name <- names(state$mesh$panels)[p]
  grid <- state$mesh$panels[[p]]$grid
  columns <- block_ends(nrow(grid), block)
  rows <- block_ends(ncol(grid), block)
  coarse <- grid[columns, rows, drop = FALSE]
  # `panel_places()` lists the nodes of grids first, each grid in its order.
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

# Returns only the data that clouds depend on. The tank solves the same mesh repeatedly, and
# `netting_clouds()` then reuses its result.
what_clouds_are_of <- function(state) {
  mesh <- state$mesh
  list(
    si = list(panels = state$si$panels),
    mesh = list(
      panels = mesh$panels, bar_part = mesh$bar_part,
      nodes = mesh$nodes, model = list(bars = mesh$model$bars["node"])
    )
  )
}

netting_clouds <- remembered(new_netting_clouds)

new_netting_clouds <- function(of, part, places) {
  lapply(seq_along(of$mesh$panels), function(p) {
    if (of$mesh$panels[[p]]$netting == "bars") cloud_frame(of, p, part[p], places)
  })
}

# Returns the fixed data of a panel's cloud: knots, middles of bars and nodes on its edges. `u` and
# `v` list the bars that end at its points: list(bar, at (number of the point)).
cloud_frame <- function(of, p, part, places) {
  name <- names(of$mesh$panels)[p]
  drawn <- of$mesh$panels[[p]]
  panel <- of$si$panels[[name]]
  on_edges <- which(places$panel == p)
  node <- point_number(drawn$node, of$mesh$nodes)
  left <- panel_left(panel, drawn$j)
  s <- (drawn$i - left) / pmax(panel_right(panel, drawn$j) - left, 1e-9)
  point <- c(node, point_number(places$node[on_edges], of$mesh$nodes))
  s <- c(pmin(pmax(s, 0), 1), places$s[on_edges])
  t <- c(drawn$j / panel$deep, places$t[on_edges])
  kept <- which(!duplicated(round(s * 1e6) + 1e7 * round(t * 1e6)))
  point <- point[kept]
  bars <- bars_of_part(of, part)
  ends <- bar_ends(of, bars)
  family <- bar_twines(of, name, ends)$family
  # Family 1 runs along u.
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

# Returns twine coordinates u and v (2 x points) at fractions s (across) and t (deep) of a panel.
twine_coordinates <- function(panel, s, t) {
  j <- t * panel$deep
  left <- panel_left(panel, j)
  i <- left + s * (panel_right(panel, j) - left)
  if (panel$orientation == "square") rbind(i, j) else rbind(i + j, j - i)
}
