# The misfit at random values of all sliders of a state, see misfit().
misfit_at_random <- function(series, places = 3) {
  max(vapply(seq_len(places), function(k) {
    values <- vapply(series$fields, function(field) of_share(field, stats::runif(1, -1, 1)), 0)
    off <- misfit(series$terms, series$filler, values)
    if (is.character(off)) 0 else off
  }, 0))
}

test_that("slider series reproduce the numbers of changed plans", {
  set.seed(38)
  for (name in c("towed_cable", "stow_net", "t90_codend")) {
    state <- suppressWarnings(settle(name, nodes = 300))
    standard <- shared_measures(state)$standard
    series <- slider_series(state, slider_fields(state$gear, NULL, NULL), standard)
    # double precision, after sums of a dozen terms
    expect_lt(misfit_at_random(series), 1e-12)
    # check of the test: without its last term a series is wrong
    less <- series
    less$terms <- less$terms[-1L]
    expect_gt(misfit_at_random(less), 1e-6)
  }
})

test_that("slider series has a cross term for area times lift coefficient", {
  state <- suppressWarnings(settle("poly_noreastern_trawl", nodes = 300))
  fields <- slider_fields(state$gear, c("otter_boards.area", "otter_boards.lift_coefficient"), NULL)
  series <- slider_series(state, fields, shared_measures(state)$standard)
  expect_true(any(lengths(lapply(series$terms, `[[`, "of")) == 2L))
  set.seed(1)
  expect_lt(misfit_at_random(series), 1e-12)
})

test_that("shared scene lists the bars of each drawn tension", {
  # netting of bars with seams, netting of cells, ropes alone
  for (name in c("midwater_trawl", "stow_net", "towed_cable")) {
    state <- suppressWarnings(settle(name, nodes = 300))
    shape <- with_meshes(scene_shape(state))
    scene <- shared_scene(state, shape, identity)
    # as the page computes them
    means <- function(groups, cells, empty) {
      bars <- seq_along(groups$element) <= c(groups$split, length(groups$element))[1]
      tension <- ifelse(bars, state$bar_tension[groups$element + 1], cells[groups$element + 1])
      of <- factor(groups$group, seq_len(groups$count) - 1)
      total <- function(x) as.double(tapply(x, of, sum))
      mean <- total(unclass(groups$weight) * tension) / total(unclass(groups$weight))
      as.double(ifelse(is.na(mean), empty, mean))
    }
    expect_equal(means(scene$rope, NULL, 0), shape$ropes)
    expect_equal(means(scene$u, state$u_tension, NA), as.double(shape$u))
    expect_equal(means(scene$v, state$v_tension, NA), as.double(shape$v))
  }
})

test_that("slider_fields() rejects unsuitable fields by name", {
  gear <- read_gear("towed_cable")
  expect_wrong(slider_fields(gear, "ropes.cable.segments", NULL), "ropes.cable.segments")
  # a field that changes the mesh changes more than numbers
  base <- list(gear.panels.rows = 4L, gear.panels.deep = c(1, 2))
  odd <- function(...) odd_array(list(...), base)
  expect_match(odd(gear.panels.rows = 4L, gear.panels.deep = 1:3 + 0), "parts")
  expect_match(odd(gear.panels.rows = 5L, gear.panels.deep = c(1, 2)), "panels rows")
  expect_null(odd(gear.panels.rows = 4L, gear.panels.deep = c(1, 3)))
  state <- suppressWarnings(settle("t90_codend", nodes = 300))
  of <- function(path) {
    slider_series(state, slider_fields(state$gear, path, NULL), shared_measures(state)$standard)
  }
  expect_wrong(of(list(sprintf("panels.net_%d.meshes.deep", 1:8))), "changes the mesh of the model")
})

test_that("share() checks its arguments before any computation", {
  state <- settle("towed_cable")
  argument <- function(expression) expect_error(expression, class = "codend_error")
  argument(slider_fields(state$gear, "nowhere.length", NULL))
  argument(slider_fields(state$gear, 3, NULL))
  argument(slider_fields(state$gear, "towing.speed", list(ropes.cable.length = c("1 m", "2 m"))))
  argument(slider_fields(state$gear, "towing.speed", list(towing.speed = c("6 knot", "8 knot"))))
  range <- list(towing.speed = c("2 knot", "6 knot"))
  field <- slider_fields(state$gear, "towing.speed", range)[[1]]
  control <- shared_form(state$gear, list(field))$quick[[1]]
  expect_equal(unlist(control[c("value", "low", "high", "step")], use.names = FALSE),
    c(4, 2, 6, 0.02))
})

bytes_of <- function(text) memDecompress(jsonlite::base64_dec(text), "gzip")

test_that("packed_arrays() can be decoded from its bytes", {
  arrays <- list(
    a = c(1.5, -2, pi), b = 1:5, c = c("x", "y", "x"), d = structure(2L, class = "groups"),
    e = cos(seq_len(999))
  )
  packed <- packed_arrays(arrays)
  raw <- bytes_of(packed$body)
  back <- function(of, size, kind) {
    readBin(raw[of[[3]] + seq_len(of[[2]] * size)], kind, of[[2]], size, endian = "little")
  }
  expect_identical(back(packed$head$a, 8L, "double"), arrays$a)
  expect_identical(cumsum(back(packed$head$b, 4L, "integer")), arrays$b)
  words <- as.character(packed$head$c[[4]])
  expect_identical(words[cumsum(back(packed$head$c, 4L, "integer")) + 1L], arrays$c)
  expect_identical(back(packed$head$e, 8L, "double"), arrays$e)
  expect_equal(few_figures(c(pi, -1e-7, 0, NA), 10), c(pi, -1e-7, 0, NA), tolerance = 2^-10)
})

test_that("share() escapes the plan's strings and needs the engine for pages", {
  gear <- update(read_gear("towed_cable"), name = "</script><script>hurt()</script>")
  state <- settle(gear)
  file <- tempfile(fileext = ".html")
  on.exit(unlink(file))
  if (!can_share()) {
    expect_wrong(share(state, file), "make wasm")
    skip("the engine for pages is not made")
  }
  expect_identical(withVisible(share(state, file)), list(value = file, visible = FALSE))
  text <- paste(readLines(file, warn = FALSE, encoding = "UTF-8"), collapse = "\n")
  expect_false(grepl("<script>hurt", text, fixed = TRUE))
  packed <- jsonlite::fromJSON(sub("</script>.*", "", sub(".*id=\"packed\">", "", text)),
    simplifyVector = FALSE)
  scene <- rawToChar(bytes_of(packed$scene))
  expect_false(grepl("<", scene, fixed = TRUE))
  expect_match(jsonlite::fromJSON(scene)$name, "</script>", fixed = TRUE)
  expect_lt(file.size(file), 1e6)
})
