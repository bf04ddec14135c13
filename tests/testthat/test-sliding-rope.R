# Ropes that slide through points, and points at a fraction of a rope's length.

# The rope's second end is `drop` m lower.
hanging_weight <- function(drop = 0, ...) {
  gear(
    "A weight on a rope over a ring",
    a = gear_point(position = c(0, 0, -1), held = "fixed"),
    b = gear_point(position = c(8, 0, -1 - drop), held = "fixed"), ring = gear_point(),
    wire = rope("a", "b", through = list("ring"), length = 10, diameter = "10 mm",
      axial_stiffness = 1e8, mass_per_length = 0, volume_per_length = 0),
    weight = piece(at = "ring", mass = "500 kg", volume = 0),
    depth = measure(depth = "ring"), pull = measure(tension = "wire.max"), ...
  )
}

test_that("weight on a sliding rope settles with equal slopes", {
  for (drop in c(0, 1.5)) {
    state <- settle(hanging_weight(drop))
    # both parts have the angle with cosine 8/10; EA of 1e8 N stretches by 4e-5 under 4 kN
    expect_equal(measures(state)[["depth_m"]], 1 + 3 + drop / 2, tolerance = 1e-4)
    expect_equal(state$position[1, nodes_at(state, "ring")], 4 + drop * 8 / 12, tolerance = 1e-4)
    expect_equal(measures(state)[["pull_kN"]], 0.5 * 9.81 / (2 * 0.6), tolerance = 1e-4)
    expect_identical(state$bar_tension[1], state$bar_tension[2])
    balance <- codend:::balance_table(state)
    expect_lt(max(abs(balance[balance$force == "remainder", -1])), 1e-7)
  }
})

test_that("point at a fraction of a laced rope has its own node", {
  wall <- gear(
    "Netting on two piles",
    west = gear_point(position = c(0, -5, -1), held = "fixed"),
    east = gear_point(position = c(0, 5, -1), held = "fixed"),
    wall = netting_panel(mesh_size = "100 mm", meshes = list(upper = 140, lower = 140, deep = 10),
      twine = list(diameter = "2 mm", material = "PA")),
    headline = rope(along = "wall.upper", hanging_ratio = 0.7, diameter = "12 mm",
      material = "PE"),
    foot = rope(along = "-wall.lower", hanging_ratio = 0.7, diameter = "12 mm", material = "PE"),
    west_tie = rope("west", "wall.upper_left", length = 0.5, diameter = "12 mm", material = "PE"),
    east_tie = rope("east", "wall.upper_right", length = 0.5, diameter = "12 mm", material = "PE"),
    ring = gear_point(at = "foot[0.17]"),
    weight = piece(at = "ring", mass = "10 kg", density = "7850 kg/m3"),
    depth = measure(depth = "foot[0.17]")
  )
  mesh <- codend:::build_mesh(codend:::gear_si(wall), 100)
  foot <- along_rope(mesh, "foot")
  node <- nodes_at(mesh, "foot[0.17]")
  # breaks are accurate to 1e-7 of an edge
  expect_equal(foot$at[match(node, foot$node)], 0.17, tolerance = 1e-6)
  expect_equal(nodes_at(mesh, "ring"), node)
  # 0.83 of the edge, which runs in the opposite direction
  panel <- division_of(mesh)
  on_lower <- panel$before[2] + seq_len(panel$count[2])
  expect_equal(panel$fraction[on_lower][panel$edge_node[on_lower] == node], 0.83, tolerance = 1e-6)
})
