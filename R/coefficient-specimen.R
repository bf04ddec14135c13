# Evaluates the engine's forces on single elements whose nodes are all fixed.

specimen_density <- 1000
specimen_viscosity <- 1e-6

# Returns the fields of a mesh without elements: points (3 x n, m) in still water.
specimen <- function(points, materials = twine_materials(list())) {
  n <- ncol(points)
  bare <- gear("Nothing",
    water = list(density = specimen_density, viscosity = specimen_viscosity),
    held_point = gear_point(position = list(0, 0, 0), held = "fixed")
  )
  fields <- engine_model_fields(build_mesh(gear_si(bare))$model)
  fields$nodes <- n
  fields$held <- rep(TRUE, n)
  fields$load <- numeric(3L * n)
  fields$mass <- numeric(n)
  fields$slack_twine <- "straight"
  fields$materials <- fields$blended$materials <- materials
  list(position = points, fields = fields)
}

# Evaluates the forces on elements of `points` nodes each. They move towards -x in still water.
# speed: m/s, one per element or one for all.
evaluate_specimen <- function(specimen, speed, points) {
  velocity <- rbind(-rep_len(rep(speed, each = points), specimen$fields$nodes), 0, 0)
  engine_evaluate(engine_model(specimen$fields), as.double(specimen$position), as.double(velocity))
}

# Returns list(drag, lift): force (3 x n, N) along x and y over 1/2 rho U^2 and an area (m2).
drag_and_lift <- function(force, speed, area) {
  per <- 0.5 * specimen_density * speed^2 * area
  force <- matrix(force, 3L)
  list(drag = force[1, ] / per, lift = force[2, ] / per)
}

# Coefficients of twines 1 m long and 2 mm thick at angles (rad) to the flow. Reference area:
# diameter times length.
twine_specimens <- function(coefficients, angle, reynolds, solidity) {
  diameter <- 0.002
  n <- length(angle)
  line <- list(
    axial_stiffness = 1, diameter = diameter, volume_per_length = 0,
    coefficients = drag_model(coefficients), added_mass = c(normal = 0, tangential = 0)
  )
  materials <- twine_materials(list(line))
  materials$solidity <- solidity
  ends <- matrix(0, 3L, 2L * n)
  second <- 2L * seq_len(n)
  # The normal component of the flow then points along +y.
  ends[, second] <- rbind(cos(angle), -sin(angle), 0)
  held <- specimen(ends, materials)
  held$fields$bars <- list(
    node = seq_len(2L * n), rest = rep(1, n), multiplicity = rep(1, n), height = rep(diameter, n),
    material = rep(1L, n)
  )
  speed <- reynolds * specimen_viscosity / diameter
  found <- evaluate_specimen(held, speed, 2L)
  drag_and_lift(found$forces$bar_drag, speed, diameter)
}

# Coefficients of square knotless netting, 20 by 20 bars of 2 mm twine. angle (rad): between its
# normal and the flow. Reference area: the netting.
netting_specimens <- function(law, angle, reynolds, solidity) {
  diameter <- 0.002
  n <- length(angle)
  count <- 20
  # Sn = 2 d/a - (d/a)^2 counts each crossing once; the sum over twines counts it twice.
  bar <- if (law %in% c("morison", "blended")) {
    2 * diameter / solidity
  } else {
    diameter / (1 - sqrt(1 - solidity))
  }
  side <- count * bar
  line <- list(
    axial_stiffness = 1, twine_diameter = diameter, twine_count = 1, mesh_size = 2 * bar,
    orientation = "square", volume_per_length = 0, coefficients = drag_model("bessonneau_marichal"),
    added_mass = c(normal = 0, tangential = 0)
  )
  materials <- twine_materials(list(line))
  corners <- vapply(angle, function(a) {
    along <- side * c(-sin(a), cos(a), 0)
    up <- c(0, 0, side)
    cbind(0, along, along + up, up)
  }, matrix(0, 3L, 4L))
  held <- specimen(matrix(corners, 3L), materials)
  node <- seq_len(4L * n)
  twine <- rep(c(0, 0, count, 0, count, count, 0, count), n)
  common <- list(
    node = node, twine = twine, rest = rep(bar, n), multiplicity = rep(1, n),
    height = rep(diameter, n), material = rep(1L, n)
  )
  if (law == "morison") {
    held$fields$cells <- c(
      common, list(straight = numeric(n), inner = integer(n))
    )
  } else if (law == "blended") {
    held$fields$blended[c(names(common), "overlap")] <- c(common, list(numeric(n)))
  } else {
    held$fields$screens <- list(
      node = node, twine = twine, twine_area = rep(solidity * side^2, n),
      overlap = numeric(n),
      diameter = rep(diameter, n), multiplicity = rep(1, n),
      height = rep(diameter, n), law = rep(law, n)
    )
  }
  speed <- reynolds * specimen_viscosity / diameter
  found <- evaluate_specimen(held, speed, 4L)
  which <- c(morison = "cell_drag", blended = "blended_force")
  force <- found$forces[[if (law %in% names(which)) which[[law]] else "screen_force"]]
  drag_and_lift(force, speed, side^2)
}

# Coefficients of upright otter boards of 1 m2 by angle of attack (rad). Reference area: the board.
board_specimens <- function(polar, angle, aspect_ratio) {
  span <- sqrt(aspect_ratio)
  board <- list(
    attachment = cbind(c(0, 0, 0), c(1 / span, 0, span / 2), c(1 / span, 0, -span / 2)), side = 1,
    level = FALSE, chord = 1 / span, span = span, height = span, area = 1,
    pressure_centre = 0.5, pressure_wanders = FALSE, mass = 0, volume = 0,
    gravity_centre = c(0, 0, 0), buoyancy_centre = c(0, 0, 0), added_volume = 0, shoe_area = 0,
    polar = board_polar(polar, aspect_ratio)
  )
  points <- vapply(angle, function(a) upright_board(board, c(0, 0, 0), a), matrix(0, 3L, 3L))
  held <- specimen(matrix(points, 3L))
  held$fields$plates <- lapply(seq_along(angle), function(k) {
    engine_board(board, 3L * (k - 1L) + 1:3, specimen_density)
  })
  speed <- 1
  found <- evaluate_specimen(held, speed, 3L)
  drag_and_lift(found$forces$plate_force, speed, 1)
}

# Coefficients of knots or smooth spheres by Reynolds number. Reference area: projected area.
sphere_specimens <- function(reynolds, smooth = FALSE) {
  n <- length(reynolds)
  diameter <- 0.002
  held <- specimen(matrix(0, 3L, n))
  held$fields$spheres <- list(
    node = seq_len(n), drag_area = rep(pi / 4 * diameter^2, n), diameter = rep(diameter, n),
    smooth = rep(smooth, n), added_mass = numeric(n), height = rep(diameter, n)
  )
  speed <- reynolds * specimen_viscosity / diameter
  drag_and_lift(evaluate_specimen(held, speed, 1L)$forces$sphere_drag, speed, pi / 4 * diameter^2)
}
