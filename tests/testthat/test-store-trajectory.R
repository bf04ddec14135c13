skip_if_not_installed("RNetCDF")

# A weight on a cable with a slipping winch, and a rope behind it that breaks.
hauled_plan <- list(
  codend = 1, name = "Hauled \u00e5 weight", towing = list(speed = 2),
  points = list(ship = list(position = c(0, 0, 0), held = "moved"), body = list()),
  ropes = list(
    cable = list(
      from = "ship", to = "body", length = 60, diameter = 0.012, axial_stiffness = 2e6,
      mass_per_length = 0.4, segments = 12, role = "warp", strength = 5e3
    ),
    tail = list(
      from = "body", to = "end", length = 5, diameter = 0.01, axial_stiffness = 1e5,
      mass_per_length = 0.1, segments = 4
    )
  ),
  pieces = list(weight = list(at = "body", mass = 100, volume = 0.02, drag_area = 0.05))
)
hauled_plan$points$end <- list(load = c(200, 0, 0))

hauled <- function(...) {
  tow(as_gear(hauled_plan), every = 5,
    schedule = tow_schedule(speed = data.frame(time = c(0, 20), value = c(2, 3)),
    winch = list(speed_limit = 0.5, tension_limit = 1000),
    breaking = list(list(rope = "tail", time = 12))), ...)
}

known <- function(trajectory) unclass(plain_result(trajectory))

test_that("saved tow is read back identically", {
  folder <- test_folder()
  file <- file.path(folder, "tow.nc")
  trajectory <- hauled(until = 30)
  expect_identical(write_result(trajectory, file), file)
  expect_gt(max(trajectory$winch_length), 60)
  expect_identical(known(read_result(file)), known(trajectory))
  expect_equal(list.files(folder, all.files = TRUE, no.. = TRUE), "tow.nc")

  netting <- tow("midwater_trawl", until = 0.2, every = 0.1, nodes = 300, netting = "cells",
    step = 0.1)
  expect_gt(length(netting$u_tension), 0)
  write_result(netting, file)
  expect_identical(known(read_result(file)), known(netting))
  expect_identical(nrow(netting$straight_tension), 0L)
})

test_that("saved tow includes straight bars of hexagonal netting", {
  plan <- panel_in_current_plan
  plan$panels$net[c("orientation", "straight_bar", "netting")] <- list("hexagonal", 0.02, "cells")
  trajectory <- tow(as_gear(plan), until = 0.2, every = 0.1, nodes = 100)
  state <- state_at(trajectory, 0.2)
  # recomputed from positions and velocities that are rotated into the vessel's axes and back
  expect_equal(trajectory$straight_tension[, 3], state$straight_tension, tolerance = 1e-8)
  expect_gt(max(trajectory$straight_tension), 0)
  tensions <- as.data.frame(trajectory, what = "tensions")
  held <- c(trajectory$u_tension[, 1], trajectory$v_tension[, 1], trajectory$straight_tension[, 1])
  # meshes of 100 mm with straight bars of 20 mm have oblique bars of 30 mm
  long <- outer(state$mesh$model$frame$cells$bars, c(0.03, 0.03, 0.02))
  expect_equal(tensions$mean_kN[tensions$part == "net"][1],
    sum(held * long) / sum(long) / 1000)
  file <- file.path(test_folder(), "tow.nc")
  write_result(trajectory, file)
  expect_identical(known(read_result(file)), known(trajectory))
})

test_that("saved tow keeps errors of measures and friction anchors", {
  trawl <- tow("poly_noreastern_trawl", nodes = 300, until = 2, every = 1)
  file <- file.path(test_folder(), "tow.nc")
  write_result(trawl, file)
  read <- read_result(file)
  expect_gt(length(trawl$memory$done$anchor), 0)
  expect_identical(read$memory$done, trawl$memory$done)
  error <- attr(measures(state_at(trawl, 2)), "error")
  expect_true(all(is.finite(error)))
  expect_identical(attr(measures(state_at(read, 2)), "error"), error)
})

