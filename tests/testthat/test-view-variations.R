variations <- function() {
  table <- expand.grid(towing.speed_knot = c(3, 4, 5), warps.length_m = c(300, 500))
  table$settled <- c(TRUE, FALSE, TRUE, TRUE, TRUE, TRUE)
  table$problem <- ifelse(table$settled, NA, "did not settle")
  table$warning <- NA_character_
  table$door_spread_m <- c(80, NA, 90, 100, 105, 110)
  table$filtered_volume_m3_per_h <- table$door_spread_m * 1e6
  structure(table, class = c("codend_variations", "data.frame"), gear_name = "A trawl",
    unit = c(towing.speed_knot = "knot", warps.length_m = "m", door_spread_m = "m",
      filtered_volume_m3_per_h = "m3/h"))
}

test_that("there is a line for every combination of the other fields", {
  x <- variations()
  study <- variations_study(x, NULL)
  expect_identical(study$measures, c("door_spread_m", "filtered_volume_m3_per_h"))
  expect_identical(study$group_labels, c("300", "500"))
  expect_identical(study$groups_title, "warps length (m)")
  figure <- variations_figure(x, study, "door_spread_m")
  expect_identical(figure$across, "towing speed (knot)")
  expect_equal(figure$lines[[1]]$x, c(3, 5))
  expect_equal(figure$lines[[1]]$y, c(80, 90))
  expect_equal(figure$lines[[2]]$y, c(100, 105, 110))
  expect_equal(figure$missing, 4)
  expect_identical(in_millions(variations_figure(x, study, "filtered_volume_m3_per_h"))$unit,
    "million m3/h")
})

test_that("a field that follows the first makes no lines of its own", {
  x <- variations()[4:6, ]
  x <- cbind(x[1], ropes.other_m = c(1, 2, 3), x[-1])
  class(x) <- c("codend_variations", "data.frame")
  expect_identical(variations_study(x, NULL)$group_labels, "")
})

test_that("texts become places along the axis", {
  x <- variations()
  x <- cbind(material = rep(c("PA", "PE", "hmpe"), 2), x[-1])
  class(x) <- c("codend_variations", "data.frame")
  study <- variations_study(x, "door_spread_m")
  expect_identical(study$ticks, c("PA", "PE", "hmpe"))
  expect_equal(study$at, c(1, 2, 3, 1, 2, 3))
})

test_that("pictures are written, and too small a page is told", {
  folder <- test_folder()
  x <- variations()
  for (file in file.path(folder, c("a.png", "a.pdf"))) {
    expect_identical(plot(x, file = file), x)
    expect_gt(file.size(file), 1000)
  }
  expect_wrong(plot(x, measures = "speed"), "must be any of")
  many <- x[c(1:5, rep(6, 60))]
  names(many)[-(1:5)] <- paste0("m", 1:60, "_m")
  class(many) <- class(x)
  expect_wrong(plot(many, file = file.path(folder, "b.png"), height = 3), "too small")
})

test_that("keys wrap within the page", {
  key <- list(title = "warps length (m)", labels = format(seq(100, 1000, 100)), missing = "none")
  place <- key_places(key_entries(key), 4)
  expect_true(all(place$left < 4 - 0.5))
  expect_gt(max(place$row), 1)
  expect_true(all(diff(place$row) >= 0))
  expect_equal(key_height(NULL, 4), 0)
})

test_that("many figures find room on a small page by being drawn smaller", {
  # six rows of 1.3 inches and the title do not fit into 7 inches
  layout <- series_layout(24, NULL, c(7, 7))
  expect_lt(layout$zoom, 1)
  expect_gte((7 / layout$zoom - layout$above) / layout$rows, least_series[2])
  expect_gte(layout$columns * layout$rows, 24)
  expect_equal(series_layout(4, NULL, c(7, 7))$zoom, 1)
  expect_null(series_layout(60, NULL, c(7, 3)))
})
