# Motions of nearly straight, stiff lines: errors appear in tensions and in energy.

# A chain that hangs from a point, pulled aside lightly and released after 1 s.
plucked_chain <- function(diameter, pull_stiffness = 1e6, ...) {
  free <- list(length = 29.9, diameter = 0.01, axial_stiffness = pull_stiffness,
    mass_per_length = 0, volume_per_length = 0, coefficients = list(normal = 0), segments = 1)
  as_gear(list(
    codend = 1, name = "Plucked chain", ...,
    points = list(
      top = list(position = c(0, 0, -2), held = "moved"), tail = list(),
      post = list(position = c(30, 0, -12), held = "moved")
    ),
    ropes = list(
      chain = c(list(from = "top", to = "tail", length = 10, segments = 100), diameter),
      pull = c(list(from = "tail", to = "post"), free)
    ),
    tow = list(
      until = 60, every = 0.5, breaking = list(list(rope = "pull", time = 1, position = "start"))
    )
  ))
}

steel_chain <- function() plucked_chain(list(diameter = 0.022, material = "steel_chain"))

chain_in_air <- function() {
  plucked_chain(list(diameter = 0.05, axial_stiffness = 1e8, mass_per_length = 10,
    coefficients = list(normal = 0), added_mass = list(normal = 1, tangential = 0)),
  water = list(density = 0))
}

test_that("plucked chain has its weight as tension at any accuracy", {
  for (accuracy in c(0.1, 0.01, 0.001)) {
    found <- tow(steel_chain(), accuracy = accuracy)
    # the converged motion has 821.5 N (other steps, other schemes); 5 % is the requirement
    expect_equal(max(found$bar_tension), 821.5, tolerance = 0.05)
  }
  # in air the weight of ten metres of 10 kg/m, except half a segment at the top; the oscillation
  # adds little
  expect_equal(max(tow(chain_in_air())$bar_tension), 10 * 9.81 * 9.95, tolerance = 0.05)
})

test_that("plucked chain in air gains no energy", {
  # the scheme removes energy; gains are the rounding of 1e4 J of potential energy
  expect_lt(max(tow(chain_in_air())$conditions$energy_imbalance), 1e-6)
})

test_that("findings() warns if the scheme removes energy that nothing else removes", {
  # a chain in air has no other dissipation
  warned <- function(trajectory) "numerical dissipation" %in% findings(trajectory)$check
  coarse <- tow(chain_in_air(), step = 0.2)
  expect_true(warned(coarse))
  expect_false(warned(tow(chain_in_air(), accuracy = "0.1 %")))
  expect_output(print(summary(coarse)), "Energy removed by the time scheme: 0.0")
})

test_that("work of net and vessel equals dissipation in the water", {
  # a cable that settles again: kinetic and elastic energy return, so work and drag must agree
  found <- tow("towed_cable", until = 60, every = 10)
  part <- setNames(as.list(found$energy[, 7]), engine_energy_parts())
  expect_equal(-part$water, part$supports, tolerance = 1e-6)
  expect_lt(abs(found$conditions$energy_imbalance[7]), 1e-6 * part$put_through)
})

test_that("accuracy may name position and tension", {
  gear <- chain_in_air()
  loose <- tow(gear, until = 3, accuracy = list(position = 0.1))
  strict <- tow(gear, until = 3, accuracy = list(position = "10 cm", tension = 1e-4))
  expect_gt(strict$report$steps, 1.5 * loose$report$steps)
  expect_wrong(tow(gear, until = 1, accuracy = list(speed = 1)), "`accuracy` must be")
})

test_that("lower accuracy needs no more iterations", {
  cost <- vapply(c(0.1, 0.01), function(a) {
    tow(steel_chain(), accuracy = a, every = 2)$report$iterations
  }, 0)
  expect_lte(cost[1], cost[2])
})

test_that("tow() resolves the shock of a very stiff rope without loss of energy", {
  # A weight falls into its rope. The shock takes 1e-6 s.
  falling <- gear("a weight that falls into its rope",
    top = gear_point(position = c(0, 0, 0), held = "moved"), end = gear_point(),
    line = rope("top", "end", length = "5 m", diameter = "10 mm", axial_stiffness = "1e15 N",
      mass_per_length = "0.01 kg/m", segments = 1),
    weight = piece(at = "end", mass = "100 kg", volume = "0 l"), water = list(density = 0)
  )
  # faster down than it falls, for 0.3 s
  found <- tow(falling, until = 1, every = 0.1,
    schedule = tow_schedule(heave = function(t) -10 * min(t, 0.3)^2))
  height <- found$position[3, 2, ]
  # it falls 0.9 m and rebounds within the 2 % that one step may lose
  expect_lt(min(height), -5.7)
  expect_lt(max(abs(found$conditions$energy_imbalance)), 0.02 * 100.05 * gear_gravity * 0.9)
  expect_error(abort_unbalanced(list(time = 1, worst_node = 2L), found),
    "energy balance is wrong", class = "codend_error_energy")
})
