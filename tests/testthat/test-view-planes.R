test_that("plot() returns its state, on a device or in a file", {
  state <- unsettled(sheets_plan)
  grDevices::pdf(NULL)
  device <- grDevices::dev.cur()
  on.exit(grDevices::dev.off(device))
  parameters <- function() graphics::par(no.readonly = TRUE)[c("mai", "cex", "xpd")]
  before <- parameters()
  expect_identical(withVisible(plot(state)), list(value = state, visible = FALSE))
  expect_equal(parameters(), before)
  folder <- test_folder()
  plot(state, file = file.path(folder, "a.png"))
  expect_equal(grDevices::dev.cur(), device)
  expect_equal(list.files(folder, all.files = TRUE, no.. = TRUE), "a.png")
})

test_that("plot() writes the file format of the name", {
  state <- unsettled("towed_cable")
  folder <- test_folder()
  start <- function(file) rawToChar(readBin(file.path(folder, file), "raw", 5L)[2:4])
  for (file in c("a.png", "a.pdf", "a.svg")) plot(state, file = file.path(folder, file))
  expect_equal(start("a.png"), "PNG")
  expect_equal(start("a.pdf"), "PDF")
  expect_equal(start("a.svg"), "?xm")
  size <- function(...) {
    file <- file.path(folder, "size.png")
    plot(state, file = file, ...)
    # A PNG file has its width and height in bytes 17 to 24 (ISO/IEC 15948).
    readBin(readBin(file, "raw", 24L)[17:24], "integer", 2L, endian = "big")
  }
  expect_equal(size(width = 6, height = 5), c(1200, 1000))
  expect_equal(size(planes = "xz", width = 8)[1], 1600)
  # the page height depends on the number of planes
  expect_false(size(planes = "xz")[2] == size()[2])
})

test_that("narrow page is a scaled wide page", {
  figure <- plane_figure(unsettled("midwater_trawl", nodes = 300), c("xy", "xz", "yz"))
  expect_equal(fitting_height(figure, full_width / 2), fitting_height(figure, full_width) / 2)
  folder <- test_folder()
  file <- file.path(folder, "a.png")
  plot(unsettled("crossing_cables"), width = 3, height = 3, file = file)
  expect_true(file.exists(file))
})

test_that("plot() that fails keeps the old file", {
  folder <- test_folder()
  file <- file.path(folder, "a.png")
  writeLines("old", file)
  devices <- grDevices::dev.list()
  state <- unsettled("crossing_cables")
  state$si$water$density <- NULL
  expect_error(plot(state, file = file))
  expect_equal(grDevices::dev.list(), devices)
  expect_equal(readLines(file), "old")
  expect_equal(list.files(folder, all.files = TRUE, no.. = TRUE), "a.png")
})

test_that("plane views have equal scales and fit the page", {
  state <- unsettled(sheets_plan)
  figure <- plane_figure(state, c("xy", "xz", "yz"))
  for (page in list(c(10, 12), c(7, 5), c(14, 6))) {
    views <- views_for_page(figure, page)
    frames <- page_frames(views, page)$views
    for (frame in frames) {
      expect_true(all(frame[1:2] >= -1e-9) && all(frame[3:4] <= page + 1e-9))
      expect_true(frame[3] - frame[1] > space_across && frame[4] - frame[2] > space_up)
    }
    grDevices::pdf(NULL, page[1], page[2])
    graphics::plot.new()
    for (k in seq_along(views)) {
      draw_plane(figure, views[[k]], frames[[k]], page)
      metres <- diff(graphics::par("usr"))[c(1, 3)]
      expect_equal(metres[1] / graphics::par("pin")[1], metres[2] / graphics::par("pin")[2],
        tolerance = 1e-6)
    }
    grDevices::dev.off()
  }
})

test_that("plane views enlarge a distant net if the page allows", {
  plan <- sheets_plan
  far <- plan
  far$ropes$line_port$length <- far$ropes$line_starboard$length <- 300
  regions <- function(plan, page) {
    views <- views_for_page(plane_figure(unsettled(plan), c("xy", "xz", "yz")), page)
    paste(vapply(views, `[[`, "", "plane"), vapply(views, `[[`, "", "region"))
  }
  whole <- c("xy whole", "xz whole", "yz whole")
  expect_equal(regions("towed_cable", c(10, 20)), whole)
  expect_setequal(regions(far, c(10, 20)), c(whole, "xy net", "xz net"))
  expect_equal(regions(far, c(10, 4)), whole)
})

test_that("plane views draw the seabed only under gear on it", {
  expect_null(drawn_bed(unsettled("midwater_trawl", nodes = 300)))
  expect_equal(bed_heights(list(normal = c(0, 0, 1), height = -30), cbind(c(5, 7), c(0, 0))),
    c(-30, -30))
  # 1 in 10 down aft: 2 m deeper at 20 m
  normal <- c(1, 0, 10) / sqrt(101)
  bed <- list(normal = normal, height = -30 * normal[3])
  expect_equal(bed_heights(bed, cbind(c(0, 9), c(20, -4))), c(-30, -32))
  trawl <- update(read_gear("beam_trawl"), seabed.slope = list(angle = "5 deg", toward = "0 deg"))
  state <- settle(trawl, nodes = 200)
  bed <- drawn_bed(state)
  heel <- state$position[, nodes_at(state, "lower_port")]
  # the heel is within a few metres of the middle of the gear on the bed
  expect_lt(abs(bed$middle[1] - heel[1]), 5)
  expect_equal(bed_heights(bed, cbind(heel[1:2])), -30 - heel[1] * tan(5 * pi / 180))
})
