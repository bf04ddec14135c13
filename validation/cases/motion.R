# Motions at an accuracy of 0.1 %, or at the default if they are stiff, compared with analytical
# solutions, with equations of motion integrated by deSolve, and with explicit time steps.

# Compares series over time. The misfit is the largest deviation as a ratio of `scale`, which is by
# default the range of the exact series.
compared_series <- function(quantity, at, exact, found, scale = diff(range(exact))) {
  compared(quantity, at, scale, scale + max(abs(found - exact)))
}

# Compares positions and tensions with rows of a stored motion (case, time, kind, number, value).
# Deviations of positions are ratios of the longest displacement along an axis.
compared_motion <- function(at, exact, found) {
  stopifnot(all.equal(found[1:4], exact[1:4], check.attributes = FALSE))
  pulls <- grepl("tension", exact$kind)
  displacement <- tapply(exact$value, exact[3:4], function(value) diff(range(value)))
  tension <- exact$kind == "largest_tension"
  rbind(
    compared_series("position", at, exact$value[!pulls], found$value[!pulls],
      max(displacement[setdiff(rownames(displacement), c("tension", "largest_tension")), ],
        na.rm = TRUE)),
    compared_series("tension", at, exact$value[pulls], found$value[pulls],
      max(exact$value[tension]))
  )
}

# Positions (m) of the point `name` from `begin` (s) on; `time` is counted from there.
track_of <- function(trajectory, name, begin = 0) {
  late <- trajectory$time >= begin
  position <- t(trajectory$position[, nodes_at(trajectory, name), late])
  data.frame(time = trajectory$time[late] - begin, x = position[, 1], z = position[, 3])
}

# Solution of y' = rate(time, y) at the times: a row for each.
integrated <- function(start, time, rate) {
  deSolve::ode(start, time, function(t, y, parms) list(rate(t, y)), NULL, rtol = 1e-10,
    atol = 1e-10)[, -1L]
}

# A line without weight and drag.
light_line <- function(from, to, length, axial_stiffness) {
  rope(from, to, length = length, diameter = "10 mm", axial_stiffness = axial_stiffness,
    mass_per_length = 0, volume_per_length = 0, coefficients = list(normal = 0), segments = 1)
}

# A load that hangs in air from the origin by `line`. A rope pulls it from `at` towards `post` with
# `force` (N) until the rope parts after 1 s.
pulled_load <- function(line, mass, at, post, force) {
  distance <- sqrt(sum((post - at)^2))
  gear("load that is let go",
    top = gear_point(position = c(0, 0, 0), held = "moved"), load = gear_point(),
    post = gear_point(position = post, held = "moved"),
    line = line, pull = light_line("load", "post", 0.99 * distance, 99 * force),
    mass = piece(at = "load", mass = mass, volume = 0), water = list(density = 0),
    tow = list(breaking = list(list(rope = "pull", time = 1, position = "start")))
  )
}

# A mass on an elastic line swings by 30 degrees for three periods.
case_pendulum <- function() {
  length <- 10
  stiffness <- 1e6
  mass <- 100
  at <- length * c(sin(pi / 6), 0, -cos(pi / 6))
  found <- tow(
    pulled_load(light_line("top", "load", length, stiffness), mass, at, at + c(10, 0, 0),
      mass * gear_gravity * tan(pi / 6)),
    until = 20, every = 0.1, accuracy = "0.1 %"
  )
  track <- track_of(found, "load", 1)
  exact <- integrated(c(track$x[1], track$z[1], 0, 0), track$time, function(t, y) {
    stretched <- sqrt(sum(y[1:2]^2))
    c(y[3:4], stiffness * (1 / stretched - 1 / length) / mass * y[1:2] - c(0, gear_gravity))
  })
  rbind(
    compared_series("position", "along", exact[, 1], track$x),
    compared_series("position", "up", exact[, 2], track$z)
  )
}

# A mass at the end of a wire oscillates after a load of 2 kN has parted from it. The wire's mass is
# lumped at its nodes, so that the exact motion is a sum of its modes.
case_ringing_wire <- function() {
  n <- 20
  length <- 100
  stiffness <- 1e6
  per_metre <- 0.5
  force <- 2000
  load <- 500
  line <- rope("top", "load", length = length, diameter = "10 mm", axial_stiffness = stiffness,
    mass_per_length = per_metre, volume_per_length = 0, coefficients = list(normal = 0),
    segments = n)
  stretch <- (force + gear_gravity * (load + per_metre * length / 2)) * length / stiffness
  at <- c(0, 0, -length - stretch)
  found <- tow(pulled_load(line, load, at, at - c(0, 0, 100), force), until = 7, every = 0.01,
    accuracy = "0.1 %")
  track <- track_of(found, "load", 1)
  mass <- rep(per_metre * length / n, n)
  mass[n] <- load + mass[n] / 2
  spring <- n * stiffness / length
  between <- diag(c(rep(2, n - 1), 1)) - (abs(outer(1:n, 1:n, `-`)) == 1)
  modes <- eigen(spring * between / sqrt(outer(mass, mass)), symmetric = TRUE)
  # before the load parts it stretches all segments equally
  shape <- crossprod(modes$vectors, sqrt(mass) * force / spring * (1:n))
  swing <- modes$vectors[n, ] * shape / sqrt(mass[n])
  exact <- colSums(as.vector(swing) * cos(outer(sqrt(modes$values), track$time)))
  rest <- track$z[1] + exact[1]
  compared_series("position", "end", -exact, track$z - rest)
}

