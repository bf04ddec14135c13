# A trawl in a turn; saved times are not evenly spaced.
turning_trawl <- local({
  found <- NULL
  function() {
    if (is.null(found)) {
      found <<- tow("midwater_trawl", until = 25, every = 10, nodes = 300,
        schedule = tow_schedule(speed = "4.5 knot", warp_out = "700 m",
        course = data.frame(time = c(0, 25), value = c("0 deg", "30 deg"))))
    }
    found
  }
})

test_that("scene of a tow moves every line as in the state", {
  trajectory <- turning_trawl()
  page <- view_3d(trajectory)
  expect_s3_class(page, "htmlwidget")
  scene <- page$x$scene
  expect_identical(as.double(scene$times), c(0, 10, 20, 25))
  ends <- matrix(unpacked(scene$ropes$ends, "integer", 4) + 1, 2)
  for (k in c(1, 3, 4)) {
    state <- state_at(trajectory, trajectory$time[k])
    points <- places_at(scene$points, k)
    drawing <- state_drawing(state)
    # the seams follow the ropes; plane figures draw them after the twines
    seams <- utils::tail(seq_along(drawing$netting$tension), ncol(ends) - ncol(drawing$ropes$from))
    from <- cbind(drawing$ropes$from, drawing$netting$from[, seams])
    to <- cbind(drawing$ropes$to, drawing$netting$to[, seams])
    # half a step, and single precision of about 1000 m
    near <- function(told) 0.51 * max(unpacked(told$step, "double", 4)) + 1e-4
    expect_lt(max(abs(points[, ends[1, ]] - from)), near(scene$points))
    expect_lt(max(abs(points[, ends[2, ]] - to)), near(scene$points))
    # compared with a net of about 100 m
    expect_lt(near(scene$points), 0.02)
    marks <- places_at(scene$places, k)
    expect_lt(max(abs(marks - t(as.matrix(drawing$marks[c("x", "y", "z")])))), near(scene$places))
    told <- values_at(scene$rope_tension, k)
    # half a step of the square root, twice, relative to the largest
    now <- c(drawing$ropes$tension, drawing$netting$tension[seams])
    expect_lt(max(abs(told - now)), 1.05 / 4095 * scene$rope_tension$top)
  }
  expect_match(scene$labels[4], "25.0 s, 4.5 knot, course 30\u00b0", fixed = TRUE)
})

test_that("motion_graph() has every measure at every time and the energy imbalance", {
  trajectory <- turning_trawl()
  graph <- motion_graph(trajectory)
  table <- as.data.frame(trajectory, what = "measures")
  expect_length(graph, length(unique(table$measure)) + 1L)
  last <- graph[[length(graph)]]
  expect_match(last$words, "energy imbalance")
  now <- trajectory$conditions[length(trajectory$time), ]
  expect_equal(utils::tail(as.double(last$values), 1L),
    100 * now$energy_imbalance / now$energy_put_through, tolerance = 1e-4)
  first <- table[table$measure == table$measure[1], ]
  expect_equal(as.double(graph[[1]]$values), first$value, tolerance = 1e-4)
})

test_that("packed_values() keeps precision, signs, slack and missing values", {
  values <- c(0, 1e-6, -3, 10, 5000, NA, 1e-12)
  packed <- packed_values(c(values, rev(values), values), 3L)
  expect_identical(values_at(packed, 1), values_at(packed, 3))
  told <- values_at(packed, 1)
  expect_identical(told == 0, c(TRUE, FALSE, FALSE, FALSE, FALSE, NA, FALSE))
  # the square root of 3 in 5000 is 100 of 4095 steps: half a step, twice
  expect_equal(told[3:5], values[3:5], tolerance = 0.01)
  expect_lt(told[3], 0)
  expect_identical(is.na(told), is.na(values))
})

test_that("packed_places() keeps positions within half a step or 1/65535", {
  at <- array(
    c(0, 0, 0, 100, -700, 3, 0.5, 0, 1e-3, 100, -650, 3, 900, 1, 0, 99, -651, 3), c(3, 2, 3)
  )
  told <- packed_places(at, 3L, 0.01)
  way <- apply(at, 1:2, max) - apply(at, 1:2, min)
  for (k in 1:3) {
    error <- abs(places_at(told, k) - at[, , k])
    # and single precision of the position
    expect_true(all(error <= 0.5001 * pmax(0.01, way / 65535) + 1.2e-7 * 1000))
  }
})

test_that("long tow makes a page of less than 2 MB", {
  trajectory <- turning_trawl()
  moved <- scene_moved(lapply(trajectory$time, function(t) {
    scene_shape(state_at(trajectory, t))
  }))
  rest <- sum(file.size(system.file("view", c("viewer.js", "viewer.css"), package = "codend")))
  # the connectivity of the largest drawn mesh takes about 100 kB
  expect_lt(scene_bytes + rest + 1.5e5, 2e6)
  # two of four times if all times would exceed the limit
  scene <- motion_scene(trajectory, bytes = 0.8 * scene_size(moved))
  expect_lt(length(scene$times), 4)
  expect_identical(range(as.double(scene$times)), c(0, 25))
  expect_lt(scene_size(scene[names(moved)]), scene_size(moved))
})

test_that("page of a moored gear labels only the time", {
  moored <- tow("dip_net", until = 2, every = 1, nodes = 100)
  expect_identical(as.character(motion_labels(moored)), paste("after", c("0.0", "1.0", "2.0"), "s"))
  expect_identical(motion_text(moored), "after 2.0 s")
  expect_identical(motion_text(turning_trawl()), "towed for 25.0 s")
})

test_that("colours have one scale for the whole tow", {
  trajectory <- turning_trawl()
  all <- unlist(lapply(trajectory$time, function(t) {
    state_drawing(state_at(trajectory, t))$ropes$tension
  }))
  told <- motion_scene(trajectory)$scales$tension$rope
  expect_equal(as.double(told$limits), tension_scale(all, "rope")$limits)
})

test_that("time_text() uses seconds, and minutes for long tows", {
  expect_equal(time_text(61.25, 100), "61.2 s")
  expect_equal(time_text(659.7, 2400), "11:00 min")
})
