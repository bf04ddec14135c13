# Numbers with a known uncertainty, and factors on force components.

uncertain_warp <- function(text) read_text(spoil("length: 100 m", paste("length:", text)))

test_that("number with an uncertainty equals the number and stores it", {
  plain <- read_text(small_plan)
  known <- uncertain_warp("{value: 100 m, uncertainty: 10 %}")
  expect_identical(known$plan$ropes$warp$length, "100 m")
  expect_identical(known$plan$uncertain, list(ropes.warp.length = "10 %"))
  expect_identical(gear_si(known), gear_si(plain))
  expect_equal(uncertain_numbers(known$plan)[, "share"], 0.1)
  # in the field's unit, or another of its dimension
  numbers <- function(text) unlist(uncertain_numbers(uncertain_warp(text)$plan), use.names = FALSE)
  expect_equal(numbers("{value: 100 m, uncertainty: 2 m}"), c(0.02, 0, 0))
  expect_equal(numbers("{value: 100 m, uncertainty: 50 cm}"), c(0.005, 0, 0))
  # uniform between two limits: half of the range over the square root of 3
  expect_equal(numbers("{value: 100 m, range: [97 m, 103 m]}"), c(0.03 / sqrt(3), 0, 1))
  expect_equal(numbers("{value: 100 m, range: [100 m, 108 m]}"), c(0.04 / sqrt(3), 0.04, 1))
  middle <- uncertain_warp("{range: [90 m, 110 m]}")
  expect_equal(quantity_si(middle$plan$ropes$warp$length, "length"), 100)
  # items of lists, and whole parts changed at once
  net <- update(known, panels.net.twine = list(
    diameter = list(value = "2 mm", uncertainty = "5 %"), material = "PE"
  ))
  expect_equal(uncertain_numbers(net$plan)[, "share"],
    c(0.1, 0.05))
})

test_that("uncertainty is written next to its number and reads back", {
  text <- spoil("length: 100 m", "length: {value: 100 m, uncertainty: 10 %} # counter")
  gear <- read_text(text)
  expect_identical(format(gear, remarks = TRUE), text)
  for (remarks in c(TRUE, FALSE)) {
    again <- read_text(format(gear, remarks = remarks))
    expect_identical(again$plan, gear$plan)
  }
  longer <- update(gear, ropes.warp.length = "120 m")
  expect_match(format(longer, remarks = TRUE),
    "length: {value: 120 m, uncertainty: 10 %} # counter", fixed = TRUE)
  # by paths, in one section
  apart <- read_text(paste0(small_plan, "uncertain: {ropes.warp.length: 10 %}\n"))
  expect_identical(apart$plan$uncertain, gear$plan$uncertain)
})

test_that("uncertainty of a part is removed with the part", {
  gear <- update(as_gear(towed_sphere_plan()), uncertain = list(
    towing.speed = "1 %", pieces.sphere.mass = "4 %", multipliers.piece_drag = "5 %"
  ))
  bare <- update(gear, pieces = NULL)
  expect_identical(names(bare$plan$uncertain), c("towing.speed", "multipliers.piece_drag"))
})

test_that("changed value keeps its uncertainty and a range that contains it", {
  known <- uncertain_warp("{value: 100 m, range: [97 m, 103 m]}")
  expect_identical(update(known, ropes.warp.length = "102 m")$plan$uncertain, known$plan$uncertain)
  expect_null(update(known, ropes.warp.length = "120 m")$plan$uncertain)
  known <- uncertain_warp("{value: 100 m, uncertainty: 3 m}")
  expect_identical(update(known, ropes.warp.length = "120 m")$plan$uncertain, known$plan$uncertain)
})

test_that("relative uncertainty of a value changed to 0 is 0", {
  gear <- update(read_gear("poly_noreastern_trawl"), bridles.upper.setback = "0 mm")
  expect_identical(uncertain_numbers(gear$plan)["bridles.upper.setback", "share"], 0)
})

test_that("multipliers scale only their own force component", {
  plan <- towed_sphere_plan()
  one <- settle(as_gear(plan))
  plan$multipliers <- list(piece_drag = 2)
  two <- settle(as_gear(plan))
  # a thin line and a sphere: the sphere has all but about 1e-8 of the drag
  expect_equal(measures(two)[["total_drag_kN"]], 2 * measures(one)[["total_drag_kN"]],
    tolerance = 1e-7)
  known <- path_node(list(), "multipliers")$properties
  plan$multipliers <- lapply(known, `[[`, "default")
  expect_identical(settle(as_gear(plan))$position, one$position)
  expect_identical(names(known), names(force_multipliers))
})

test_that("multipliers of a trawl are linear in their forces", {
  state <- settled("poly_noreastern_trawl", nodes = 400)
  still <- numeric(length(state$position))
  net_force <- function(by) {
    si <- state$si
    si$multipliers[names(by)] <- by
    engine_evaluate(build_mesh(si, 400)$model, as.vector(state$position), still)$force
  }
  one <- net_force(numeric())
  of <- names(force_multipliers)
  own <- unlist(state$si$multipliers)
  component <- lapply(setNames(of, of), function(name) net_force(own[name] + 1) - one)
  size <- vapply(component, function(force) max(abs(force)), 0)
  # this gear has no bodies except floats, and no turned netting with opening stiffness
  expect_identical(of[size == 0], c("mesh_opening", "piece_drag"))
  for (name in of) {
    half <- net_force(own[name] - 0.5) - one
    expect_lt(max(abs(half + component[[name]] / 2)), 1e-11 * max(size))
  }
  gear <- update(settled_gear("poly_noreastern_trawl"), multipliers = list(board_lift = 1.1))
  expect_identical(gear_si(gear)$multipliers$board_lift, 1.1)
})
