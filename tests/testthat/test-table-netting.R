test_that("table of netting has the twine and mass of the mesh", {
  state <- settled("t90_codend")
  found <- summary(state$gear)$netting
  drag <- as.data.frame(state, what = "drag")
  drag <- drag[drag$kind == "netting", ]
  expect_equal(found$weight_in_water_kN, drag$weight_in_water_kN[match(found$panel, drag$part)],
    tolerance = 1e-10)
  # reference: a panel of 10 to 6 meshes of 100 mm, 5 deep, of two twines of 2 mm and 4 g/m
  gear <- gear("Panel",
    points = list(nail = list(at = "net.upper_left", position = c(0, 0, 0), held = "fixed")),
    panels = list(net = netting_panel("100 mm", list(upper = 10, lower = 6, deep = 5),
      list(diameter = "2 mm", axial_stiffness = 1e3, mass_per_length = 0.004, double = TRUE)))
  )
  net <- summary(gear)$netting
  cells <- 8 * 5 * 2
  expect_equal(net$knots, cells)
  expect_equal(net$twine_m, cells * 2 * (2 * 0.05 + 16 * 0.002))
  expect_equal(net$in_knots_percent, 100 * 0.032 / 0.132)
  expect_equal(net$twine_area_m2, cells * 2 * 0.1 * 0.002)
  expect_equal(net$mass_kg, net$twine_m * 0.004)
})
