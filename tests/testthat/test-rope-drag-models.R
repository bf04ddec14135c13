# Ropes and twine with load tables instead of EA, strumming and friction.

hanging <- function(mass, ...) {
  gear("a rope with a weight",
    top = gear_point(position = c(0, 0, 0), held = "fixed"), end = gear_point(),
    line = rope("top", "end", length = "10 m", diameter = "20 mm", mass_per_length = "0.001 kg/m",
      volume_per_length = "0 m2", segments = 4, ...),
    weight = piece(at = "end", mass = mass, volume = "0 l")
  )
}

law <- list(
  list(elongation = "1 %", load = "1 kN"), list(elongation = "3 %", load = "6 kN"),
  list(elongation = "5 %", load = "20 kN")
)

test_that("rope stretches by its load table", {
  depth <- function(load) {
    state <- settle(hanging(load / gear_gravity, load_by_elongation = law))
    -state$position[3, nodes_at(state, "end")]
  }
  # the rope's own weight of 0.1 N, compared with 500 N and more
  expect_equal(depth(500), 10 * 1.005, tolerance = 1e-5)
  expect_equal(depth(3500), 10 * 1.02, tolerance = 1e-5)
  expect_equal(depth(13000), 10 * 1.04, tolerance = 1e-5)
  expect_equal(depth(27000), 10 * 1.06, tolerance = 1e-5)
})

test_that("rope with a load table conserves energy", {
  # hung from a heaving point, so that its load passes from row to row
  bouncing <- gear("a rope with a weight that heaves",
    top = gear_point(position = c(0, 0, 0), held = "moved"), end = gear_point(),
    line = rope("top", "end", length = "10 m", diameter = "20 mm", mass_per_length = "0.001 kg/m",
      volume_per_length = "0 m2", segments = 4, load_by_elongation = law),
    weight = piece(at = "end", mass = "300 kg", volume = "0 l"), water = list(density = 0)
  )
  found <- tow(bouncing, until = 4, every = 0.05, accuracy = 1e-4,
    schedule = tow_schedule(heave = function(t) 0.15 * sin(pi * min(t, 2))^2))
  tension <- apply(found$bar_tension, 2L, max)
  expect_lt(min(tension), 1000)
  expect_gt(max(tension), 6000)
  last <- found$conditions[nrow(found$conditions), ]
  expect_lt(abs(last$energy_imbalance), 0.02 * last$energy_put_through)
})

test_that("strumming warp has the drag by Vandiver", {
  drag <- function(...) {
    state <- settle(gear("a bar",
      a = gear_point(position = c(0, 0, -5), held = "fixed"),
      b = gear_point(position = c(0, 1, -5), held = "fixed"),
      bar = rope("a", "b", length = "1 m", diameter = "20 mm", axial_stiffness = "1 MN",
        mass_per_length = "3 kg/m", segments = 1,
        coefficients = list(normal = 1.2, tangential = 0, skin = 0), ...),
      water = list(current = list(speed = "1 m/s", toward = "0 deg"))
    ))
    state$forces$bar_drag[1, 1]
  }
  expect_equal(drag(strumming = 0.5) / drag(), 2.043, tolerance = 1e-12)
  expect_refused(
    rope_law_error <- gear("a bar", a = gear_point(position = c(0, 0, 0), held = "fixed"),
      b = gear_point(),
      bar = rope("a", "b", length = 1, diameter = 0.02, material = "PA", strumming = 0.5,
        coefficients = "choo_casarella"))
  )
})

test_that("chain with low friction along itself slides along itself", {
  # A chain at an angle to its tow aligns with its path. Drawn along, its tension is the friction
  # coefficient times its weight.
  pull <- function(...) {
    found <- tow(gear("a chain that is towed",
      start = gear_point(position = c(0, 0, -9.98), held = "moved"), end = gear_point(),
      chain = rope("start", "end", length = "8 m", diameter = "20 mm", material = "steel_chain",
        segments = 8, coefficients = list(normal = 0, tangential = 0, skin = 0), ...),
      towing = list(speed = "0.5 m/s"), seabed = list(depth = "10 m", friction = 0.5)
    ), until = 60, every = 30)
    found$bar_tension[1, 3]
  }
  # 0.5 and 0.25 of the same weight on the ground
  expect_equal(pull(friction = list(along = 0.25, across = 0.8)) / pull(), 0.5, tolerance = 0.02)
})
