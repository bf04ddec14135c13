# Files in kept/ were written by codend 0.1.0.9000: the flat panel with 40 nodes and the towed cable of 10
# segments, towed for 20 s. They stay as they are; the number in a name is its format's (state.nc and
# tow.nc: 2 and 4). Where a change of the lattice or the engine's arrays makes this test fail, the format
# has changed: count its version up and add files of the new one.

kept_file <- function(name) test_path("kept", name)

format_of <- function(file, what) {
  nc <- RNetCDF::open.nc(file)
  on.exit(RNetCDF::close.nc(nc))
  RNetCDF::att.get.nc(nc, "NC_GLOBAL", what)
}

test_that("files of earlier versions are read, or refused by the number of their format", {
  skip_if_not_installed("RNetCDF")
  formats <- numeric()
  for (state in kept_files("state")) {
    formats <- c(formats, format_of(state, "codend_state"))
  if (format_of(state, "codend_state") == state_file_version) {
    read <- read_state(state)
    nc <- RNetCDF::open.nc(state)
    written <- rbind(RNetCDF::var.get.nc(nc, "x"), RNetCDF::var.get.nc(nc, "y"),
      RNetCDF::var.get.nc(nc, "z"))
    RNetCDF::close.nc(nc)
    expect_identical(matrix(read$position, 3L), unname(written))
    expect_identical(read$gear$plan$name, "Flat panel of netting")
    expect_true(settle(read$gear, nodes = 40, from = read)$report$converged)
  } else {
    expect_error(read_state(state), "is of format", class = "codend_error_file")
  }
  tow <- kept_file("tow.nc")
  if (format_of(tow, "codend_trajectory") == trajectory_file_version) {
    read <- read_trajectory(tow)
    expect_identical(read$time, c(0, 5, 10, 15, 20))
    expect_identical(utils::tail(tow(read, until = 25)$time, 1L), 25)
  } else {
    expect_error(read_trajectory(tow), "is of format", class = "codend_error_file")
  }
})

test_that("plans of earlier versions are read", {
  # the plan in a file of this version is text of its time
  skip_if_not_installed("RNetCDF")
  for (name in c("state.nc", "tow.nc")) {
    nc <- RNetCDF::open.nc(kept_file(name))
    text <- RNetCDF::att.get.nc(nc, "NC_GLOBAL", "plan")
    RNetCDF::close.nc(nc)
    expect_s3_class(read_text(text), "codend_gear")
  }
})
