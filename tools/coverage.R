# Which lines the tests run, of R by covr and of the C++ by gcov, both through the package's tests;
# what runs in processes that these start counts too. Prints every file of under 95 % with its lines
# that are not run, then both totals, and fails where a test does.
#   Rscript tools/coverage.R    R and C++; some forty minutes
#   Rscript tools/coverage.R R  R alone, in half of that

least <- 95
of_cpp <- !identical(commandArgs(TRUE), "R")
Sys.unsetenv(c("MAKEFLAGS", "MFLAGS", "MAKELEVEL"))
Sys.setenv(NOT_CRAN = "true")
flags <- if (of_cpp) "-O1 --coverage" else "-O2"
options(covr.flags = c(CXX17FLAGS = flags, LDFLAGS = if (of_cpp) "--coverage" else ""))
tests <- normalizePath("tests/testthat")
failures <- tempfile()
run <- sprintf(paste(
  "options(device = function(...) grDevices::pdf(NULL, ...));",
  "found <- as.data.frame(testthat::test_dir('%s', package = 'codend', load_package = 'installed',",
  "reporter = 'check', stop_on_failure = FALSE));",
  "writeLines(unique(found$test[found$failed > 0 | found$error]), '%s')"
), tests, failures)
found <- covr::package_coverage(type = "none", code = run, quiet = FALSE,
  line_exclusions = list("R/cpp11.R", "src/cpp11.cpp"))
lines <- covr::tally_coverage(found, by = "line")
lines <- lines[startsWith(lines$filename, "R/") | startsWith(lines$filename, "src/"), ]

# 1, 2, 3, 7 as "1-3, 7"
ranges <- function(x) {
  x <- sort(x)
  run <- cumsum(c(TRUE, diff(x) > 1))
  paste(tapply(x, run, function(r) if (length(r) > 1L) paste0(r[1], "-", tail(r, 1)) else r),
    collapse = ", ")
}
share <- function(part) 100 * mean(part$value > 0)
for (part in split(lines, lines$filename)) {
  if (share(part) < least) {
    cat(sprintf("%5.1f %%  %s  %s\n", share(part), part$filename[1],
      ranges(part$line[part$value == 0])))
  }
}
for (part in split(lines, ifelse(startsWith(lines$filename, "R/"), "R", "C++"))) {
  cat(sprintf("%s: %.1f %% of %s lines\n", c("C++", "R")[1 + startsWith(part$filename[1], "R/")],
    share(part), format(nrow(part), big.mark = ",")))
}
failed <- readLines(failures)
if (length(failed)) {
  cat("Tests that failed:", failed, sep = "\n  ")
  quit(status = 1)
}
