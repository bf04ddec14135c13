# The table of a gear's resolution, and how many nodes its lattice has.
resolution_of <- function(si, netting = NULL) {
  bars <- panels_of_bars(si, netting)
  pieces <- division_frame(gear_chains(si), linked = !bars)$pieces
  resolution_table(si, panel_table(si$panels), pieces, bars)
}

test_that("beside netting only the cube root of more segments than are ample goes into ropes", {
  one <- list(length = c(15, 72, 576), own = rep(TRUE, 3), segments = rep(NA_real_, 3))
  # at 1.5 m a segment ropes would have 10, 48 and 8 times 48
  expect_identical(rope_counts(c(one, list(bars = logical())), 1), c(10L, 48L, 384L))
  expect_identical(rope_counts(c(one, list(bars = FALSE)), 1), c(10L, 48L, 96L))

  # what 48 are worth: the end of a towed cable lies where it does with four times as many
  cable <- function(n) settle(update(read_gear("towed_cable"), ropes.cable.segments = n))
  coarse <- cable(48)
  fine <- cable(192)
  length <- coarse$si$ropes$cable$length
  end <- function(state) state$position[, state$lattice$place("cable.end")]
  # of second order, see `ample_segments`
  expect_lt(sqrt(sum((end(coarse) - end(fine))^2)), length / 48^2)
})

test_that("counts of cells are as nearly whole as lattices of a sixth more or fewer nodes allow", {
  for (name in c("pair_trawl", "poly_noreastern_trawl", "model_cage")) {
    si <- gear_si(read_gear(name))
    of <- resolution_of(si)
    for (nodes in c(1000, 1500, 2300)) {
      h <- element_length(of, nodes)
      plain <- counted_length(of, nodes)
      expect_lte(rounding(of, h), rounding(of, plain))
      off <- abs(log(c(count_nodes(of, h), count_nodes(of, plain)) / nodes))
      expect_lte(off[1], max(2 * fitting_range, off[2]))
    }
  }
})

test_that("counts know the inner nodes of hexagons, and what a plan divides itself", {
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
    # edges have a row of nodes more than cells: a tenth at 200 of a grid's
    expect_equal(build_lattice(gear_si(gear), nodes)$nodes, nodes, tolerance = 0.25)
  }
  codend <- gear_si(read_gear("t90_codend"))
  # eight strips of one column and 50 rows
  expect_identical(fixed_nodes(codend, NULL), 400)
  expect_identical(fixed_nodes(undivided(codend), NULL), Inf)
  # its errors are told by a finer lattice, against one of 27 times the nodes
  state <- settle("t90_codend")
  expect_gt(levels_of(state, plain_measures(measures(state)))[[1]]$nodes, 2 * state$lattice$nodes)
  error <- attr(measures(state), "error")
  fine <- c(length_m = 4.21, catch_volume_m3 = 1.27, total_drag_kN = 5.08)
  off <- abs(plain_measures(measures(state))[names(fine)] - fine)
  expect_true(all(off <= 2 * error[names(fine)]))
  expect_lt(max(error[names(fine)] / fine), 0.1)
  # half as many nodes tell 10 %
  expect_lt(error[["total_drag_kN"]] / fine[["total_drag_kN"]], 0.04)
  # a cable of so many segments; ropes that a plan leaves open
  expect_identical(fixed_nodes(gear_si(read_gear("towed_cable")), NULL),
    as.double(gear_si(read_gear("towed_cable"))$ropes[[1]]$segments))
  expect_identical(fixed_nodes(gear_si(read_gear("pair_trawl")), NULL), Inf)
})
