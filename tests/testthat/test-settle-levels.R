# Mesh levels from coarse to fine, and solves from a state.

test_that("mesh levels and the crude start reach the same equilibrium", {
  gear <- read_gear("midwater_trawl")
  state <- settle(gear, nodes = 1500, netting = "bars")
  crude <- settle_numbers(gear_si(gear), 1500, "bars", through_levels = FALSE)
  expect_true(crude$report$converged)
  # Residual of 1e-8 of the largest tension; slack twine has little stiffness.
  expect_equal(crude$position, as.vector(state$position), tolerance = 1e-6)
  expect_lte(state$report$iterations, crude$report$iterations)
})

test_that("settle() from a state handles another speed, warp or finer mesh", {
  gear <- read_gear("midwater_trawl")
  state <- settled("midwater_trawl", nodes = 500)
  # Steps from the state and from a crude start when this was written: 8 and 25, 25 and 23.
  share <- c("4.6 knot" = 1 / 2, "5 knot" = 1.25)
  for (speed in names(share)) {
    faster <- update(gear, towing = list(speed = speed))
    near <- settle(faster, nodes = 500, from = state)
    anew <- settle(faster, nodes = 500)
    expect_equal(measures(near), measures(anew), tolerance = 1e-5)
    crude <- settle_numbers(gear_si(faster), 500, NULL, through_levels = FALSE)
    expect_lt(near$report$factorisations, share[[speed]] * crude$report$factorisations)
  }

  # If the net kept its position it would be torn: 60 steps and more, for 10 or 30 % more warp.
  longer <- update(gear, warps.length = "910 m")
  near <- settle(longer, nodes = 500, from = state)
  expect_lte(near$report$iterations, 40)
  expect_equal(measures(near)[["door_spread_m"]],
    measures(settle(longer, nodes = 500))[["door_spread_m"]], tolerance = 1e-5)

  finer <- settle(gear, nodes = 1500, from = state)
  expect_gt(engine_array(finer, "nodes"), 1000)
  expect_equal(
    measures(finer)[["total_drag_kN"]], measures(settled("midwater_trawl"))[["total_drag_kN"]],
    tolerance = 1e-6
  )
})

test_that("settle() from a state falls back if its steps diverge", {
  state <- settled("midwater_trawl", nodes = 500)
  # at its old position, the net is torn between ropes a seventh as long
  gear <- update(state$gear, warps.length = "100 m")
  near <- settle(gear, nodes = 500, from = state)
  mesh <- build_mesh(gear_si(gear), 500, NULL, state_shape(state))
  expect_identical(near$mesh$model$bars, mesh$model$bars)
  # the same numbers from a start that was never settled
  bare <- engine_settle(mesh$model, as.double(mesh$start), "crude", numeric(),
    line_part(mesh), settle_tolerance, settle_iterations, function(...) NULL)
  expect_equal(as.double(near$position), bare$position, tolerance = 1e-6)
})

test_that("codend filled in steps is flat, filled at once it is round", {
  codend <- read_gear("t90_codend")
  filled <- function(meshes, from = NULL, speed = "3 knot") {
    gear <- update(codend, catch.blocked_meshes = meshes, towing.speed = speed)
    # a warning would report an unstable shape
    expect_no_warning(settle(gear, 1500, from = from), class = "codend_warning_catch_unstable")
  }
  volume <- function(state) measures(state)[["catch_volume_m3"]]
  round <- filled(9)
  # with 4 meshes it is flat
  flat <- Reduce(function(state, meshes) filled(meshes, state), 5:9, filled(4))
  expect_identical(flat$gear$plan, round$gear$plan)
  expect_lt(volume(flat), 0.7 * volume(round))
  # each is found from its own state in another flow, and back
  for (state in list(flat, round)) {
    back <- filled(9, filled(9, state, "3.03 knot"))
    expect_equal(volume(back), volume(state), tolerance = 1e-6)
  }
  # a study does not depend on the order of its designs
  study <- vary(codend, catch.blocked_meshes = c(8, 9), nodes = 1500)
  expect_equal(study$catch_volume_m3, c(volume(filled(8)), volume(round)), tolerance = 1e-6)
})
