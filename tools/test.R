# Runs the engine's tests and then the package's, and ends with "N passed, N failed, N skipped",
# where a test is a doctest test case or a test_that() block. Fails when any test does.

engine <- function() {
  # a make above this one would pass on flags that do not fit here
  Sys.unsetenv(c("MAKEFLAGS", "MFLAGS", "MAKELEVEL"))
  said <- suppressWarnings(system2(
    "make", c("-s", "-C", "tests/engine", paste0("-j", parallel::detectCores()), "run"),
    stdout = TRUE, stderr = TRUE
  ))
  cat(said, sep = "\n")
  line <- grep("test cases:", said, value = TRUE)
  # no summary: the tests did not build or did not live to their end
  if (length(line) != 1L) return(c(passed = 0, failed = 1, skipped = 0))
  count <- function(word) as.numeric(sub(paste0(".*?([0-9]+) ", word, ".*"), "\\1", line))
  c(passed = count("passed"), failed = count("failed"), skipped = count("skipped"))
}

package <- function() {
  found <- as.data.frame(testthat::test_dir(
    "tests/testthat", package = "codend", load_package = "installed",
    reporter = testthat::CheckReporter$new(), stop_on_failure = FALSE
  ))
  failed <- found$failed > 0 | found$error
  skipped <- found$skipped & !failed
  c(passed = sum(!failed & !skipped), failed = sum(failed), skipped = sum(skipped))
}

total <- engine() + package()
cat(sprintf("%d %s", total, names(total)), sep = ", ")
cat("\n")
quit(status = total[["failed"]] > 0)
