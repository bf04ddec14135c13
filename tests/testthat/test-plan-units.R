# Factors from NIST SP 811 and the definitions of the knot, nautical mile and fathom.
test_that("quantity_si() converts quantities in words to SI", {
  cases <- list(
    list("4.5 knot", "speed", 2.315), list("9 km/h", "speed", 2.5), list("32mm", "length", 0.032),
    list("1 nautical mile", "length", 1852), list("10 fathom", "length", 18.288),
    list("2 ft", "length", 0.6096), list("3.3 tonne", "mass", 3300),
      list("2 lb", "mass", 0.90718474),
    list("10 kgf", "force", 98.0665), list("1 lbf", "force", 4.4482216152605),
    list("12 kg/100 m", "mass_per_length", 0.12), list("5 kg / 100m", "mass_per_length", 0.05),
    list("1.025 g/cm^3", "density", 1025), list("2 m\u00b2", "area", 2),
      list("5 mm2", "area", 5e-6),
    list("1.19e-6 m2/s", "viscosity", 1.19e-6), list("0.44 GPa", "stress", 4.4e8),
    list("180 deg", "angle", pi), list("90\u00b0", "angle", pi / 2), list("1.5 h", "time", 5400),
    list("2 litres", "volume", 0.002), list("3 MW", "power", 3e6), list("2 PS", "power", 1470.9975),
    list("45 %", "number", 0.45), list(".5", "number", 0.5), list("  -5   m ", "length", -5),
    list("1e3 m", "length", 1000), list(7, "length", 7), list("7", "length", 7)
  )
  for (case in cases) {
    expect_equal(quantity_si(case[[1]], case[[2]]), case[[3]], tolerance = 1e-14, label = case[[1]])
  }
})

test_that("quantity_si() returns NA for invalid quantities", {
  for (text in c("5 kg", "1_000 m", "1,5 m", "m", "5 m m", "5 knott", "", "0x1F m", "--5 m",
    "5 M")) {
    expect_identical(quantity_si(text, "length"), NA_real_, label = text)
  }
  expect_identical(quantity_si("5 KN", "force"), NA_real_)
  expect_identical(quantity_si("5 kn", "speed"), 5 * 1852 / 3600)
})

test_that("schema patterns match the table of units", {
  schema <- jsonlite::fromJSON(
    system.file("schema", "plan.schema.json", package = "codend"), simplifyVector = FALSE
  )
  dimensions <- Filter(function(node) !is.null(node[["x-dimension"]]), schema$`$defs`)
  expect_setequal(names(dimensions), names(plan_units))
  for (name in names(dimensions)) {
    pattern <- dimensions[[name]]$pattern
    units <- unique(unlist(lapply(plan_units, names), use.names = FALSE))
    allowed <- units[vapply(paste("2.5", units), grepl, NA, pattern = pattern, perl = TRUE)]
    expect_setequal(allowed, names(plan_units[[name]]))
  }
})
