# Cells of netting with realistic twine stiffness, compared with the same netting mesh by mesh and
# with the analytical solution of a tube under pressure.

# A diamond panel of 160 by 90 meshes of 80 mm between two points, a chain at its foot, in 0.6 m/s.
hung_diamonds <- function(stiffness, ...) {
  as_gear(list(
    codend = 1, name = "Hanging panel", water = list(current = list(speed = 0.6, toward = 0)),
    points = list(
      a = list(position = c(0, -4, -1), held = "fixed"),
      b = list(position = c(0, 4, -1), held = "fixed")
    ),
    panels = list(net = list(
      mesh_size = 0.08, meshes = list(upper = 160, lower = 160, deep = 90), knotted = FALSE,
      ...,
      twine = list(diameter = 0.002, axial_stiffness = stiffness, mass_per_length = 0.0036)
    )),
    seams = list(beam = list(edges = list("net.upper"), held_between = list("a", "b"))),
    ropes = list(chain = list(
      along = "net.lower", hanging_ratio = 0.625, diameter = 0.016, material = "steel_chain"
    )),
    measures = list(
      foot_width = list(spread = list("chain.start", "chain.end")),
      net_drag = list(drag = list("net"))
    )
  ))
}

test_that("cells of stiff twine hang as netting modelled mesh by mesh", {
  # Reference: bars mesh by mesh with 29,051 nodes, computed once by bench/netting.R. With two
  # pieces per bar, 58,000 nodes, the width is the same to 4 digits. Values: foot width, m, and
  # drag, kN, at EA of 3 kN and 200 kN, nearly as rigid as steel wire; all twine is taut. With equal
  # sag of all twines at any tension, the width deviated by 2.4 % at 1,000 nodes and 1.4 % at 5,000;
  # with triangles by 21 %.
  mesh_by_mesh <- list("3000" = c(3.372, 0.4716), "2e+05" = c(3.412, 0.4747))
  for (stiffness in c(3000, 2e5)) {
    for (nodes in c(1000, 3000)) {
      found <- measures(settle(hung_diamonds(stiffness), nodes = nodes))
      known <- mesh_by_mesh[[as.character(stiffness)]]
      # the requirement at 5,000 nodes
      expect_lt(abs(found[["foot_width_m"]] / known[1] - 1), 0.01)
      expect_lt(abs(found[["net_drag_kN"]] / known[2] - 1), 0.005)
      expect_lt(found[["slack_netting_percent"]], 1)
    }
  }
})

test_that("hexagonal netting of stiff twine does not lock", {
  # Its cells have three corners and an inner point. Three lengths use the three degrees of freedom
  # of the inner point and leave the corners free. Reference at 60,000 nodes, computed once: foot
  # width 2.590 m and drag 0.4351 kN; with turned hexagons 5.036 m and 0.4363 kN. At 1,100 nodes the
  # deviation is 1 and 2 %; triangles of diamonds deviated by 21 and 3 %.
  finest <- list(hexagonal = c(2.590, 0.4351), hexagonal_turned = c(5.036, 0.4363))
  for (orientation in names(finest)) {
    gear <- hung_diamonds(3000, orientation = orientation, straight_bar = 0.01)
    state <- settle(gear, nodes = 1100)
    found <- measures(state)
    expect_equal(found[["foot_width_m"]], finest[[orientation]][1], tolerance = 0.01)
    expect_equal(found[["net_drag_kN"]], finest[[orientation]][2], tolerance = 0.02)
  }
})

# A closed tube of diamond netting with `around` meshes in strips of `each`, filled with catch over
# most of its length. Its entrance is fixed on a circle of radius r.
full_tube <- function(around, deep, filled, speed, size, radius, stiffness = 1e5, each = 1) {
  net <- list(
    mesh_size = size, meshes = list(upper = each, lower = each, deep = deep), knotted = FALSE,
    columns = 1, rows = deep / each,
    twine = list(diameter = 0.003, axial_stiffness = stiffness, mass_per_length = 0.0072453)
  )
  as_gear(bag_plan(net, circle_of_corners(around / each, radius, -10),
    list(blocked_meshes = filled), coefficients = list(normal = 0), speed = speed))
}

# Tensions of netting well behind the front and before the closed end, N.
middle_tensions <- function(state) {
  lines <- as.data.frame(state, what = "tensions")
  lines <- lines[lines$kind == "netting", ]
  # at a distance of a fifth of the catch's length from either
  x <- range(state$position[1, ])
  1000 * lines$tension_kN[lines$x_m > x[1] + 0.45 * diff(x) & lines$x_m < x[1] + 0.65 * diff(x)]
}

test_that("settle() leaves an inverted equilibrium of a full bag", {
  # Two bags in a row, pinched off between, each pushed outward, are in equilibrium too. They have
  # half the tension in the middle and less volume. A perturbation grows there.
  around <- 48
  size <- 0.1
  speed <- 1.5
  radius <- around * size * sqrt(2 / 3) / (2 * pi)
  still <- 0.5 * 1.4 * 1025 * speed^2 * radius * size / 2 / sqrt(2)
  for (stiffness in c(3e3, 1e4, 2e5)) {
    # with the stretched bar: radius and length both grow
    wanted <- still
    for (turn in 1:50) wanted <- still * (1 + wanted / stiffness)^2
    for (filled in c(60, 70)) {
      state <- settle(full_tube(around, 72, filled, speed, size, radius, stiffness, each = 4))
      expect_false(state$report$unstable)
      tension <- middle_tensions(state)
      # twelve sides under the circle's pressure: the mesh error is 0.1 %
      expect_equal(mean(tension), wanted, tolerance = 2e-3)
      expect_lt(stats::sd(tension) / mean(tension), 0.02)
    }
  }
  # an equilibrium that remains unstable gives a warning
  state$report$unstable <- TRUE
  expect_warning(codend:::warn_of_doubts(state, swings = FALSE), "catch.panels",
    class = "codend_warning_catch_unstable")
})
