test_that("measure_changes() matches measures by name", {
  kinds <- user_measure_kinds()
  none <- rep(NA_real_, 3)
  table <- measure_changes(
    new_measures(c(a_m = 3, b_kN = 2000, c_m = 0), kinds[c("length", "tension", "length")],
      none, FALSE),
    new_measures(c(a_m = 2, c_m = 0, d_m = 5), kinds[rep("length", 3)], none, FALSE)
  )
  expect_identical(table$unit, c("m", "kN", "m", "m"))
  expect_identical(table$definition[c(1, 4)], rep("Straight distance between two locations.", 2))
  expect_identical(table$measure, c("a", "b", "c", "d"))
  expect_identical(table$change, c(1, NA, 0, NA))
  expect_identical(table$change_percent, c(50, NA, NA, NA))
})

test_that("signed() shows a sign and the decimals of the values", {
  expect_identical(signed(c(1.26, -0.04, 0.04, NA, -12345.6), c(1, 1, 2, 1, 0)),
    c("+1.3", "0", "+0.04", "", "\u221212\u202f346"))
})

test_that("fixed_decimals() shows zero without a sign", {
  expect_identical(fixed_decimals(c(-2e-8, 4e-5, 0, -6e-5, NA, Inf), 4L),
    c("0", "0", "0", "-0.0001", "", "Inf"))
})

test_that("tables have a string for each column of each row", {
  state <- settled("midwater_trawl", nodes = 500)
  say <- make_translator()
  other <- update(read_gear("midwater_trawl"), towing.speed = "5 knot")
  tables <- c(tension_tables(state, say), drag_tables(state, say),
    difference_tables(read_gear("midwater_trawl"), other, say))
  expect_length(tables, 5L)
  for (table in tables) {
    expect_gt(length(table$rows), 0L)
    expect_identical(unique(lengths(c(table$rows, list(table$numbers)))), length(table$head))
    expect_type(unlist(table$rows), "character")
  }
  expect_identical(unclass(tables[[5L]]$rows[[1L]]), c("towing.speed", "4 knot", "5 knot"))
  expect_identical(difference_tables(other, other, say)[[1L]]$note, say("no_difference"))
})

test_that("ranked_tensions() orders ropes by tension with their strength margin", {
  state <- settled("midwater_trawl", nodes = 500)
  ranked <- ranked_tensions(state)
  expect_false(is.unsorted(-ranked$highest_kN))
  warp <- ranked[ranked$part == "warp, 2 ropes", ]
  # 630 MPa on the square of 32 mm, from the table of materials
  expect_equal(warp$strength_kN, 630e3 * 0.032^2)
  expect_equal(warp$margin, warp$strength_kN / warp$highest_kN)
  # The vessel's blocks carry only the warps. Water drags one end less of their last half element,
  # in the surface.
  pull <- as.data.frame(state, what = "reactions")[c("x_kN", "y_kN", "z_kN")]
  expect_equal(warp$highest_kN, max(sqrt(rowSums(pull^2))), tolerance = 2e-4)
})

test_that("plan_changes() finds differences of plans by path", {
  one <- list(a = list(b = 1, c = "x"), d = c(1, 2))
  other <- list(a = list(b = 2, c = "x"), d = c(1, 3), e = TRUE)
  found <- plan_changes(one, other)
  expect_identical(vapply(found, `[[`, "", "path"), c("a.b", "d", "e"))
  expect_length(plan_changes(one, one), 0L)
})

test_that("key_names() returns six measures with the main ones first", {
  names <- c("a_m", "total_drag_kN", "b_m", "door_spread_m", "c_m", "d_m", "e_m")
  first <- c("door_spread_m", "total_drag_kN", "a_m", "b_m", "c_m", "d_m")
  expect_identical(key_names(names), first)
})

test_that("displayed_numbers() gives numbers in the order of displayed_measures()", {
  now <- measures(settled("towed_cable", nodes = 300))
  kept <- measures(settled("towed_cable", nodes = 300))
  listed <- displayed_measures(now, kept)
  told <- displayed_numbers(listed, now, kept)
  expect_identical(as.double(told$now), unname(plain_measures(now)))
  expect_identical(as.double(told$error), unname(attr(now, "error")))
  expect_identical(told[c("intervals", "level")], list(intervals = NULL, level = NULL))
  keys <- vapply(listed, `[[`, NA, "key")
  expect_identical(names(now)[keys], intersect(names(now), key_names(names(now))))
})
