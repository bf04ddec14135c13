# optimise and calibrate from the command line.

test_that("optimise command finds an optimum and writes its plan", {
  skip_if_not_installed("nloptr")
  out <- tempfile(fileext = ".yaml")
  said <- capture.output(status <- suppressMessages(run_command(c(
    "optimise", "--minimise", "total_drag_kN", "--keep", "body_depth >= '450 m'",
    "--change", "ropes.cable.length = 600 m .. 1200 m", "--nodes", "50", "--out", out, "towed_cable"
  ))))
  expect_identical(status, 0L)
  expect_true(any(grepl("ropes.cable.length", said)))
  expect_equal(measures(settle(read_gear(out), nodes = 50))[["body_depth_m"]], 450,
    tolerance = 1e-3)
})

test_that("find command prints found values and writes them as JSON and a plan", {
  out <- tempfile(fileext = ".yaml")
  status <- NULL
  run <- function(json, target) {
    capture.output(status <<- suppressMessages(run_command(c("find", "towed_cable", "--change",
      "ropes.cable.length = 500 m .. 1200 m; towing.speed = 3 knot .. 5 knot", "--target", target,
      "--nodes", "50", "--json", json, "--out", out))))
  }
  json <- tempfile(fileext = ".json")
  said <- run(json, "body_depth=450 m")
  expect_identical(status, 0L)
  expect_match(said, "ropes.cable.length", all = FALSE)
  record <- jsonlite::fromJSON(json)
  expect_true(record$reached)
  expect_identical(record$fields$field, c("ropes.cable.length", "towing.speed"))
  expect_identical(record$targets$measure, "body_depth_m")
  found <- measures(settle(read_gear(out), nodes = 50))[["body_depth_m"]]
  expect_equal(found, 450, tolerance = 1e-3)
  expect_equal(record$targets$value, found, tolerance = 1e-6)
  # two targets, only JSON on standard output
  record <- jsonlite::fromJSON(run("-", "body_depth = 450 m; ship_tension_kN = 9"))
  expect_equal(record$targets$target, c(450, 9))
})

test_that("calibrate command fits hauls of a CSV file and predicts others", {
  data <- tempfile(fileext = ".csv")
  others <- tempfile(fileext = ".csv")
  plan <- tempfile(fileext = ".yaml")
  out <- tempfile(fileext = ".csv")
  writeLines(c("towing.speed,Depth", "3 knot,590", "4 knot,503", "5 knot,430", "6 knot,370"), data)
  writeLines(c("towing.speed,Depth", "3.5 knot,545"), others)
  said <- capture.output(status <- suppressMessages(run_command(c(
    "calibrate", "--data", data, "--match", "Depth ~ body_depth_m", "--nodes", "50",
    "--change", "ropes.cable.coefficients.normal = 0.5 .. 3", "--out", plan, "--explain",
    "--predict", others, "--predicted", out, "towed_cable"
  ))))
  expect_identical(status, 0L)
  expect_match(said, "Depth .* 4 hauls", all = FALSE)
  expect_match(said, "pieces.sphere", all = FALSE)
  expect_true(file.exists(plan))
  found <- utils::read.csv(out)
  expect_identical(found$measured, 545L)
  expect_true(found$lower < found$fit && found$fit < found$upper)
})

test_that("optimise command writes a trade-off, sensitivities command derivatives, as CSV", {
  skip_if_not_installed("nloptr")
  record <- tempfile()
  curves <- lapply(1:2, function(k) {
    curve <- tempfile(fileext = ".csv")
    status <- suppressMessages(run_command(c(
      "optimise", "--minimise", "total_drag_kN", "--and=-body_depth_m", "--points", "3",
      "--change", "ropes.cable.length = 600 m .. 1200 m", "--nodes", "50", "--file", record,
      "--out", curve, "towed_cable"
    )))
    expect_identical(status, 0L)
    list(curve = utils::read.csv(curve, check.names = FALSE), record = readLines(record))
  })
  # the repeated command reads the recorded gears
  expect_identical(curves[[2L]]$record, curves[[1L]]$record)
  expect_equal(curves[[2L]]$curve, curves[[1L]]$curve, tolerance = 1e-6)
  expect_gt(length(curves[[1L]]$record), 5L)
  curve <- curves[[1L]]$curve
  expect_identical(nrow(curve), 3L)
  expect_true(all(diff(curve$total_drag_kN) > 0) && all(diff(curve[["-body_depth_m"]]) < 0))
  said <- capture.output(status <- run_command(c("sensitivities", "--of", "total_drag_kN", "--to",
    "towing.speed; ropes.cable.length", "--nodes", "50", "towed_cable")))
  expect_identical(status, 0L)
  found <- utils::read.csv(text = said)
  expect_identical(found$field, c("towing.speed", "ropes.cable.length"))
  same <- sensitivities(settle("towed_cable", nodes = 50), "total_drag_kN", found$field)
  expect_equal(found$derivative, same$derivative)
})

test_that("study command creates, runs, reads and draws a study", {
  skip_if_not_installed("RNetCDF")
  skip_if_not_installed("spacefillr")
  store <- file.path(test_folder(), "cable.study")
  run <- function(...) {
    said <- capture.output(status <- suppressMessages(run_command(c("study", ...))))
    expect_identical(status, 0L)
    said
  }
  run("new", store, "towed_cable", "--nodes", "50", "--how", "indices", "--number", "4", "--change",
    "towing.speed = 3 knot .. 5 knot; ropes.cable.length = 400 m .. 700 m")
  run("run", store)
  measure <- c("--measures", "total_drag_kN")
  effects <- utils::read.csv(text = run("effects", store, measure))
  expect_identical(unique(effects$field), c("towing.speed_knot", "ropes.cable.length_m"))
  pairs <- utils::read.csv(text = run("pairs", store, measure))
  expect_identical(nrow(pairs), 1L)
  indices <- utils::read.csv(text = run("indices", store, measure))
  expect_true(all(c("index", "lower", "upper") %in% names(indices)))
  picture <- file.path(test_folder(), "study.png")
  run("plot", store, measure, "--out", picture)
  expect_gt(file.size(picture), 1000)
  grid <- study_axes("a.b = 3, 4; c = 1 m .. 2 m; d = PA, PE")
  expect_identical(grid$a.b, c(3, 4))
  expect_identical(grid$d, c("PA", "PE"))
  expect_s3_class(grid$c, "codend_distribution")
})