# A float 2 m below the surface on a tight line in regular waves.
case_moored_float <- function() {
  found <- tow(gear("moored float",
    anchor = gear_point(position = c(0, 0, -12), held = "fixed"), float = gear_point(),
    line = light_line("anchor", "float", 10, 1e4),
    buoy = piece(at = "float", mass = 20, diameter = 0.6),
    water = list(waves = list(height = 0.8, period = 7, rising = 5))
  ), until = 33, every = 0.25, accuracy = "0.1 %")
  track <- track_of(found, "float")
  volume <- pi / 6 * 0.6^3
  density <- 1025
  frequency <- 2 * pi / 7
  number <- frequency^2 / gear_gravity
  # regular waves in deep water (Airy), stretched to their surface (Wheeler)
  water <- function(t, x, z) {
    s <- min(t / 5, 1)
    risen <- s^2 * (3 - 2 * s)
    rate <- if (s < 1) 6 * s * (1 - s) / 5 else 0
    angle <- number * x - frequency * t
    speed <- 0.4 * frequency * exp(number * (z - risen * 0.4 * cos(angle)))
    u <- speed * c(cos(angle), sin(angle))
    list(u = risen * u, a = risen * frequency * speed * c(sin(angle), -cos(angle)) + rate * u)
  }
  exact <- integrated(c(track$x[1], track$z[1], 0, 0), track$time, function(t, y) {
    flow <- water(t, y[1], y[2])
    line <- y[1:2] - c(0, -12)
    stretched <- sqrt(sum(line^2))
    past <- flow$u - y[3:4]
    force <- 1e4 * (1 / stretched - 1 / 10) * line +
      c(0, (density * volume - 20) * gear_gravity) + 1.5 * density * volume * flow$a +
      0.5 * density * 0.47 * pi / 4 * 0.6^2 * sqrt(sum(past^2)) * past
    c(y[3:4], force / (20 + 0.5 * density * volume))
  })
  rbind(
    compared_series("position", "along", exact[, 1], track$x),
    compared_series("position", "up", exact[, 2], track$z)
  )
}

# A sphere of 100 kg that is cut loose in still water: z = -V tau log(cosh(t / tau)).
case_sinking_sphere <- function() {
  diameter <- 0.4
  volume <- pi / 6 * diameter^3
  weight <- (100 - 1025 * volume) * gear_gravity
  drag <- 0.5 * 1025 * 0.47 * pi / 4 * diameter^2
  speed <- sqrt(weight / drag)
  slow <- (100 + 0.5 * 1025 * volume) * speed / weight
  found <- tow(gear("sphere that is cut loose",
    top = gear_point(position = c(0, 0, -1), held = "moved"), sphere = gear_point(),
    line = light_line("top", "sphere", 5, 1e6),
    ball = piece(at = "sphere", mass = 100, diameter = diameter),
    tow = list(breaking = list(list(rope = "line", time = 1, position = "end")))
  ), until = 5, every = 0.25, accuracy = "0.1 %")
  track <- track_of(found, "sphere", 1)
  compared_series("position", "down", -speed * slow * log(cosh(track$time / slow)),
    track$z - track$z[1])
}

# The references were computed with explicit steps much shorter than the period of the fastest mode.
case_stiff_lines <- function() {
  reference <- utils::read.csv("validation/references/stiff-lines.csv")
  do.call(rbind, lapply(names(stiff_lines), function(name) {
    compared_motion(gsub("_", " ", name), reference[reference$case == name, ],
      stiff_line_rows(name, integrate_stiff_line(name)))
  }))
}

case_started_net <- function() {
  reference <- utils::read.csv("validation/references/net-in-starting-current.csv")
  do.call(rbind, lapply(c(8, 20), function(n) {
    found <- tow(started_net(n), nodes = 1e4)
    compared_motion(paste(n, "knots"), reference[reference$n == n, ], started_net_rows(n, found))
  }))
}
