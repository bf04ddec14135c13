# optimise and calibrate from the command line.

test_that("an optimum is found and written from the command line", {
  skip_if_not_installed("nloptr")
  skip_if_not_installed("optparse")
  out <- tempfile(fileext = ".yaml")
  said <- capture.output(status <- suppressMessages(run_command(c(
    "optimise", "--minimise", "total_drag_kN", "--keep", "body_depth >= '450 m'",
    "--change", "ropes.cable.length = 600 m .. 1200 m", "--nodes", "50", "--out", out, "towed_cable"
  ))))
  expect_identical(status, 0L)
  expect_true(any(grepl("ropes.cable.length", said)))
  expect_equal(measures(settle(read_gear(out), nodes = 50))[["body_depth_m"]], 450,
    tolerance = 1e-3)
})

test_that("hauls of a CSV file calibrate from the command line", {
  skip_if_not_installed("optparse")
  data <- tempfile(fileext = ".csv")
  writeLines(c("towing.speed,Depth", "3 knot,590", "4 knot,503", "5 knot,430", "6 knot,370"), data)
  out <- tempfile(fileext = ".yaml")
  said <- capture.output(status <- suppressMessages(run_command(c(
    "calibrate", "--data", data, "--match", "Depth ~ body_depth_m", "--nodes", "50",
    "--change", "ropes.cable.coefficients.normal = 0.5 .. 3", "--out", out, "towed_cable"
  ))))
  expect_identical(status, 0L)
  expect_true(any(grepl("Depth +4 hauls", said)))
  expect_true(file.exists(out))
})

test_that("wrong options are one message", {
  skip_if_not_installed("optparse")
  wrong <- function(...) suppressMessages(capture.output(
    status <- run_command(c(...)), type = "message"
  ))
  expect_match(wrong("optimise", "towed_cable"), "--minimise", all = FALSE)
  expect_match(wrong("optimise", "--minimise", "total_drag", "--change", "a", "towed_cable"),
    "FIELD = FROM", all = FALSE)
  expect_match(wrong("calibrate", "--data", "x.csv", "--match", "Depth", "towed_cable"),
    "COLUMN ~ MEASURE", all = FALSE)
  # nothing is run but formulas
  expect_match(wrong("optimise", "--minimise", "total_drag + quit()", "--change",
    "towing.speed = 1 .. 3", "towed_cable"), "quit", all = FALSE)
})
