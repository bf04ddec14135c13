# A catch in netting during a tow.

# A codend of four square sheets with a catch, fixed open at its entrance and towed.
full_codend <- function(catch) {
  corners <- cbind(0, c(-0.4, 0.4, 0.4, -0.4), c(-0.4, -0.4, 0.4, 0.4) - 5)
  net <- list(
    mesh_size = 0.1, meshes = list(upper = 20, lower = 20, deep = 40), knotted = FALSE,
    twine = list(diameter = 0.003, axial_stiffness = 1e4, mass_per_length = 0.008),
    columns = 3, rows = 10
  )
  as_gear(bag_plan(net, corners, catch))
}

test_that("gear with a catch in netting remains settled in a tow", {
  for (catch in list(list(volume = 0.2), list(blocked_meshes = 10))) {
    state <- settle(full_codend(catch), nodes = 150)
    found <- tow(state, until = 10, every = 5)
    # settled to 1e-8 of the tension, front accurate to 1e-6 of the volume
    expect_lt(max(abs(found$position[, , 3] - (state$position - c(15, 0, 0)))), 1e-4)
    expect_equal(measures(state_at(found, 10)), measures(state), tolerance = 1e-4)
  }
})

test_that("catch growing by volume ends at the equilibrium from half volume", {
  growing <- data.frame(time = c(0, 20), value = c(1, 2))
  gear <- full_codend(list(volume = 0.15))
  found <- tow(gear, nodes = 150, until = 120, every = 20, schedule = tow_schedule(catch = growing))
  # a direct solve may reach another equilibrium of the bag
  twice <- settle(full_codend(list(volume = 0.3)), nodes = 150, from = settle(gear, nodes = 150))
  # the bag of 10 m is at rest within the accuracy of a step, 0.01 m
  expect_equal(measures(state_at(found, 120)), measures(twice), tolerance = 1e-3)
  expect_equal(found$catch_front[2, c(1, 2)], c(0.15, 0.3), tolerance = 1e-6)
  # half of the tow, and the continued tow
  half <- tow(gear, nodes = 150, until = 60, every = 20, schedule = tow_schedule(catch = growing))
  on <- tow(half, until = 120)
  expect_equal(on$position, found$position, tolerance = 1e-3)
  skip_if_not_installed("RNetCDF")
  file <- file.path(test_folder(), "tow.nc")
  write_result(half, file)
  expect_identical(tow(read_result(file), until = 120)$position, on$position)
})

test_that("catch growing by meshes has the scheduled front", {
  found <- tow(full_codend(list(blocked_meshes = 8)), nodes = 150, until = 20, every = 10,
    schedule = tow_schedule(catch = data.frame(time = c(0, 20), value = c(1, 1.25))))
  expect_equal(found$catch_front[1, ], c(8, 9, 10))
  expect_true(all(diff(found$catch_front[2, ]) > 0))
})

test_that("catch has the mass of its displaced water", {
  state <- settle(full_codend(list(volume = 0.2)), nodes = 150)
  mass <- catch_masses(state$si, state$mesh, 0.2)
  expect_equal(sum(mass - engine_array(state, "mass")), 1025 * 0.2, tolerance = 1e-5)
  expect_true(all(mass >= engine_array(state, "mass")))
})

test_that("tow() rejects impossible catches by name", {
  gear <- full_codend(list(volume = 0.2))
  expect_wrong(tow(gear, nodes = 150, until = 4, schedule = tow_schedule(catch = -1)), "`catch`")
  expect_wrong(tow(settle(gear, nodes = 150), until = 4,
    schedule = tow_schedule(catch = 2)), "`state` has another catch")
  full <- data.frame(time = c(0, 1), value = c(1, 1000))
  expect_refused(tow(settle(gear, nodes = 150), until = 4,
    schedule = tow_schedule(catch = full)), "holds at most")
})

test_that("tow() with a growing catch starts from a plan and continues", {
  go <- function(until) {
    tow("t90_codend", nodes = 300, until = until, every = 10,
      schedule = tow_schedule(catch = data.frame(time = c(0, 40), value = c(0.5, 1))))
  }
  whole <- go(40)
  half <- tow(go(20), until = 40)
  # 1 % of a movement of 1 m, and whole meshes
  expect_equal(half$position, whole$position, tolerance = 1e-3)
  expect_equal(half$catch_front, whole$catch_front, tolerance = 0.01)
})
