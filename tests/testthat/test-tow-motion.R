# What the engine says of a tow's schedule that does not fit its lattice.

complaint_of_schedule <- function(change) {
  gear <- read_gear("towed_cable")
  si <- gear_si(gear)
  lattice <- build_lattice(si)
  given <- list(breaking = list(list(rope = names(si$ropes)[1], time = 5)), catch = NULL)
  schedule <- change(scheduled_motion(si, lattice, given, until = 10)$schedule)
  error <- tryCatch(
    {
      engine_scheduled(lattice$mesh, schedule, 0)
      NULL
    },
    codend_error_engine = identity
  )
  expect_s3_class(error, "codend_error")
  c(error$field, conditionMessage(error))
}

test_that("a place or number that is missing from a schedule is named", {
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
  expect_match(beyond[2], "none of the model's [0-9]+ nodes")
})

test_that("a smooth curve has the mean of the slopes next to each value", {
  curve <- smooth_curve(c(0, 1, 3), c(0, 2, 2))
  expect_equal(curve$begin_rate, c(2, 1))
  expect_equal(curve$end_rate, c(1, 0))
})

test_that("what a winch is too slow for comes at its greatest speed", {
  wanted <- list(time = c(0, 1, 100), begin = c(0, 10), end = c(10, 10), begin_rate = c(10, 0),
    end_rate = c(10, 0))
  expect_equal(curve_at(limited_curve(wanted, 2), c(0, 2, 4, 7)), c(0, 4, 8, 10))
})

test_that("a million times may be kept and no more", {
  expect_null(check_tow_times(1e6, list(every = 1)))
  expect_wrong(check_tow_times(1e6, list(every = 1 / 1.001)), "at least 1 s")
})
