# The schedule of a tow as given by users.

test_that("tow_schedule() prints its changes", {
  expect_snapshot({
    tow_schedule()
    tow_schedule(
      speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot")), warp_out = "200 m",
      winch = list(speed_limit = "0.5 m/s"), heave = function(time) sin(time),
      control = function(measures, time) 0
    )
  })
})

test_that("tow_schedule() takes omitted fields from the plan", {
  planned <- list(speed = 2, catch = 0.5, until = 60)
  found <- with_planned(tow_schedule(speed = 3), planned)
  expect_identical(found$speed, 3)
  expect_identical(found$catch, 0.5)
  expect_null(found$warp_out)
})

test_that("tow() rejects schedules of a wrong kind", {
  expect_wrong(tow("towed_cable", schedule = list(speed = 2)), "must be a schedule")
  expect_wrong(tow_schedule(control = 3), "`control` must be a function")
  expect_wrong(tow_schedule(winch = list(force = 1)), "`winch` must be a list")
  expect_wrong(tow_schedule(control_every = "-2 s"), "`control_every` is")
})
