# The engine's error for a tow schedule that does not fit its mesh.

complaint_of_schedule <- function(change) {
  gear <- read_gear("towed_cable")
  si <- gear_si(gear)
  mesh <- build_mesh(si)
  given <- list(breaking = list(list(rope = names(si$ropes)[1], time = 5)), catch = NULL)
  schedule <- change(scheduled_motion(si, mesh, given, until = 10)$schedule)
  error <- tryCatch(
    {
      engine_scheduled(mesh$model, schedule, 0)
      NULL
    },
    codend_error_engine = identity
  )
  expect_s3_class(error, "codend_error")
  c(error$field, conditionMessage(error))
}

test_that("engine names a missing index or number of a schedule", {
  lost <- complaint_of_schedule(function(schedule) {
    schedule$ruptures[[1]]$bars[2] <- NA
    schedule
  })
  expect_identical(lost[1], "schedule.ruptures[1].bars[2]")
  beyond <- complaint_of_schedule(function(schedule) {
    schedule$motion$node[1] <- 100000L
    schedule
  })
  expect_identical(beyond[1], "schedule.motion.node[1]")
  expect_match(beyond[2], "must be one of the [0-9]+ nodes of the model")
})

test_that("smooth_curve() uses the mean of neighbouring slopes", {
  curve <- smooth_curve(c(0, 1, 3), c(0, 2, 2))
  expect_equal(curve$begin_rate, c(2, 1))
  expect_equal(curve$end_rate, c(1, 0))
})

test_that("limited_curve() follows a fast target at the greatest speed", {
  wanted <- list(time = c(0, 1, 100), begin = c(0, 10), end = c(10, 10), begin_rate = c(10, 0),
    end_rate = c(10, 0))
  expect_equal(curve_at(limited_curve(wanted, 2), c(0, 2, 4, 7)), c(0, 4, 8, 10))
})

test_that("check_tow_times() allows a million saved times", {
  expect_null(check_tow_times(1e6, list(every = 1)))
  expect_wrong(check_tow_times(1e6, list(every = 1 / 1.001)), "at least 1 s")
})
