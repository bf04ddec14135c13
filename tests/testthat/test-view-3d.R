scene_json <- function(scene) {
  as.character(jsonlite::toJSON(scene, auto_unbox = TRUE, digits = 16, null = "null"))
}

test_that("view_3d() returns a widget with the state's positions and tensions", {
  state <- unsettled(sheets_plan)
  page <- view_3d(state)
  expect_s3_class(page, "htmlwidget")
  scene <- page$x$scene
  points <- matrix(unpacked(scene$points$floats, "double", 4), 3L)
  all <- state_points(state)
  # single precision: 6e-8 of about 20 m
  near <- function(x) apply(x, 2L, function(p) min(colSums((all - p)^2)))
  expect_lt(max(near(points)), 1e-10)
  ends <- matrix(unpacked(scene$ropes$ends, "integer", 4) + 1L, 2L)
  ropes <- parts_of(state)$kind[part_of(state, "bar")] == "rope"
  expect_identical(ncol(ends), sum(ropes))
  length <- sqrt(colSums((points[, ends[1, ]] - points[, ends[2, ]])^2))
  expect_equal(length, state$bar_length[ropes], tolerance = 1e-5)
  expect_equal(unpacked(scene$rope_tension$floats, "double", 4), state$bar_tension[ropes],
    tolerance = 1e-6)
  expect_length(scene$netting, length(sheets_plan$panels))
})

test_that("netting surfaces contain as many meshes as the plan", {
  state <- unsettled(sheets_plan, nodes = 300)
  surfaces <- netting_surfaces(state)
  # In twine coordinates a panel's area is its number of bars of one family.
  area <- vapply(surfaces$panels, function(panel) {
    at <- function(row) matrix(panel$mesh[row, ], panel$columns)
    quad <- function(x) {
      list(x[-1, -ncol(x)] - x[-nrow(x), -ncol(x)], x[-1, -1] - x[-nrow(x), -1],
        x[-nrow(x), -1] - x[-nrow(x), -ncol(x)], x[-1, -1] - x[-1, -ncol(x)])
    }
    u <- quad(at(1))
    v <- quad(at(2))
    sum(abs(u[[1]] * v[[4]] - u[[4]] * v[[1]]) + abs(u[[2]] * v[[3]] - u[[3]] * v[[2]])) / 2
  }, 0)
  expect_equal(area, unname(vapply(state$si$panels, panel_bars, 0)), tolerance = 1e-9)
  expect_length(surfaces$u, ncol(surfaces$at))
  # blocks of cells preserve the total
  coarse <- netting_surfaces(state, limit = 40)
  expect_lt(length(coarse$u), length(surfaces$u) / 2)
  mean_of <- function(of) stats::weighted.mean(of$u, rep(1, length(of$u)))
  expect_true(all(is.finite(mean_of(coarse))))
})

test_that("cloud of bars has the panel's mesh coordinates and tensions", {
  state <- unsettled(sheets_plan, nodes = 300, netting = "bars")
  state$bar_tension[] <- 7
  surfaces <- netting_surfaces(state)
  p <- which(names(state$si$panels) == "middle")
  panel <- surfaces$panels[[p]]
  expect_identical(panel$columns, 0L)
  # square meshes: as many twines across and deep as in the plan
  expect_equal(unname(apply(panel$mesh, 1L, range)), cbind(c(0, 40), c(0, 20)))
  u <- surfaces$u[surfaces$panel == p]
  expect_setequal(u[!is.na(u)], 7)
})

test_that("view colours have a contrast of 3 to 1 or more", {
  # Relative luminance and contrast of WCAG 2.2.
  light <- function(colour) {
    share <- grDevices::col2rgb(colour) / 255
    linear <- ifelse(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055)^2.4)
    drop(c(0.2126, 0.7152, 0.0722) %*% linear)
  }
  contrast <- function(a, b) (pmax(light(a), light(b)) + 0.05) / (pmin(light(a), light(b)) + 0.05)
  # the water from the surface down, the bed, and paper
  code <- web_source("view/materials.ts")
  water <- regmatches(code,
    regexpr("waters = \\[[^]]*\\], sands = \\['#[0-9A-F]{6}'", code))
  behind <- unique(c(regmatches(water, gregexpr("#[0-9A-F]{6}", water))[[1]], "#FFFFFF"))
  expect_length(behind, 5)
  shown <- c(
    slack_colour, muted_slack_colour, view_symbols$solid, tension_palette("rope"),
    tension_palette("netting")
  )
  for (back in behind) expect_gt(min(contrast(shown, back)), 3)
  # text in the picture, and text on a white background
  for (back in behind) expect_gt(min(contrast(c("#202428", "#1c5279", "#5b4a26"), back)), 4.5)
  expect_gt(min(contrast(c("#2a3238", "#4d555c", "#b3005c"), "#FFFFFF")), 4.5)
})

