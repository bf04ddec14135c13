# The seabed under a gear: shape, load and friction of a dragged chain.

# A chain without water, so that only weight and ground act, dragged over level ground.
dragged_chain <- function(...) {
  gear("dragged chain",
    ship = gear_point(position = c(0, 0, 0), held = "moved"), tail = gear_point(),
    chain = rope("ship", "tail", length = "60 m", diameter = "13 mm", axial_stiffness = "50 MN",
      mass_per_length = "4 kg/m"),
    seabed = list(depth = "15 m", friction = 0.6),
    water = list(density = 0), towing = list(speed = "1 m/s"), ...
  )
}

# Analytical solution. A hanging length s pulls down with V = w s. The part on the ground has the
# friction H = mu w (L - s), with mu reduced by the slip speed of 0.02 m/s. The catenary rises by
# H/w (sqrt(1 + (V/H)^2) - 1). Returns s (m) and, in N, both forces at the ship, the ground load and
# the weight of a metre.
hung_chain <- function() {
  w <- 4 * gear_gravity
  mu <- 0.6 / sqrt(1 + 0.02^2)
  rise <- function(s) {
    h <- mu * (60 - s)
    h * (sqrt(1 + (s / h)^2) - 1)
  }
  s <- uniroot(function(s) rise(s) - 15, c(15, 59), tol = 1e-10)$root
  c(hanging = s, along = mu * w * (60 - s), vertical = w * s, ground = w * (60 - s), metre = w)
}

test_that("dragged chain hangs in a catenary set by its friction", {
  state <- settle(dragged_chain(), nodes = 400)
  exact <- hung_chain()
  s <- exact[["hanging"]]
  w <- exact[["metre"]]
  found <- measures(state)
  pull <- summary(state)$reactions
  # Elements of 0.15 m: the lowest hanging one is half on the ground, 0.15 m of s = 30 m.
  expect_equal(pull$z_kN, exact[["vertical"]] / 1000, tolerance = 0.15 / s)
  expect_equal(-pull$x_kN, exact[["along"]] / 1000, tolerance = 0.15 / (60 - s))
  expect_equal(found[["ground_load_kN"]], 60 * w / 1000 - pull$z_kN, tolerance = 1e-6)
  expect_equal(found[["ground_friction_percent"]], 100, tolerance = 1e-6)
  # Penetration at the equilibrium: p^2 = 2 h w / (k d), h = 0.02 m, k = 3e6 Pa/m.
  sunk <- sqrt(2 * 0.02 * w / (3e6 * 0.013))
  # So the chain, curved with a radius of H/w, touches the ground earlier by sqrt(2 sunk H/w).
  sooner <- sqrt(2 * sunk * exact[["along"]] / w)
  expect_gt(found[["rope_on_ground_m"]], 60 - s)
  expect_lt(found[["rope_on_ground_m"]], 60 - s + sooner + 0.15)
  tail <- state$position[3, nodes_at(state, "tail")]
  expect_equal(-15 - tail, sunk - 0.013 / 2, tolerance = 1e-4)
})

test_that("gear settles on sloping ground with zero remainder", {
  state <- settle(update(dragged_chain(),
    seabed.slope = list(angle = "10 deg", toward = "90 deg"), water.density = 1025
  ), nodes = 100)
  x <- state$position[, nodes_at(state, "tail")]
  # It slides sideways down, and its middle is half a diameter, less a millimetre or two, above the
  # ground.
  expect_gt(x[2], 1)
  above <- height_above_ground(state$si$ground, cbind(x))
  expect_lt(abs(above - 0.013 / 2), 0.007)
  remainder <- summary(state)$balance
  remainder <- unlist(remainder[remainder$force == "remainder", -1])
  expect_lt(max(abs(remainder)), 1e-6)
})

test_that("otter board settles on the ground on its shoe", {
  # A board on the ground has equilibria upright and on its side. With its centre of gravity at -0.6
  # m the mesh decides the result; here most meshes have it upright.
  board <- read_gear(test_path("plans", "towed_board.yaml"))
  state <- settle(update(board,
    seabed = list(depth = "9.7 m", friction = 0.5), ropes.warp.length = "60 m",
    otter_boards.otter_board.centre_of_gravity.up = "-0.5 m"
  ), nodes = 100)
  table <- board_table(state)
  expect_equal(table$condition, "flying")
  expect_gt(table$ground_load_kN, 0.01)
  # The warp is attached 1.35 m above its lower edge, which is level except for the trim.
  expect_equal(measures(state)[["depth_m"]], 9.7 - 1.35, tolerance = 0.05 / 8)
  remainder <- summary(state)$balance
  expect_lt(max(abs(unlist(remainder[remainder$force == "remainder", -1]))), 1e-6)
})

test_that("sloping bed has the plan's depth below the origin", {
  bed <- list(depth = 50, slope = list(angle = 0.3, toward = 0.5), friction = 0.5, stiffness = 1e4)
  ground <- si_seabed(bed, 2, 100)
  expect_equal(height_above_ground(ground, c(0, 0, -50)), 0)
  # 10 m down the slope it is 10 tan(0.3) deeper, and distances are normal to it
  down <- 10 * c(cos(0.5), sin(0.5))
  expect_equal(height_above_ground(ground, c(down, -50 - 10 * tan(0.3))), 0)
  expect_equal(height_above_ground(ground, c(0, 0, -40)), 10 * cos(0.3))
})
