# What the sea bed does to a gear.

# Force of the ground on the gear: list(total (3, N), normal (N), along_flow = share along the flow
# (N), length = of rope on the ground, m).
ground_forces <- function(state) {
  ground <- state$lattice$engine$ground
  lattice <- state$lattice
  total <- total_force(state, "ground")
  touching <- unique(lattice$engine$contacts$node[colSums(state$forces$contact_force^2) > 0])
  bars <- lattice$engine$bars
  # poles are no ropes
  struts <- vapply(state$si$ropes, `[[`, NA, "strut")
  of_ropes <- lattice$parts$kind[lattice$bar_part] == "rope" &
    !lattice$parts$name[lattice$bar_part] %in% names(struts)[struts]
  ends <- matrix(bars$node %in% touching, 2L)
  list(
    total = total, normal = sum(ground$normal * total),
    along_flow = sum(total * flow_axes(state$si)[, "flow"]),
    length = sum((bars$rest * colMeans(ends))[of_ropes])
  )
}
