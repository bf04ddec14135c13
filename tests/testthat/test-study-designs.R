test_that("designs(how = \"grid\") returns every combination with range ends", {
  found <- designs(towing.speed = value_range("3 knot", "5 knot"), floats.number = c(10, 20),
    how = "grid", number = 3)
  expect_s3_class(found, "codend_designs")
  expect_identical(found$towing.speed, rep(c("3 knot", "4 knot", "5 knot"), 2))
  expect_equal(found$floats.number, rep(c(10, 20), each = 3))
  expect_equal(designs(a.number = value_range(1, 3, whole = TRUE), how = "grid")$a.number, 1:3)
  together <- data.frame(port.length = c("1 m", "2 m"), starboard.length = c("3 m", "4 m"))
  expect_equal(nrow(designs(together, towing.speed = 1:3, how = "grid")), 6L)
})

test_that("designs(how = \"one_at_a_time\") starts with the unchanged plan", {
  found <- designs(towing.speed = c("3 knot", "5 knot"), warps.length = value_range(400, 600),
    how = "one_at_a_time", number = 3)
  expect_identical(found$towing.speed, c(NA, "3 knot", "5 knot", NA, NA, NA))
  expect_equal(found$warps.length, c(NA, NA, NA, 400, 500, 600))
})

test_that("designs(how = \"latin\") covers every stratum of every field once", {
  skip_if_not_installed("lhs")
  found <- designs(a.length = value_range(0, 1), b.length = value_range(10, 1000, log = TRUE),
    c.mass = normal_value(5, 2), how = "latin", number = 50, seed = 4)
  strata <- function(share) sort(floor(share * 50))
  expect_equal(strata(found$a.length), 0:49)
  expect_equal(strata(log(found$b.length / 10) / log(100)), 0:49)
  expect_equal(strata(pnorm(found$c.mass, 5, 2)), 0:49)
})

test_that("designs(how = \"sobol\") returns a net of two fields", {
  skip_if_not_installed("spacefillr")
  # The first two coordinates of Sobol's sequence are a (0, m, 2)-net in base 2 (Sobol' 1967), and
  # scrambling preserves this property (Owen 1995). So each box of 2^-a by 2^-(m - a) contains one
  # point among 2^m.
  found <- designs(a.length = value_range(0, 1), b.length = value_range(0, 1), how = "sobol",
    number = 64,
    seed = 9)
  for (a in 0:6) {
    box <- table(floor(found$a.length * 2^a), floor(found$b.length * 2^(6 - a)))
    expect_true(all(box == 1), label = a)
  }
  other <- designs(a.length = value_range(0, 1), b.length = value_range(0, 1), number = 64,
    seed = 10)
  expect_false(identical(found$a.length, other$a.length))
})

test_that("designs(how = \"random\") has the requested distributions", {
  found <- designs(a.length = normal_value("2 m", "10 cm", low = "1.9 m"), b.number = 1:4,
    c.number = value_range(2, 5, whole = TRUE), how = "random", number = 20000)
  value <- as.double(sub(" m", "", found$a.length))
  expect_true(all(value >= 1.9))
  # Normal distribution cut at one standard deviation below its mean: mean + sd dnorm(1) / pnorm(1);
  # 4 standard errors of 20,000 draws.
  expect_equal(mean(value), 2 + 0.1 * dnorm(1) / pnorm(1), tolerance = 4 * 0.1 / sqrt(20000) / 2)
  # a quarter each; 4 standard errors of a fraction
  share <- 4 * sqrt(0.25 * 0.75 / 20000)
  expect_true(all(abs(table(found$b.number) / 20000 - 0.25) < share))
  expect_true(all(abs(table(found$c.number) / 20000 - 0.25) < share))
})

test_that("designs(how = \"indices\") combines two samples field by field", {
  skip_if_not_installed("spacefillr")
  found <- designs(a.length = value_range(0, 1), b.length = value_range(0, 1), how = "indices",
    number = 8)
  block <- function(k) as.matrix(found[8 * k + 1:8, ])
  expect_equal(nrow(found), 32L)
  expect_equal(block(2)[, 1], block(1)[, 1], ignore_attr = TRUE)
  expect_equal(block(2)[, 2], block(0)[, 2], ignore_attr = TRUE)
  expect_equal(block(3)[, 1], block(0)[, 1], ignore_attr = TRUE)
  expect_equal(block(3)[, 2], block(1)[, 2], ignore_attr = TRUE)
})

test_that("designs() is reproducible by seed and keeps the session's random state", {
  draw <- function(seed) {
    designs(a.length = value_range("1 m", "2 m"), how = "random", number = 20, seed = seed)
  }
  kept <- RNGkind("Wichmann-Hill")
  on.exit(do.call(RNGkind, as.list(kept)))
  set.seed(3)
  before <- .Random.seed
  first <- draw(1)
  expect_identical(.Random.seed, before)
  expect_identical(RNGkind()[1], "Wichmann-Hill")
  RNGkind("Mersenne-Twister")
  expect_identical(draw(1), first)
  expect_false(identical(draw(2)$a.length, first$a.length))
  rm(.Random.seed, envir = globalenv())
  draw(1)
  expect_false(exists(".Random.seed", globalenv(), inherits = FALSE))
})

test_that("designs() accepts a table or a CSV file unchanged", {
  file <- file.path(test_folder(), "designs.csv")
  table <- data.frame(towing.speed = c("3 knot", NA), ropes.cable.length = c(300, 500))
  utils::write.csv(table, file, row.names = FALSE, na = "")
  for (found in list(designs(file), designs(table))) {
    expect_identical(attr(found, "how"), "table")
    expect_equal(as.data.frame(unclass(found)), table)
  }
  expect_error(designs("no-such.csv"), "does not exist", class = "codend_error_file")
})

test_that("ranges and distributions print in the plan's units", {
  expect_output(print(value_range("3 knot", "5 knot")), "between 3 knot and 5 knot")
  expect_identical(value_range("1 m", "250 cm")$ends, c(1, 2.5))
  expect_output(print(normal_value("2 t", "100 kg", high = "2200 kg")),
    "mean 2 t, standard deviation 0.1 t, at most 2.2 t")
  expect_output(print(designs(towing.speed = c("3 knot", "4 knot"), how = "one_at_a_time")),
    "as in the plan")
  kept <- options(OutDec = ",", scipen = -9)
  on.exit(options(kept))
  expect_identical(designs(a.b = value_range("1 m", "2 m"), how = "grid", number = 3)$a.b,
    c("1 m", "1.5 m", "2 m"))
})