test_that("tow() continues from a file as from its trajectory", {
  file <- file.path(test_folder(), "tow.nc")
  half <- hauled(until = 15)
  write_result(half, file)
  on <- tow(read_result(file), until = 30, file = file)
  expect_identical(known(on), known(tow(half, until = 30)))
  expect_identical(known(read_result(file)), known(on))
})

test_that("saved tow is plain NetCDF", {
  file <- file.path(test_folder(), "tow.nc")
  trajectory <- hauled(until = 10, file = file)
  nc <- RNetCDF::open.nc(file)
  on.exit(RNetCDF::close.nc(nc))
  expect_equal(as.vector(RNetCDF::var.get.nc(nc, "time")), c(0, 5, 10))
  expect_identical(RNetCDF::var.get.nc(nc, "z_m"), trajectory$position[3, , ])
  expect_identical(RNetCDF::var.get.nc(nc, "bar_tension_N"), trajectory$bar_tension)
  expect_equal(as.vector(RNetCDF::var.get.nc(nc, "vessel_x_m")), trajectory$conditions$x)
  expect_equal(RNetCDF::att.get.nc(nc, "z_m", "units"), "m")
  expect_equal(RNetCDF::att.get.nc(nc, "z_velocity_m_per_s", "units"), "m s-1")
  part <- as.vector(RNetCDF::var.get.nc(nc, "part"))[RNetCDF::var.get.nc(nc, "bar_part")]
  expect_equal(part, rep(c("cable", "tail"), c(12, 4)))
  plan <- file.path(dirname(file), "plan.yaml")
  writeBin(charToRaw(RNetCDF::att.get.nc(nc, "NC_GLOBAL", "plan")), plan)
  expect_identical(read_gear(plan)$plan, trajectory$gear$plan)
})

test_that("xarray opens a tow with its measures over time", {
  skip_if_not(has_python("xarray") && has_python("netCDF4"), "xarray is not installed")
  file <- file.path(test_folder(), "tow.nc")
  trajectory <- hauled(until = 10)
  write_result(trajectory, file)
  found <- read_with_python(file,
    "import json, sys, xarray",
    "data = xarray.open_dataset(sys.argv[1])",
    "drag = data['total_drag_kN']",
    "print(json.dumps({'z': data['z_m'].values.tolist(), 'drag': drag.values.tolist(),",
    "  'units': drag.attrs['units'], 'across': list(drag.dims),",
    "  'names': [str(data[v].attrs.get('standard_name'))",
    "    for v in ['time', 'vessel_speed_m_per_s']]}))"
  )
  expect_identical(found$z, t(trajectory$position[3, , ]))
  table <- as.data.frame(trajectory, what = "measures")
  expect_identical(found$drag, table$value[table$measure == "total_drag_kN"])
  expect_identical(found[c("units", "across")], list(units = "kN", across = "time"))
  expect_identical(found$names, c("time", "platform_speed_wrt_ground"))
})

# Pays out slowly. If requested, sends its own process a signal between the states of 15 and 20 s.
steered <- function(plan, file) {
  control <- function(measures, time) {
    signal <- Sys.getenv("CODEND_TEST_SIGNAL")
    if (time > 17 && nzchar(signal)) tools::pskill(Sys.getpid(), as.integer(signal))
    0.1
  }
  codend::tow(plan, until = 30, every = 5,
    schedule = codend::tow_schedule(control = control, control_every = 6), file = file)
}
environment(steered) <- globalenv()

