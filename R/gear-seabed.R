# The sea bed as the engine takes it, and what of a gear may lie on it.

# seabed: checked fields, or NULL. Returns list(normal, height, velocity, friction, stiffness), see
# ground.hpp; the ground passes a towed gear at the towing speed.
si_seabed <- function(seabed, towing_speed) {
  if (is.null(seabed)) return(NULL)
  slope <- first_of(seabed$slope, list(angle = 0, toward = 0))
  fall <- sin(slope$angle) * c(cos(slope$toward), sin(slope$toward))
  normal <- c(fall, cos(slope$angle))
  along <- c(1, 0, 0) - normal[1] * normal
  list(
    normal = normal, height = -seabed$depth * normal[3], velocity = towing_speed * along,
    friction = seabed$friction, stiffness = seabed$stiffness
  )
}

# Height (m) of points (3 x n) above the ground, across it.
height_above_ground <- function(ground, position) drop(ground$normal %*% position) - ground$height
