# Runs package tests; a test is a test_that() block. Prints failures, then "N passed, N failed,
# N skipped".
#   Rscript tools/test.R '^s'   the files test-*.R whose names match this regular expression
#   Rscript tools/test.R fast   all files except the slow ones

# Test files that `fast` skips, because each takes more than 4.5 s.
slow <- c(
  "command", "command-line", "draw-gear", "engine-file", "export-vtk", "file-write", "finding",
  "flume", "flume-shared", "flume-tow", "flume-worker", "gear",
  "gear-check", "gear-new-plan", "input-current", "kind-beam-trawl", "kind-bottom-trawl",
  "kind-cage", "kind-demersal-seine", "kind-longline", "kind-midwater-trawl", "kind-purse-seine",
  "kind-set-nets", "kites", "measure-error", "measure-state", "measure-turn", "misuse",
  "operation-shooting", "operation-tow", "otter-boards", "paper-scheme", "plan-check",
  "plan-given", "plan-places", "plan-read", "plan-write", "plan-written", "report", "scene-drawn",
  "settle-from", "settle-levels", "share", "shielding", "stiff-motion", "store-saved",
  "store-state", "store-trajectory", "store-versions", "study-calibrate", "study-effects",
  "study-futures", "study-optimise", "study-posterior", "study-sensitivities", "study-slurm",
  "study-store", "study-uncertainty", "study-vary", "table-tidy", "text-plain", "tow-catch",
  "validation-codend", "validation-invariants", "validation-refinement", "view-3d"
)

# Tests that CRAN skips run too.
Sys.setenv(NOT_CRAN = "true")
# Plots without a file are discarded.
options(device = function(...) grDevices::pdf(NULL, ...))

filter <- commandArgs(TRUE)
stopifnot(length(filter) == 1L)
if (filter == "fast") {
  names <- sub("^test-(.*)\\.R$", "\\1", list.files("tests/testthat", "^test-.*\\.R$"))
  filter <- paste0("^(", paste(setdiff(names, slow), collapse = "|"), ")$")
}
results <- testthat::test_dir(
  "tests/testthat", package = "codend", load_package = "installed", filter = filter,
  reporter = testthat::CheckReporter$new(), stop_on_failure = FALSE
)
# A test fails if R warns that `$` matched only the beginning of a name.
partial_match <- vapply(results, function(test) {
  messages <- vapply(test$results, conditionMessage, "")
  partial <- grepl("^partial (argument )?match of ", messages)
  if (any(partial)) cat(sprintf("%s, %s: %s", test$file, test$test, messages[partial]), sep = "\n")
  any(partial)
}, NA)
table <- as.data.frame(results)
failed <- table$failed > 0 | table$error | partial_match
skipped <- table$skipped & !failed
passed <- sum(!failed & !skipped)
cat(sprintf("%d passed, %d failed, %d skipped\n", passed, sum(failed), sum(skipped)))
quit(status = any(failed))
