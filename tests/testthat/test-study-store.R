skip_if_not_installed("RNetCDF")

small_study <- function() {
  designs(towing.speed = c("3 knot", "4 knot", "5 knot"), ropes.cable.length = c("300 m", "500 m"))
}

test_that("study on disk equals the study in memory to the last bit", {
  store <- file.path(test_folder(), "a.study")
  alone <- vary("towed_cable", small_study())
  expect_identical(vary("towed_cable", small_study(), store = store), alone)
  expect_identical(read_result(store), alone)
  # again: no design is left to run
  before <- file.mtime(list.files(store, recursive = TRUE, full.names = TRUE))
  expect_identical(vary("towed_cable", small_study(), store = store), alone)
  expect_identical(file.mtime(list.files(store, recursive = TRUE, full.names = TRUE)), before)
})

test_that("store returns designs of every kind unchanged", {
  store <- file.path(test_folder(), "a.study")
  table <- data.frame(
    towing.speed = c(pi / 2, NA, 1 / 3), ropes.cable.length = c("300 m", NA, "1e2 fathom"),
    check.names = FALSE
  )
  given <- designs(table)
  vary("towed_cable", given, store = store, tasks = 0, nodes = 40L)
  study <- read_store(store)
  expect_identical(as.list(study$designs), as.list(given))
  expect_identical(study$nodes, 40)
  expect_identical(study$gear$plan, read_gear("towed_cable")$plan)
})

test_that("tasks divide the designs and skip finished ones", {
  store <- file.path(test_folder(), "a.study")
  vary("towed_cable", small_study(), store = store, tasks = 0)
  expect_equal(run_study(store, 2, 4), 2L)
  expect_identical(designs_done(store), c(2L, 6L))
  expect_equal(summary(read_result(store))$done, 2L)
  expect_identical(attr(read_result(store), "study")$design, c(2L, 6L))
  expect_equal(run_study(store), 4L)
  expect_equal(run_study(store), 0L)
  expect_output(print(summary(read_result(store))), "6 done, 6 settled")
  expect_identical(read_result(store), vary("towed_cable", small_study()))
})

test_that("store ignores the remains of a killed worker", {
  store <- file.path(test_folder(), "a.study")
  vary("towed_cable", small_study(), store = store, tasks = 0)
  run_study(store, 1, 6)
  # an incomplete file, a row gathered by another process, and a design that a process was settling
  dir.create(file.path(store, "claims", "0000003"))
  writeLines("{\"design\":2,\"prob", file.path(store, "rows", ".codend-1234"))
  expect_identical(designs_done(store), 1L)
  run_study(store, 2, 3)
  expect_identical(designs_done(store), c(1L, 2L, 5L))
  row <- stored_rows(store)[row_designs(stored_rows(store)) == 2L]
  writeLines(row, row_file(store, 2L, store_mark(store)))
  expect_equal(nrow(read_result(store)), 3L)
  expect_equal(run_study(store), 3L)
  expect_length(list.files(file.path(store, "claims")), 0L)
})

test_that("simultaneous processes create a store exactly once", {
  skip_if_not_installed("callr")
  folder <- test_folder()
  store <- file.path(folder, "a.study")
  start <- Sys.time() + 4
  makers <- lapply(1:3, function(k) {
    callr::r_bg(function(store, k, start) {
      study <- codend::designs(towing.speed = 2 + seq_len(k) / 10)
      Sys.sleep(max(0, as.double(start - Sys.time(), "secs")))
      tryCatch({
        codend::vary("towed_cable", study, store = store, tasks = 0)
        k
      }, codend_error_file = conditionMessage)
    }, list(store, k, start))
  })
  on.exit(for (maker in makers) maker$kill())
  for (maker in makers) maker$wait(60000)
  found <- lapply(makers, function(maker) maker$get_result())
  made <- vapply(found, is.numeric, NA)
  expect_identical(sum(made), 1L)
  for (said in found[!made]) expect_match(said, "other\\s+designs")
  expect_identical(summary(read_result(store))$designs, found[made][[1]])
  expect_identical(list.files(folder, all.files = TRUE, no.. = TRUE), "a.study")
})

test_that("processes on one store divide the designs and give equal results", {
  skip_if_not_installed("callr")
  skip_on_os("windows")
  folder <- test_folder()
  store <- file.path(folder, "a.study")
  many <- designs(towing.speed = value_range("2 knot", "6 knot"), how = "grid", number = 60)
  workers <- lapply(1:2, function(k) {
    callr::r_bg(function(store, many) codend::vary("towed_cable", many, store = store),
      list(store, many))
  })
  on.exit(for (worker in workers) worker$kill())
  for (worker in workers) worker$wait(120000)
  found <- lapply(workers, function(worker) worker$get_result())
  expect_identical(found[[1]], found[[2]])
  expect_identical(found[[1]], vary("towed_cable", many))
  # at the end each may settle the other's last design
  settled <- unlist(lapply(list.files(file.path(store, "tasks"), full.names = TRUE), readLines))
  expect_lte(length(settled), 60L + 2L)
})

