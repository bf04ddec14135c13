# The engine compared with a direct implementation of the paper's equations: Li et al., Modeling of
# the Midwater Trawl Dynamical Behavior Based on R Language. It is written for readability, one mass
# point and one spring at a time, from the plan's numbers alone. Equation numbers refer to the
# paper. In (7) the density of the water replaces the material's density of the paper, as buoyancy
# requires.

# Three by three diamond meshes on a head rope between two lines, a weight at each lower corner.
paper_plan <- list(
  codend = 1, name = "Netting of the paper", slack_twine = "straight", netting = "bars",
  water = list(density = 1025, viscosity = 1.19e-6, current = list(speed = 0.8, toward = 0.4)),
  points = list(
    port = list(position = c(0, -0.6, 0), held = "fixed"),
    starboard = list(position = c(0, 0.6, 0), held = "fixed")
  ),
  ropes = list(
    line_port = list(from = "port", to = "net.upper_left", length = 0.6, segments = 2,
      diameter = 0.006, axial_stiffness = 900, mass_per_length = 0.03,
      added_mass = list(normal = 1, tangential = 1)),
    line_starboard = list(from = "starboard", to = "net.upper_right", length = 0.6, segments = 2,
      diameter = 0.006, axial_stiffness = 900, mass_per_length = 0.03,
      added_mass = list(normal = 1, tangential = 1)),
    head_rope = list(along = list("net.upper"), length = 0.9, diameter = 0.008,
      axial_stiffness = 1200, mass_per_length = 0.05,
      added_mass = list(normal = 1, tangential = 1))
  ),
  panels = list(net = list(
    mesh_size = 0.4, meshes = list(upper = 3, lower = 3, deep = 3), columns = 3, bar_segments = 2,
    twine = list(diameter = 0.003, axial_stiffness = 400, mass_per_length = 0.008),
    knot_diameter = 0.007, added_mass = list(normal = 1, tangential = 1)
  )),
  pieces = list(
    weight_port = list(at = "net.lower_left", mass = 0.5, volume = 6e-5, drag_area = 0.002,
      added_mass = 0.5),
    weight_starboard = list(at = "net.lower_right", mass = 0.5, volume = 6e-5, drag_area = 0.002,
      added_mass = 0.5)
  )
)

# The paper's mass points and springs: a knot at each even i + j of the half meshes, and a point in
# the middle of each mesh bar. The two lines have points at their ends and middles.
paper_net <- function(plan) {
  net <- plan$panels$net
  points <- data.frame(name = character(), knot = numeric())
  springs <- NULL
  point <- function(name, knot = 0) {
    if (!name %in% points$name) points[nrow(points) + 1L, ] <<- list(name, knot)
    name
  }
  spring <- function(from, to, line, rest) {
    springs <<- rbind(springs, data.frame(
      from = from, to = to, rest = rest, diameter = line$diameter, stiffness = line$axial_stiffness,
      mass = rest * line$mass_per_length, volume = rest * pi / 4 * line$diameter^2
    ))
  }
  mesh_point <- function(i, j) sprintf("%g %g", i / 2, j / 2)
  for (j in 0:6) for (i in 0:6) if ((i + j) %% 2 == 0 && j %% 2 == 0) {
    # Half of a knot on an edge belongs to the neighbour of the panel.
    point(mesh_point(i, j), knot = if (i %in% c(0, 6) || j %in% c(0, 6)) 0.5 else 1)
  } else if ((i + j) %% 2 == 0) {
    point(mesh_point(i, j), knot = 1)
  }
  # The number of knots equals the number of bars of one direction, 2 x 3 x 3.
  points$knot <- points$knot * 18 / sum(points$knot)
  for (j in 0:5) for (i in 0:5) {
    ends <- if ((i + j) %% 2 == 0) c(i, j, i + 1, j + 1) else c(i + 1, j, i, j + 1)
    middle <- point(mesh_point(i + 0.5, j + 0.5))
    spring(mesh_point(ends[1], ends[2]), middle, net$twine, net$mesh_size / 4)
    spring(middle, mesh_point(ends[3], ends[4]), net$twine, net$mesh_size / 4)
  }
  head_rope <- plan$ropes$head_rope
  for (i in c(0, 2, 4)) {
    spring(mesh_point(i, 0), mesh_point(i + 2, 0), head_rope, head_rope$length / 3)
  }
  for (side in c("port", "starboard")) {
    line <- plan$ropes[[paste0("line_", side)]]
    middle <- point(paste("middle", side))
    spring(point(side), middle, line, line$length / 2)
    spring(middle, mesh_point(if (side == "port") 0 else 6, 0), line, line$length / 2)
  }

  pieces <- list(weight_port = mesh_point(0, 6), weight_starboard = mesh_point(6, 6))
  water <- plan$water
  n <- nrow(points)
  mass <- volume <- added <- area <- numeric(n)
  for (s in seq_len(nrow(springs))) for (end in c(springs$from[s], springs$to[s])) {
    p <- match(end, points$name)
    mass[p] <- mass[p] + springs$mass[s] / 2
    volume[p] <- volume[p] + springs$volume[s] / 2
    added[p] <- added[p] + 1 * water$density * springs$volume[s] / 2 # (8), C_m = 1
  }
  # twine in the knots, 16 diameters (the paper's knots are spheres without weight)
  in_knots <- points$knot * 16 * net$twine$diameter
  mass <- mass + in_knots * net$twine$mass_per_length
  volume <- volume + in_knots * pi / 4 * net$twine$diameter^2
  added <- added + 0.5 * water$density * points$knot * pi / 6 * net$knot_diameter^3
  for (k in names(pieces)) {
    p <- match(pieces[[k]], points$name)
    piece <- plan$pieces[[k]]
    mass[p] <- mass[p] + piece$mass
    volume[p] <- volume[p] + piece$volume
    added[p] <- added[p] + piece$added_mass * water$density * piece$volume
    area[p] <- piece$drag_area
  }
  list(
    points = points, springs = springs, held = points$name %in% c("port", "starboard"),
    from = match(springs$from, points$name), to = match(springs$to, points$name),
    mass = mass, volume = volume, inertia = mass + added, drag_area = area,
    knot_diameter = net$knot_diameter, water = water,
    current = water$current$speed * c(cos(water$current$toward), sin(water$current$toward), 0)
  )
}

