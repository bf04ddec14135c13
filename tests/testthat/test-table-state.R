test_that("tensions table has a row per bar and per cell family", {
  state <- settled("midwater_trawl", nodes = 500, netting = "cells")
  table <- as.data.frame(state, what = "tensions")
  bars <- length(engine_array(state, "bars", "rest"))
  expect_equal(nrow(table), bars + 2 * length(engine_array(state, "cells", "rest")))
  expect_named(table, c("part", "kind", "role", "element", "family", "x_m", "y_m", "z_m",
    "length_m", "tension_kN", "lines", "slack"))
  expect_identical(table$slack, table$tension_kN == 0)
  expect_equal(unique(table$kind), c("rope", "netting"))
  expect_equal(unique(table$family), c("bar", "u", "v"))
})

test_that("table has the midpoint and length of each line", {
  for (netting in c("cells", "bars")) {
    state <- settled("panel_in_current", nodes = 200, netting = netting)
    table <- as.data.frame(state, what = "tensions")
    bars <- table[table$family == "bar", ]
    ends <- array(state_points(state)[, engine_array(state, "bars", "node")], c(3, 2, nrow(bars)))
    middles <- t(as.matrix(bars[c("x_m", "y_m", "z_m")]))
    expect_equal(middles, (ends[, 1, ] + ends[, 2, ]) / 2, ignore_attr = TRUE)
    expect_equal(bars$length_m, sqrt(colSums((ends[, 1, ] - ends[, 2, ])^2)))
    netting_rows <- table[table$kind == "netting", ]
    # within the sheet's corners and the stretch of its twine
    expect_true(all(netting_rows$z_m > -2.5 & netting_rows$z_m < 0.5))
  }
})

test_that("lines times unstretched length equals the plan's twine", {
  for (netting in c("cells", "bars")) {
    state <- settled("panel_in_current", nodes = 200, netting = netting)
    lines <- state_lines(state)
    net <- lines[parts_of(state)$kind[lines$part] == "netting", ]
    # 20 x 20 meshes of four bars of 50 mm; the mesh is built to 1e-6
    expect_equal(sum(net$lines * net$rest), 20 * 20 * 4 * 0.05, tolerance = 1e-6)
  }
})

test_that("tied points are between their nodes", {
  state <- structure(list(
    position = cbind(c(0, 0, 0), c(4, 8, 0)),
    mesh = sketched_mesh(model = list(ties = list(first = 1L, second = 2L, share = 0.25)))
  ), class = "codend_state")
  expect_equal(state_points(state)[, 3], c(1, 2, 0))
})

test_that("nodes table lists the connected parts and fixed nodes", {
  state <- settled("crossing_cables")
  table <- as.data.frame(state, what = "nodes")
  expect_named(table, c("node", "x_m", "y_m", "z_m", "parts", "held"))
  expect_equal(sum(table$held), 8)
  at <- nodes_at(state, "crossing_south_west")
  expect_equal(table$parts[at], "south_1, south_2, west_1, west_2")
  expect_equal(table$parts[nodes_at(state, "west_south")], "south_1")
  expect_equal(t(as.matrix(table[c("x_m", "y_m", "z_m")])), state$position, ignore_attr = TRUE)
})

test_that("elements on tied points belong to both supporting nodes", {
  mesh <- sketched_mesh(
    model = list(
      nodes = 3L, ties = list(first = 1L, second = 2L, share = 0.5),
      bars = list(node = c(4L, 3L)), cells = list(node = integer())
    ),
    bar_part = 1L, parts = data.frame(name = "net")
  )
  expect_equal(node_parts(mesh), c("net", "net", "net"))
})

test_that("measures, drag and reactions are available as tables", {
  state <- settled("towed_cable")
  table <- as.data.frame(state, what = "measures")
  expect_equal(setNames(table$value, table$measure), plain_measures(measures(state)))
  expect_equal(table$unit[table$measure == "tow_power_kW"], "kW")
  expect_equal(as.data.frame(state, what = "drag"), summary(state)$drag)
  expect_equal(as.data.frame(state, what = "reactions")$point, "ship")
  # an unnamed `what` would be mistaken for row names
  expect_error(as.data.frame(state, "drag"))
})

test_that("number columns end in their unit", {
  state <- shipped_state("midwater_trawl")
  plain <- c("element", "lines", "node")
  for (what in c("tensions", "nodes", "drag", "reactions")) {
    table <- as.data.frame(state, what = what)
    numbers <- setdiff(names(table)[vapply(table, is.numeric, NA)], plain)
    expect_true(all(grepl("_(m|kN)$", numbers)), info = what)
  }
})
