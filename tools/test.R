# Runs the engine's tests and then the package's, and ends with what failed, again, and
# "N passed, N failed, N skipped", where a test is a doctest test case or a test_that() block. Fails
# when any test does.
#   Rscript tools/test.R       all of them
#   Rscript tools/test.R fast  without the files of package tests that take longest
#   Rscript tools/test.R ci    the checks of tools/checks.R, each counted as one, all of the tests,
#                              two minutes of tests/fuzz and a hundred gears drawn at random, each
#                              counted as one
# All of the package's tests run in two processes, of which the second, `rest`, has the later files.

lane <- c(commandArgs(TRUE), "full")[1]
stopifnot(lane %in% c("full", "fast", "ci", "rest"))
# a make above this one would pass on flags that do not fit here
Sys.unsetenv(c("MAKEFLAGS", "MFLAGS", "MAKELEVEL"))
# what a test plots without naming a file goes nowhere
options(device = function(...) grDevices::pdf(NULL, ...))

# Files, test-*.R, that `fast` leaves out: they settle or tow many gears, draw many pages or start
# R.
slow <- c(
  "command", "command-line", "command-line-export", "draw-gear", "finding", "flume",
  "kind-bottom-trawl", "kind-cage", "kind-purse-seine", "kind-set-nets", "measure-error",
  "measure-turn", "operation-shooting", "operation-tow", "otter-boards", "paper-scheme", "readme",
  "report",
  "settle-cost", "settle-levels", "shielding", "store-kept", "store-trajectory", "study-futures",
  "study-slurm", "study-store", "study-vary", "tow-catch", "validation-cables", "validation-codend",
  "validation-invariants",
  "validation-published-cases", "validation-refinement"
)

# What failed, to be said once more at the end: a log may keep its end alone.
failures <- character()
fails <- function(lines) failures <<- c(failures, lines)

# What a script whose last line counts tests counts.
counted <- function(...) {
  said <- suppressWarnings(system2("Rscript", c(...), stdout = TRUE, stderr = TRUE))
  cat(said, sep = "\n")
  count <- as.numeric(regmatches(tail(said, 1L), gregexpr("[0-9]+", tail(said, 1L)))[[1]])
  if (length(count) != 3L || count[2] > 0) fails(tail(said, 40L))
  if (length(count) != 3L) return(c(passed = 0, failed = 1, skipped = 0))
  stats::setNames(count, c("passed", "failed", "skipped"))
}

engine <- function() {
  said <- suppressWarnings(system2(
    "make", c("-s", "-C", "tests/engine", paste0("-j", parallel::detectCores()), "run"),
    stdout = TRUE, stderr = TRUE
  ))
  cat(said, sep = "\n")
  if (!is.null(attr(said, "status"))) fails(tail(said, 40L))
  line <- grep("test cases:", said, value = TRUE)
  # no summary: the tests did not build or did not live to their end
  if (length(line) != 1L) return(c(passed = 0, failed = 1, skipped = 0))
  count <- function(word) as.numeric(sub(paste0(".*?([0-9]+) ", word, ".*"), "\\1", line))
  c(passed = count("passed"), failed = count("failed"), skipped = count("skipped"))
}

quick_files <- function() {
  names <- sub("^test-(.*)\\.R$", "\\1", list.files("tests/testthat", "^test-.*\\.R$"))
  paste0("^(", paste(setdiff(names, slow), collapse = "|"), ")$")
}

# Files of the first process and of the second, which has the shorter half, for it does more.
files_of <- c(fast = quick_files(), full = "^[a-rw]", ci = "^[a-rw]", rest = "^[^a-rw]")

package <- function() {
  results <- testthat::test_dir(
    "tests/testthat", package = "codend", load_package = "installed",
    filter = files_of[[lane]],
    reporter = testthat::CheckReporter$new(), stop_on_failure = FALSE
  )
  partly <- logical(length(results))
  for (k in seq_along(results)) {
    test <- results[[k]]
    for (result in test$results) {
      message <- conditionMessage(result)
      in_part <- inherits(result, "expectation_warning") &&
        grepl("^partial (argument )?match of ", message)
      partly[k] <- partly[k] || in_part
      if (in_part || inherits(result, c("expectation_failure", "expectation_error"))) {
        fails(sprintf("%s, %s: %s", test$file, test$test, message))
      }
    }
  }
  found <- as.data.frame(results)
  failed <- found$failed > 0 | found$error | partly
  skipped <- found$skipped & !failed
  c(passed = sum(!failed & !skipped), failed = sum(failed), skipped = sum(skipped))
}

# The same cases each time, as many as the machine gets through.
fuzz <- function() {
  said <- suppressWarnings(system2(
    "Rscript", c("tests/fuzz/run.R", "120", "1"), stdout = TRUE, stderr = TRUE
  ))
  cat(said, sep = "\n")
  failed <- !is.null(attr(said, "status"))
  if (failed) fails(tail(said, 40L))
  c(passed = !failed, failed = failed, skipped = 0)
}

# A hundred gears drawn at random, others every time: it says which.
forge <- function() {
  seed <- as.integer(Sys.time()) %% 1e6
  said <- suppressWarnings(system2(
    "Rscript", c("bench/settle-forge.R", "count=100", paste0("seed=", seed), "least=0.9"),
    stdout = TRUE, stderr = TRUE
  ))
  cat(said, sep = "\n")
  failed <- !is.null(attr(said, "status"))
  if (failed) fails(tail(said, 40L))
  c(passed = !failed, failed = failed, skipped = 0)
}

total <- if (lane == "rest") 0 else engine()
# the first process keeps one core busy: the others run beside it, and what they say comes after, so
# that lines do not mix
two <- lane %in% c("full", "ci")
if (two) {
  beside <- parallel::mcparallel({
    said <- utils::capture.output({
      count <- counted("tools/test.R", "rest")
      if (lane == "ci") count <- count + counted("tools/checks.R") + fuzz() + forge()
    })
    list(said = said, count = count, failures = failures)
  })
}
total <- total + package()
if (two) {
  beside <- parallel::mccollect(beside)[[1L]]
  if (!is.list(beside)) {
    beside <- list(said = beside, count = c(passed = 0, failed = 1, skipped = 0))
  }
  cat(beside$said, sep = "\n")
  fails(beside$failures)
  total <- total + beside$count
}
if (length(failures)) cat("What failed:", failures, sep = "\n")
cat(sprintf("%d %s", total, names(total)), sep = ", ")
cat("\n")
quit(status = total[["failed"]] > 0)
