test_that("tables have a value in each row of each column", {
  state <- settled("midwater_trawl", nodes = 500)
  other <- update(read_gear("midwater_trawl"), towing.speed = "5 knot")
  changed <- difference_tables(read_gear("midwater_trawl"), other)
  tables <- c(tension_tables(state), drag_tables(state), changed)
  expect_length(tables, 5L)
  for (table in tables) {
    expect_length(unique(lengths(table$columns)), 1L)
    expect_gt(length(table$columns[[1L]]), 0L)
  }
  expect_identical(unlist(changed[[1L]]$columns), c("towing.speed", "4 knot", "5 knot"))
  expect_length(difference_tables(other, other)[[1L]]$columns[[1L]], 0L)
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

test_that("measures_numbers() gives numbers in the order of measures_about()", {
  now <- measures(settled("towed_cable", nodes = 300))
  about <- measures_about(now)
  told <- measures_numbers(now)
  expect_identical(vapply(about, `[[`, "", "name"), names(now))
  expect_identical(as.double(told$now), unname(plain_measures(now)))
  expect_identical(as.double(told$error), unname(attr(now, "error")))
  keys <- vapply(about, `[[`, NA, "key")
  expect_identical(names(now)[keys], intersect(names(now), key_names(names(now))))
})
