# Simple gear at rest settles and stays at rest in a tow.

on_bed <- "seabed: {depth: 20 m, friction: 0.5}"
ground_rope <- function(material, where = on_bed) {
  read_text(sprintf("
codend: 1
name: Slack rope
%s
points:
  west: {position: [0 m, 0 m, -20 m], held: fixed}
  east: {position: [8 m, 0 m, -20 m], held: fixed}
ropes:
  line: {from: west, to: east, length: 10 m, diameter: 20 mm, material: %s}
", where, material))
}
# Largest displacement of a node after 20 s, m.
drift <- function(state) {
  end <- tow(state, until = 20, every = 20)
  expect_equal(max(end$time), 20)
  max(abs(state_at(end, 20)$position - state$position))
}

test_that("slack rope on level ground has its weight in water as load", {
  for (material in c("steel_chain", "PA")) {
    state <- settle(ground_rope(material), 100)
    line <- state$si$ropes$line
    weight <- 10 * (line$mass_per_length - 1025 * line$volume_per_length) * 9.81
    # a fixed end carries half of the element next to it
    expect_equal(measures(state)[["ground_load_kN"]], weight / 1000, tolerance = 0.02)
    expect_lt(drift(state), 1e-3)
  }
})

test_that("slack rope in still water hangs as a catenary", {
  state <- settle(ground_rope("PA", ""), 100)
  # an inextensible catenary: sinh(u) / u = length / span, sag a (cosh(u) - 1)
  u <- stats::uniroot(function(u) sinh(u) / u - 10 / 8, c(0.1, 5), tol = 1e-10)$root
  sag <- 4 / u * (cosh(u) - 1)
  expect_equal(-20 - min(state$position[3, ]), sag, tolerance = 1e-3)
  expect_lt(drift(state), 1e-3)
})

test_that("net settles on the bed and in still water", {
  wall <- "
codend: 1
name: Net at rest
%s
points:
  west: {position: [0 m, -5 m, -20 m], held: fixed}
  east: {position: [0 m, 5 m, -20 m], held: fixed}
panels:
  wall:
    mesh_size: 100 mm
    meshes: {upper: 140, lower: 140, deep: 30}
    twine: {diameter: 2 mm, material: PA}
ropes:
  headline: {along: wall.upper, hanging_ratio: 0.7, diameter: 12 mm, material: PA}
  west_tie: {from: west, to: wall.upper_left, length: 0.5 m, diameter: 12 mm, material: PA}
  east_tie: {from: east, to: wall.upper_right, length: 0.5 m, diameter: 12 mm, material: PA}
"
  for (where in c(on_bed, "")) {
    state <- settle(read_text(sprintf(wall, where)), 300)
    expect_lt(drift(state), 0.02)
  }
})

test_that("gear of every kind settles in still water", {
  for (name in c("gillnet", "cage", "stow_net", "dip_net", "midwater_trawl")) {
    gear <- read_gear(name)
    still <- if (is.null(gear$plan$towing)) {
      update(gear, water.current = NULL)
    } else {
      update(gear, towing.speed = 0)
    }
    state <- suppressWarnings(settle(still, 500))
    expect_lt(drift(state), 0.02)
  }
})
