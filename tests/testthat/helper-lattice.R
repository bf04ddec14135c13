# How tests read a lattice: a change of what it is made of touches this file alone. x: a lattice, or
# a state or trajectory that has one.

lattice_of <- function(x) if (inherits(x, "codend_lattice")) x else x$lattice

# An array of the engine as the engine has it, such as engine_array(x, "bars", "rest"); without
# names the mesh that the engine holds.
engine_array <- function(x, ...) {
  found <- lattice_of(x)$mesh
  for (name in c(...)) found <- found[[name]]
  found
}

# A lattice with the fields of its mesh in the place of the handle to it.
plain_lattice <- function(x) {
  lattice <- unclass(lattice_of(x))
  lattice$mesh <- engine_mesh_fields(lattice$mesh)
  lattice
}

# Parts of the gear: data.frame(name, kind, role).
parts_of <- function(x) lattice_of(x)$parts

# Numbers of the parts (rows of parts_of()) that elements belong to; what: "bar", "cell",
# "sphere" or "board".
part_of <- function(x, what) lattice_of(x)[[paste0(what, "_part")]]

# Numbers of the elements of a part by its name.
elements_of <- function(x, what, name) which(part_of(x, what) == match(name, parts_of(x)$name))

# Nodes of points and other places, such as "ship", "net.lower_left" or "chain[0.5]".
nodes_at <- function(x, places) {
  unname(lattice_of(x)$places[places])
}

# A rope's nodes and where they are, as shares of its length: list(node, at).
along_rope <- function(x, rope) lattice_of(x)$ropes[[rope]]

# How panels are divided, by name: each list(netting, and grid and places of cells in it, or node,
# i, j, lambda and segments of bars).
panels_of <- function(x) lattice_of(x)$panels
panel_of <- function(x, name) panels_of(x)[[name]]

# Places along all edges of panels: list(nodes, fraction, edge_node, count, before, grids).
division_of <- function(x) lattice_of(x)$division

# The nodes of an edge that is held on a line: list(node, at).
held_edge_of <- function(x, seam) lattice_of(x)$held_edges[[seam]]

# Where the lattice's nodes start, and where they hang before a gear is shot: 3 x n, m.
start_of <- function(x) lattice_of(x)$start
hung_shape <- function(x) lattice_of(x)$hung

# A state or trajectory without what it computed, and without the other lattices that its errors
# follow from, which a file holds in another form.
plain_result <- function(x) {
  x$levels <- x$handle <- NULL
  x
}

# A lattice of what a test needs of it: ropes = nodes of each by name, mesh = some of the engine's
# arrays, parts = data.frame(name, kind, role), bar_part.
sketched_lattice <- function(ropes = list(), mesh = list(), parts = NULL,
                             bar_part = integer()) {
  structure(list(
    ropes = lapply(ropes, function(node) list(node = node)), mesh = mesh, nodes = mesh$nodes,
    parts = parts, bar_part = bar_part, cell_part = integer()
  ), class = "codend_lattice")
}
