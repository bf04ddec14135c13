test_that("view gives a widget with the gear's lines and leaves the session as it was", {
  kept <- options(rgl.useNULL = FALSE)
  on.exit(options(kept))
  state <- unsettled(sheets_plan)
  page <- view(state)
  expect_s3_class(page, "htmlwidget")
  expect_false(getOption("rgl.useNULL"))
  expect_length(rgl::rgl.dev.list(), 0)
  drawing <- state_drawing(state)
  objects <- attr(page, "origScene")$objects
  ends <- vapply(objects, function(o) if (o$type == "lines") NROW(o$vertices) else 0L, 0L)
  expect_true((2 * length(drawing$netting$tension)) %in% ends)
  expect_true((2 * length(drawing$ropes$tension)) %in% ends)
})

test_that("the scene holds the state's own coordinates at one scale", {
  state <- unsettled("towed_cable")
  drawing <- state_drawing(state)
  ranges <- drawn_ranges(list(drawing$ropes, drawing$netting), drawing$marks)
  scales <- list(rope = tension_scale(drawing$ropes$tension, "rope"), netting = NULL)
  scene <- gear_scene(state, drawing, scales, ranges, NULL)
  n <- 2 * length(drawing$ropes$tension)
  lines <- Filter(function(o) o$type == "lines" && nrow(o$vertices) == n, scene$objects)
  # rgl keeps coordinates in single precision, 6e-8 of their size.
  expect_equal(
    unname(lines[[1]]$vertices), t(matrix(rbind(drawing$ropes$from, drawing$ropes$to), 3L)),
    tolerance = 1e-6
  )
  scale <- scene$rootSubscene$par3d$scale
  expect_equal(scale, rep(scale[1], 3))
})

test_that("the scene turns around the net where it is far behind its ship", {
  far <- sheets_plan
  far$ropes$line_port$length <- far$ropes$line_starboard$length <- 300
  state <- unsettled(far)
  page <- view(state)
  drawing <- state_drawing(state)
  net <- drawn_ranges(list(drawing$netting), NULL)
  scene <- attr(page, "origScene")
  box <- matrix(scene$rootSubscene$par3d$bbox, 2L)
  # The box also holds what is drawn around the outermost points.
  expect_equal(colMeans(box), unname(colMeans(net)), tolerance = 0.02)
  buttons <- page$jsHooks$render[[1]]$data
  ids <- vapply(scene$objects, `[[`, 0, "id")
  expect_true(all(c(buttons$net_axes, buttons$whole_axes) %in% ids))
  expect_length(intersect(buttons$net_axes, buttons$whole_axes), 0)
})

test_that("the file is one page that asks nothing of the network", {
  folder <- test_folder()
  file <- file.path(folder, "gear.html")
  state <- unsettled(sheets_plan)
  expect_false(withVisible(view(state, file = file))$visible)
  expect_equal(list.files(folder, all.files = TRUE, no.. = TRUE), "gear.html")
  html <- paste(readLines(file, warn = FALSE), collapse = "\n")
  expect_match(html, "rglWebGL", fixed = TRUE)
  expect_match(html, "webgl", fixed = TRUE)
  asking <- "(src|href|url)\\s*[=(]\\s*[\"']?(https?:)?//[^\"' )>]*"
  expect_equal(regmatches(html, gregexpr(asking, html))[[1]], character())
  expect_false(grepl("src=[\"'](?!data:)", html, perl = TRUE))
  # The name reaches the page as text, never as markup.
  expect_match(html, "Sheets &lt;&amp; ", fixed = TRUE)
})

test_that("legends in the page name units, slack netting and symbols", {
  state <- unsettled(sheets_plan)
  drawing <- state_drawing(state)
  drawing$netting$tension <- c(0, seq(1, 500, length.out = length(drawing$netting$tension) - 1))
  scales <- list(
    rope = tension_scale(c(1000, 5000), "rope"),
    netting = tension_scale(drawing$netting$tension, "netting")
  )
  html <- page_legend(state, drawing, scales)
  expect_match(html, "Tension of ropes (kN)", fixed = TRUE)
  expect_match(html, "Tension of one twine (N)", fixed = TRUE)
  for (label in c("slack", "otter board", "float", "towing point", "other piece")) {
    expect_match(html, label, fixed = TRUE)
  }
})

test_that("wrong arguments are clear errors that leave nothing", {
  state <- unsettled("crossing_cables")
  folder <- test_folder()
  wrong <- function(...) expect_error(view(...), class = "codend_error_argument")
  wrong_file <- function(...) expect_error(view(...), class = "codend_error_file")
  wrong_file(state, file = file.path(folder, "a.htm"))
  wrong_file(state, file = file.path(folder, "no", "a.html"))
  wrong(list())
  expect_length(list.files(folder, all.files = TRUE, no.. = TRUE), 0)
})
