# A trawl that turns while it is towed; kept times are not all the same time apart.
turning_trawl <- local({
  found <- NULL
  function() {
    if (is.null(found)) {
      found <<- tow("midwater_trawl", until = 25, every = 10, nodes = 300,
        speed = "4.5 knot", warp_out = "700 m",
        course = data.frame(time = c(0, 25), value = c("0 deg", "30 deg")))
    }
    found
  }
})

unpacked <- function(text, what, size) {
  bytes <- jsonlite::base64_dec(text)
  readBin(bytes, what, length(bytes) / size, size = size, signed = size > 1, endian = "little")
}

page_motion <- function(page) {
  scripts <- vapply(page$jsHooks$render, `[[`, "", "code")
  page$jsHooks$render[[grep("Plays a trajectory", scripts)]]$data
}

test_that("the page of a trajectory moves every line to where the state has it", {
  trajectory <- turning_trawl()
  page <- view(trajectory)
  expect_s3_class(page, "htmlwidget")
  motion <- page_motion(page)
  expect_identical(as.double(motion$time), c(0, 10, 20, 25))
  points <- unpacked(motion$points, "double", 4)
  points <- array(points, c(3, length(points) / 12, 4))
  objects <- attr(page, "origScene")$objects
  for (k in c(1, 3, 4)) {
    drawing <- state_drawing(state_at(trajectory, trajectory$time[k]))
    for (kind in 1:2) {
      lines <- drawing[[c("netting", "ropes")[kind]]]
      ends <- matrix(unpacked(motion$lines[[kind]]$ends, "integer", 4) + 1, 2)
      # single precision: 6e-8 of some 1000 m
      expect_lt(max(abs(points[, ends[1, ], k] - lines$from)), 1e-4)
      expect_lt(max(abs(points[, ends[2, ], k] - lines$to)), 1e-4)
      object <- Filter(function(o) o$id == motion$lines[[kind]]$id, objects)[[1]]
      expect_identical(nrow(object$vertices), 2L * ncol(ends))
    }
    marks <- array(unpacked(motion$marks, "double", 4), c(3, nrow(drawing$marks), 4))
    expect_lt(max(abs(marks[, , k] - t(as.matrix(drawing$marks[c("x", "y", "z")])))), 1e-4)
  }
  shown <- c(vapply(motion$plates, `[[`, 0L, "mark"), motion$balls$mark)
  expect_setequal(shown, seq_len(nrow(drawing$marks)))
  expect_match(motion$label[4], "25.0 s, 4.5 knot, course 30\u00b0", fixed = TRUE)
})

test_that("the page of a gear that is moored tells the time alone", {
  moored <- tow("dip_net", until = 2, every = 1, nodes = 100)
  expect_identical(as.character(motion_labels(moored)), paste("after", c("0.0", "1.0", "2.0"), "s"))
  expect_identical(motion_words(moored), "after 2.0 s")
  expect_identical(motion_words(turning_trawl()), "towed for 25.0 s")
})

test_that("colours have one scale for the whole tow, which is the legend's", {
  trajectory <- turning_trawl()
  motion <- page_motion(view(trajectory))$lines[[2]]
  state <- state_at(trajectory, 20)
  all <- unlist(lapply(trajectory$time, function(t) {
    state_drawing(state_at(trajectory, t))$ropes$tension
  }))
  drawn <- state_drawing(state)$ropes$tension
  numbers <- matrix(unpacked(motion$colour, "integer", 1), ncol = 4)[, 3]
  expected <- tension_colours(tension_scale(all, "rope"), drawn)
  expect_identical(rgb(t(motion$palette))[numbers + 1], expected)
})

test_that("the scene holds the gear at all times, and the file is one page", {
  trajectory <- turning_trawl()
  motion <- gear_motion(trajectory)
  box <- matrix(attr(view(trajectory), "origScene")$rootSubscene$par3d$bbox, 2)
  for (axis in 1:3) {
    expect_lte(box[1, axis], min(motion$points[axis, , ]))
    expect_gte(box[2, axis], max(motion$points[axis, , ]))
  }
  file <- file.path(test_folder(), "tow.html")
  view(trajectory, file = file)
  html <- paste(readLines(file, warn = FALSE), collapse = "\n")
  expect_match(html, "Plays a trajectory", fixed = TRUE)
  expect_false(grepl("src=[\"'](?!data:)", html, perl = TRUE))
})

test_that("times are told in seconds, or in minutes where a tow is long", {
  expect_equal(time_words(61.25, 100), "61.2 s")
  expect_equal(time_words(659.7, 2400), "11:00 min")
})
