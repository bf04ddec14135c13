# How much of the drag rests on the force of the water along twines and ropes, the coefficient that
# is known worst.

# Total drag (kN, as measures()' total_drag_kN) with the tangential and skin coefficients of all
# twines and ropes halved and doubled, at the settled shape: list(halved, settled, doubled). The
# gear would settle into another shape with other coefficients; what is left of the change then is
# not computed.
tangential_sensitivity <- function(state) {
  mesh <- state$lattice$mesh
  still <- numeric(length(state$position))
  flow <- flow_axes(state$si)[, "flow"]
  shared <- function(materials, share) {
    list(materials = list(tangential_share = share * materials$tangential_share))
  }
  along <- function(share) {
    changes <- shared(mesh$materials, share)
    changes$blended <- shared(mesh$blended$materials, share)
    forces <- engine_evaluate(changed_mesh(mesh, changes), as.vector(state$position), still)$forces
    in_unit(sum(flow * total_force(list(forces = lapply(forces, matrix, 3L)), "flow")), "kN")
  }
  now <- in_unit(measure_value(state, "total_drag"), "kN")
  as_settled <- along(1)
  list(
    halved = now + along(0.5) - as_settled, settled = now, doubled = now + along(2) - as_settled
  )
}