# Sum of T, F, W and B on every mass point (3 x n), equations (2) to (7).
paper_force <- function(net, x, v) {
  density <- net$water$density
  force <- matrix(0, 3, ncol(x))
  for (i in seq_len(ncol(x))) {
    weight <- net$mass[i] * 9.81 # (6)
    buoyancy <- density * net$volume[i] * 9.81 # (7)
    u <- net$current - v[, i]
    speed <- sqrt(sum(u^2))
    reynolds <- speed * net$knot_diameter / net$water$viscosity
    c_d <- 24 / reynolds + 6 / (1 + sqrt(reynolds)) + 0.4
    s_1 <- net$points$knot[i] * pi / 4 * net$knot_diameter^2
    drag <- 0.5 * density * (c_d * s_1 + net$drag_area[i]) * speed * u # (3)
    force[, i] <- drag + c(0, 0, buoyancy - weight)
  }
  for (s in seq_len(nrow(net$springs))) {
    i <- net$from[s]
    j <- net$to[s]
    spring <- net$springs[s, ]
    along <- x[, j] - x[, i]
    length <- sqrt(sum(along^2))
    k <- spring$stiffness / spring$rest
    tension <- if (length > spring$rest) k * (length - spring$rest) else 0 # (2)
    force[, i] <- force[, i] + tension * along / length
    force[, j] <- force[, j] - tension * along / length

    u <- net$current - (v[, i] + v[, j]) / 2
    speed <- sqrt(sum(u^2))
    if (sum(u * along) < 0) along <- -along
    alpha <- acos(min(1, sum(u * along) / (speed * length)))
    c_d <- 1.1 * sin(alpha)^3 + 0.02
    c_l <- 1.1 * sin(alpha)^2 * cos(alpha)
    # Across the flow, away from the axis, in the plane of both.
    across <- sum(u * along) / speed^2 * u - along
    across <- across / sqrt(sum(across^2))
    s_2 <- spring$diameter * spring$rest
    lift <- 0.5 * c_l * density * s_2 * speed^2 * across # (4)
    drag <- 0.5 * c_d * density * s_2 * speed * u # (5)
    force[, i] <- force[, i] + (lift + drag) / 2
    force[, j] <- force[, j] + (lift + drag) / 2
  }
  force
}

# Accelerations (1), (9); fixed points have none.
paper_acceleration <- function(net, x, v) {
  a <- sweep(paper_force(net, x, v), 2, net$inertia, "/")
  a[, net$held] <- 0
  a
}

# Equation (14), with the initial guess of (11).
paper_march <- function(net, x, v, dt, steps, tolerance) {
  q <- v
  x_before <- q_before <- NULL
  rounds <- 0
  for (k in seq_len(steps)) {
    f <- paper_acceleration(net, x, q)
    if (is.null(x_before)) {
      x_new <- x + dt * q
      q_new <- q + dt * f
    } else {
      x_new <- x_before + 2 * dt * q
      q_new <- q_before + 2 * dt * f
    }
    repeat {
      rounds <- rounds + 1
      f_new <- paper_acceleration(net, x_new, q_new)
      x_next <- x + dt / 2 * (q + q_new)
      q_next <- q + dt / 2 * (f + f_new)
      change <- max(abs(q_next - q_new), abs(x_next - x_new) / dt)
      x_new <- x_next
      q_new <- q_next
      if (change <= tolerance) break
      stopifnot(rounds < 100 * steps)
    }
    x_before <- x
    q_before <- q
    x <- x_new
    q <- q_new
  }
  list(position = x, velocity = q, rounds = rounds)
}

