test_that("in_units() converts values, errors and names of measures", {
  state <- settle("crossing_cables")
  found <- measures(state)
  other <- in_units(found, force = "tonnef", length = "ft")
  expect_identical(names(other)[1:3], c("sag_ft", "edge_tension_tonnef", "total_drag_tonnef"))
  expect_identical(attr(other, "unit")[["sag_ft"]], "ft")
  # a foot is 0.3048 m, a tonne weighs 9.80665 kN
  expect_equal(other[["sag_ft"]] * 0.3048, found[["sag_m"]])
  expect_equal(other[["edge_tension_tonnef"]] * 9.80665, found[["edge_tension_kN"]])
  expect_equal(attr(other, "error")[["sag_ft"]] * 0.3048, attr(found, "error")[["sag_m"]])
  expect_identical(in_units(state, length = "ft"), in_units(found, length = "ft"))
})

test_that("in_units() keeps mm and N of meshes and twines", {
  found <- measures(settle("midwater_trawl", nodes = 200))
  other <- in_units(found, force = "tf")
  twine <- "largest_panel_twine_tension_N"
  expect_identical(other[[twine]], found[[twine]])
})

test_that("in_units() converts columns and rows of tables", {
  state <- settle("crossing_cables")
  nodes <- as.data.frame(state, what = "nodes")
  expect_equal(in_units(nodes, length = "fathom")$z_fathom, nodes$z_m / 1.8288)
  rows <- as.data.frame(state, what = "measures")
  expect_identical(in_units(rows, length = "ft"), as.data.frame(in_units(state, length = "ft")))
  tow <- tow("towed_cable", until = 60, every = 30)
  table <- in_units(tow, time = "min", force = "kgf")
  expect_identical(unique(table$time_min), c(0, 0.5, 1))
  drag <- as.data.frame(tow, what = "measures")
  expect_equal(table$value[table$measure == "total_drag_kgf"],
    drag$value[drag$measure == "total_drag_kN"] / 9.80665e-3)
})

test_that("in_units() converts variations that studies read", {
  found <- vary("towed_cable", towing.speed = paste(3:4, "knot"), nodes = 60)
  other <- in_units(found, force = "kgf", speed = "m/s")
  expect_equal(other$towing.speed_m_per_s, found$towing.speed_knot * 1852 / 3600)
  expect_equal(other$total_drag_kgf, found$total_drag_kN / 9.80665e-3)
  drag <- summary(other)$measures
  expect_identical(drag$unit[drag$measure == "total_drag_kgf"], "kgf")
})

test_that("units of prints follow the option codend.units", {
  kept <- options(codend.units = c(force = "tonnef", length = "fathom"))
  on.exit(options(kept))
  found <- measures(settle("crossing_cables"))
  expect_snapshot(print(found))
})
