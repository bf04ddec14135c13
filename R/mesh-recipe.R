# Changes of a gear's default mesh, and the recipe that rebuilds a mesh.

# Returns a mesh with other values of some fields than its gear defines.
change_mesh <- function(mesh, fields) {
  mesh$model <- changed_model(mesh$model, fields)
  # Recipes store the wake separately.
  fields$wake <- NULL
  if (length(fields)) {
    mesh$changes <- utils::modifyList(first_of(mesh$changes, list()), fields, keep.null = TRUE)
  }
  mesh
}

# Returns the data that rebuild a mesh, together with the numbers of its gear. It contains the
# requested number of nodes, the panels with `bars`, the counts that define the mesh, the wake, and
# the front of a catch. For a time step of a tow, it adds other differences of its mesh, and the
# rope lengths (m) that it was built with.
mesh_recipe <- function(mesh) {
  recipe <- list(
    nodes = mesh$counts$asked$nodes, bars = unname(mesh$counts$asked$bars),
    counts = mesh$counts[mesh_counts], wake = mesh$model$wake,
    blocked = mesh$catch$blocked, let_go = mesh$let_go
  )
  c(recipe, Filter(length, mesh[c("changes", "built_lengths")]))
}

# Returns a mesh from its recipe. `position`: 3 x nodes (m), or NULL for a crude layout.
mesh_of_recipe <- function(si, recipe, position = NULL) {
  for (rope in names(recipe$built_lengths)) si$ropes[[rope]]$length <- recipe$built_lengths[[rope]]
  si$panels <- Map(function(panel, of_bars) {
    panel$netting <- if (of_bars) "bars" else "cells"
    panel
  }, si$panels, recipe$bars)
  asked <- requested_mesh_size(si, recipe$nodes, NULL)
  shape <- list(mesh = list(counts = c(list(asked = asked), recipe$counts)))
  mesh <- build_mesh(si, recipe$nodes, NULL, shape)
  if (!is.null(position)) mesh$start <- matrix(position, 3L)
  mesh$let_go <- recipe$let_go
  mesh$built_lengths <- recipe$built_lengths
  if (!is.null(recipe$blocked)) mesh <- set_catch_front(mesh, recipe$blocked)
  changes <- c(Filter(length, recipe["wake"]), recipe$changes)
  if (length(changes)) change_mesh(mesh, changes) else mesh
}