# The mesh of the same plan, and in `node` its node for each of the paper's mass points.
paper_mesh <- function(plan, net) {
  mesh <- build_mesh(gear_si(as_gear(plan)))
  drawn <- panel_of(mesh, "net")
  node <- drawn$node[match(net$points$name, sprintf("%g %g", drawn$i, drawn$j))]
  for (side in c("port", "starboard")) {
    line <- along_rope(mesh, paste0("line_", side))$node
    node[net$points$name == side] <- line[1]
    node[net$points$name == paste("middle", side)] <- line[2]
  }
  list(mesh = mesh, node = node)
}

# A distorted hanging net: some springs are taut, some slack.
paper_state <- function(net, seed) {
  set.seed(seed)
  x <- vapply(net$points$name, function(name) {
    switch(name,
      port = c(0, -0.6, 0), starboard = c(0, 0.6, 0),
      "middle port" = c(0.1, -0.55, -0.25), "middle starboard" = c(0.1, 0.55, -0.25),
      {
        ij <- as.numeric(strsplit(name, " ")[[1]])
        c(0.2 + 0.1 * ij[2], 0.3 * (ij[1] - 1.5), -0.5 - 0.35 * ij[2])
      }
    )
  }, numeric(3))
  free <- !net$held
  x[, free] <- x[, free] + stats::runif(3 * sum(free), -0.03, 0.03)
  v <- matrix(0, 3, ncol(x))
  v[, free] <- stats::runif(3 * sum(free), -0.5, 0.5)
  list(x = unname(x), v = v)
}

# Columns by the engine's nodes instead of the paper's mass points.
by_node <- function(values, node) {
  out <- matrix(0, 3, length(node))
  out[, node] <- values
  as.vector(out)
}

test_that("engine has exactly the paper's mass points", {
  net <- paper_net(paper_plan)
  built <- paper_mesh(paper_plan, net)
  expect_identical(sort(built$node), seq_len(engine_array(built, "nodes")))
  expect_identical(which(engine_array(built, "held")), sort(built$node[net$held]))
  expect_length(engine_array(built, "ties", "share"), 0L)
})

test_that("engine forces and masses equal the paper's equations (1) to (9)", {
  net <- paper_net(paper_plan)
  built <- paper_mesh(paper_plan, net)
  for (seed in 1:5) {
    state <- paper_state(net, seed)
    found <- engine_evaluate(
      engine_array(built), by_node(state$x, built$node), by_node(state$v, built$node)
    )
    length <- sqrt(colSums((state$x[, net$to] - state$x[, net$from])^2))
    taut <- mean(length > net$springs$rest)
    expect_true(taut > 0.2 && taut < 0.8)
    expected <- paper_force(net, state$x, state$v)
    # About ten terms a node, 1e-16 each; acos() loses digits near 0, but alpha is above 0.4.
    difference <- matrix(found$force, 3)[, built$node] - expected
    expect_lt(max(abs(difference)), 1e-10 * max(abs(expected)))

    # The mass is a scalar here: equal diagonal entries, other entries zero.
    masses <- matrix(found$mass, 9)[, built$node]
    expect_equal(masses[c(1, 5, 9), ], matrix(rep(net$inertia, each = 3), 3), tolerance = 1e-13)
    expect_lt(max(abs(masses[c(2, 3, 4, 6, 7, 8), ])), 1e-13 * max(net$inertia))
  }
})

test_that("engine steps equal the paper's equation (14)", {
  net <- paper_net(paper_plan)
  built <- paper_mesh(paper_plan, net)
  state <- paper_state(net, 6)
  dt <- 1e-4
  expected <- paper_march(net, state$x, state$v, dt, 20, 1e-9)
  found <- engine_integrate(
    engine_array(built), by_node(state$x, built$node), by_node(state$v, built$node), dt, 20L, 1e-9,
    100L
  )
  expect_true(found$converged)
  expect_identical(found$steps, 20L)
  expect_equal(found$substitutions, expected$rounds)
  # The same substitutions, so only rounding differs: 1e-13 of the forces, 20 steps.
  moved <- matrix(found$position, 3)[, built$node] - expected$position
  expect_lt(max(abs(moved)), 1e-12)
  expect_lt(max(abs(matrix(found$velocity, 3)[, built$node] - expected$velocity)), 1e-10)
  expect_gt(max(abs(expected$position - state$x)), 1e-4)
})

test_that("engine_integrate() stops if the paper's scheme does not converge", {
  net <- paper_net(paper_plan)
  built <- paper_mesh(paper_plan, net)
  state <- paper_state(net, 7)
  x <- by_node(state$x, built$node)
  v <- by_node(state$v, built$node)
  # The fastest motion of a net has about 2 sqrt(EA / (rest m)): two twines of 0.1 m between knots.
  fastest <- 2 * sqrt(max(net$springs$stiffness / net$springs$rest) / min(net$inertia))
  found <- engine_integrate(engine_array(built), x, v, 10 * 2 / fastest, 20L, 1e-9, 500L)
  expect_false(found$converged)
  expect_lt(found$steps, 20L)
  expect_true(all(is.finite(c(found$position, found$velocity))))
})
