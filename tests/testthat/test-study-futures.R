skip_if_not_installed("future")
skip_if_not_installed("RNetCDF")

sixteen <- designs(towing.speed = value_range("3 knot", "5 knot"),
  ropes.cable.length = c("300 m", "500 m"), how = "grid", number = 8)

with_plan <- function(..., run) {
  kept <- future::plan(...)
  on.exit(future::plan(kept))
  force(run)
}

test_that("two workers give the bytes of one, with or without store", {
  alone <- vary("towed_cable", sixteen)
  store <- file.path(test_folder(), "a.study")
  found <- with_plan("multisession", workers = 2, run = {
    vary("towed_cable", sixteen, store = store, tasks = 5)
  })
  expect_identical(found, alone)
  expect_length(task_files(store), 5L)
  expect_identical(with_plan("multisession", workers = 2, run = vary("towed_cable", sixteen)),
    alone)
})

test_that("study continues after a killed worker and names the deadly design", {
  skip_on_os("windows")
  store <- file.path(test_folder(), "a.study")
  open_or_create(new_study("towed_cable", list(sixteen), 1500, NULL), store)
  deadly <- new.env()
  deadly$start <- function(store, designs) {
    future::future(
      {
        for (k in designs) {
          if (k == 7L) tools::pskill(Sys.getpid(), tools::SIGKILL)
          get("run_task", asNamespace("codend"))(store, k)
        }
      },
      globals = list(store = store, designs = designs), packages = "codend", seed = NULL
    )
  }
  package <- environment(vary_stored)
  run <- vary_stored
  futures <- run_futures
  environment(futures) <- list2env(list(start_task = deadly$start), parent = package)
  environment(run) <- list2env(list(run_futures = futures), parent = package)
  with_plan("multisession", workers = 2, run = run(store, 4))
  found <- read_result(store)
  expect_identical(which(!found$settled), 7L)
  expect_match(found$problem[7], "worker process ended 2 times")
  expect_identical(found$total_drag_kN[-7], vary("towed_cable", sixteen)$total_drag_kN[-7])
})

# Returns the sum of the steps that a call reports to progressr.
reported_steps <- function(call) {
  told <- 0
  withCallingHandlers(
    progressr::with_progress(call, enable = TRUE, handlers = progressr::handler_void),
    progression = function(p) if (identical(p$type, "update")) told <<- told + p$amount
  )
  told
}

test_that("studies report rows and tows report percents to progressr", {
  skip_if_not_installed("progressr")
  expect_equal(reported_steps(vary("towed_cable", sixteen[1:3, ])), 3)
  store <- file.path(test_folder(), "a.study")
  expect_equal(reported_steps(vary("towed_cable", sixteen[1:3, ], store = store)), 3)
  expect_equal(reported_steps(tow("towed_cable", until = 4, every = 2, nodes = 20)), 100)
})
