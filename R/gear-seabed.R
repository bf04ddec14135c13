# Upper limit of the default slip distance (m), and the default as a fraction of the longest rope.
most_slip_distance <- 0.01
slip_share <- 1e-3

# Returns list(normal, height, velocity, friction, stiffness, onset, slip, slip_distance,
# stick_lag), see ground.hpp. The last four follow from the slip distance and gravity, so that
# contact follows Froude's scaling. With 10 mm, contact stiffens over 20 mm, sliding friction is
# rounded below 20 mm/s, and sticking is damped over 0.1 s.
#
# `seabed`: checked fields, or NULL; `longest`: length of the longest rope, m. The ground moves past
# a towed gear at the towing speed.
si_seabed <- function(seabed, towing_speed, longest) {
  if (is.null(seabed)) return(NULL)
  slope <- first_of(seabed$slope, list(angle = 0, toward = 0))
  fall <- sin(slope$angle) * c(cos(slope$toward), sin(slope$toward))
  normal <- c(fall, cos(slope$angle))
  along <- c(1, 0, 0) - normal[1] * normal
  distance <- first_of(seabed$slip_distance, min(most_slip_distance, slip_share * longest))
  list(
    normal = normal, height = -seabed$depth * normal[3], velocity = towing_speed * along,
    friction = seabed$friction, stiffness = seabed$stiffness, onset = 2 * distance,
    slip = sqrt(distance * gear_gravity) / 16, slip_distance = distance,
    stick_lag = pi * sqrt(distance / gear_gravity)
  )
}

# Returns the height (m) of points (3 x n) above the ground, normal to it.
height_above_ground <- function(ground, position) drop(ground$normal %*% position) - ground$height
