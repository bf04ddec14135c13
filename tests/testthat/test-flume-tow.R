faster <- function(...) {
  speed <- list(to = "5 knot", from = "5 s", over = "10 s")
  list(until = "40 s", changes = list(speed = speed), ...)
}

test_that("page plays a tow of the current design that equals tow()", {
  in_flume("towed_cable", function(session, sent, tank) {
    session$hear(tow_wanted = faster())
    scene <- sent("flume_tow")[[1]]$scene
    expect_equal(range(scene$times), c(0, 40))
    here <- tow(tank$state, until = 40, every = 0.4,
      schedule = tow_schedule(speed = data.frame(time = c(0, 5, 15),
        value = c(tank$state$si$towing$speed, tank$state$si$towing$speed, 5 * 1852 / 3600))))
    trajectory <- unserialize(tank$trajectory)
    expect_equal(trajectory$position, here$position, tolerance = 1e-12)
    expect_identical(scene, viewed_scene(trajectory))
    words <- vapply(scene$graph, `[[`, "", "words")
    expect_true("body depth (m)" %in% words)
    # energy balance of an accurate time integration: within 2 % of the total
    energy <- scene$graph[[grep("energy imbalance", words)]]$values
    expect_length(energy, length(trajectory$time))
    expect_lt(max(abs(energy)), 2)

    # saved files equal the displayed tow
    table <- utils::read.csv(saved_file(session, "tow_measures"))
    expect_equal(table$value, as.data.frame(trajectory, what = "measures")$value, tolerance = 1e-12)
    listed <- utils::untar(saved_file(session, "tow_grids"), list = TRUE, tar = "internal")
    expect_gt(length(listed), 100L)
    expect_true("tow.pvd" %in% basename(listed))
    page <- readLines(saved_file(session, "tow_motion"), warn = FALSE)
    expect_match(page[1], "DOCTYPE", fixed = TRUE)
  })
})

test_that("describe_tow() pays out warps from their length and allows jumps", {
  state <- settled("midwater_trawl", nodes = 500)
  given <- describe_tow(state, list(warp_out = list(by = "-50 m", from = "0 s", over = "20 s"),
    course = list(by = "90 deg", from = "10 s", over = "0 s")))$schedule
  expect_identical(names(Filter(Negate(is.null), unclass(given))), c("course", "warp_out"))
  warps <- Filter(function(rope) identical(rope$role, "warp"), state$si$ropes)
  expect_identical(names(given$warp_out), names(warps))
  for (name in names(warps)) {
    expect_identical(given$warp_out[[name]],
      data.frame(time = c(0, 20), value = warps[[name]]$length - c(0, 50)))
  }
  course <- as.data.frame(given)
  course <- course[course$input == "course", ]
  expect_equal(course$time_s, c(0, 10, 10))
  expect_equal(course$value, c(0, 0, pi / 2))
})

test_that("page rejects an invalid tow and keeps the last one", {
  in_flume("towed_cable", function(session, sent, tank) {
    wrong <- list(
      list(), list(until = "2 days"), list(until = "-3 s"), list(until = 1:3),
      list(until = "10 s", planned = TRUE),
      list(until = "10 s", changes = list(speed = list(to = "fast", from = "0 s", over = "0 s"))),
      list(until = "10 s", changes = list(speed = list(to = "5 knot"))),
      list(until = "10 s", changes = list(speed = "5 knot")),
      list(until = "10 s", changes = list(speed = list(to = "5 m", from = "0 s", over = "5 s")))
    )
    expect_asks_refused(session, sent, "tow_wanted", wrong, "tow")
    expect_null(tank$trajectory)
  })
})

test_that("page runs the tow of the plan", {
  gear <- update(read_gear("towed_cable"), tow = list(until = "5 min", speed = list(
    list(time = "0 s", value = "4 knot"), list(time = "10 s", value = "5 knot"))))
  in_flume(gear, function(session, sent, tank) {
    session$hear(tow_wanted = list(until = "20 s", planned = TRUE))
    trajectory <- unserialize(tank$trajectory)
    # until the requested time
    expect_identical(max(trajectory$time), 20)
    expect_equal(utils::tail(trajectory$conditions$speed, 1L), 5 * 1852 / 3600, tolerance = 1e-12)
  })
})

test_that("page offers no tow unless the plan has one", {
  beam <- read_gear("beam_trawl")
  expect_true("towing" %in% names(beam$plan) && !"tow" %in% names(beam$plan))
  in_flume(beam, function(session, sent, tank) {
    expect_false(sent("flume_picture")[[1]]$towed)
  })
})
