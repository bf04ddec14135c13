
test_that("meshes have about the requested number of nodes", {
  for (name in c("pair_trawl", "poly_noreastern_trawl", "model_cage")) {
    numbers <- gear_numbers(gear_si(read_gear(name)))
    for (nodes in c(1000, 1500, 2300)) {
      # a sixth more or fewer, see resolution.hpp
      expect_lt(abs(log(sum(engine_node_counts(numbers, nodes)$nodes) / nodes)), 0.16)
    }
  }
})

test_that("node counts include hexagons and meshes fixed by the plan", {
  strip <- list(
    mesh_size = "144 mm", meshes = list(upper = 50, lower = 50, deep = 60), knotted = FALSE,
    orientation = "hexagonal", straight_bar = "12 mm",
    twine = list(diameter = "3 mm", material = "PE")
  )
  gear <- as_gear(list(
    codend = 1, name = "Hexagons", water = list(current = list(speed = 0.5, toward = "0 deg")),
    points = list(a = list(position = c(0, -2, -1), held = "fixed"),
      b = list(position = c(0, 2, -1), held = "fixed")),
    panels = list(net = strip),
    seams = list(beam = list(edges = list("net.upper"), held_between = list("a", "b")))
  ))
  for (nodes in c(600, 1500)) {
    # edges have one row of nodes more than cells: 10 % at 200 nodes of a grid
    expect_equal(build_mesh(gear_si(gear), nodes)$nodes, nodes, tolerance = 0.25)
  }
  codend <- gear_si(read_gear("t90_codend"))
  # eight strips of one column and 50 rows
  expect_identical(fixed_nodes(codend, NULL), 400)
  expect_identical(fixed_nodes(undivided(codend), NULL), Inf)
  # a finer mesh estimates its errors; reference: a mesh with 27 times the nodes
  state <- settle("t90_codend")
  expect_gt(levels_of(state, plain_measures(measures(state)))[[1]]$nodes, 2 * state$mesh$nodes)
  error <- attr(measures(state), "error")
  fine <- c(length_m = 4.21, catch_volume_m3 = 1.27, total_drag_kN = 5.08)
  off <- abs(plain_measures(measures(state))[names(fine)] - fine)
  expect_true(all(off <= 2 * error[names(fine)]))
  expect_lt(max(error[names(fine)] / fine), 0.1)
  # a mesh with half as many nodes would estimate 10 %
  expect_lt(error[["total_drag_kN"]] / fine[["total_drag_kN"]], 0.04)
  # a cable with a given number of segments; ropes without one
  expect_identical(fixed_nodes(gear_si(read_gear("towed_cable")), NULL),
    as.double(gear_si(read_gear("towed_cable"))$ropes[[1]]$segments))
  expect_identical(fixed_nodes(gear_si(read_gear("pair_trawl")), NULL), Inf)
})
