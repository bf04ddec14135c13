# A limit on file size simulates a full disk: the system returns the same short counts and errors to
# writers, with another reason.

test_that("write_file() replaces a file atomically and leaves nothing else", {
  folder <- test_folder()
  file <- file.path(folder, "100 %s.txt")
  writeLines("old", file)
  expect_identical(write_text("new", file), file)
  expect_identical(readLines(file, warn = FALSE), "new")
  expect_error(
    write_file(file, function(path) {
      writeLines("half", path)
      stop("no ink.")
    }), "no ink", class = "codend_error_file"
  )
  expect_error(write_file(file, function(path) NULL), "No such file", class = "codend_error_file")
  expect_identical(readLines(file, warn = FALSE), "new")
  dir.create(file.path(folder, "a folder"))
  error <- expect_error(write_text("x", file.path(folder, "a folder")), class = "codend_error_file")
  expect_match(conditionMessage(error), "a folder.*irectory")
  expect_setequal(list.files(folder, all.files = TRUE, no.. = TRUE), c("100 %s.txt", "a folder"))
})

test_that("write_file() replaces a folder as a whole", {
  folder <- file.path(test_folder(), "series")
  fill <- function(name) write_file(folder, function(path) {
    dir.create(path)
    writeLines("x", file.path(path, name))
  })
  fill("old")
  fill("new")
  expect_identical(list.files(folder), "new")
  expect_identical(list.files(dirname(folder), all.files = TRUE, no.. = TRUE), "series")
})

test_that("check_file_path() rejects a path before any computation", {
  folder <- test_folder()
  wrong <- function(file, message) {
    expect_error(check_file_path(file, ".csv"), message, class = "codend_error_file")
  }
  wrong(3, "one path")
  wrong(c("a.csv", "b.csv"), "one path")
  wrong("csv", "ends in")
  wrong("a.txt", "ends in")
  wrong(file.path(folder, "none", "a.csv"), "exists")
  expect_identical(check_file_path(file.path(folder, "a.CSV"), ".csv"), ".csv")
})

# Runs code in a separate R whose files are limited to so many kilobytes. Returns the lines that it
# prints.
limited <- function(kilobytes, code) {
  script <- tempfile(fileext = ".R")
  on.exit(unlink(script))
  writeLines(code, script)
  libraries <- paste(.libPaths(), collapse = .Platform$path.sep)
  # the signal of the limit would end R; without it writing fails as on a full disk
  line <- sprintf("trap '' XFSZ; ulimit -f %d; R_LIBS=%s exec %s %s", 2L * kilobytes,
    shQuote(libraries), shQuote(file.path(R.home("bin"), "Rscript")), shQuote(script))
  system2("sh", c("-c", shQuote(line)), stdout = TRUE, stderr = FALSE)
}

test_that("every writer keeps the old file and reports a full disk", {
  skip_on_os("windows")
  folder <- test_folder()
  calls <- c(
    "gear.yaml" = "write_gear(gear, file)", "state.vtu" = "write_result(state, file)",
    "state.glb" = "write_result(state, file)", "state.gltf" = "write_result(state, file)",
    "state.html" = "view_3d(state, file)", "report.html" = "report(state, file)",
    "state.png" = "plot(state, file = file)", "state.pdf" = "plot(state, file = file)",
    "state.svg" = "plot(state, file = file)"
  )
  if (requireNamespace("RNetCDF", quietly = TRUE)) {
    calls <- c(calls, "state.nc" = "write_result(state, file)",
      "tow.nc" = "write_result(trajectory, file)")
  }
  files <- file.path(folder, names(calls))
  for (file in files) writeLines("good", file)
  found <- limited(64, c(
    "library(codend)", "gear <- read_gear('midwater_trawl')", "state <- settle(gear, nodes = 300)",
    "trajectory <- tow('towed_cable', until = 10, every = 5)",
    "say <- function(e) cat(class(e)[1], gsub('[[:space:]]+', ' ', conditionMessage(e)), '\\n')",
    sprintf("file <- %s; tryCatch(%s, error = say)", vapply(files, deparse, ""), calls)
  ))
  expect_null(attr(found, "status"))
  expect_length(found, length(calls))
  expect_match(found, "^codend_error_file .*could not be written: File too large", all = TRUE)
  for (file in files) expect_identical(readLines(file), "good", label = file)
  expect_setequal(list.files(folder, all.files = TRUE, no.. = TRUE), names(calls))
})