test_that("store ignores rows of an earlier study in its folder", {
  folder <- test_folder()
  store <- file.path(folder, "a.study")
  other <- file.path(folder, "b.study")
  vary("towed_cable", small_study(), store = store, tasks = 0)
  vary("towed_cable", small_study()[6:1, ], store = other, tasks = 0)
  run_study(other, 1, 2)
  for (file in list.files(other, "json$", recursive = TRUE)) {
    if (file != "study.json") file.copy(file.path(other, file), file.path(store, file))
  }
  expect_equal(summary(read_result(store))$done, 0L)
  # also under this study's name
  row <- readLines(list.files(file.path(other, "tasks"), full.names = TRUE)[1])[1]
  writeLines(row, row_file(store, 1L, store_mark(store)))
  expect_equal(nrow(read_result(store)), 0L)
})

test_that("read_result() omits a damaged row of a study and reads all others", {
  store <- file.path(test_folder(), "a.study")
  vary("towed_cable", small_study(), store = store, tasks = 0)
  run_study(store, 1, 3)
  run_study(store, 2, 6)
  whole <- read_result(store)
  files <- list.files(store, "^[0-9].*json$", recursive = TRUE, full.names = TRUE)
  expect_length(files, 2L)
  set.seed(11)
  for (file in files) {
    good <- readBin(file, "raw", file.size(file))
    for (k in 1:20) {
      changed <- good
      # not a line break, which ends a row
      at <- sample(which(good != 10), 1L)
      changed[at] <- as.raw(sample(setdiff(33:255, as.integer(good[at])), 1L))
      writeBin(changed, file)
      expect_warning(found <- read_result(store), "1 row of .* is damaged",
        class = "codend_warning_study")
      expect_equal(nrow(found), nrow(whole) - 1L)
      kept <- match(interaction(found[1:2]), interaction(whole[1:2]))
      expect_identical(found$total_drag_kN, whole$total_drag_kN[kept])
    }
    writeBin(good, file)
  }
  expect_identical(read_result(store), whole)
  study <- file.path(store, "study.json")
  text <- readLines(study, warn = FALSE)
  writeLines(sub("towed_cable", "towed_cables", text), study)
  expect_error(read_result(store), "damaged", class = "codend_error_file")
})

test_that("killed process loses only its current run", {
  skip_if_not_installed("callr")
  skip_on_os("windows")
  store <- file.path(test_folder(), "a.study")
  many <- designs(towing.speed = value_range("2 knot", "6 knot"), how = "grid", number = 4000)
  vary("towed_cable", many, store = store, tasks = 0)
  worker <- callr::r_bg(function(store) codend::run_study(store), list(store))
  on.exit(worker$kill())
  for (wait in 1:600) {
    if (length(designs_done(store)) >= 3L) break
    Sys.sleep(0.1)
  }
  tools::pskill(worker$get_pid(), tools::SIGKILL)
  worker$wait()
  done <- designs_done(store)
  expect_gte(length(done), 3L)
  # consecutive and complete
  expect_identical(done, seq_along(done))
  found <- read_result(store)
  expect_true(all(found$settled))
  first <- vary("towed_cable", many[1:3, , drop = FALSE])
  expect_identical(found$total_drag_kN[1:3], first$total_drag_kN)
})

test_that("store rejects another study", {
  store <- file.path(test_folder(), "a.study")
  vary("towed_cable", small_study(), store = store, tasks = 0)
  other <- function(...) expect_error(vary(..., store = store), class = "codend_error_file")
  expect_match(conditionMessage(other("towed_cable", towing.speed = 2)), "other designs")
  expect_match(conditionMessage(other(update(read_gear("towed_cable"), towing.speed = 2),
    small_study())), "another plan")
  expect_match(conditionMessage(other("towed_cable", small_study(), nodes = 50)), "nodes")
  expect_error(read_result(tempdir()), "is not a study", class = "codend_error_file")
  expect_wrong(run_study(store, 3, 2))
  writeLines("{\"codend_study\": 99}", file.path(store, "study.json"))
  expect_error(summary(read_result(store)), "another format", class = "codend_error_file")
})

test_that("study command creates and runs a study from the shell", {
  folder <- test_folder()
  file <- file.path(folder, "designs.csv")
  writeLines(c("towing.speed,ropes.cable.length", "3 knot,300 m", ",500 m", "5 knot,"), file)
  store <- file.path(folder, "a.study")
  run <- function(...) {
    said <- utils::capture.output(status <- suppressMessages(run_command(c("study", ...))))
    list(status = status, said = said)
  }
  expect_match(run("new", store, "towed_cable", "--designs", file)$said[1], "0 done")
  expect_identical(run("run", store, "--task", "2", "--of", "2")$status, 0L)
  expect_match(run("status", store)$said[1], "1 done")
  run("run", store)
  out <- file.path(folder, "found.csv")
  expect_identical(run("table", store, "--out", out)$status, 0L)
  expect_equal(read.csv(out)$total_drag_kN, read_result(store)$total_drag_kN)
  expect_identical(run("go", store)$status, 2L)
  expect_identical(run("new", store)$status, 2L)
  expect_identical(run("run", store, "--task", "3", "--of", "2")$status, 2L)
  expect_identical(run("run", file.path(folder, "none"))$status, 1L)
})
