# The catch: which part of the netting around it lies behind its front (src/engine/measure).

# Meshes behind the front that the plan gives, or a first guess; 0 without a catch.
planned_front <- function(si) {
  if (is.null(si$catch)) return(0)
  if (is.na(si$catch$blocked)) 0.3 * si$catch$deep else si$catch$blocked
}

# The lattice with the catch's front `blocked` meshes from the lower edges.
set_catch_front <- function(lattice, blocked) {
  lattice$catch$blocked <- blocked
  lattice$mesh <- engine_filled_mesh(lattice$mesh, blocked)
  lattice
}

# Volume (m3) that netting behind the catch's front encloses with a front drawn from its edge to the
# edge's middle, and area (m2) of the netting behind it.
catch_volume <- function(lattice, position, ...) catch_sizes(lattice, position, ...)[1L]

catch_sizes <- function(lattice, position, blocked = lattice$catch$blocked) {
  engine_catch_sizes(lattice$mesh, blocked, as.double(lattice_points(lattice, position)))
}
