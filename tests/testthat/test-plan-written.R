trawl_text <- function() {
  paste(c(readLines(shipped_plans()[["poly_noreastern_trawl"]]), ""), collapse = "\n")
}

expect_written <- function(old, new, path, message) {
  expect_plan_error(old, new, path, message, plan = trawl_text())
}

test_that("errors in a part name the short-form field of the part", {
  expect_written("{diameter: 4 mm, material: PE}", "{diameter: 4 mm, material: nylon}",
    "wings.upper.twine.material", "Did you mean `PA`?")
  expect_written("deep: 115}, twine: {diameter: 5 mm, material: PE}}",
    "deep: 115}, twine: {diameter: 5 mm, material: tergal}}",
    "sections.body.belly.twine.material", "Did you mean `PES`?")
  expect_written("material: steel_chain", "material: chain", "footrope.material",
    "Did you mean `steel_chain`?")
  expect_written(
    "lower: {length: 54.9 m, diameter: {value: 16 mm, uncertainty: 10 %}, material: steel_wire}",
    "lower: {length: 54.9 m, diameter: 16 mm, material: steel_rod}", "bridles.lower.material",
    "steel_wire")
  expect_written("{value: 1.4 mm, uncertainty: 15 %}", "14 cm",
    "sections.codend.twine.diameter", "less than half the mesh size")
})

test_that("check names a mesh size without unit or with a wrong power", {
  expect_written("{value: 89 mm, uncertainty: 10 %}", "89", "sections.intermediate.mesh_size",
    "is 89 without a unit, which means 89 m. Is it 89 mm?")
  expect_written("127 mm\n    meshes: {tip: 0, base: 80", "120\n    meshes: {tip: 0, base: 80",
    "wings.upper.mesh_size", "is 120 without a unit")
  expect_written("{value: 89 mm, uncertainty: 10 %}", "1200 mm", "sections.intermediate.mesh_size",
    "`sections.body.mesh_size`, 127 mm, and `sections.intermediate.mesh_size`, 1200 mm")
  # a seam is not a field of a short form, so its part is named
  spoilt <- spoil("{value: 89 mm, uncertainty: 10 %}", "1200 mm", trawl_text())
  expect_match(text_error(spoilt)$message, "Plan field `seams.back_body_intermediate.edges` joins",
    fixed = TRUE)
})

test_that("invalid argument strings throw an error with the nearest choice", {
  state <- settled("towed_cable")
  expect_wrong(as.data.frame(state, what = "tension_"), "Did you mean \"tensions\"")
  expect_identical(as.data.frame(state, what = "react"), as.data.frame(state, what = "reactions"))
  expect_wrong(chosen_some(c("a_kN", "b_kM"), c("a_kN", "b_kN")), "Did you mean \"b_kN\"")
  expect_identical(chosen_some(NULL, c("a", "b")), c("a", "b"))
})