# Runs it in a separate process; returns list(status, end = end of its trajectory).
signalled <- function(plan, folder, file, signal) {
  saveRDS(steered, file.path(folder, "run.rds"))
  script <- file.path(folder, "run.R")
  path <- function(name) deparse(file.path(folder, name))
  writeLines(c(
    sprintf("found <- readRDS(%s)(%s, %s)", path("run.rds"), deparse(plan), deparse(file)),
    sprintf("writeLines(found$end, %s)", path("end.txt"))
  ), script)
  libraries <- paste(.libPaths(), collapse = .Platform$path.sep)
  status <- system2(file.path(R.home("bin"), "Rscript"), shQuote(script), stdout = FALSE,
    stderr = FALSE,
    env = c(paste0("CODEND_TEST_SIGNAL=", signal), paste0("R_LIBS=", shQuote(libraries))))
  end <- file.path(folder, "end.txt")
  list(status = status, end = if (file.exists(end)) readLines(end))
}

test_that("interrupted tow returns its result and continues from its file", {
  skip_on_os("windows")
  folder <- test_folder()
  file <- file.path(folder, "tow.nc")
  plan <- write_gear(as_gear(hauled_plan), file.path(folder, "plan.yaml"))
  expect_identical(
    signalled(plan, folder, file, tools::SIGINT), list(status = 0L, end = "interrupted")
  )
  found <- read_result(file)
  expect_identical(found$end, "interrupted")
  expect_identical(found$time, c(0, 5, 10, 15))
  whole <- steered(plan, NULL)
  expect_wrong(tow(found, until = 30), "`control` was a function.*give it again")
  control <- function(measures, time) 0.1
  on <- tow(found, until = 30, schedule = tow_schedule(control = control), file = file)
  # both have errors of steps of 0.01 m, on some 50 m
  expect_equal(on$position, whole$position, tolerance = 1e-3)
  same <- setdiff(names(whole), "given")
  expect_identical(known(read_result(file))[same], known(on)[same])
})

test_that("killed tow leaves its saved steps and continues from them", {
  folder <- test_folder()
  file <- file.path(folder, "tow.nc")
  plan <- write_gear(as_gear(hauled_plan), file.path(folder, "plan.yaml"))
  ran <- signalled(plan, folder, file, tools::SIGKILL)
  expect_false(ran$status == 0)
  expect_null(ran$end)
  found <- read_result(file)
  expect_identical(found$end, "interrupted")
  expect_identical(found$time, c(0, 5, 10, 15))
  whole <- steered(plan, NULL)
  on <- tow(found, until = 30, schedule = tow_schedule(control = function(measures, time) 0.1))
  expect_equal(on$position, whole$position, tolerance = 1e-3)

  # an incomplete record: its numbers are there, but its mark is not
  nc <- RNetCDF::open.nc(file, write = TRUE)
  RNetCDF::var.put.nc(nc, "time", 20, 5, 1)
  RNetCDF::var.put.nc(nc, "resume_now_time", 20, 2, 1)
  RNetCDF::close.nc(nc)
  expect_identical(read_result(file)[c("time", "memory")], found[c("time", "memory")])

  # if the machine stopped too, the end of the file may not have reached the disk
  bytes <- readBin(file, "raw", file.size(file))
  for (lost in c(1, 100, 500)) {
    cut <- file.path(folder, "cut.nc")
    writeBin(utils::head(bytes, -lost), cut)
    expect_identical(read_result(cut)$time, found$time)
  }
  writeBin(utils::head(bytes, -(length(bytes) %/% 2)), cut)
  expect_error(read_result(cut), class = "codend_error_file")
})

test_that("unwritable files throw an error and leave nothing", {
  folder <- test_folder()
  trajectory <- hauled(until = 5)
  wrong <- function(code) expect_error(code, class = "codend_error_file")
  wrong(write_result(trajectory, file.path(folder, "tow.csv")))
  wrong(write_result(trajectory, file.path(folder, "no", "tow.nc")))
  wrong(tow(trajectory, until = 10, file = 3))
  expect_error(write_result(list(), file.path(folder, "tow.nc")), class = "codend_error")
  expect_length(list.files(folder, all.files = TRUE, no.. = TRUE), 0)
})
