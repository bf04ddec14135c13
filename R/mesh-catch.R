# The catch: the part of the surrounding netting behind its front (src/engine/measure).

# Returns the number of meshes behind the front in the plan, or an initial guess; 0 without a catch.
planned_front <- function(si) {
  if (is.null(si$catch)) return(0)
  if (is.na(si$catch$blocked)) 0.3 * si$catch$deep else si$catch$blocked
}

# Returns the mesh with the catch's front `blocked` netting meshes from the lower edges.
set_catch_front <- function(mesh, blocked) {
  mesh$catch$blocked <- blocked
  mesh$model <- engine_filled_model(mesh$model, blocked)
  mesh
}

# Returns the volume (m3) behind the catch's front. `catch_sizes()` also returns the area (m2) of
# the netting behind it. The front surface connects its edge to the centre of the edge.
catch_volume <- function(mesh, position, ...) catch_sizes(mesh, position, ...)[1L]

catch_sizes <- function(mesh, position, blocked = mesh$catch$blocked) {
  engine_catch_sizes(mesh$model, blocked, as.double(mesh_points(mesh, position)))
}
