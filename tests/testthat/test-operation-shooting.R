# Gear that is shot: its layout, its release and its sinking.

# A rope of 200 m that is shot along a half circle to port, between fixed points at its ends.
shot_chain <- function() {
  gear(
    "Rope along a half circle",
    first = gear_point(position = c(0, 0, 0), held = "fixed"),
    last = gear_point(position = c(0, -400 / pi, 0), held = "fixed"),
    chain = rope("first", "last", length = 200, diameter = "20 mm", axial_stiffness = 1e6,
      mass_per_length = 1, volume_per_length = 0.0003, segments = 40,
      coefficients = list(normal = 1.2, tangential = 0, skin = 0)),
    water = list(free_surface = TRUE), depth = measure(depth = "chain[0.5]"),
    speed = measure(sinking_speed = "chain[0.5]"),
    shooting = list(rope = "chain", speed = 5, arc = "-180 deg")
  )
}

test_that("shot rope sinks at the terminal speed of its drag", {
  chain <- update(shot_chain(), shooting.speed = 30)
  sunk <- tow(chain, until = 12, every = 12, accuracy = 0.001)
  weight <- 9.81 * (1 - 1025 * 0.0003)
  terminal <- sqrt(weight / (0.5 * 1025 * 1.2 * 0.02))
  # Far from its ends it is level and free, except for their tension inward along the arc, which
  # also moves the rope sideways. Drag along z is 1/2 rho C d |v| v_z.
  state <- state_at(sunk, 12)
  v <- state$velocity[, nodes_at(state, "chain[0.5]")]
  # ripples of 0.001 m over steps of about 0.1 s are 1 % of the speed
  expect_equal(sqrt(sqrt(sum(v^2)) * -v[3]), terminal, tolerance = 0.01)
  expect_equal(measures(state)[["speed_m_per_s"]], -v[3])
})

test_that("shot gear follows its arc and is released behind the vessel", {
  chain <- tow(shot_chain(), until = 30, every = 5)
  mesh <- chain$mesh
  node <- along_rope(mesh, "chain")$node
  at <- along_rope(mesh, "chain")$at
  inner <- -c(1L, length(node))
  start <- chain$position[, node, 1]
  # on a half circle to port, of 200 m, from the origin towards -x
  turn <- pi * at
  radius <- 200 / pi
  expect_equal(start[1, inner], -radius * sin(turn)[inner], tolerance = 1e-9)
  expect_equal(start[2, inner], -radius * (1 - cos(turn))[inner], tolerance = 1e-9)
  for (k in seq_along(chain$time)) {
    # fixed nodes move only by rounding of zero
    moved <- abs(chain$position[, node, k] - start) > 1e-12
    waits <- at * 200 / 5 > chain$time[k] + 0.5
    expect_false(any(moved[, waits & seq_along(at) %in% seq_along(at)[inner]]))
  }
  gone <- at * 200 / 5 < 29
  expect_true(all(chain$position[3, node[gone][-1], 7] < start[3, gone][-1] - 0.01))
})
