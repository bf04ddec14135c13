# Sensitivity of drag to the tangential force on twines and ropes, the least certain coefficient.

# Returns list(halved, settled, doubled): total drag [kN] with all tangential and skin coefficients
# scaled. The shape is fixed, so the effect of the changed equilibrium is not included.
tangential_sensitivity <- function(state) {
  model <- state$mesh$model
  still <- numeric(length(state$position))
  flow <- flow_axes(state$si)[, "flow"]
  shared <- function(materials, share) {
    list(materials = list(tangential_share = share * materials$tangential_share))
  }
  along <- function(share) {
    changes <- shared(model$materials, share)
    changes$blended <- shared(model$blended$materials, share)
    forces <- engine_evaluate(changed_model(model, changes), as.vector(state$position),
      still)$forces
    in_unit(sum(flow * total_force(list(forces = lapply(forces, matrix, 3L)), "flow")), "kN")
  }
  now <- in_unit(measure_value(state, "total_drag"), "kN")
  as_settled <- along(1)
  list(
    halved = now + along(0.5) - as_settled, settled = now, doubled = now + along(2) - as_settled
  )
}
