# `codend export` as a shell runs it; the files are tested where they are written.

skip_if_not_installed("RNetCDF")

export <- function(..., command = "export") {
  script <- system.file("exec", "codend", package = "codend")
  err <- tempfile()
  on.exit(unlink(err))
  libraries <- paste(.libPaths(), collapse = .Platform$path.sep)
  status <- system2(
    file.path(R.home("bin"), "Rscript"), shQuote(c(script, command, ...)), stdout = FALSE,
    stderr = err, env = paste0("R_LIBS=", shQuote(libraries))
  )
  list(status = status, err = paste(readLines(err), collapse = " "))
}

test_that("a plan becomes files of every kind, and a kept state gives the same", {
  folder <- test_folder()
  files <- file.path(folder, c("cable.vtu", "cable.glb", "cable.nc", "cable.csv"))
  ran <- do.call(export, as.list(c("towed_cable", files, "--set", "towing.speed=2")))
  expect_identical(ran$status, 0L)
  expect_true(all(file.exists(files)))
  expect_identical(read_state(files[3])$si$towing$speed, 2)
  again <- file.path(folder, "again.vtu")
  expect_identical(export(files[3], again)$status, 0L)
  expect_identical(unname(tools::md5sum(again)), unname(tools::md5sum(files[1])))
})

test_that("a wrong use ends with status 2 before anything is settled", {
  folder <- test_folder()
  expect_identical(export("towed_cable")$status, 2L)
  wrong <- export("towed_cable", file.path(folder, "cable.obj"))
  expect_identical(wrong$status, 2L)
  expect_match(wrong$err, "must end in one of .vtu")
  expect_identical(export("towed_cable", file.path(folder, "cable.pvd"))$status, 2L)
  expect_identical(export("towed_cable", file.path(tempfile(), "cable.vtu"))$status, 2L)
  expect_identical(export("kept.nc", "--nodes", "9", file.path(folder, "a.vtu"))$status, 2L)
})

test_that("a plan is drawn in every format, on the sheet that is asked for", {
  folder <- test_folder()
  files <- file.path(folder, c("net.svg", "net.dxf"))
  ran <- export("gillnet", files, "--page", "A3", "--set", "wall.mesh_size=140 mm",
    command = "draw")
  expect_identical(ran$status, 0L)
  expect_true(all(file.exists(files)))
  svg <- paste(readLines(files[1]), collapse = "")
  expect_match(svg, "width=\"420mm\"", fixed = TRUE)
  expect_match(svg, ">140<", fixed = TRUE)
  wrong <- export("gillnet", file.path(folder, "net.jpg"), command = "draw")
  expect_identical(wrong$status, 2L)
  expect_match(wrong$err, "must end in one of .svg, .pdf, .png, .dxf", fixed = TRUE)
  expect_identical(export("gillnet", files[1], "--page", "B4", command = "draw")$status, 2L)
})
