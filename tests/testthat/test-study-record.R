runs <- data.frame(
  towing.speed = c("3 knot", "3 knot", "4 knot", "4 knot", "5 knot"),
  Tension = c(13.1, 13.3, 14.7, 14.6, 16.4)
)
fitted_cable <- function(file = NULL) {
  calibrate("towed_cable", runs, change = list(ropes.cable.length = c("800 m", "1500 m")),
    match = Tension ~ ship_tension_kN, nodes = 40, file = file)
}
best_cable <- function(starts = NULL, file = NULL) {
  optimise_gear("towed_cable", ~ total_drag / towing.speed, ~ body_depth >= "450 m",
    list(ropes.cable.length = c("600 m", "1200 m"), towing.speed = c("3 knot", "5 knot")),
    nodes = 40, starts = starts, file = file)
}

# Counts the gears that a call settles.
count_settled <- function(code) {
  count <- 0L
  own <- getFromNamespace("settle_alone", "codend")
  on.exit(assignInNamespace("settle_alone", own, "codend"))
  assignInNamespace("settle_alone", function(...) {
    count <<- count + 1L
    own(...)
  }, "codend")
  force(code)
  count
}

test_that("calibrate() resumes from a record with the same fields", {
  file <- file.path(test_folder(), "hauls.record")
  alone <- fitted_cable()
  whole <- count_settled(expect_equal(fitted_cable(file)$fields, alone$fields, tolerance = 1e-6))
  lines <- readLines(file)
  # only the states of the last step are settled again, for the errors
  expect_lte(count_settled(fitted_cable(file)), 4L)
  # an interruption leaves the first lines; a damaged line is settled again
  lines <- lines[seq_len(length(lines) / 2)]
  lines[3] <- sub("[0-9][.]", "7.", lines[3])
  writeLines(lines, file)
  resumed <- 0L
  expect_no_warning(resumed <- count_settled(again <- fitted_cable(file)))
  # The first gear settles from another state, which may end the fit one step earlier: the last step
  # changes the length by 0.006 % of its range of 700 m.
  expect_equal(again$fields$value, alone$fields$value, tolerance = 1e-4)
  expect_identical(again$n_solves, alone$n_solves)
  expect_true(resumed > 4L && resumed < whole)
})

test_that("optimise_gear() resumes from a record with the same steps", {
  skip_if_not_installed("nloptr")
  file <- file.path(test_folder(), "best.record")
  alone <- best_cable()
  # A point that is tried twice is settled once with a record: equal within the solver's tolerance.
  expect_equal(best_cable(file = file)$history$objective, alone$history$objective, tolerance = 1e-6)
  lines <- readLines(file)
  writeLines(lines[seq_len(length(lines) / 2)], file)
  again <- best_cable(file = file)
  expect_equal(again$history$objective, alone$history$objective, tolerance = 1e-6)
  expect_equal(again$fields$value, alone$fields$value, tolerance = 1e-5)
})

test_that("open_record() rejects a file that is not a record", {
  file <- file.path(test_folder(), "notes.txt")
  writeLines("my notes", file)
  expect_error(fitted_cable(file), "not a record", class = "codend_error_file")
  expect_identical(readLines(file), "my notes")
})

test_that("workers give the results of one process to calibrate() and optimise_gear()", {
  skip_if_not_installed("future")
  skip_if_not_installed("nloptr")
  fit <- fitted_cable()
  best <- best_cable(starts = 3)
  kept <- future::plan("multisession", workers = 2)
  withr::defer(future::plan(kept))
  parts <- c("fields", "matched", "n_solves", "slopes")
  expect_identical(fitted_cable()[parts], fit[parts])
  parts <- c("fields", "keep", "history", "starts", "n_solves")
  expect_identical(best_cable(starts = 3)[parts], best[parts])
})

test_that("searches report each step unless the option is off", {
  withr::local_options(codend.steps = TRUE)
  expect_message(expect_message(fitted_cable(), "Step 1: misfit"), "Step 2.*largest change",
    class = "codend_message_step") |> suppressMessages()
  expect_silent(suppressMessages(fitted_cable()))
})
