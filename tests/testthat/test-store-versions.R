# Files in saved/ have the present formats: the flat panel with 40 nodes, the towed cable of 10
# segments towed for 20 s, and a study of six designs of which two are run. If a change of the mesh
# or of the saved fields makes a test fail, the format has changed: increase its number and replace
# the file.

test_that("read_result() reads a saved state of the present format", {
  skip_if_not_installed("RNetCDF")
  file <- test_path("saved", "state.nc")
  read <- read_result(file)
  nc <- RNetCDF::open.nc(file)
  on.exit(RNetCDF::close.nc(nc))
  places <- c("x_m", "y_m", "z_m")
  written <- do.call(rbind, lapply(places, function(name) RNetCDF::var.get.nc(nc, name)))
  expect_identical(matrix(read$position, 3L), unname(written))
  expect_identical(read$gear$plan$name, "Flat panel of netting")
  expect_true(settle(read$gear, nodes = 40, from = read)$report$converged)
})

test_that("tow() continues a saved tow of the present format", {
  skip_if_not_installed("RNetCDF")
  read <- read_result(test_path("saved", "tow.nc"))
  expect_identical(read$time, c(0, 5, 10, 15, 20))
  expect_identical(utils::tail(tow(read, until = 25)$time, 1L), 25)
})

test_that("run_study() continues a saved study of the present format", {
  skip_if_not_installed("RNetCDF")
  store <- file.path(test_folder(), "study")
  expect_true(file.copy(test_path("saved", "study"), dirname(store), recursive = TRUE))
  # git stores no empty folders
  for (folder in c("rows", "tasks", "claims")) {
    dir.create(file.path(store, folder), showWarnings = FALSE)
  }
  done <- read_result(store)
  expect_identical(attr(done, "study")$design, c(2L, 6L))
  # from version 0.1.0, to the accuracy of settled shapes
  expect_equal(done$ship_tension_kN, c(8.770061, 9.601878), tolerance = 1e-6)
  expect_equal(run_study(store), 4L)
  all <- read_result(store)
  expect_identical(all$settled, rep(TRUE, 6L))
  expect_equal(all$ship_tension_kN[c(2, 6)], done$ship_tension_kN)
})
