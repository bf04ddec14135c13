# Runs the engine's tests and then the package's, and ends with what failed, again, and
# "N passed, N failed, N skipped", where a test is a doctest test case or a test_that() block. Fails
# when any test does.
#   Rscript tools/test.R       all of them
#   Rscript tools/test.R fast  without the files of package tests that take longest
#   Rscript tools/test.R ci    the checks of tools/checks.R, each counted as one, all of the tests,
#                              a minute of tests/fuzz and a hundred gears drawn at random, each
#                              counted as one, and the smallest part of make bench
#   Rscript tools/test.R files '^s'  package tests of these files, test-*.R
# All but the engine's tests run in as many processes as there are cores, the longest first.

lane <- c(commandArgs(TRUE), "full")[1]
stopifnot(lane %in% c("full", "fast", "ci", "files"))
# a make above this one would pass on flags that do not fit here
Sys.unsetenv(c("MAKEFLAGS", "MFLAGS", "MAKELEVEL"))
# the blocks of the README run too
Sys.setenv(NOT_CRAN = "true")
# what a test plots without naming a file goes nowhere
options(device = function(...) grDevices::pdf(NULL, ...))

# Files, test-*.R, that `fast` leaves out: they settle or tow many gears, draw many pages or start
# R.
slow <- c(
  "command", "command-line", "draw-gear", "finding", "flume",
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

# All files in parts, for a process each, the longest first. What a file settles others of its part
# have.
parts <- c("^s", "^f", "^[m-rtw]", "^[g-l]", "^[a-e]", "^[u-vx-z]")

package <- function(filter) {
  results <- testthat::test_dir(
    "tests/testthat", package = "codend", load_package = "installed",
    filter = filter,
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

# A script that is one test: it fails where its status says so.
whole <- function(...) {
  said <- suppressWarnings(system2("Rscript", c(...), stdout = TRUE, stderr = TRUE))
  cat(said, sep = "\n")
  failed <- !is.null(attr(said, "status"))
  if (failed) fails(tail(said, 40L))
  c(passed = !failed, failed = failed, skipped = 0)
}

# The same cases each time, as many as the machine gets through.
fuzz <- function() whole("tests/fuzz/run.R", "60", "1")

# A hundred gears drawn at random, others every time: it says which.
forge <- function() {
  seed <- as.integer(Sys.time()) %% 1e6
  whole("bench/settle-forge.R", "count=100", paste0("seed=", seed), "least=0.9")
}

# What a job says, counts and finds wrong: jobs run at once, and their lines are not to mix.
apart <- function(job) {
  failures <<- character()
  said <- utils::capture.output(count <- job())
  list(said = said, count = count, failures = failures)
}

total <- if (lane == "files") 0 else engine()
if (lane %in% c("fast", "files")) {
  total <- total + package(if (lane == "fast") quick_files() else commandArgs(TRUE)[2])
} else {
  jobs <- lapply(parts, function(part) function() counted("tools/test.R", "files", shQuote(part)))
  checks <- function() counted("tools/checks.R")
  if (lane == "ci") jobs <- append(jobs, list(fuzz, checks, forge), 1L)
  cores <- parallel::detectCores()
  found <- parallel::mclapply(jobs, apart, mc.preschedule = FALSE, mc.cores = cores)
  for (one in found) {
    if (!is.list(one)) one <- list(said = "", count = c(passed = 0, failed = 1, skipped = 0))
    cat(one$said, sep = "\n")
    fails(one$failures)
    total <- total + one$count
  }
}
# Nothing runs next to what is timed.
if (lane == "ci") total <- total + counted("bench/smallest.R")
if (length(failures)) cat("What failed:", failures, sep = "\n")
cat(sprintf("%d %s", total, names(total)), sep = ", ")
cat("\n")
quit(status = total[["failed"]] > 0)
