skip_if_not_installed("ggplot2")

drawn <- function(...) ggplot2::autoplot(...)$data

variations <- function() {
  table <- expand.grid(towing.speed_knot = c(3, 4, 5), warps.length_m = c(300, 500))
  fields <- names(table)
  table$door_spread_m <- c(80, NA, 90, 100, 105, 110)
  table$filtered_volume_m3_per_h <- table$door_spread_m * 1e6
  table$settled <- c(TRUE, FALSE, TRUE, TRUE, TRUE, TRUE)
  table$problem <- ifelse(table$settled, NA, "did not settle")
  table$warning <- NA_character_
  structure(table, class = c("codend_variations", "data.frame"), gear_name = "A trawl",
    fields = fields,
    unit = c(towing.speed_knot = "knot", warps.length_m = "m", door_spread_m = "m",
      filtered_volume_m3_per_h = "m3/h"))
}

# A tow with known speed: faster after 10 s.
faster_cable <- function() {
  tow("towed_cable", until = 30, every = 5,
    schedule = tow_schedule(speed = data.frame(time = c(0, 10, 20), value = c(1, 1, 2))))
}

test_that("chart of variations has a line per combination of other fields", {
  chart <- ggplot2::autoplot(variations())
  of <- chart$data[chart$data$panel == "door spread (m)", ]
  expect_equal(of$at, c(3, 5, 3, 4, 5))
  expect_equal(of$value, c(80, 90, 100, 105, 110))
  expect_identical(as.character(of$group), c("300", "300", "500", "500", "500"))
  expect_identical(levels(chart$data$panel), c("door spread (m)", "filtered volume (m3/h)"))
  expect_identical(chart$labels$x, "towing speed (knot)")
  expect_identical(chart$labels$colour, "warps length (m)")
  # a gear without convergence has a cross in each panel
  crosses <- Filter(function(layer) inherits(layer$geom, "GeomText"), chart$layers)
  expect_equal(crosses[[1]]$data$at, c(4, 4))
})

test_that("field that follows the first adds no lines", {
  x <- variations()[4:6, ]
  x <- cbind(x[1], ropes.other_m = c(1, 2, 3), x[-1])
  x <- structure(x, class = c("codend_variations", "data.frame"), fields = names(x)[1:3])
  expect_identical(levels(drawn(x)$group), "")
})

test_that("strings become positions along the axis", {
  x <- variations()
  x <- cbind(material = rep(c("PA", "PE", "hmpe"), 2), x[-1])
  x <- structure(x, class = c("codend_variations", "data.frame"), fields = names(x)[1:2])
  expect_identical(levels(drawn(x, "door_spread_m")$at), c("PA", "PE", "hmpe"))
})

test_that("chart of a tow has panels for measures and changed conditions", {
  trajectory <- faster_cable()
  data <- drawn(trajectory)
  speed <- data[data$panel == "vessel speed (m/s)", ]
  expect_equal(speed$at, seq(0, 30, 5))
  expect_equal(speed$value, c(1, 1, 1, 1.5, 2, 2, 2))
  expect_false(any(grepl("course|heave", data$panel)))
  drag <- drawn(trajectory, "total_drag_kN")
  expected <- vapply(seq(0, 30, 5), function(t) {
    measures(state_at(trajectory, t))[["total_drag_kN"]]
  }, 0)
  expect_identical(drag$value, expected)
  expect_identical(levels(drag$panel), "total drag (kN)")
  table <- as.data.frame(trajectory)
  expect_equal(drag$high - drag$value, 2 * table$error[table$measure == "total_drag_kN"])
})

test_that("constant is drawn as a straight line", {
  ends <- function(value) range(least_range(data.frame(panel = "a", value = value))$value)
  expect_equal(ends(c(100, 100 + 1e-10)), c(99.95, 100.05))
  expect_equal(ends(c(0, 0)), c(-0.5, 0.5))
  expect_equal(nrow(least_range(data.frame(panel = "a", value = c(3, 9)))), 0L)
})

test_that("equal ropes and equal panels are both visible", {
  tensions <- as.data.frame(settled("midwater_trawl", nodes = 500), what = "rope_tensions",
    parts = "warp")
  chart <- ggplot2::autoplot(tensions)
  expect_equal(range(chart$data$value), range(tensions$tension_kN))
  built <- ggplot2::layer_data(chart, 2)
  expect_setequal(built$linetype, c("solid", "33"))
  trawl <- suppressWarnings(settle("pair_trawl", nodes = 300))
  meshes <- as.data.frame(trawl, what = "mesh_openings")
  lines <- ggplot2::layer_data(ggplot2::autoplot(meshes), 2)
  expect_setequal(lines$linetype, c("solid", "33"))
  # each panel of the net is a line in both facets
  expect_identical(nrow(unique(lines[c("PANEL", "group")])),
    2L * length(unique(meshes$panel[meshes$meshes_across > 0])))
})

test_that("bars are sorted by size in each panel", {
  found <- sensitivities(settled("towed_cable"), fields = c("towing.speed", "ropes.cable.length",
    "ropes.cable.diameter"))
  chart <- ggplot2::autoplot(found, c("total_drag_kN", "body_depth_m"))
  for (panel in split(chart$data, chart$data$panel)) {
    expect_false(is.unsorted(panel$size[order(panel$row)]))
  }
  expect_equal(sort(chart$data$elasticity),
    sort(found$elasticity[found$measure %in% c("total_drag_kN", "body_depth_m")]))
  # a sensitivity of 0 that is not smooth has no secants to draw
  found[1, c("derivative", "elasticity")] <- 0
  found$smooth[1] <- FALSE
  expect_silent(plot(found, found$measure[1], file = tempfile(fileext = ".png")))
})

test_that("charts are drawn on a device or in a fitting file", {
  x <- variations()
  folder <- test_folder()
  grDevices::pdf(NULL, width = 10, height = 8)
  on.exit(grDevices::dev.off())
  expect_identical(withVisible(plot(x)), list(value = x, visible = FALSE))
  for (file in file.path(folder, c("a.png", "a.pdf", "a.svg"))) {
    expect_identical(plot(x, file = file), x)
    expect_gt(file.size(file), 1000)
  }
  expect_wrong(plot(x, measures = "speed"), "must be any of")
  many <- x[c(1:2, 5:7, rep(3, 60))]
  names(many)[-(1:5)] <- paste0("m", 1:60, "_m")
  class(many) <- class(x)
  # eight rows of at most eight panels
  expect_equal(chart_height(ggplot2::autoplot(many, names(many)[-(1:5)])), 1 + 8 * 1.8)
})
