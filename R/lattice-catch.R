# The catch: which part of the netting around it lies behind its front (src/engine/measure).

# The catch of a lattice whose gear has one: list(cell = of every triangle that it may lie against
# (NA: of a sheet), node = 3 x these, depth, across = 3 x these, meshes from the lower edge and
# along it, real = share of each that is real, weight = the same signed, with the circle's share:
# negative where its normal points inward, blocked = meshes behind its front). bag: what the engine
# found.
lattice_catch <- function(bag, blocked) {
  c(
    list(cell = replace(bag$cell, bag$cell == 0L, NA)),
    lapply(bag[c("node", "depth", "across")], matrix, 3L), bag[c("real", "weight")],
    list(blocked = blocked)
  )
}

# Meshes behind the front that the plan gives, or a first guess; 0 without a catch.
planned_front <- function(si) {
  if (is.null(si$catch)) return(0)
  if (is.na(si$catch$blocked)) 0.3 * si$catch$deep else si$catch$blocked
}

# The lattice with the catch's front `blocked` meshes from the lower edges.
set_catch_front <- function(lattice, blocked) {
  lattice$catch$blocked <- blocked
  weight <- engine_bag_weights(filled_bag(lattice))
  lattice$mesh <- changed_mesh(lattice$mesh, list(pressure = list(weight = weight)))
  lattice
}

# The bag of a lattice as the engine reads it, or NULL.
filled_bag <- function(lattice, blocked = lattice$catch$blocked) {
  held <- lattice$catch
  if (is.null(held)) return(NULL)
  c(
    list(points = length(lattice$mesh$mass)),
    lapply(held[c("node", "depth", "across")], as.vector),
    # R CMD check takes `held$real` for a use of R's own real(), which is no more
    list(real = held[["real"]], weight = held$weight, blocked = as.double(blocked))
  )
}

# Volume (m3) that netting behind the catch's front encloses with a front drawn from its edge to the
# edge's middle, and area (m2) of the netting behind it.
catch_volume <- function(lattice, position, ...) catch_sizes(lattice, position, ...)[1L]

catch_sizes <- function(lattice, position, ...) {
  engine_bag_sizes(filled_bag(lattice, ...), as.double(lattice_points(lattice, position)))
}
