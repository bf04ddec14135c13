# A study of a function of its fields instead of a gear.
study_of <- function(designs, f, failed = integer()) {
  table <- as.data.frame(unclass(designs), optional = TRUE)
  value <- apply(as.matrix(table), 1, f)
  value[failed] <- NA
  n <- nrow(table)
  settled <- !seq_len(n) %in% failed
  structure(
    data.frame(table, drag_kN = value, constant_m = 3, settled = settled,
      problem = ifelse(settled, NA, "did not settle"), warning = NA_character_,
      check.names = FALSE),
    class = c("codend_variations", "data.frame"), gear_name = "A function",
    fields = names(table), main = "drag_kN",
    errors = data.frame(table, drag_kN = 0.1, constant_m = 0, check.names = FALSE),
    unit = c(drag_kN = "kN", constant_m = "m"), study = list(
      how = attr(designs, "how"), number = attr(designs, "number"), design = seq_len(n),
      designs = n, factors = attr(designs, "factors")
    )
  )
}

# Ishigami and Homma (1990): sin x1 + a sin^2 x2 + b x3^4 sin x1 for x in -pi to pi, with analytical
# indices.
ishigami <- function(x) sin(x[1]) + 7 * sin(x[2])^2 + 0.1 * x[3]^4 * sin(x[1])
three <- function(how, number) {
  side <- value_range(-pi, pi)
  designs(x.1 = side, x.2 = side, x.3 = side, how = how, number = number)
}

test_that("effects() returns the Sobol' indices of a known function", {
  skip_if_not_installed("spacefillr")
  found <- effects(study_of(three("indices", 1024), ishigami), resamples = 200, what = "indices")
  v1 <- 0.5 * (1 + 0.1 * pi^4 / 5)^2
  v2 <- 7^2 / 8
  v13 <- 0.1^2 * pi^8 * (1 / 18 - 1 / 50)
  variance <- v1 + v2 + v13
  expect_identical(found$measure, rep("drag_kN", 6))
  expect_identical(found$field, rep(c("x.1", "x.2", "x.3"), 2))
  expect_identical(found$index, rep(c("first", "total"), each = 3))
  # the half width of their 90 % intervals is 0.05 or less with 1024 random samples
  expect_true(all(abs(found$value - c(v1, v2, 0, v1 + v13, v2, v13) / variance) < 0.05))
  expect_true(all(found$lower < found$value & found$value < found$upper))
  expect_true(all((found$upper - found$lower)[4:6] < 0.15))
})

test_that("effects() returns indices of a sum within half a percent", {
  skip_if_not_installed("spacefillr")
  side <- value_range(0, 1)
  many <- designs(x.1 = side, x.2 = side, how = "indices", number = 8192)
  found <- effects(study_of(many, function(x) x[1] + 2 * x[2]), resamples = 10, what = "indices")
  # variances of 1 and 4 twelfths; the points leave an error of some thousandths
  expect_lt(max(abs(found$value / c(0.2, 0.8, 0.2, 0.8) - 1)), 0.005)
})

test_that("index intervals contain the true index at their stated rate", {
  # a sum of two fields: variances 1 and 4 of 5; 40 samples of 64
  held <- vapply(1:40, function(seed) {
    points <- with_seed(seed, matrix(runif(64 * 4), 64))
    blocks <- pick_freeze(points)
    table <- structure(data.frame(x.1 = blocks[, 1], x.2 = blocks[, 2]), how = "indices",
      number = 64, factors = c("x.1", "x.2"))
    found <- effects(study_of(table, function(x) x[1] + 2 * x[2]), what = "indices",
      resamples = 200)
    total <- found[4, ]
    abs(total$lower + total$upper - 1.6) <= total$upper - total$lower
  }, NA)
  # 90 % of 40 is 36, with a standard deviation of 1.9: four standard deviations below
  expect_gte(sum(held), 28)
})

test_that("effects() omits groups with unsettled designs and warns", {
  skip_if_not_installed("spacefillr")
  whole <- three("indices", 256)
  expect_warning(found <- effects(study_of(whole, ishigami, failed = c(3, 300, 1030)),
    resamples = 20, what = "indices"), "3 of 1280 designs", class = "codend_warning_study")
  # 3 and 1030 = 4 * 256 + 6, 300 = 256 + 44: three groups
  expect_identical(unique(found$designs), 253L)
})

test_that("effects() of a grid equal an analysis of variance", {
  grid <- designs(x.1 = c(1, 2, 4), x.2 = c(0, 3), how = "grid")
  f <- function(x) x[1] + x[2] + 0.5 * x[1] * x[2]
  x <- study_of(grid, f)
  found <- effects(x)
  table <- data.frame(y = x$drag_kN, a = factor(grid$x.1), b = factor(grid$x.2))
  means <- stats::model.tables(stats::aov(y ~ a * b, table), "means")$tables
  expect_equal(found$value, unname(c(means$a, means$b)), ignore_attr = TRUE)
  expect_equal(found$level, c(1, 2, 4, 0, 3))
  squares <- summary(stats::aov(y ~ a * b, table))[[1]][["Sum Sq"]]
  expect_equal(effects(x, what = "pairs")$spread, sqrt(squares[3] / 6))
})

