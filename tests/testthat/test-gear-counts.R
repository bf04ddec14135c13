# A panel by three counts, or by two counts and its cutting rate. The independent rule of net
# makers: a cycle 1N2B goes down 2 meshes and across 1, ISO 1532.
cut_panel <- function(meshes, ..., kind = small_plan) {
  fields <- paste0("\n    ", c(...), collapse = "")
  read_text(spoil("meshes: {upper: 10, lower: 5, deep: 10}", paste0("meshes: ", meshes, fields)))
}

counts <- function(gear) unlist(gear_si(gear)$panels$net[c("upper", "lower", "deep")])

test_that("cutting rate determines the omitted count", {
  expect_equal(counts(cut_panel("{upper: 40, deep: 20}", "cutting: 1N2B")),
    c(upper = 40, lower = 20, deep = 20))
  # one edge; the other is straight
  one <- cut_panel("{upper: 40, deep: 20}", "cutting: 1N2B", "tapered: left")
  expect_equal(counts(one)[["lower"]], 30)
  # all bars lose a mesh in a mesh, 1T2B two in one, 1N4B 2/3
  expect_equal(counts(cut_panel("{upper: 100, deep: 20}", "cutting: AB"))[[2]], 60)
  expect_equal(counts(cut_panel("{upper: 100, deep: 20}", "cutting: 1T2B"))[[2]], 20)
  expect_equal(counts(cut_panel("{upper: 100, deep: 30}", "cutting: 1N4B"))[[2]], 60)
  # alternating cycles: 9(1N2B)+1(1N3B) goes down 9 * 2 + 2.5 and across 9 + 1.5
  expect_equal(counts(cut_panel("{upper: 61, deep: 41}", "cutting: 9(1N2B)+1(1N3B)"))[[2]],
    61 - 2 * 41 * 10.5 / 20.5)
  # the depth, and the narrower edge if the upper one is omitted
  expect_equal(counts(cut_panel("{upper: 40, lower: 20}", "cutting: 1N2B"))[[3]], 20)
  expect_equal(counts(cut_panel("{lower: 40, deep: 20}", "cutting: 1N2B"))[[1]], 20)
  # in turned netting N and T are exchanged
  expect_equal(
    counts(cut_panel("{upper: 40, deep: 20}", "cutting: 1T2B", "orientation: turned"))[[2]], 20
  )
})

test_that("different cutting rates split the mesh loss between edges", {
  gear <- cut_panel("{upper: 60, deep: 20}", "cutting: {left: AB, right: 1N2B}")
  expect_equal(counts(gear)[["lower"]], 60 - 20 - 10)
  expect_equal(unlist(gear_si(gear)$panels$net[c("lost_left", "lost_right")]),
    c(lost_left = 20, lost_right = 10))
  expect_identical(panel_rates(gear_si(gear)$panels$net), c(left = "AB", right = "1N2B"))
})

test_that("check rejects counts that contradict the rate and suggests a rate", {
  error <- function(...) {
    tryCatch(cut_panel(...), codend_error_plan = function(e) {
      list(path = e$path, message = gsub("[[:space:]]+", " ", conditionMessage(e)))
    })
  }
  found <- error("{upper: 40, lower: 26, deep: 20}", "cutting: 1N2B")
  expect_identical(found$path, "panels.net.cutting")
  expect_match(found$message, "removes 14 meshes over 20 rows", fixed = TRUE)
  # net makers round by up to a mesh at each edge
  expect_s3_class(cut_panel("{upper: 40, lower: 22, deep: 20}", "cutting: 1N2B"), "codend_gear")
  expect_match(error("{upper: 40, deep: 20}")$message, "from the other two counts", fixed = TRUE)
  expect_match(error("{upper: 40}", "cutting: AB")$message, "two of the three counts",
    fixed = TRUE)
  expect_match(error("{upper: 10, deep: 20}", "cutting: AB")$message, "meshes remain", fixed = TRUE)
  expect_match(error("{upper: 10, deep: 20}", "cutting: AT")$message, "advances in depth",
    fixed = TRUE)
  expect_match(error("{upper: 10, deep: 20}", "cutting: 2X")$message, "such as AN", fixed = TRUE)
  expect_match(error("{upper: 10, deep: 20}", "cutting: 1N2B", "orientation: square")$message,
    "omitted in square netting", fixed = TRUE)
})

test_that("short forms accept cutting rates and take-up ratios", {
  text <- paste(readLines(shipped_plans()[["poly_noreastern_trawl"]]), collapse = "\n")
  text <- sub("meshes: {tip: 0, base: 80, deep: 80}",
    "meshes: {tip: 0, deep: 80}\n    cutting: 1T26B", text, fixed = TRUE)
  text <- sub("meshes: {upper: 250, lower: 185, deep: 115}",
    "meshes: {upper: 250, deep: 115}\n    cutting: 10(1N4B)+1(1N3B)", text, fixed = TRUE)
  text <- sub("meshes: {upper: 264, lower: 30, deep: 121}",
    "meshes: {lower: 30, deep: 121}\n    take_up: \"5:7\"", text, fixed = TRUE)
  gear <- read_text(text)
  panels <- gear_si(gear)$panels
  expect_equal(panels$back_wing_left$lower, 80 + 80 / 13)
  lower <- 250 - 2 * 115 * (10 * 2 + 1.5) / (10 * 3 + 2.5)
  expect_equal(panels$back_body$lower, lower)
  expect_equal(panels$belly_intermediate$upper, lower * 7 / 5)
  # sides with separate counts keep them
  expect_identical(panels$side_port_body$lower, 126)
  expect_output(print(gear), "sections.body.meshes.lower 97.85", fixed = TRUE)
  # the count is computed again after a change elsewhere
  again <- update(gear, towing.speed = "4 knot")
  expect_identical(gear_checked(again)$derived, gear_checked(gear)$derived)
  expect_identical(gear_si(assembly(gear))$panels, panels)
  expect_refused(update(gear, sections.intermediate.meshes.upper = 171), "needs 136.98")
})

test_that("Rtex determines the twine's mass, and its diameter by material", {
  twine <- function(text) {
    gear_si(read_text(spoil("twine: {diameter: 2 mm, material: PE}", text)))$panels$net
  }
  plain <- twine("twine: {diameter: 2 mm, material: PE}")
  # the same twine by its weight: g/km of the mass by its diameter
  by_weight <- twine(sprintf("twine: {rtex: %.12g, material: PE}", plain$mass_per_length * 1e6))
  expect_equal(by_weight[c("twine_diameter", "mass_per_length", "volume_per_length",
    "axial_stiffness")], plain[c("twine_diameter", "mass_per_length", "volume_per_length",
    "axial_stiffness")], tolerance = 1e-10)
  both <- twine("twine: {diameter: 2 mm, rtex: 2500, material: PE}")
  expect_equal(both$mass_per_length, 2.5e-3)
  expect_equal(both$twine_diameter, 2e-3)
  expect_refused(twine("twine: {rtex: 2500}"))
  expect_refused(twine("twine: {rtex: 2500, material: PE, mass_per_length: 2 g/m}"), "both")
})