test_that("view_3d() file is one small reproducible page without network requests", {
  folder <- test_folder()
  file <- file.path(folder, "gear.html")
  state <- unsettled(sheets_plan)
  expect_false(withVisible(view_3d(state, file = file))$visible)
  expect_equal(list.files(folder, all.files = TRUE, no.. = TRUE), "gear.html")
  expect_lt(file.size(file), 2e6)
  html <- paste(readLines(file, warn = FALSE), collapse = "\n")
  expect_match(html, "codendView", fixed = TRUE)
  asking <- "(src|href|url)\\s*[=(]\\s*[\"']?(https?:)?//[^\"' )>]*"
  expect_equal(regmatches(html, gregexpr(asking, html))[[1]], character())
  expect_false(grepl("src=[\"'](?!data:)", html, perl = TRUE))
  # The name is escaped as text.
  expect_match(html, "Sheets &lt;&amp; ", fixed = TRUE)
  other <- file.path(folder, "other.html")
  view_3d(state, file = other)
  expect_identical(readLines(other, warn = FALSE), readLines(file, warn = FALSE))
  expect_identical(scene_json(state_scene(state)), scene_json(view_3d(state)$x$scene))
})

test_that("view colours of meshes are means of the table of openings", {
  state <- settle("t90_codend", nodes = 200)
  scene <- view_3d(state, colour = "mesh_opening")$x$scene
  expect_identical(scene$colour, "mesh_opening")
  told <- unpacked(scene$opening$floats, "double", 4)
  known <- as.data.frame(state, what = "mesh_openings")$opening_percent
  # means of corners are within the range along the rows
  expect_gt(min(told), 0.9 * min(known))
  expect_lt(max(told), 1.1 * max(known))
})

test_that("view shows vessels at the surface ends of warps", {
  pair <- unsettled("pair_trawl")
  expect_length(state_scene(pair)$vessels, 2)
  expect_length(state_scene(unsettled("midwater_trawl"))$vessels, 1)
  expect_length(state_scene(unsettled("gillnet"))$vessels, 0)
})

test_that("view_3d() escapes plan names that contain HTML", {
  plan <- read_gear("towed_cable")$plan
  plan$name <- "<!-- <script> </script> & \u003c"
  state <- settle(as_gear(plan), nodes = 50)
  file <- file.path(test_folder(), "a.html")
  view_3d(state, file = file)
  html <- paste(readLines(file, warn = FALSE, encoding = "UTF-8"), collapse = "\n")
  data <- regmatches(html, regexpr("<script type=\"application/json\"[^>]*>.*?</script>", html,
    perl = TRUE))
  inner <- sub("</script>$", "", sub("^<script[^>]*>", "", data))
  expect_no_match(inner, "<", fixed = TRUE)
  expect_identical(jsonlite::fromJSON(inner)$x$scene$name, plan$name)
})

test_that("view shows a catch, chains, ground gear and pieces by kind", {
  codend <- settled("t90_codend", nodes = 200)
  panel <- netting_surfaces(codend)$panels[[1L]]
  # 15 of 50 meshes are full, counted from the rear
  depth <- drop(panel$down %*% panel$mesh)
  expect_equal(range(depth), c(0, 50))
  expect_equal(panel$full, 35)
  trawl <- unsettled("beam_trawl")
  expect_null(netting_surfaces(trawl)$panels[[1L]]$full)
  form <- with(scene_parts(trawl), setNames(form, role))
  expect_setequal(form[names(form) == "tickler"], 1L)
  expect_setequal(form[names(form) == "ground_gear"], 2L)
  expect_setequal(form[names(form) == "beam"], 3L)
  expect_setequal(form[names(form) == "headline"], 0L)
  marks <- scene_marks(scene_shape(unsettled("cage"))$fixed$marks)
  # 100 kg of steel as a sphere: square root of its projected area
  ball <- (3 * 100 / 7850 / (4 * pi))^(1 / 3)
  expect_equal(as.double(marks$size[marks$role == "weight"]), sqrt(pi) * ball, tolerance = 1e-6)
  expect_false("other piece" %in% scene_marks(scene_shape(unsettled("longline"))$fixed$marks)$label)
})
