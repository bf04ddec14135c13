# Otter boards, kites and depressors as rigid bodies, in SI numbers and in the engine's body axes.

# Stiffness of a board's struts per area, N/m per m2: 25 kN per m2 changes lengths by about 1 mm.
strut_stiffness <- 3e7
usual_shoe_width <- 0.05

# Returns a board in SI: points and their positions in body axes, centres, polar, mass and volume.
# Axes (see lifting_plate.hpp): x aft of the leading edge, y to starboard, z up from mid-span.
si_otter_board <- function(board, path, fields, known) {
  side <- if (board$lift_direction == "starboard") 1 else -1
  si_lifting_body(board, path, fields, known, side, FALSE,
    axes = function(place) c(place$aft, -side * place$inward, place$up))
}

# A kite or depressor is a board with a horizontal span: in its axes y is up and z to port.
si_kite <- function(kite, path, fields, known) {
  side <- if (kite$lift_direction == "up") 1 else -1
  si_lifting_body(kite, path, fields, known, side, TRUE,
    axes = function(place) c(place$aft, -side * place$inward, -place$starboard))
}

is_kite <- function(board) identical(board$role, "kite")

# axes: function(position as given in the plan) that returns the position in body axes.
si_lifting_body <- function(board, path, fields, known, side, kite, axes) {
  points <- names(board$attachments)
  for (name in points) {
    if (!name %in% known$points) {
      abort_reference(name, name, known$points, "point", paste0(path, ".attachments"))
    }
  }
  attachment <- vapply(board$attachments, axes, c(0, 0, 0))
  e1 <- attachment[, 2] - attachment[, 1]
  e2 <- attachment[, 3] - attachment[, 1]
  across <- c(e1[2] * e2[3] - e1[3] * e2[2], e1[3] * e2[1] - e1[1] * e2[3],
    e1[1] * e2[2] - e1[2] * e2[1])
  if (sqrt(sum(across^2)) < 0.01 * board$chord * board$span) {
    abort_field(paste0(path, ".attachments"), points,
      "three points on the board that are not in one line")
  }
  body <- piece_body(board, path, fields)
  wanders <- identical(board$centre_of_pressure, "joessel")
  middle <- c(board$chord / 2, 0, 0)
  gravity <- if (is.null(board$centre_of_gravity)) middle else axes(board$centre_of_gravity)
  water <- fields$water$density
  added <- if (is.null(board$added_mass_kg)) {
    plate_added_volume(board$chord, board$span)
  } else if (water > 0) {
    board$added_mass_kg / water
  } else {
    0
  }
  list(
    points = points, attachment = unname(attachment), side = side,
    role = if (kite) "kite" else "otter_board",
    chord = board$chord, span = board$span, area = first_of(board$area, board$chord * board$span),
    mass = body$mass, volume = body$volume,
    pressure_centre = if (wanders) 0.5 else board$centre_of_pressure, pressure_wanders = wanders,
    gravity_centre = gravity,
    buoyancy_centre = if (is.null(board$centre_of_buoyancy)) {
      gravity
    } else {
      axes(board$centre_of_buoyancy)
    },
    added_volume = added,
    shoe_area = if (kite) 0 else first_of(board$shoe_area, usual_shoe_width * board$chord) / 2,
    friction = board$shoe_friction, height = if (kite) board$chord else board$span,
    polar = si_polar(board$polar, paste0(path, ".polar"), board$span / board$chord)
  )
}

# Returns the angle of attack (deg) with the largest lift. A board stalls beyond it.
stall_angle <- function(board) {
  front <- board$polar[board$polar$attack > 0 & board$polar$attack < 90, ]
  front$attack[which.max(front$lift)]
}

strut_line <- function(board) {
  list(
    axial_stiffness = strut_stiffness * board$area * board$span, diameter = 0.01 * board$span,
    volume_per_length = 0, strut = TRUE,
    coefficients = list(law = "constant", normal = 0, tangential = 0, skin = 0),
    added_mass = c(normal = 0, tangential = 0)
  )
}

engine_board <- function(board, nodes, density) {
  radii <- plate_added_radii(board$chord, board$span)
  ratio <- board$span / board$chord
  list(
    node = nodes, attachment = as.double(board$attachment), side = board$side,
    level = is_kite(board), chord = board$chord, span = board$span, area = board$area,
    height = board$height,
    pressure_centre = board$pressure_centre, pressure_wanders = board$pressure_wanders,
    weight = gear_gravity * board$mass, buoyancy = gear_gravity * density * board$volume,
    gravity_centre = board$gravity_centre, buoyancy_centre = board$buoyancy_centre,
    mass = board$mass,
    second_moment = plate_second_moment(board$mass, board$chord, board$span),
    added_mass = board$added_volume, added_radius_chord = radii[["chord"]],
    added_radius_span = radii[["span"]], normal_slope = at_ratio(plate_turning, "slope", ratio),
    yaw_damping = at_ratio(plate_turning, "yaw", ratio),
    roll_damping = at_ratio(plate_turning, "roll", ratio), shoe_area = board$shoe_area,
    own_friction = !is.null(board$friction), friction_along = first_of(board$friction$along, 0),
    friction_across = first_of(board$friction$across, 0),
    polar = engine_polar(board$polar)
  )
}

# Returns the points (m) of an upright board, or of a kite with its span horizontal. The leading
# edge is turned outward by `attack` (rad; half the stall angle for kites by default). The centre of
# the points is `place`. The flow is along x.
upright_board <- function(board, place,
    attack = from_unit(if (is_kite(board)) stall_angle(board) / 2 else 25, "deg")) {
  turn <- board$side * attack
  rotation <- cbind(c(cos(turn), -sin(turn), 0), c(sin(turn), cos(turn), 0), c(0, 0, 1))
  if (is_kite(board)) rotation <- rbind(rotation[1, ], -rotation[3, ], rotation[2, ])
  at <- rotation %*% board$attachment
  at - rowMeans(at) + place
}
