# Access to a mesh in tests, so that a change of its representation affects only this file. x: a
# mesh, or a state or trajectory that has one.

mesh_of <- function(x) if (inherits(x, "codend_mesh")) x else x$mesh

# Returns an array of the engine, such as engine_array(x, "bars", "rest"); without names the
# engine's whole mesh.
engine_array <- function(x, ...) {
  found <- mesh_of(x)$model
  for (name in c(...)) found <- found[[name]]
  found
}

# A mesh with the fields of the engine's mesh instead of the handle.
plain_mesh <- function(x) {
  mesh <- unclass(mesh_of(x))
  mesh$model <- engine_model_fields(mesh$model)
  mesh
}

# Parts of the gear: data.frame(name, kind, role).
parts_of <- function(x) mesh_of(x)$parts

# Numbers of the parts (rows of parts_of()) for every element; `what` is "bar", "cell", "sphere"
# or "board".
part_of <- function(x, what) mesh_of(x)[[paste0(what, "_part")]]

# Numbers of the elements of a part by its name.
elements_of <- function(x, what, name) which(part_of(x, what) == match(name, parts_of(x)$name))

# Nodes at points and other positions, such as "ship", "net.lower_left" or "chain[0.5]".
nodes_at <- function(x, places) {
  unname(mesh_of(x)$places[places])
}

# A rope's nodes and their positions as fractions of its length: list(node, at).
along_rope <- function(x, rope) mesh_of(x)$ropes[[rope]]

# Meshes of panels, by name. Each is list(netting, ...): grid and positions of cells, or node, i, j,
# lambda and segments of bars.
panels_of <- function(x) mesh_of(x)$panels
panel_of <- function(x, name) panels_of(x)[[name]]

# Positions along all edges of panels: list(nodes, fraction, edge_node, count, before, grids).
division_of <- function(x) mesh_of(x)$division

# The nodes of an edge that is fixed on a line: list(node, at).
held_edge_of <- function(x, seam) mesh_of(x)$held_edges[[seam]]

# Initial node positions, and positions of the hanging gear before it is shot: 3 x n, m.
start_of <- function(x) mesh_of(x)$start
hung_shape <- function(x) mesh_of(x)$hung

# A state or trajectory without its computed results and without the meshes for its errors, which a
# file stores in another form.
plain_result <- function(x) {
  x$levels <- x$handle <- NULL
  x
}

# A mesh with only the fields that a test needs: ropes = nodes of each by name, model = some of the
# engine's arrays, parts = data.frame(name, kind, role), bar_part.
sketched_mesh <- function(ropes = list(), model = list(), parts = NULL, bar_part = integer()) {
  structure(list(
    ropes = lapply(ropes, function(node) list(node = node)), model = model, nodes = model$nodes,
    parts = parts, bar_part = bar_part, cell_part = integer()
  ), class = "codend_mesh")
}