test_that("effects() groups a field of many values equally", {
  skip_if_not_installed("spacefillr")
  found <- effects(study_of(three("sobol", 64), ishigami), groups = 4)
  expect_identical(found$designs, rep(16L, 12))
  expect_true(all(diff(found$level[1:4]) > 0))
})

test_that("summary() of a study counts designs and effects() checks arguments", {
  x <- study_of(designs(x.1 = c(1, 2, 4), x.2 = c(0, 3)), sum, failed = 2)
  expect_output(print(summary(x)), "6 designs of \"A function\": 6 done, 5 settled")
  expect_output(print(summary(x)), "1 did not settle")
  expect_equal(summary(x)$measures$largest, 7)
  expect_wrong(effects(x, what = "indices"))
  expect_wrong(effects(x, "depth"))
  expect_wrong(effects(x, groups = 1))
  expect_wrong(effects(study_of(designs(x.1 = 1:3), sum), what = "pairs"))
})

test_that("main effects are drawn in one panel per field", {
  x <- study_of(designs(x.1 = c(1, 2, 4), x.2 = c(0, 3)), sum)
  found <- effects(x)
  data <- ggplot2::autoplot(found)$data
  expect_equal(data$at[data$across == "x 1"], c(1, 2, 4))
  expect_equal(data$value[data$across == "x 1"], c(2.5, 3.5, 5.5))
  found$level <- rep(c("PA", "PE", "steel"), length.out = nrow(found))
  expect_identical(levels(ggplot2::autoplot(found)$data$at), c("PA", "PE", "steel"))
  expect_picture(effects(x))
})

test_that("pair effects are drawn as diverging lines", {
  grid <- designs(x.1 = c(1, 2, 4), x.2 = c(0, 3), x.3 = 1:2, how = "grid")
  # x.1 and x.2 interact, x.3 adds to both
  found <- effects(study_of(grid, function(x) x[1] * x[2] + x[3]), what = "pairs")
  expect_identical(c(found$field[1], found$other[1]), c("x.1", "x.2"))
  expect_equal(found$spread[-1], c(0, 0))
  drawn <- pair_points(found, 1)
  expect_equal(as.double(drawn$at), c(1, 2, 4, 1, 2, 4))
  expect_equal(drawn$value, c(1.5, 1.5, 1.5, 4.5, 7.5, 13.5))
  expect_identical(unique(drawn$group), c("x 2 = 0", "x 2 = 3"))
  expect_picture(found)
  expect_length(chosen_pairs(found, NULL, 2), 2)
  expect_wrong(plot(found, "depth"))
  expect_wrong(plot(found, most = 0))
  expect_length(chosen_pairs(found[1:2, ], NULL, 6), 2)
  attr(found, "means") <- NULL
  expect_wrong(plot(found))
})

test_that("Sobol' indices are drawn with their intervals", {
  skip_if_not_installed("spacefillr")
  found <- effects(study_of(three("indices", 64), ishigami), resamples = 20, what = "indices")
  expect_picture(found)
  expect_wrong(plot(found, "depth"))
})

test_that("designs are drawn with response curves by field", {
  skip_if_not_installed("lhs")
  side <- value_range(0, 1)
  sample <- study_of(designs(x.1 = side, x.2 = side, how = "latin", number = 30, seed = 3),
    function(x) 3 * x[1], failed = 4)
  chart <- ggplot2::autoplot(sample, "drag_kN")
  expect_identical(levels(chart$data$across), c("x 1", "x 2"))
  of_first <- chart$data[chart$data$across == "x 1", ]
  expect_identical(sum(!of_first$joined), 29L)
  # a smooth curve through points of a straight line equals the line
  curve <- of_first[of_first$joined, ]
  expect_equal(curve$value, 3 * curve$at)
  crosses <- Filter(function(layer) inherits(layer$geom, "GeomText"), chart$layers)
  expect_identical(crosses[[1]]$data$at[1], sample$x.1[4])
  single <- study_of(designs(x.1 = c(1, 2, 4), x.2 = c(0, 3), how = "one_at_a_time"), sum)
  # as in the plan: 9 and 7
  single$x.1[is.na(single$x.1)] <- 9
  single$x.2[is.na(single$x.2)] <- 7
  single$drag_kN <- single$x.1 + single$x.2
  data <- ggplot2::autoplot(single, "drag_kN")$data
  expect_equal(data$at[data$across == "x 1"], c(1, 2, 4, 9))
  expect_equal(data$value, c(c(1, 2, 4, 9) + 7, c(0, 3, 7) + 9))
  # a sample has no value for each combination
  expect_true(has_response_curves(sample))
  expect_false(has_response_curves(study_of(designs(x.1 = 1:3, x.2 = 1:2), sum)))
  expect_picture(sample, "drag_kN")
})
