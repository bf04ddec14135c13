test_that("in_unit() and from_unit() convert between SI and common units", {
  expect_equal(in_unit(1852 / 3600, "knot"), 1)
  expect_equal(in_unit(pi, "deg"), 180)
  expect_equal(in_unit(0.25, "%"), 25)
  expect_equal(in_unit(2500, "kN"), 2.5)
  expect_equal(in_unit(2500, "kW"), 2.5)
  # one standard gravity on a tonne
  expect_equal(in_unit(9806.65, "tf"), 1)
  # a metre of net towed at a metre per second covers 3600 m2 an hour
  expect_equal(in_unit(1, "km2/h"), 0.0036)
  expect_equal(in_unit(1, "m3/h"), 3600)
  expect_equal(from_unit(c(2.5, 90), "kN"), c(2500, 90000))
  expect_equal(from_unit(180, "deg"), pi)
})

test_that("with_unit() appends units and label_of() removes them", {
  name <- c("speed", "slack", "area", "weight", "factor")
  unit <- c("m/s", "%", "km2/h", "kg/100 m", "")
  whole <- c("speed_m_per_s", "slack_percent", "area_km2_per_h", "weight_kg_per_100_m", "factor")
  expect_identical(with_unit(name, unit), whole)
  expect_identical(label_of(whole, unit), name)
  expect_identical(without_unit(c(whole, "door_spread_m")), c(name, "door_spread"))
})

test_that("cf_unit() returns units of the CF conventions", {
  expect_identical(
    cf_unit(c("m/s", "%", "deg", "km2/h", "meshes", "kN")),
    c("m s-1", "percent", "degree", "km2 h-1", "1", "kN")
  )
})
