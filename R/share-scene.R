# What a shared page draws of a shape that it settles: how points, tensions and meshes that the
# viewer takes follow from the engine's numbers. Numbers count from 0.

# shape: as scene_shape() gives it; keep(x): keeps a long array and gives its name.
shared_scene <- function(state, shape, keep) {
  lattice <- state$lattice
  fixed <- shape$fixed
  ropes <- rope_groups(state)
  netting <- netting_groups(state)
  stopifnot(ropes$count == length(shape$ropes), netting$count == length(shape$u))
  c(
    list(
      drawn = keep(fixed$drawn - 1L), marks = shared_marks(state, fixed$marks),
      rope = keep_groups(ropes, keep), values = length(shape$u),
      u = keep_groups(netting$u, keep), v = keep_groups(netting$v, keep),
      boards = unname(lapply(state$si$otter_boards, function(board) {
        I(unname(lattice$points[board$points]) - 1L)
      })),
      ties = list(first = keep(as.integer(lattice$engine$ties$first) - 1L),
        second = keep(as.integer(lattice$engine$ties$second) - 1L))
    ),
    if (length(state$si$panels)) list(meshes = shared_meshes(state, fixed$netting, keep))
  )
}

keep_groups <- function(groups, keep) {
  list(element = keep(as.integer(groups$element) - 1L), group = keep(as.integer(groups$group) - 1L),
    weight = keep(single_floats(groups$weight)), bars = isTRUE(groups$bars), count = groups$count,
    split = groups$split)
}

# Bars of ropes by the line that is drawn through them; see rope_lines().
rope_groups <- function(state, limit = scene_limit) {
  lattice <- state$lattice
  ropes <- which(lattice$parts$kind == "rope")
  k <- ceiling(sum(lattice$bar_part %in% ropes) / limit)
  element <- group <- integer()
  last <- 0L
  for (part in ropes) {
    bars <- bars_of_part(state, part)
    if (!length(bars)) next
    line <- (seq_along(bars) - 1L) %/% k + 1L
    element <- c(element, bars)
    group <- c(group, last + line)
    last <- last + max(line)
  }
  list(element = element, group = group, weight = lattice$engine$bars$rest[element], count = last)
}

# Elements by the place of netting that shows their tension, for u and v; see netting_surfaces().
# Of those the first `split` are bars, the others cells.
netting_groups <- function(state, limit = scene_limit) {
  draw <- netting_to_draw(state, limit)
  none <- list(element = integer(), group = integer(), weight = numeric())
  of <- list(u = list(bars = none, cells = none), v = list(bars = none, cells = none))
  add <- function(way, kind, element, group, weight) {
    old <- of[[way]][[kind]]
    of[[way]][[kind]] <<- list(element = c(old$element, element), group = c(old$group, group),
      weight = c(old$weight, weight))
  }
  last <- 0L
  for (p in seq_along(draw$part)) {
    if (draw$of_bars[p]) {
      cloud <- draw$clouds[[p]]
      for (way in c("u", "v")) {
        add(way, "bars", cloud[[way]]$bar, last + cloud[[way]]$at, rep(1, length(cloud[[way]]$at)))
      }
      last <- last + length(cloud$point)
    } else {
      cells <- block_cells(state, names(draw$drawn)[p], draw$part[p], draw$block)
      for (way in c("u", "v")) add(way, "cells", cells$cell, last + cells$block, cells$weight)
      last <- last + cells$count
    }
  }
  joined <- lapply(of, function(way) {
    list(
      element = c(way$bars$element, way$cells$element), group = c(way$bars$group, way$cells$group),
      weight = c(way$bars$weight, way$cells$weight), count = last, split = length(way$bars$element)
    )
  })
  c(joined, list(count = last))
}

# Nodes in whose middle each mark lies.
shared_marks <- function(state, marks) {
  lattice <- state$lattice
  points <- state_points(state)
  key <- function(x) paste(x[1L, ], x[2L, ], x[3L, ])
  node <- match(key(t(as.matrix(marks[c("x", "y", "z")]))), key(points))
  lapply(seq_len(NROW(marks)), function(k) {
    board <- state$si$otter_boards[[as.character(marks$part[k])]]
    I(if (is.null(board)) node[k] - 1L else unname(lattice$points[board$points]) - 1L)
  })
}

# What mesh_means() takes of the lattice.
shared_meshes <- function(state, netting, keep) {
  meshes <- state$lattice$frame$meshes
  panel <- meshes$row_panel[meshes$row + 1L]
  list(
    panel = keep(panel - 1L), unit = keep(meshes$unit),
    means = keep_sparse(mesh_mean_terms(state, netting, meshes, panel), keep)
  )
}

# Rows of a sparse matrix, one after the other.
keep_sparse <- function(terms, keep) {
  good <- which(terms$weight != 0)
  order <- good[order(terms$row[good], terms$column[good])]
  list(
    count = keep(tabulate(terms$row[order], terms$rows)), column = keep(terms$column[order] - 1L),
    weight = keep(terms$weight[order])
  )
}

# How mesh_means() takes what the netting's places show from all places of meshes.
mesh_mean_terms <- function(state, netting, meshes, panel) {
  table <- panel_table(state$si$panels)
  rows <- list(panel = meshes$row_panel, t = meshes$row_t, row = meshes$row + 1L, s = meshes$s)
  places <- panel_places(table, state$lattice$division, state$lattice$panels)
  on <- rows_at(places, rows)
  key <- function(panel, node) panel * 1e9 + node
  at <- match(key(rep(netting$panel, each = nrow(netting$at)), netting$at),
    key(places$panel, places$node))
  place <- rep(seq_len(ncol(netting$at)), each = nrow(netting$at))[!is.na(at)]
  at <- at[!is.na(at)]
  share <- (1 / tabulate(place, ncol(netting$at)))[place]
  list(
    row = rep(place, 4L),
    column = c(on$before$low[at], on$before$high[at], on$after$low[at], on$after$high[at]),
    weight = share * c(
      (1 - on$share[at]) * (1 - on$before$share[at]), (1 - on$share[at]) * on$before$share[at],
      on$share[at] * (1 - on$after$share[at]), on$share[at] * on$after$share[at]
    ),
    rows = ncol(netting$at)
  )
}
