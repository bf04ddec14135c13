# Files in kept/ were written by codend 0.1.0.9000: the flat panel with 40 nodes and the towed cable
# of 10 segments, towed for 20 s. The number in a name is its format's. They stay as they are. Where
# a change of the mesh or of what a file keeps makes this test fail, the format has changed: count
# its version up and add files of the new one. plans-0.1.0 has the shipped plans of that version,
# without their remarks; study-1 a study of six designs of which two are run.

kept_files <- function(what) {
  list.files(test_path("kept"), paste0("^", what, "-[0-9]+[.]nc$"), full.names = TRUE)
}

format_of <- function(file, what) {
  nc <- RNetCDF::open.nc(file)
  on.exit(RNetCDF::close.nc(nc))
  as.double(RNetCDF::att.get.nc(nc, "NC_GLOBAL", what))
}

test_that("files of earlier versions are read, or refused by the number of their format", {
  skip_if_not_installed("RNetCDF")
  formats <- numeric()
  for (file in kept_files("state")) {
    formats <- c(formats, format_of(file, "codend_state"))
    if (!utils::tail(formats, 1L) %in% kept_versions$state) {
      expect_error(read_result(file), "is of format", class = "codend_error_file")
      next
    }
    read <- read_result(file)
    nc <- RNetCDF::open.nc(file)
    written <- rbind(RNetCDF::var.get.nc(nc, "x"), RNetCDF::var.get.nc(nc, "y"),
      RNetCDF::var.get.nc(nc, "z"))
    RNetCDF::close.nc(nc)
    expect_identical(matrix(read$position, 3L), unname(written))
    expect_identical(read$gear$plan$name, "Flat panel of netting")
    expect_true(settle(read$gear, nodes = 40, from = read)$report$converged)
  }
  # the present one is among them
  expect_identical(max(formats), as.double(max(kept_versions$state)))
})

test_that("tows of earlier versions are read, or refused by the number of their format", {
  skip_if_not_installed("RNetCDF")
  formats <- numeric()
  for (file in kept_files("tow")) {
    formats <- c(formats, format_of(file, "codend_trajectory"))
    if (!utils::tail(formats, 1L) %in% kept_versions$trajectory) {
      expect_error(read_result(file), "is of format", class = "codend_error_file")
      next
    }
    read <- read_result(file)
    expect_identical(read$time, c(0, 5, 10, 15, 20))
    expect_identical(utils::tail(tow(read, until = 25)$time, 1L), 25)
  }
  expect_identical(max(formats), as.double(max(kept_versions$trajectory)))
})

test_that("a moment of a tow from an earlier version has the measures of its tow", {
  skip_if_not_installed("RNetCDF")
  tow <- read_result(test_path("kept", "tow-11.nc"))
  moment <- read_result(test_path("kept", "moment-8.nc"))
  expect_identical(moment$time, 20)
  expect_identical(measures(moment), measures(state_at(tow, 20)))
})

test_that("plans of earlier versions are read", {
  # the plan in a file of this version is text of its time
  skip_if_not_installed("RNetCDF")
  for (file in c(kept_files("state"), kept_files("tow"))) {
    nc <- RNetCDF::open.nc(file)
    text <- RNetCDF::att.get.nc(nc, "NC_GLOBAL", "plan")
    RNetCDF::close.nc(nc)
    expect_s3_class(read_text(text), "codend_gear")
  }
})

test_that("shipped plans of earlier versions are read, each to the gear that it says", {
  files <- list.files(test_path("kept", "plans-0.1.0"), full.names = TRUE)
  expect_gt(length(files), 15L)
  for (file in files) {
    read <- read_gear(file)
    expect_identical(read_text(paste(format(read), collapse = "\n"))$plan, read$plan)
    expect_gt(length(gear_si(read)$points), 0L)
  }
})

test_that("studies of earlier versions are read and go on", {
  skip_if_not_installed("RNetCDF")
  # rows of the first format carry no checksum of their study
  expect_error(read_study(test_path("kept", "study-1")), "of another format",
    class = "codend_error_file")
  for (version in 2:study_file_version) {
    name <- paste0("study-", version)
    store <- file.path(test_folder(), name)
    expect_true(file.copy(test_path("kept", name), dirname(store), recursive = TRUE))
    for (folder in c("rows", "tasks", "claims")) {
      dir.create(file.path(store, folder), showWarnings = FALSE)
    }
    expect_identical(jsonlite::read_json(file.path(store, "study.json"))$codend_study, version)
    done <- read_study(store)
    expect_identical(attr(done, "study")$design, c(2L, 6L))
    # What version 2 gave on the day: to the accuracy of settled shapes.
    expect_equal(done$ship_tension_kN, c(8.770061, 9.601878), tolerance = 1e-6)
    expect_equal(run_study(store), 4L)
    all <- read_study(store)
    expect_identical(all$settled, rep(TRUE, 6L))
    expect_equal(all$ship_tension_kN[c(2, 6)], done$ship_tension_kN)
  }
})
