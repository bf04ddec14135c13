test_that("summary() of a gear lists the masses of its plan", {
  found <- summary(read_gear("midwater_trawl"))
  parts <- found$parts
  row <- function(name) parts[parts$part == name, ]
  # two warps of 600 m at 4.100 kg/m, 30 floats of 5.03 kg
  expect_equal(row("warp")$length_m, 1200)
  expect_equal(row("warp")$mass_kg, 1200 * 4.100096, tolerance = 1e-6)
  expect_identical(row("float")$number, 30)
  expect_lt(row("float")$weight_in_water_kN, 0)
  expect_equal(sum(parts$mass_kg[parts$group == "netting"]), sum(found$netting$mass_kg))
  totals <- found$totals
  expect_equal(totals$mass_kg[totals$group == "total"], sum(parts$mass_kg))
  expect_output(print(found, n = Inf), "otter board +2 +9000")
})
