# Runs exec/codend in a shell. Numbers are tested where they are computed; these tests check exit
# status, output and files.

script <- system.file("exec", "codend", package = "codend")
libraries <- paste(.libPaths(), collapse = .Platform$path.sep)

command <- function(..., env = character()) {
  out <- tempfile()
  err <- tempfile()
  on.exit(unlink(c(out, err)))
  status <- system2(
    file.path(R.home("bin"), "Rscript"), shQuote(c(script, ...)), stdout = out, stderr = err,
    # without a locale, as in most containers
    env = c(paste0("R_LIBS=", shQuote(libraries)), "LC_ALL=C", env)
  )
  list(status = status, out = readLines(out), err = readLines(err))
}

# Expects one readable line without a message of R itself.
expect_one_message <- function(ran, status, pattern) {
  expect_identical(ran$status, status)
  expect_identical(ran$out, character())
  expect_match(paste(ran$err, collapse = " "), pattern)
  expect_false(any(grepl("Error in|Traceback|Execution halted|Calls:", ran$err)))
}

test_that("installed script is executable", {
  skip_on_os("windows")
  expect_identical(unname(file.access(script, 1L)), 0L)
})

test_that("help and version go to standard output", {
  help <- command("settle", "--help")
  expect_identical(help$status, 0L)
  expect_match(help$out[1], "Usage: codend settle", fixed = TRUE)
  expect_identical(command("--version")$out, paste("codend", packageVersion("codend")))
})

test_that("command exits with 2 for wrong use and 1 for plans", {
  expect_one_message(command(), 2L, "Usage: codend COMMAND")
  expect_one_message(command("settle", "towed_cable", "--nodes", "many"), 2L, "--nodes is many")
  expect_one_message(command("check", "towed_cabel"), 1L, "towed_cable")
})

test_that("check, gears and expand commands show plans", {
  expect_match(command("check", "towed_cable")$out[1], "Towed cable with a sphere")
  changed <- command("check", "towed_cable", "--set", "name=Another")
  expect_match(changed$out[1], "Another")
  shown <- command("gears")$out
  for (name in gears()$name) expect_true(any(startsWith(shown, name)))
  plan <- tempfile(fileext = ".yaml")
  on.exit(unlink(plan))
  writeLines(command("expand", "towed_cable")$out, plan)
  expect_identical(read_gear(plan)$plan, assembly(read_gear("towed_cable"))$plan)
})

test_that("settle command applies the last value of fields and writes JSON", {
  ran <- command(
    "settle", "towed_cable", "--nodes=60", "--set", "towing.speed=2 knot",
    "--set=ropes.cable.length=800", "--set", "towing.speed=3 knot", "--json", "-"
  )
  expect_identical(ran$status, 0L)
  record <- jsonlite::fromJSON(ran$out)
  expect_true(record$converged)
  expect_identical(record$plan$ropes$cable$length, 800L)
  expect_identical(record$plan$towing$speed, "3 knot")
  gear <- update(
    read_gear("towed_cable"), towing.speed = "3 knot", ropes.cable.length = "800 m"
  )
  state <- settle(gear, nodes = 60)
  expect_identical(vapply(record$measures, `[[`, 0, "value"), plain_measures(measures(state)))
  expect_identical(record$variables$z_m$values, state$position[3, ])
})

test_that("settle command without convergence exits with 1 and writes JSON", {
  file <- tempfile(fileext = ".json")
  out <- tempfile()
  on.exit(unlink(file))
  # heavier than any gear
  ran <- command(
    "settle", "towed_cable", "--set", "pieces.sphere.mass=1e12", "--json", file, "--out", out
  )
  expect_one_message(ran, 1L, "did not settle: after [0-9]+ iterations")
  record <- jsonlite::fromJSON(file)
  expect_false(record$converged)
  expect_named(record, c("codend", "converged", "iterations", "residual", "message"))
  expect_match(record$message, "did not settle")
  expect_gt(record$residual, 1e-8)
  expect_false(dir.exists(out))
})

test_that("settle command writes pictures and tables", {
  out <- file.path(tempfile(), "deep")
  on.exit(unlink(dirname(out), recursive = TRUE))
  ran <- command("settle", "crossing_cables", "--out", out)
  expect_identical(ran$status, 0L)
  expect_setequal(list.files(out, all.files = TRUE, no.. = TRUE), c(
    "xy.png", "xz.png", "yz.png", "view.html", "tensions.csv", "measures.csv"
  ))
  for (plane in c("xy.png", "xz.png", "yz.png")) {
    expect_identical(readBin(file.path(out, plane), "raw", 4L), as.raw(c(0x89, 0x50, 0x4e, 0x47)))
  }
  expect_match(paste(ran$out, collapse = "\n"), "Measures")
})

test_that("report command writes one page of the changed plan", {
  folder <- tempfile()
  dir.create(folder)
  on.exit(unlink(folder, recursive = TRUE))
  file <- file.path(folder, "cable.html")
  ran <- command("report", "towed_cable", "--out", file, "--set", "towing.speed=5 knot")
  expect_identical(ran$status, 0L)
  expect_identical(ran$err, paste("Written:", file))
  page <- paste(readLines(file, warn = FALSE), collapse = " ")
  expect_match(page, "Towed at 5 knot", fixed = TRUE)
  expect_identical(list.files(folder), "cable.html")
})

test_that("tow command writes tables, a plot, a page and a trajectory", {
  out <- file.path(tempfile(), "deep")
  on.exit(unlink(dirname(out), recursive = TRUE))
  ran <- command("tow", "towed_cable", "--nodes", "20", "--until", "20 s", "--every", "10 s",
    "--out", out)
  expect_identical(ran$status, 0L)
  expect_match(paste(ran$out, collapse = "\n"), "20 s, 3 states")
  wanted <- c("measures.csv", "conditions.csv", "tensions.csv", "measures.png", "view.html")
  has_netcdf <- requireNamespace("RNetCDF", quietly = TRUE)
  expect_setequal(
    list.files(out, all.files = TRUE, no.. = TRUE), c(wanted, if (has_netcdf) "trajectory.nc")
  )
  expect_identical(unique(utils::read.csv(file.path(out, "measures.csv"))$time_s), c(0L, 10L, 20L))
  skip_if_not(has_netcdf)
  expect_identical(read_result(file.path(out, "trajectory.nc"))$time, c(0, 10, 20))
})

test_that("command output does not depend on the R profile or time zone", {
  folder <- test_folder()
  profile <- file.path(folder, "profile.R")
  writeLines("options(OutDec = ',', scipen = -9, digits = 4)", profile)
  made <- function(name, ...) {
    out <- file.path(folder, name)
    settled <- command("settle", "towed_cable", "--out", out, env = c(...))
    expect_identical(settled$status, 0L)
    slopes <- command("sensitivities", "towed_cable", env = c(...))
    expect_identical(slopes$status, 0L)
    files <- dir(out, "[.](csv|html)$", full.names = TRUE)
    # one line reports the CPU time
    said <- grep("CPU", settled$out, value = TRUE, invert = TRUE)
    c(said, slopes$out, unname(tools::md5sum(files)))
  }
  expect_identical(
    made("profile", paste0("R_PROFILE_USER=", profile), "TZ=Asia/Kathmandu"), made("plain")
  )
})
