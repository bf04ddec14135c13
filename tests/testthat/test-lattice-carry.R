# Shapes carried from lattice to lattice.

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

# The lattice with a shape that is linear in the panel's mesh coordinates, and the places of all
# nodes in these.
drawn_flat <- function(si, nodes, netting) {
  lattice <- build_lattice(si, nodes, netting)
  table <- panel_table(si$panels)
  at <- panel_places(table, division_of(lattice), panels_of(lattice))
  j <- at$t * table$deep
  left <- panel_left(table, j)
  i <- left + at$s * (panel_right(table, j) - left)
  position <- matrix(NA_real_, 3L, engine_array(lattice, "nodes"))
  position[, at$node] <- rbind(2 * i - j, i + 3 * j, 0.5 * j)
  list(lattice = lattice, position = lattice_points(lattice, position), nodes = position)
}

test_that("shapes linear in mesh coordinates are carried exactly, whatever the netting", {
  si <- gear_si(as_gear(tapered_panel()))
  for (from in c("cells", "bars")) {
    for (to in c("cells", "bars")) {
      coarse <- drawn_flat(si, 80, from)
      fine <- drawn_flat(si, 1000, to)
      carried <- build_lattice(si, 1000, to, coarse[c("lattice", "position")])$start
      free <- !engine_array(fine, "held")
      expect_gt(engine_array(fine, "nodes"), 4 * engine_array(coarse, "nodes"))
      # Rounding of coordinates of some 100 meshes; knots nearly on an edge are moved onto it.
      expect_lt(max(abs(carried - fine$nodes)[, free]), if (to == "bars") 1e-6 else 1e-11)
    }
  }
})

test_that("a shape carried to the same division is the same shape", {
  si <- gear_si(as_gear(tapered_panel()))
  lattice <- build_lattice(si, 200, "bars")
  shape <- matrix(seq_len(3 * engine_array(lattice, "nodes")) / 7, 3L)
  from <- list(lattice = lattice, position = lattice_points(lattice, shape))
  again <- build_lattice(si, 200, "bars", from)
  free <- !engine_array(lattice, "held")
  expect_identical(again$start[, free], shape[, free])
  expect_identical(engine_array(again, "bars"), engine_array(lattice, "bars"))
})

test_that("places of a panel lie between its sides", {
  table <- panel_table(gear_si(as_gear(tapered_panel()))$panels)
  # 36 of 60 meshes lost over 30, half on each side
  expect_equal(panel_left(table, c(0, 10, 30)), c(0, 6, 18))
  expect_equal(panel_right(table, c(0, 10, 30)), c(60, 54, 42))
})
