# Accepts a print that fits a screen and has not changed.
expect_screen <- function(x) {
  printed <- function(value) cat(utils::capture.output(print(value)), sep = "\n")
  testthat::expect_lte(length(utils::capture.output(print(x))), 30)
  testthat::expect_snapshot(printed(x))
}

trawl_state <- function() settled("poly_noreastern_trawl", nodes = 300)

cable_study <- function(...) {
  vary("towed_cable", designs(towing.speed = value_range("3 knot", "5 knot"),
    ropes.cable.length = value_range("400 m", "700 m"), ...), nodes = 50)
}

test_that("print() of variations shows main measures with certain digits", {
  found <- vary("poly_noreastern_trawl", towing.speed = c("2.5 knot", "3 knot"), nodes = 300)
  expect_screen(found)
  expect_screen(found[c("towing.speed_knot", "total_drag_kN")])
  # the drag in the first row, to the last digit of its error
  line <- grep("^ +2.5 ", capture.output(print(found)), value = TRUE)
  expect_match(line, paste0(" ", format(round(found$total_drag_kN[1], 1), nsmall = 1), "$"))
  # everything: each design and each measure in one of the blocks
  whole <- capture.output(print(found, n = Inf))
  expect_length(grep("^ +2.5 ", whole), sum(grepl("^ +knot", whole)))
  expect_gt(length(grep("^ +2.5 ", whole)), 3)
  expect_wrong(print(found, n = 0), "number of rows")
  withr::local_options(codend.units = c(speed = "m/s", force = "tonnef"))
  expect_match(capture.output(print(found))[5], "^ +m/s .* tonnef$")
})

test_that("print() of variations limits rows and lists problems", {
  many <- cable_study(how = "random", number = 25)
  many$settled[2:3] <- FALSE
  many$problem[2:3] <- "The gear did not settle."
  many$warning[4] <- "A board is stalled."
  expect_screen(many)
  expect_screen(summary(many))
})

test_that("print() of sensitivities sorts fields and omits negligible ones", {
  found <- sensitivities(trawl_state(), secants = FALSE)
  expect_screen(found)
  main <- found[found$measure %in% attr(found, "main"), ]
  largest <- tapply(abs(main$elasticity), main$field, max, na.rm = TRUE)
  rows <- sub("^ +([a-z._]+) .*", "\\1", capture.output(print(found)))
  shown <- intersect(rows, names(largest))
  expect_identical(order(-largest[shown]), seq_along(shown))
  expect_setequal(shown, names(largest)[largest >= 0.01])
  weak <- found[found$field == "otter_boards.mass" & found$measure == "mouth_area_m2", ]
  expect_screen(weak)
})

test_that("prints of effects fit a screen", {
  skip_if_not_installed("spacefillr")
  found <- cable_study(how = "indices", number = 8)
  expect_screen(effects(found))
  expect_screen(effects(found, what = "pairs"))
  expect_screen(effects(found, resamples = 50, what = "indices"))
})

test_that("print() of uncertainties shows main measures and largest sources", {
  expect_screen(uncertainty(trawl_state()))
})

test_that("prints of a calibration and its posterior fit a screen", {
  runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
  fit <- calibrate("towed_cable", runs, nodes = 50, match = Drag ~ total_drag_kN,
    change = list(ropes.cable.diameter = c("10 mm", "30 mm")))
  expect_screen(fit)
  expect_screen(summary(fit))
  skip_if_not_installed("mcmc")
  expect_screen(suppressWarnings(sample_posterior(fit, draws = 60, burn_in = 30)))
})

test_that("prints of an optimum and a trade-off fit a screen", {
  skip_if_not_installed("nloptr")
  change <- list(ropes.cable.length = c("600 m", "1200 m"), towing.speed = c("3 knot", "5 knot"))
  expect_screen(optimise_gear("towed_cable", minimise = ~ total_drag / towing.speed, nodes = 50,
    keep = ~ body_depth >= "450 m", change = change))
  expect_screen(trade_off("towed_cable", points = 3, nodes = 50, change = change[1L],
    minimise = list(drag = ~ total_drag_kN, depth = ~ -body_depth_m)))
})

test_that("summary() of a study counts designs", {
  skip_if_not_installed("RNetCDF")
  store <- file.path(test_folder(), "cable.study")
  vary("towed_cable", towing.speed = paste(3:6, "knot"), store = store, tasks = 0, nodes = 50)
  run_study(store, 1, 2)
  expect_screen(summary(read_result(store)))
})
