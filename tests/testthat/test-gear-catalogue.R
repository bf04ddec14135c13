test_that("catalogue() entries have sources, numbers and known materials", {
  table <- catalogue()
  expect_setequal(unique(table$class), c("board", "float", "twine", "rope", "wire", "chain"))
  expect_false(anyNA(table[c("class", "item", "source")]))
  expect_match(table$source, "^(https?://|github[.]com/)")
  numbers <- table[vapply(table, is.numeric, NA)]
  expect_true(all(numbers > 0, na.rm = TRUE))
  expect_true(all(rowSums(!is.na(numbers)) > 0))
  known <- c(rownames(gear_materials), names(material_abbreviations))
  expect_identical(setdiff(stats::na.omit(table$material), known), character())
  expect_identical(catalogue("wire"), catalogue()[table$class == "wire", ], ignore_attr = TRUE)
})

test_that("catalogue() masses and strengths agree with the materials of plans", {
  # MoorPy's chain, another make of wire by EN 12385-4, ISO's laid ropes: 35 % between makes
  for (class in c("wire", "chain")) {
    table <- catalogue(class)
    material <- gear_materials[table$material[1], ]
    for (of in list(c("mass_per_length_kg_m", "mass", 1), c("strength_kN", "strength", 1e-3))) {
      there <- table[!is.na(table[[of[1]]]), ]
      told <- material[[of[2]]] * (there$diameter_mm / 1000)^2 * as.double(of[3])
      share <- stats::median(there[[of[1]]] / told)
      expect_lt(abs(log(share)), log(1.35), label = paste(class, of[1]))
    }
  }
})

test_that("catalogue() floats lift at most the water they displace", {
  table <- catalogue("float")
  displaced <- pi / 6 * (table$diameter_mm / 1000)^3 * 1025
  # heights that are slightly less than a sphere's diameter
  expect_true(all(table$buoyancy_kgf < 1.05 * displaced))
})
