new_text <- function(...) strsplit(format(new_plan(...), remarks = TRUE), "\n", fixed = TRUE)[[1]]

test_that("every kind has a plan to begin with, with remarks", {
  for (kind in names(new_plan_kinds())) {
    gear <- new_plan(kind)
    expect_identical(gear$plan$kind, kind)
    expect_true(any(grepl("#", new_text(kind), fixed = TRUE)), label = kind)
    expect_lte(length(new_text(kind)), 60)
  }
  expect_setequal(names(new_plan_kinds()), names(gear_expanders))
})

test_that("a new trawl settles as a trawl does, whatever its size", {
  settled_trawl <- function(...) as.list(measures(settle(new_plan(...), nodes = 200)))
  for (head_line in c(15, 40)) {
    h <- paste(head_line, "m")
    # wide bounds of practice: a bottom trawl spreads a third to two thirds of its head line
    found <- settled_trawl("bottom_trawl", head_line = h, mesh_size = "80 mm")
    expect_gt(found$wing_end_spread_m / head_line, 0.25)
    expect_lt(found$wing_end_spread_m / head_line, 0.7)
    expect_gt(found$headline_height_m / head_line, 0.03)
    expect_gt(found$bridle_upper_tension_kN, 0.1 * found$bridle_lower_tension_kN)
    expect_gt(found$ground_load_kN, 0)
    # a midwater trawl that is wider than high, and hangs on its warps above 200 m
    found <- settled_trawl("midwater_trawl", head_line = h, mesh_size = "1.6 m")
    expect_gt(found$net_mouth_height_m / head_line, 0.2)
    expect_gt(found$wing_end_spread_m, found$net_mouth_height_m)
    expect_lt(found$footrope_depth_m, 200)
  }
})

test_that("what a new plan is asked for is checked by name", {
  text <- new_text("bottom_trawl", head_line = "31 m", depth = 77)
  expect_true(any(grepl("depth: 77,", text, fixed = TRUE)))
  expect_true(any(startsWith(text, "head_line: {length: 31 m")))
  expect_error(new_plan("bottom_trawl", headline = "3 m"), "Did you mean `head_line`",
    class = "codend_error_argument")
  expect_error(new_plan("bottom_trawl", depth = "3 kg"), "must be a length",
    class = "codend_error_argument")
  expect_error(new_plan("botom_trawl"), "Did you mean \"bottom_trawl\"",
    class = "codend_error_argument")
  expect_error(new_plan("bottom_trawl", mesh_size = "20 m"), "eighth",
    class = "codend_error_argument")
  expect_error(new_plan("gillnet", wall.mesh_sise = "1 m"), class = "codend_error_plan")
  expect_identical(new_plan("cage", diameter = "30 m")$plan$diameter, "30 m")
})

test_that("values are asked for, and an empty answer takes the usual one", {
  answers <- textConnection(c("22 m", "", " 60 mm"))
  on.exit(close(answers))
  asks <- new_plan_kinds()$bottom_trawl$asks
  capture.output(given <- asked_values(asks, list(speed = "2 knot"), answers), type = "message")
  expect_identical(given, list(speed = "2 knot", head_line = "22 m", codend_mesh_size = "60 mm"))
})

test_that("a typed number has the unit of the usual value, and what is none is asked for again", {
  answers <- textConnection(c("32", "80", "wide", "3 knot", "-1", "60 mm", "2.5", "-4 m"))
  on.exit(close(answers))
  asks <- new_plan_kinds()$bottom_trawl$asks
  said <- capture.output(given <- asked_values(asks, list(), answers), type = "message")
  # what was typed last stands where answers end, for its own error
  expect_identical(given, list(head_line = "32 m", mesh_size = "80 mm", codend_mesh_size = "60 mm",
    speed = "2.5 knot", depth = "-4 m"))
  expect_match(said, "\"wide\" is no length; it must be one such as 80 mm", fixed = TRUE,
    all = FALSE)
  expect_length(grep("is no length", said), 4L)
})
