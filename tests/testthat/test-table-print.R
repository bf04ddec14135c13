test_that("a state prints in at most ten lines", {
  for (name in shipped_states) {
    state <- shipped_state(name)
    lines <- capture.output(shown <- withVisible(print(state)))
    expect_lte(length(lines), 10)
    expect_false(shown$visible)
    expect_match(lines[1], state$si$name, fixed = TRUE)
    expect_true(any(grepl("total drag", lines)))
  }
})

test_that("numbers show four figures and no powers of ten", {
  expect_equal(
    figures(c(0, 835.6825, 12.0467, 0.00012345, 1e-9, 23718655, -4.6736, NA)),
    c("0", "835.7", "12.05", "0.0001", "0", "23720000", "-4.674", "")
  )
})

test_that("a column of numbers lines up at its points", {
  column <- format(column_figures(c(10.392, 0.711, 0, -123.4)), justify = "right")
  expect_equal(column, c("  10.4", "   0.7", "   0  ", "-123.4"))
  expect_equal(align_points(c("2846", "87.57", "3.130")), c("2846    ", "87.57 ", "3.130"))
})

test_that("columns stand side by side", {
  expect_equal(
    align_columns(list(c("a", "warp"), c("1.5", "10.0"), c("kN", "")), left = c(1, 3)),
    c("  a      1.5  kN", "  warp  10.0")
  )
})

test_that("conditions are told in words", {
  still <- list(
    water = list(density = 1025, current = data.frame(depth = 0, x = 0, y = 0)),
    towing = list(speed = 4.5 * 1852 / 3600)
  )
  expect_equal(conditions_text(still), "Towed at 2.315 m/s (4.5 knot) in water of 1025 kg/m3")
  held <- list(
    water = list(
      density = 1000, current = data.frame(depth = c(0, 9), x = c(0.3, 0), y = c(0.4, 0))
    ),
    towing = list(speed = 0)
  )
  expect_equal(conditions_text(held), "Held in water of 1000 kg/m3, current up to 0.5 m/s")
  held$water$density <- 0
  held$water$current <- data.frame(depth = 0, x = 0, y = 0)
  expect_equal(conditions_text(held), "Held in no water")
})
