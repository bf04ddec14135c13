# What differs in the mesh of a lattice from that of its gear, and the recipe from which both are
# built again.

# A lattice whose mesh has other values of some fields than its gear gives it.
change_lattice <- function(lattice, fields) {
  lattice$mesh <- changed_mesh(lattice$mesh, fields)
  # recipes have it of its own
  fields$wake <- NULL
  lattice$changes <- utils::modifyList(first_of(lattice$changes, list()), fields, keep.null = TRUE)
  lattice
}

# What a lattice is built again from, with the numbers of its gear: about how many nodes were asked
# for, which panels are of bars, how everything is divided, wakes, where a catch's front is, and for
# a moment of a tow what else of its mesh differs and the lengths (m) of ropes that it was built
# with.
mesh_recipe <- function(lattice) {
  recipe <- list(
    nodes = lattice$counts$asked$nodes, bars = unname(lattice$counts$asked$bars),
    counts = lattice$counts[lattice_counts], wake = lattice$mesh$wake,
    blocked = lattice$catch$blocked, let_go = lattice$let_go
  )
  c(recipe, Filter(length, lattice[c("changes", "built_lengths")]))
}

# A lattice by its recipe. si: numbers of its gear; position: 3 x nodes (m), or NULL for a crude
# layout.
lattice_of_recipe <- function(si, mesh, position = NULL) {
  for (rope in names(mesh$built_lengths)) si$ropes[[rope]]$length <- mesh$built_lengths[[rope]]
  si$panels <- Map(function(panel, of_bars) {
    panel$netting <- if (of_bars) "bars" else "cells"
    panel
  }, si$panels, mesh$bars)
  asked <- asked_division(si, mesh$nodes, NULL)
  shape <- list(lattice = list(counts = c(list(asked = asked), mesh$counts)))
  lattice <- build_lattice(si, mesh$nodes, NULL, shape)
  if (!is.null(position)) lattice$start <- matrix(position, 3L)
  lattice$let_go <- mesh$let_go
  lattice$built_lengths <- mesh$built_lengths
  if (!is.null(mesh$blocked)) lattice <- set_catch_front(lattice, mesh$blocked)
  changes <- c(Filter(length, mesh["wake"]), mesh$changes)
  if (length(changes)) change_lattice(lattice, changes) else lattice
}
