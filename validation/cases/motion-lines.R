# Motions that keep their energy, and wave forces, compared with analytical solutions and with the
# same lumped systems integrated by deSolve.

# Integrates a gear of one rope from positions and velocities along it (3 x nodes) to `until` (s).
# The saved states have the interval `every` (s); their positions have the order of the rope.
motion_from <- function(gear, position, velocity, until, every, accuracy = "0.1 %") {
  si <- gear_si(gear)
  mesh <- build_mesh(si)
  along <- mesh$ropes$line$node
  what <- tow_start(gear, si, mesh, tow_schedule(), until)
  start <- add_start(what, position[, order(along)], velocity[, order(along)])
  found <- integrate_trajectory(start, until, every, tow_method("tr_bdf2", accuracy, NULL))
  list(trajectory = found, time = found$time, position = found$position[, along, ])
}

# A line in air from `top` to `end`, with its nodes in this order.
line_in_air <- function(top, end, held, length, stiffness, per_metre, n) {
  gear("line in air", top = gear_point(position = top, held = "fixed"),
    end = if (held) gear_point(position = end, held = "fixed") else gear_point(),
    line = rope("top", "end", length = length, diameter = "10 mm", axial_stiffness = stiffness,
      mass_per_length = per_metre, volume_per_length = 0, coefficients = list(normal = 0),
      segments = n),
    water = list(density = 0))
}

# A mass on a line swings by 30 degrees for 1,000 periods.
case_long_pendulum <- function() {
  length <- 10
  # stretched by its weight, so that it does not ring along the line
  stretched <- length + 100 * gear_gravity * cos(pi / 6) * length / 1e6
  at <- stretched * c(sin(pi / 6), 0, -cos(pi / 6))
  swing <- gear("pendulum", top = gear_point(position = c(0, 0, 0), held = "fixed"),
    load = gear_point(), line = light_line("top", "load", length, 1e6),
    mass = piece(at = "load", mass = 100, volume = 0), water = list(density = 0))
  # 4 K(sin(a/2)) sqrt(L/g) for the angle a
  period <- 6.4585
  begun <- motion_from(swing, cbind(c(0, 0, 0), at), 0 * diag(3)[, 1:2], 999 * period, 999 * period)
  last <- tow(begun$trajectory, until = 1000.5 * period, every = period / 40)
  late <- last$time > 999.5 * period
  compared("amplitude", "after 1,000 periods", at[1], max(abs(last$position[1, 2, late])))
}

# A hanging cable whirls in its lowest mode, J0(j0 sqrt(s/L)) at the height s above its end.
case_whirling_cable <- function() {
  n <- 60
  length <- 10
  stiffness <- 1e7
  j0 <- 2.404826
  rate <- j0 / 2 * sqrt(gear_gravity / length)
  height <- length * (n:0) / n
  x <- 0.02 * besselJ(j0 * sqrt(height / length), 0)
  x[1] <- 0
  tension <- gear_gravity * (height[-1] + length / n / 2)
  long <- length / n * (1 + tension / stiffness)
  z <- -c(0, cumsum(sqrt(long^2 - diff(x)^2)))
  position <- rbind(x, 0, z)
  turn <- 2 * pi / rate
  found <- motion_from(line_in_air(c(0, 0, 0), c(0, 0, -length), FALSE, length, stiffness, 1, n),
    position, rbind(0, rate * x, 0), 3 * turn, turn / 30)
  rbind(
    compared_series("position", "x", x[n + 1] * cos(rate * found$time), found$position[1, n + 1, ]),
    compared_series("position", "y", x[n + 1] * sin(rate * found$time), found$position[2, n + 1, ])
  )
}

