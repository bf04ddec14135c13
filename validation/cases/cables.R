# Cables and their analytical solutions; references/analytic_benchmarks.csv documents each value.

benchmark <- local({
  table <- utils::read.csv("validation/references/analytic_benchmarks.csv", comment.char = "#")
  function(case, quantity) table$value[table$case == case & table$quantity == quantity]
})

weight_per_metre <- function(newton) newton / 9.81

# A rope without weight, buoyancy and drag by default.
line <- function(from, to, length, ..., diameter = 0.02, mass_per_length = 0) {
  rope(
    from = from, to = to, length = length, diameter = diameter, volume_per_length = 0,
    mass_per_length = mass_per_length, ...
  )
}

no_drag <- list(normal = 0, tangential = 0, skin = 0)
air <- list(density = 0)

reaction <- function(state, name) {
  table <- as.data.frame(state, what = "reactions")
  1000 * unlist(table[table$point == name, c("x_kN", "y_kN", "z_kN")], use.names = FALSE)
}
node_at <- function(state, name) state$position[, nodes_at(state, name)]

hanging_catenary <- function(segments) {
  settle(gear("Catenary",
    water = air, low = gear_point(c(0, 0, 0), "fixed"), high = gear_point(c(80, 0, 20), "fixed"),
    chain = line("low", "high", 100, axial_stiffness = 1e5,
      mass_per_length = weight_per_metre(20), segments = segments)
  ))
}

# Position of the loaded point of an isolated cable (m); load: N.
isolated_cable <- function(load) {
  part <- function(from, to, length) {
    line(from, to, length, axial_stiffness = 548.4e-6 * 131.0e9,
      mass_per_length = weight_per_metre(46.12), segments = 60)
  }
  node_at(settle(gear("Isolated cable",
    water = air, left = gear_point(c(0, 0, 0), "fixed"), right = gear_point(c(304.8, 0, 0),
      "fixed"),
    node = gear_point(load = c(0, 0, -load)), short = part("left", "node", 125.847),
    long = part("node", "right", 186.855)
  )), "node")
}

critical_cables <- data.frame(
  d = c(0.0173, 0.032, 0.012), w = c(8.89, 35, 0.5), normal = c(1.5, 1.2, 1.2),
  speed = c(6 * 1852 / 3600, 2.315, 1)
)

# Angles (degrees) of the elements of a towed cable without tangential drag; of: its row above.
critical_angles <- function(of) {
  state <- settle(gear("Critical angle",
    towing = list(speed = of$speed), ship = gear_point(c(0, 0, 0), "moved"), tail = gear_point(),
    cable = line("ship", "tail", 50, diameter = of$d, axial_stiffness = 1e7,
      mass_per_length = weight_per_metre(of$w), segments = 10,
      coefficients = list(normal = of$normal, tangential = 0, skin = 0))
  ))
  x <- state$position[, along_rope(state, "cable")$node]
  atan2(-diff(x[3, ]), diff(x[1, ])) * 180 / pi
}

# Layback and depth of the body (m), tension (N) and angle (degrees) at the ship.
towed_body <- function(segments) {
  # the table's weight to all its digits: 8.89 N/m
  state <- settle(update(read_gear("towed_cable"),
    ropes.cable.volume_per_length = (1.12 - 8.89 / 9.81) / 1025, ropes.cable.segments = segments
  ))
  x <- node_at(state, "body")
  pull <- reaction(state, "ship")
  c(x[1], -x[3], sqrt(sum(pull^2)), atan2(pull[3], -pull[1]) * 180 / pi)
}

# Normal drag R sin^2 alone keeps T constant. The shape is a catenary of parameter c = T / R across
# the flow, with half length c sinh(b / c) for a half span b. Returns tension (N) and depth of the
# bight (m).
neutral_catenary <- function() {
  drag <- 0.5 * 1025 * 1.2 * 0.02 * 1.5^2
  c <- 30 / uniroot(function(u) sinh(u) / u - 40 / 30, c(0.1, 5), tol = 1e-14)$root
  list(tension = drag * c, bight = c * (cosh(30 / c) - 1))
}
# The same for the gear, with every element's tension.
neutral_cable <- function(segments) {
  state <- settle(gear("Neutral cable",
    towing = list(speed = 1.5), port = gear_point(c(0, -30, -10), "moved"),
    starboard = gear_point(c(0, 30, -10), "moved"),
    cable = line("port", "starboard", 80, axial_stiffness = 1e9,
      coefficients = list(normal = 1.2, tangential = 0, skin = 0), segments = segments)
  ))
  bight <- state$position[1, along_rope(state, "cable")$node[segments / 2 + 1]]
  list(tension = state$bar_tension, bight = bight)
}

