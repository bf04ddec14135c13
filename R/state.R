# A state: where every node is and what every element carries, with the gear that it belongs to.

# velocity: 3 per node, m/s, relative to the vessel.
new_state <- function(gear, si, lattice, position, report,
                      velocity = numeric(length(position))) {
  found <- engine_evaluate(lattice$engine, position, velocity)
  three <- function(x) matrix(x, 3L)
  triangle_drag <- three(found$triangle_drag)
  screens <- lattice$engine$drag_screens$triangle
  triangle_drag[, screens] <- triangle_drag[, screens] + three(found$screen_force)
  blended <- lattice$engine$blended$triangle
  triangle_drag[, blended] <- triangle_drag[, blended] + three(found$blended_force)
  structure(
    list(
      gear = gear, si = si, lattice = lattice, report = report,
      position = three(position), velocity = three(velocity),
      force = three(found$force),
      bar_tension = found$bar_tension, bar_length = found$bar_length,
      u_tension = found$u_tension, u_length = found$u_length,
      v_tension = found$v_tension, v_length = found$v_length,
      bar_drag = three(found$bar_drag), triangle_drag = triangle_drag,
      straight_tension = found$straight_tension, straight_length = found$straight_length,
      sphere_drag = three(found$sphere_drag), lift_force = three(found$lift_force),
      catch_force = three(found$catch_force),
      boards = c(
        found$boards[c("attack", "heel", "trim", "lift", "drag", "lost_buoyancy")],
        lapply(found$boards[c("force", "ground_force")], three)
      ),
      contact_force = three(found$contact_force), volume_force = three(found$volume_force)
    ),
    class = "codend_state"
  )
}