# A pulse travels along a tight vertical wire and is reflected at its fixed ends. The exact motion
# is the sum of the modes of masses on tight springs.
case_reflected_wave <- function() {
  n <- 100
  rest <- 1
  stiffness <- 1e6
  tension <- 1000 + 0.5 * gear_gravity * rest * rev(seq_len(n) - 1)
  long <- rest * (1 + tension / stiffness)
  z <- -c(0, cumsum(long))
  x <- 0.01 * exp(-((z - mean(z)) / 8)^2)
  x[c(1, n + 1)] <- 0
  wire <- line_in_air(c(0, 0, 0), c(0, 0, z[n + 1]), TRUE, n * rest, stiffness, 0.5, n)
  found <- motion_from(wire, rbind(x, 0, z), 0 * rbind(x, 0, z), 2.2, 0.05, accuracy = "0.02 %")
  spring <- tension / long
  inner <- 2:n
  matrix <- diag(spring[-n] + spring[-1])
  matrix[cbind(1:(n - 2), 2:(n - 1))] <- matrix[cbind(2:(n - 1), 1:(n - 2))] <- -spring[2:(n - 1)]
  modes <- eigen(matrix / (0.5 * rest), symmetric = TRUE)
  shape <- crossprod(modes$vectors, x[inner])
  exact <- modes$vectors %*% (as.vector(shape) * cos(outer(sqrt(modes$values), found$time)))
  compared_series("position", "all nodes", exact, found$position[1, inner, ])
}

# A folded chain falls from one end (Tomaszewski, Pieranski and Geminard 2006), compared with the
# same masses and springs integrated by deSolve until shortly before the fold opens.
case_dropped_chain <- function() {
  n <- 15
  length <- 2
  stiffness <- 500
  per_metre <- 0.5
  # two straight halves at the strain of their weight, one segment apart
  seg <- length / n
  half <- (n + 1) / 2
  tension <- per_metre * gear_gravity * seg * (half - seq_len(half - 1))
  depth <- c(0, cumsum(seg * (1 + tension / stiffness)))
  start <- rbind(rep(c(0, seg), each = half), 0, -c(depth, rev(depth)))
  chain <- line_in_air(c(0, 0, 0), c(0, 0, -length), FALSE, length, stiffness, per_metre, n)
  found <- motion_from(chain, start, 0 * start, 0.6, 0.02)
  mass <- per_metre * seg * c(rep(1, n - 1), 0.5)
  exact <- integrated(c(start[1, -1], start[3, -1], rep(0, 2 * n)), found$time, function(t, y) {
    place <- cbind(c(0, y[1:n]), c(0, y[n + 1:n]))
    line <- diff(place)
    long <- sqrt(rowSums(line^2))
    pull <- line / long * pmax(stiffness * (long / seg - 1), 0)
    force <- rbind(pull[-1, ], 0) - pull
    c(y[-(1:(2 * n))], force[, 1] / mass, force[, 2] / mass - gear_gravity)
  })
  compared_series("position", "free end", exact[, 2 * n], found$position[3, n + 1, ])
}

# A cylinder lies still along the crests of an irregular sea: standard deviation of Morison's force.
case_irregular_sea <- function() {
  gear <- gear("cylinder in waves",
    port = gear_point(position = c(0, -5, -6), held = "fixed"),
    starboard = gear_point(position = c(0, 5, -6), held = "fixed"),
    bar = rope("port", "starboard", length = 9.99, diameter = "0.5 m", axial_stiffness = "1e8 N",
      mass_per_length = "200 kg/m", coefficients = list(normal = 1.1, tangential = 0),
      segments = 1),
    water = list(waves = list(height = 3, period = 8, spectrum = "jonswap", rising = 5)))
  found <- tow(gear, until = 405, every = 0.4)
  waves <- gear_si(gear)$water$waves
  late <- found$time > 5
  force <- vapply(found$time[late], function(t) sum(state_at(found, t)$force[1, ]), 0)
  exact <- vapply(found$time[late], function(t) {
    number <- waves$frequency^2 / gear_gravity
    angle <- waves$phase - waves$frequency * t
    speed <- waves$amplitude * waves$frequency *
      exp(number * (-6 - sum(waves$amplitude * cos(angle))))
    u <- sum(speed * cos(angle))
    past <- sqrt(u^2 + sum(speed * sin(angle))^2)
    volume <- pi / 4 * 0.5^2 * 10
    0.5 * 1025 * 1.1 * 0.5 * 10 * past * u +
      2 * 1025 * volume * sum(waves$frequency * speed * sin(angle))
  }, 0)
  compared("deviation", "force", stats::sd(exact), stats::sd(force))
}
