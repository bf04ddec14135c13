# Calls every function that accepts a gear, a state or a tow, for every shipped gear and both kinds
# of netting. Checks the results: numbers are finite, tables are complete, independent readers
# accept the files, R does not warn. The models have few nodes, so the numbers are coarse.
#   Rscript tests/matrix/run.R [GEAR...]
# The last line counts the checks as "N passed, N failed, N skipped".

library(codend)
options(warn = 1, cli.num_colors = 1L, device = function(...) grDevices::pdf(NULL, ...))
folder_of_tests <- dirname(sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)))
source(file.path(folder_of_tests, "..", "testthat", "helper-export.R"))
source(file.path(folder_of_tests, "readers.R"))
source(file.path(folder_of_tests, "checks.R"))

chosen <- commandArgs(TRUE)
if (!length(chosen)) chosen <- gears()$name
count <- c(passed = 0, failed = 0, skipped = 0)
seconds <- numeric()

# Runs one check and prints its failures. Returns its value, or NULL if it fails.
# Warnings of codend concern the gear; any other warning is a failure.
run_check <- function(gear, netting, name, check) {
  start <- proc.time()[1L]
  warned <- character()
  value <- tryCatch(
    withCallingHandlers(check(), warning = function(w) {
      if (!inherits(w, "codend_warning")) warned <<- c(warned, conditionMessage(w))
      invokeRestart("muffleWarning")
    }),
    error = identity
  )
  seconds[name] <<- sum(seconds[name], proc.time()[1L] - start, na.rm = TRUE)
  failures <- c(if (inherits(value, "error")) conditionMessage(value),
    sprintf("R warns: %s", warned))
  skipped <- inherits(value, "skipped")
  result <- if (length(failures)) "failed" else if (skipped) "skipped" else "passed"
  count[result] <<- count[result] + 1
  if (!length(failures)) return(value)
  cat(sprintf("%s, %s, %s: %s\n", gear, netting, name, failures), sep = "")
  NULL
}

# Runs checks of an object; each check writes to its own folder.
run_checks <- function(gear, netting, checks, object) {
  for (name in names(checks)) {
    run_check(gear, netting, name, function() {
      folder <- tempfile("matrix-")
      dir.create(folder)
      on.exit(unlink(folder, recursive = TRUE))
      checks[[name]](object, folder)
    })
  }
}

for (name in chosen) {
  gear <- read_gear(name)
  run_checks(name, "plan", gear_checks, gear)
  has_netting <- length(codend:::gear_si(gear)$panels) > 0L
  for (netting in if (has_netting) c("bars", "cells") else "none") {
    kind <- if (has_netting) netting
    state <- run_check(name, netting, "settle", function() {
      settle(gear, nodes = few_nodes, netting = kind)
    })
    if (is.null(state)) next
    run_checks(name, netting, state_checks, state)
    trajectory <- run_check(name, netting, "tow", function() short_tow(gear, kind))
    if (!is.null(trajectory)) run_checks(name, netting, tow_checks, trajectory)
  }
}
seconds <- sort(seconds, decreasing = TRUE)
cat(sprintf("CPU seconds: %.0f, most in %s\n", sum(seconds),
  toString(utils::head(sprintf("%s %.0f", names(seconds), seconds), 6L))))
if (count[["failed"]] > 0) cat("Run one gear alone with: Rscript tests/matrix/run.R GEAR\n")
cat(sprintf("%d passed, %d failed, %d skipped\n", count[[1L]], count[[2L]], count[[3L]]))
quit(status = count[["failed"]] > 0)
