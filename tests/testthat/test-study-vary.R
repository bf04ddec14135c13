test_that("vary() gives each variation the result of a single settle()", {
  found <- vary("towed_cable", towing.speed = c("3 knot", "4 knot"),
    ropes.cable.length = c(300, 500, 700))
  expect_s3_class(found, "codend_variations")
  expect_equal(found[["towing.speed_knot"]], rep(c(3, 4), 3))
  expect_equal(found[["ropes.cable.length_m"]], rep(c(300, 500, 700), each = 2))
  expect_true(all(found$settled))
  for (row in c(2, 5)) {
    gear <- update(read_gear("towed_cable"),
      towing.speed = paste(found[["towing.speed_knot"]][row], "knot"),
      ropes.cable.length = found[["ropes.cable.length_m"]][row])
    alone <- measures(settle(gear))
    # both are settled to 1e-8 of the largest tension, from different starts
    expect_equal(unlist(found[row, names(alone)]), plain_measures(alone), tolerance = 1e-6)
    # a design with another shape has its own errors, close to the gear's errors
    error <- unlist(errors_by_design(found)[row, names(alone)])
    expect_true(all(is.finite(error)))
    main <- names(alone) %in% c("total_drag_kN", "body_depth_m")
    expect_lt(max((error / attr(alone, "error"))[main]), 10)
  }
  expect_output(print(summary(found)), "error")
  base <- measures(settle("towed_cable"))
  same <- vary("towed_cable", towing.speed = c("4 knot", "5 knot"))
  expect_equal(errors_by_design(same)$total_drag_kN / same$total_drag_kN,
    rep(attr(base, "error")[["total_drag_kN"]] / base[["total_drag_kN"]], 2), tolerance = 1e-6)
  expect_identical(
    vary("towed_cable", towing.speed = 2:3, ropes.cable.length = c(300, 500)),
    vary("towed_cable", towing.speed = 2:3, ropes.cable.length = c(300, 500))
  )
})

test_that("vary() changes fields of a data frame together and reports units", {
  found <- vary("crossing_cables", data.frame(
    ropes.south_1.length = c("4.1 m", "410 cm"), ropes.south_2.length = c("4.1 m", "4.2 m")
  ), ropes.west_1.material = "PA")
  expect_equal(nrow(found), 2L)
  # mixed units are converted to SI
  expect_equal(found[["ropes.south_1.length_m"]], c(4.1, 4.1))
  expect_equal(found[["ropes.south_2.length_m"]], c(4.1, 4.2))
  expect_identical(found[["ropes.west_1.material"]], c("PA", "PA"))
  found <- vary("towed_cable", towing.speed = 2, ropes.cable.material = "steel_wire")
  expect_named(found[1:2], c("towing.speed_m_per_s", "ropes.cable.material"))
  expect_identical(field_words(found, "towing.speed_m_per_s"), "towing speed (m/s)")
  expect_identical(field_words(found, "ropes.cable.material"), "ropes cable material")
})

test_that("vary() reports a design without convergence and continues", {
  failing <- function(gear, ...) {
    if (gear_si(gear)$towing$speed == 2) {
      cli::cli_abort("The gear did not settle: {.field test}.",
        class = c("codend_error_not_converged", "codend_error"), call = NULL)
    }
    cli::cli_warn("A board is {.field stalled}.", class = "codend_warning")
    settle(gear, ...)
  }
  package <- environment(run_design)
  single <- settle_one
  environment(single) <- list2env(list(settle = failing), parent = package)
  run <- run_design
  environment(run) <- list2env(list(settle_one = single), parent = package)
  study <- new_study("towed_cable", list(towing.speed = 1:3), 1500, NULL)
  found <- study_table(study, read_rows(vapply(3:1, function(k) run(study, NULL, k), "")))
  expect_identical(found$settled, c(TRUE, FALSE, TRUE))
  expect_identical(found$problem[2], "The gear did not settle: test.")
  expect_identical(found$warning[1], "A board is stalled.")
  expect_true(is.na(found$total_drag_kN[2]))
  alone <- measures(settle(update(read_gear("towed_cable"), towing.speed = 3)))
  expect_equal(unlist(found[3, names(alone)]), plain_measures(alone), tolerance = 1e-6)
})

test_that("vary() reports incompatible values in their row", {
  plan <- update(read_gear("towed_cable"), ropes.cable.segments = NULL)
  found <- vary(plan, towing.speed = "3 knot", ropes.cable.to = c(plan$plan$ropes$cable$to, "moon"))
  expect_identical(found$settled, c(TRUE, FALSE))
  expect_match(found$problem[2], "moon")
})

test_that("vary() keeps the plan's value for NA and joins fields", {
  gear <- read_gear("crossing_cables")
  both <- update(gear, ropes.south_1.length = 4.1, ropes.south_2.length = 4.1)
  found <- vary(gear, designs(data.frame(
    "ropes.south_1.length + ropes.south_2.length" = c("4.1 m", NA), check.names = FALSE
  )))
  for (row in 1:2) {
    alone <- measures(settle(list(both, gear)[[row]]))
    # both are settled to 1e-8 of the largest tension, from different starts
    expect_equal(unlist(found[row, names(alone)]), plain_measures(alone), tolerance = 1e-6)
  }
  found <- vary("towed_cable", designs(towing.speed = c("3 knot", "5 knot"),
    ropes.cable.length = c("300 m", "500 m"), how = "one_at_a_time"))
  # the plan's 4 knot and 1000 m
  expect_equal(found[["towing.speed_knot"]], c(4, 3, 5, 4, 4))
  expect_equal(found[["ropes.cable.length_m"]], c(1000, 1000, 1000, 300, 500))
})

test_that("vary() gives the same measures as settle() by default", {
  speed <- gear_si(read_gear("beam_trawl"))$towing$speed
  state <- settle("beam_trawl")
  expect_gt(state$mesh$nodes, 2500)
  found <- measures(state)
  by <- vary("beam_trawl", towing.speed = speed)
  expect_equal(unlist(as.data.frame(by, wide = TRUE)[names(found)]), plain_measures(found),
    tolerance = 1e-9)
  skip_if_not_installed("RNetCDF")
  store <- withr::local_tempfile(fileext = ".study")
  vary("beam_trawl", designs(towing.speed = speed), store = store, tasks = 0)
  run_study(store)
  stored <- read_result(store)
  expect_equal(unlist(stored[names(found)]), plain_measures(found), tolerance = 1e-9)
})