# A sphere on a line in a current of 1.2 m/s toward 30 degrees: the state, and the static solution.
hanging_sphere <- function() {
  settle(gear("Hanging sphere",
    water = list(current = list(speed = 1.2, toward = "30 deg")),
    buoy = gear_point(c(0, 0, -5), "fixed"), ball = gear_point(),
    line = line("buoy", "ball", 10, axial_stiffness = 1e6, coefficients = no_drag, segments = 4),
    sphere = piece(at = "ball", mass = 100, diameter = 0.4, drag_coefficient = 0.47)
  ))
}
hanging_sphere_forces <- list(
  drag = 0.5 * 1025 * 1.2^2 * 0.47 * pi / 4 * 0.4^2,
  weight = 9.81 * (100 - 1025 * pi / 6 * 0.4^3)
)

# Angle of the line (degrees) at the winch of a kite.
kite_line <- function() {
  state <- settle(gear("Kite",
    towing = list(speed = 2), winch = gear_point(c(0, 0, -100), "moved"), end = gear_point(),
    line = line("winch", "end", 20, axial_stiffness = 1e7, coefficients = no_drag, segments = 4),
    kite = piece(at = "end", area = 5, lift_coefficient = 1.16, drag_coefficient = 0.35,
      lift_direction = "up")
  ))
  pull <- reaction(state, "winch")
  atan2(-pull[3], -pull[1]) * 180 / pi
}

# Steady cable in a current that turns with depth. It is integrated from the body up to the ship in
# the unstretched length; shooting determines the body's depth. Classical fourth-order Runge-Kutta.
shoot_cable <- function(water_at, cable, body, steps) {
  rho <- 1025
  line_drag <- function(z, t) {
    u <- water_at(z)
    u_t <- sum(u * t) * t
    u_n <- u - u_t
    0.5 * rho * cable$d *
      (cable$normal * sqrt(sum(u_n^2)) * u_n + cable$tangential * sqrt(sum(u_t^2)) * u_t)
  }
  rise <- function(y) {
    tension <- sqrt(sum(y[4:6]^2))
    t <- y[4:6] / tension
    c((1 + tension / cable$ea) * t, -line_drag(y[3], t) - c(0, 0, -cable$w))
  }
  integrate_from <- function(z) {
    u <- water_at(z)
    on_body <- 0.5 * rho * body$drag_area * sqrt(sum(u^2)) * u - c(0, 0, body$w)
    y <- c(0, 0, z, -on_body)
    h <- cable$length / steps
    for (k in seq_len(steps)) {
      k1 <- rise(y)
      k2 <- rise(y + h / 2 * k1)
      k3 <- rise(y + h / 2 * k2)
      k4 <- rise(y + h * k3)
      y <- y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    }
    y
  }
  z <- uniroot(function(z) integrate_from(z)[3], c(-cable$length, -1), tol = 1e-9)$root
  y <- integrate_from(z)
  list(body = c(-y[1:2], z), tension = y[4:6])
}

sheared_layers <- list(
  list(depth = 0, speed = 0.2, toward = "0 deg"),
  list(depth = 120, speed = 0.8, toward = "90 deg"),
  list(depth = 300, speed = 0.3, toward = "200 deg")
)
# A cable towed with a body through these layers.
sheared_cable <- function(segments) {
  settle(gear("Cable in a shear",
    water = list(current = sheared_layers), towing = list(speed = 1.5),
    ship = gear_point(c(0, 0, 0), "moved"), body = gear_point(),
    cable = line("ship", "body", 400, diameter = 0.015, axial_stiffness = 5e6,
      mass_per_length = weight_per_metre(6), segments = segments,
      coefficients = list(normal = 1.3, tangential = 0.03, skin = 0)),
    sphere = piece(at = "body", mass = 300, drag_area = 0.3)
  ))
}
# The same by shooting.
sheared_cable_exact <- function() {
  depth <- c(0, 120, 300)
  toward <- c(0, 90, 200) * pi / 180
  speed <- c(0.2, 0.8, 0.3)
  water_at <- function(z) {
    at <- function(v) stats::approx(depth, v, -z, rule = 2)$y
    c(1.5 + at(speed * cos(toward)), at(speed * sin(toward)), 0)
  }
  shoot_cable(
    water_at, list(d = 0.015, ea = 5e6, w = 6, length = 400, normal = 1.3, tangential = 0.03),
    list(w = 300 * 9.81, drag_area = 0.3), steps = 400
  )
}

# A warp with a clump, which all programs for mooring lines can run. Values: the clump's x and z
# from the upper end (m) and the tension there (N), by shooting and by the plan.
towed_warp_exact <- function() {
  found <- shoot_cable(
    function(z) c(2, 0, 0),
    list(d = 0.028, ea = 35e6, w = 9.81 * (3 - 1025 * pi / 4 * 0.028^2), length = 1000,
      normal = 1.2, tangential = 0.01 * pi),
    list(w = 9.81 * (500 - 1025 * 0.0637), drag_area = 0.1), steps = 1000
  )
  c(found$body[c(1, 3)], sqrt(sum(found$tension^2)))
}
towed_warp <- function(segments) {
  state <- settle(update(read_gear(test_path("plans", "towed_warp.yaml")),
    ropes.warp.segments = segments))
  run <- node_at(state, "lower_end") - node_at(state, "upper_end")
  c(run[c(1, 3)], sqrt(sum(reaction(state, "upper_end")^2)))
}
