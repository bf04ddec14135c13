test_that("study as Slurm jobs gives the bytes of one process", {
  # next to the package's tests in a checkout, not in the installed package
  script <- test_path("..", "slurm", "with-slurm")
  skip_if_not(file.exists(script), "the scripts of a checkout")
  skip_if_not_installed("future.batchtools")
  skip_if_not_installed("RNetCDF")
  run <- function(...) {
    # a minute is usual; a Slurm that hangs counts as a failure
    suppressWarnings(system2(normalizePath(script), c(...), stdout = TRUE, stderr = TRUE,
      timeout = 600))
  }
  said <- run("true")
  status <- attr(said, "status")
  skip_if(identical(status, 77L), paste(said, collapse = " "))
  said <- run(file.path(R.home("bin"), "Rscript"), shQuote(test_path("..", "slurm", "study.R")))
  expect_null(attr(said, "status"), info = paste(said, collapse = "\n"))
  expect_match(said, "job array: 50 designs in 4 tasks", all = FALSE)
})
