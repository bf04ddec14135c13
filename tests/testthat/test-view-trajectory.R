# A tow whose numbers are known: faster after 10 s.
faster_cable <- local({
  found <- NULL
  function() {
    if (is.null(found)) {
      found <<- tow("towed_cable", until = 30, every = 5,
        speed = data.frame(time = c(0, 10, 20), value = c(1, 1, 2)))
    }
    found
  }
})

test_that("a trajectory's figures show its measures and what its schedule changes", {
  trajectory <- faster_cable()
  series <- trajectory_series(trajectory, NULL)
  words <- vapply(series, `[[`, "", "words")
  expect_identical(series[[1]], list(
    words = "vessel speed", unit = "m/s", time = seq(0, 30, 5), value = c(1, 1, 1, 1.5, 2, 2, 2)
  ))
  expect_false(any(c("vessel course", "heave") %in% words))
  drag <- series[[match("total drag", words)]]
  expected <- vapply(seq(0, 30, 5), function(t) {
    measures(state_at(trajectory, t))[["total_drag_kN"]]
  }, 0)
  expect_identical(drag$value, expected)
  expect_identical(drag$unit, "kN")
  expect_identical(trajectory_series(trajectory, "total_drag_kN"), list(drag))
})

test_that("depths grow downwards, and what stands still is not its rounding", {
  expect_equal(series_range(c(3, 9, 4), "door depth"), c(9, 3))
  expect_equal(series_range(c(3, 9, 4), "spread"), c(3, 9))
  expect_equal(series_range(c(100, 100 + 1e-10), "spread"), c(99.95, 100.05))
  expect_equal(series_range(c(0, 0), "least depth"), c(0.5, -0.5))
})

test_that("figures go to a device or a file", {
  trajectory <- faster_cable()
  folder <- test_folder()
  grDevices::pdf(NULL, width = 10, height = 8)
  on.exit(grDevices::dev.off())
  expect_identical(withVisible(plot(trajectory))$visible, FALSE)
  plot(trajectory, file = file.path(folder, "a.png"))
  plot(trajectory, measures = "total_drag_kN", file = file.path(folder, "b.svg"))
  expect_equal(list.files(folder, all.files = TRUE, no.. = TRUE), c("a.png", "b.svg"))
})
