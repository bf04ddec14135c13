test_that("figures() returns four digits without powers of ten", {
  expect_equal(
    figures(c(0, 835.6825, 12.0467, 0.00012345, 1e-9, 23718655, -4.6736, NA)),
    c("0", "835.7", "12.05", "0.0001", "0", "23720000", "-4.674", "")
  )
})

test_that("figures() returns the digits that the error allows", {
  expect_identical(
    figures(c(53.8612, 49.4123, 434300, 1.14612, 0.31, 123.45678, 8), c(1.3, 0.3, 67000, 0.0033, 2,
      1e-6, NA)),
    c("53.9", "49.4", "430000", "1.146", "0", "123.457", "8.000")
  )
})

test_that("limited_lines() counts the lines that it leaves out", {
  expect_identical(limited_lines(letters[1:3], 3), letters[1:3])
  expect_identical(limited_lines(letters[1:4], 3),
    c("a", "b", "  ... and 2 more: print(x, n = Inf)"))
  expect_identical(limited_lines(letters, Inf), letters)
})

test_that("column_figures() aligns numbers at their decimal points", {
  column <- format(column_figures(c(10.392, 0.711, 0, -123.4)), justify = "right")
  expect_equal(column, c("  10.4", "   0.7", "   0  ", "-123.4"))
  expect_equal(align_points(c("2846", "87.57", "3.130")), c("2846    ", "87.57 ", "3.130"))
})

test_that("align_columns() places columns next to each other", {
  expect_equal(
    align_columns(list(c("a", "warp"), c("1.5", "10.0"), c("kN", "")), left = c(1, 3)),
    c("  a      1.5  kN", "  warp  10.0")
  )
})
