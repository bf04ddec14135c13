# Transfer of shapes from mesh to mesh.

tapered_panel <- function(deep = 30) {
  list(
    codend = 1, name = "Tapered panel", water = list(density = 0),
    points = list(
      left = list(position = c(0, 0, 0), held = "fixed"),
      right = list(position = c(0, 4, 0), held = "fixed")
    ),
    panels = list(net = list(
      mesh_size = 0.1, meshes = list(upper = 60, lower = 24, deep = deep),
      twine = list(diameter = 0.002, axial_stiffness = 1e3, mass_per_length = 0.01)
    )),
    ropes = list(line = list(
      along = list("net.right"), length = 3, diameter = "8 mm", material = "PP"
    )),
    seams = list(top = list(edges = list("net.upper"), held_between = c("left", "right")))
  )
}

# The mesh with a shape that is linear in the panel's mesh coordinates, and these coordinates of all
# nodes.
drawn_flat <- function(si, nodes, netting) {
  mesh <- build_mesh(si, nodes, netting)
  table <- panel_table(si$panels)
  at <- panel_places(table, division_of(mesh), panels_of(mesh))
  j <- at$t * table$deep
  left <- panel_left(table, j)
  i <- left + at$s * (panel_right(table, j) - left)
  position <- matrix(NA_real_, 3L, engine_array(mesh, "nodes"))
  position[, at$node] <- rbind(2 * i - j, i + 3 * j, 0.5 * j)
  list(mesh = mesh, position = mesh_points(mesh, position), nodes = position)
}

test_that("mesh transfer is exact for linear shapes with any netting element", {
  si <- gear_si(as_gear(tapered_panel()))
  for (from in c("cells", "bars")) {
    for (to in c("cells", "bars")) {
      coarse <- drawn_flat(si, 80, from)
      fine <- drawn_flat(si, 1000, to)
      carried <- build_mesh(si, 1000, to, coarse[c("mesh", "position")])$start
      free <- !engine_array(fine, "held")
      expect_gt(engine_array(fine, "nodes"), 4 * engine_array(coarse, "nodes"))
      # Rounding of coordinates of about 100 meshes; knots close to an edge are moved onto it.
      expect_lt(max(abs(carried - fine$nodes)[, free]), if (to == "bars") 1e-6 else 1e-11)
    }
  }
})

test_that("mesh transfer to the same mesh keeps the shape", {
  si <- gear_si(as_gear(tapered_panel()))
  mesh <- build_mesh(si, 200, "bars")
  shape <- matrix(seq_len(3 * engine_array(mesh, "nodes")) / 7, 3L)
  from <- list(mesh = mesh, position = mesh_points(mesh, shape))
  again <- build_mesh(si, 200, "bars", from)
  free <- !engine_array(mesh, "held")
  expect_identical(again$start[, free], shape[, free])
  expect_identical(engine_array(again, "bars"), engine_array(mesh, "bars"))
})

test_that("panel_left() and panel_right() return the sides of a panel", {
  table <- panel_table(gear_si(as_gear(tapered_panel()))$panels)
  # 36 of 60 meshes lost over 30, half on each side
  expect_equal(panel_left(table, c(0, 10, 30)), c(0, 6, 18))
  expect_equal(panel_right(table, c(0, 10, 30)), c(60, 54, 42))
})
