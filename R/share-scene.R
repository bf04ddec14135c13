# The drawing of a shape that a page settles: indices and weights that give the viewer's points,
# tensions and meshes from the engine's arrays. Indices start at 0.

# shape: from scene_shape(); keep(x): stores a long array and returns its name.
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

# Each mark is at the centre of its nodes.
shared_marks <- function(state, marks) {
  mesh <- state$mesh
  points <- state_points(state)
  key <- function(x) paste(x[1L, ], x[2L, ], x[3L, ])
  node <- match(key(t(as.matrix(marks[c("x", "y", "z")]))), key(points))
  lapply(seq_len(NROW(marks)), function(k) {
    board <- state$si$otter_boards[[as.character(marks$part[k])]]
    I(if (is.null(board)) node[k] - 1L else unname(mesh$points[board$points]) - 1L)
  })
}

# Returns the input of mesh_means().
shared_meshes <- function(state, netting, keep) {
  meshes <- state$mesh$model$frame$meshes
  panel <- meshes$row_panel[meshes$row + 1L]
  list(
    panel = keep(panel - 1L), unit = keep(meshes$unit),
    means = keep_sparse(mesh_mean_terms(state, netting$panel, netting$at), keep)
  )
}

keep_sparse <- function(terms, keep) {
  good <- which(terms$weight != 0)
  order <- good[order(terms$row[good], terms$column[good])]
  list(
    count = keep(tabulate(terms$row[order], terms$rows)), column = keep(terms$column[order] - 1L),
    weight = keep(terms$weight[order])
  )
}