test_that("tow() returns its result so far if writing fails", {
  skip_on_os("windows")
  skip_if_not_installed("RNetCDF")
  file <- file.path(test_folder(), "tow.nc")
  found <- limited(512, c(
    "library(codend)", sprintf("file <- %s", deparse(file)),
    "say <- function(e) cat(class(e)[1], e$why, e$trajectory$time[1:3], e$trajectory$end)",
    "tryCatch(tow('towed_cable', until = 60, every = 0.1, file = file), error = say)"
  ))
  expect_match(found, "^codend_error_file .* 0 0.1 0.2 interrupted$")
  kept <- read_result(file)
  expect_identical(kept$end, "interrupted")
  expect_gt(length(kept$time), 3)
})

test_that("written files do not depend on options, locale or time zone", {
  folder <- test_folder()
  state <- settled("towed_cable", nodes = 100)
  bytes <- function(name) {
    written <- list(
      yaml = write_gear(state$gear, file.path(folder, paste0(name, ".yaml"))),
      vtu = write_result(state, file.path(folder, paste0(name, ".vtu"))),
      gltf = write_result(state, file.path(folder, paste0(name, ".gltf"))),
      csv = write_csv(as.data.frame(state, what = "drag"), file.path(folder, paste0(name, ".csv")))
    )
    if (requireNamespace("RNetCDF", quietly = TRUE)) {
      written$nc <- write_result(state, file.path(folder, paste0(name, ".nc")))
    }
    lapply(written, function(file) readBin(file, "raw", file.size(file)))
  }
  usual <- bytes("usual")
  kept <- options(OutDec = ",", scipen = -9, digits = 3, encoding = "latin1")
  zone <- Sys.getenv("TZ", NA)
  collate <- Sys.getlocale("LC_COLLATE")
  on.exit({
    options(kept)
    if (is.na(zone)) Sys.unsetenv("TZ") else Sys.setenv(TZ = zone)
    Sys.setlocale("LC_COLLATE", collate)
  }, add = TRUE)
  Sys.setenv(TZ = "Pacific/Kiritimati")
  for (locale in c("C", "en_US.UTF-8", "et_EE.UTF-8")) {
    suppressWarnings(Sys.setlocale("LC_COLLATE", locale))
    expect_identical(bytes("other"), usual, label = locale)
    # the order of names must not depend on the locale either
    expect_identical(settle(read_gear("towed_cable"), nodes = 100)$position, state$position)
  }
})

test_that("write_text() writes through a link and keeps it", {
  skip_on_os("windows")
  folder <- test_folder()
  link <- file.path(folder, "link.csv")
  target <- file.path(folder, "deeper", "target.csv")
  dir.create(dirname(target))
  writeLines("old", target)
  file.symlink(file.path("deeper", "target.csv"), link)
  write_text("new", link)
  expect_identical(readLines(target, warn = FALSE), "new")
  expect_identical(Sys.readlink(link), file.path("deeper", "target.csv"))
  # a link to a missing file, and a circular link
  file.remove(target)
  write_text("made", link)
  expect_identical(readLines(target, warn = FALSE), "made")
  file.symlink("b", file.path(folder, "a"))
  file.symlink("a", file.path(folder, "b"))
  expect_error(write_text("x", file.path(folder, "a")), "circular", class = "codend_error_file")
})

test_that("write_file() removes files of dead processes only", {
  skip_on_os("windows")
  skip_if_not_installed("callr")
  folder <- test_folder()
  process <- callr::r_bg(function() Sys.sleep(60))
  on.exit(process$kill())
  gone <- callr::r_bg(function() NULL)
  gone$wait()
  left <- function(id, host = this_host()) {
    file <- file.path(folder, sprintf(".codend-%s-%d-1a2b", host, id))
    writeLines("half", file)
    Sys.setFileTime(file, Sys.time() - 2 * leftover_seconds)
    file
  }
  of_killed <- left(gone$get_pid())
  of_living <- left(process$get_pid())
  of_other <- left(gone$get_pid(), "elsewhere")
  young <- sub("1a2b$", "3c4d", of_killed)
  writeLines("half", young)
  write_text("x", file.path(folder, "a.txt"))
  expect_false(file.exists(of_killed))
  expect_true(all(file.exists(c(of_living, of_other, young))))
})

test_that("write_csv() quotes formulas and codend reads the strings back", {
  table <- data.frame(a = c("=1+1", "@SUM(A1)", "-2+3+cmd", "-5 deg", "+4.5 knot", "PE"),
    b = -(1:6))
  names(table)[2] <- "=HYPERLINK(0)"
  file <- tempfile(fileext = ".csv")
  write_csv(table, file)
  cells <- utils::read.csv(file, check.names = FALSE)
  expect_identical(cells$a, c("'=1+1", "'@SUM(A1)", "'-2+3+cmd", "-5 deg", "+4.5 knot", "PE"))
  expect_identical(names(cells)[2], "'=HYPERLINK(0)")
  expect_identical(cells[[2]], table[[2]])
  expect_identical(read_designs(file)$a, table$a)
})
