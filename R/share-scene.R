# What a shared page draws of a shape that it settles: how points, tensions and meshes that the
# viewer takes follow from the engine's numbers. Numbers count from 0.

# shape: as scene_shape() gives it; keep(x): keeps a long array and gives its name.
shared_scene <- function(state, shape, keep) {
  fixed <- shape$fixed
  netting <- fixed$netting$groups
  c(
    list(
      drawn = keep(fixed$drawn - 1L), marks = shared_marks(state, fixed$marks),
      rope = keep_groups(fixed$groups, keep),
      u = keep_groups(netting$u, keep), v = keep_groups(netting$v, keep)
    ),
    if (length(state$si$panels)) list(meshes = shared_meshes(state, fixed$netting, keep))
  )
}

keep_groups <- function(groups, keep) {
  list(element = keep(as.integer(groups$element) - 1L), group = keep(as.integer(groups$group) - 1L),
    weight = keep(single_floats(groups$weight)), count = groups$count, split = groups$split)
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
  meshes <- state$lattice$mesh$frame$meshes
  panel <- meshes$row_panel[meshes$row + 1L]
  list(
    panel = keep(panel - 1L), unit = keep(meshes$unit),
    means = keep_sparse(mesh_mean_terms(state, netting$panel, netting$at), keep)
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
