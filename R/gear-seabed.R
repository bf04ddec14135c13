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

# Moves points of a first shape out of the ground: what hangs below it is laid down along it, aft,
# so that lengths stay.
lay_on_ground <- function(ground, position) {
  deep <- pmin(height_above_ground(ground, position), 0)
  aft <- c(1, 0, 0) - ground$normal[1] * ground$normal
  position - outer(ground$normal + aft / sqrt(sum(aft^2)), deep)
}

# Boards of a first shape upright, with their lower edge above the ground.
stand_on_ground <- function(si, lattice, position) {
  for (board in si$otter_boards) {
    if (is_kite(board)) next
    nodes <- lattice$points[board$points]
    middle <- rowMeans(position[, nodes])
    room <- board$span / 2 + mean(board$attachment[3, ])
    lacking <- room - height_above_ground(si$ground, cbind(middle))
    middle <- middle + max(lacking, 0) * si$ground$normal
    position[, nodes] <- upright_board(board, middle)
  }
  position
}
