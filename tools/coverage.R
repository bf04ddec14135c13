# Measures the line coverage of the tests. R: by covr, with the package tests. C++: by gcov, with
# the engine tests and the package tests, each with a separately compiled engine. Processes that
# tests start count too. Prints each file below 95 % with its uncovered lines, then the totals.
# Fails if a test fails.
#   Rscript tools/coverage.R      R and C++; about 60 and 40 CPU minutes
#   Rscript tools/coverage.R R    R only
#   Rscript tools/coverage.R C++  C++ only

least <- 95
parts <- commandArgs(TRUE)
if (!length(parts)) parts <- c("R", "C++")
stopifnot(parts %in% c("R", "C++"))
Sys.unsetenv(c("MAKEFLAGS", "MFLAGS", "MAKELEVEL"))
Sys.setenv(NOT_CRAN = "true")
failures <- tempfile()
file.create(failures)

# R code that runs the package tests, several files per process and one process per core. Adds the
# names of failed tests to the file `failures`.
run_tests <- sprintf(r"(
files <- sub("^test-(.*)[.]R$", "\\1", list.files("%1$s", "^test-.*[.]R$"))
parts <- split(files, seq_along(files) %%%% ceiling(length(files) / 6))
run <- function(names) system2("Rscript", c("-e", shQuote(sprintf(r"[
options(device = function(...) grDevices::pdf(NULL, ...))
found <- as.data.frame(testthat::test_dir("%1$s", package = "codend",
  load_package = "installed", reporter = "check", stop_on_failure = FALSE, filter = "^(%%s)$"))
failed <- unique(found$test[found$failed > 0 | found$error])
cat(paste0(failed, "\n", recycle0 = TRUE), file = "%2$s", sep = "", append = TRUE)
]", paste(names, collapse = "|")))))
invisible(parallel::mclapply(
  parts, run, mc.cores = parallel::detectCores(), mc.preschedule = FALSE
))
# covr stops at unreadable counts, which a process leaves if a test kills it while it writes.
counts <- list.files(.libPaths(), "^covr_trace_", full.names = TRUE)
whole <- vapply(counts, function(file) {
  tryCatch(!is.null(readRDS(file)), error = function(e) FALSE)
}, NA)
unlink(counts[!whole])
)", normalizePath("tests/testthat"), failures)

# Returns data.frame(filename, line, value). value: number of runs of the line.
lines_of_r <- function() {
  options(covr.flags = c(CXX17FLAGS = "-O2"))
  found <- covr::package_coverage(type = "none", code = run_tests, quiet = FALSE,
    line_exclusions = list("R/cpp11.R"))
  lines <- covr::tally_coverage(found, by = "line")
  lines[startsWith(lines$filename, "R/"), c("filename", "line", "value")]
}

# Runs a program and stops if it fails.
need <- function(program, arguments, environment = character()) {
  if (system2(program, arguments, env = environment)) {
    stop(paste(c(program, arguments), collapse = " "), " failed.", call. = FALSE)
  }
}

lines_of_cpp <- function() {
  work <- tempfile("coverage")
  library <- file.path(work, "library")
  dir.create(library, recursive = TRUE)
  # gcov stores its counts next to the objects that R CMD INSTALL makes.
  need("git", c("checkout-index", "--all", paste0("--prefix=", work, "/sources/")))
  makevars <- file.path(work, "Makevars")
  writeLines(c("CXX17FLAGS = -O1 --coverage", "LDFLAGS = --coverage"), makevars)
  need("R", c("CMD", "INSTALL", "--no-docs", "--no-test-load", "--no-clean-on-error",
    paste0("--library=", library), file.path(work, "sources")),
  c(paste0("R_MAKEVARS_USER=", makevars), paste0("MAKEFLAGS=-j", parallel::detectCores())))
  need("Rscript", c("-e", shQuote(run_tests)),
    paste0("R_LIBS=", paste(c(library, .libPaths()), collapse = ":")))
  need("make", c("-s", "-C", "tests/engine", paste0("-j", parallel::detectCores()), "covered"))
  counts <- c(
    list.files(file.path(work, "sources/src"), "\\.gcda$", recursive = TRUE, full.names = TRUE),
    list.files("tests/engine/build/covered/engine", "\\.gcda$", recursive = TRUE, full.names = TRUE)
  )
  lines <- do.call(rbind, lapply(counts, counted_lines))
  lines <- stats::aggregate(value ~ filename + line, lines, max)
  lines[lines$filename != "src/cpp11.cpp", ]
}

# Returns data.frame(filename, line, value) for codend's files in one file of gcov.
counted_lines <- function(counts) {
  told <- system2("gcov", c("--json-format", "--stdout", counts), stdout = TRUE, stderr = FALSE)
  files <- jsonlite::fromJSON(paste(told, collapse = ""), simplifyVector = FALSE)$files
  do.call(rbind, lapply(files, function(file) {
    name <- file$file
    # The path of a header starts with the folder of the file that includes it.
    while (grepl("[^/.]+/\\.\\./", name)) name <- sub("[^/.]+/\\.\\./", "", name)
    name <- sub("^(.*/)?src/", "src/", name)
    if (!startsWith(name, "src/") && file.exists(file.path("src", name))) {
      name <- file.path("src", name)
    }
    if (!length(file$lines) || !startsWith(name, "src/")) return(NULL)
    data.frame(
      filename = name, line = vapply(file$lines, `[[`, 0L, "line_number"),
      value = vapply(file$lines, function(line) as.double(line$count), 0)
    )
  }))
}

# Formats 1, 2, 3, 7 as "1-3, 7".
ranges <- function(x) {
  x <- sort(x)
  run <- cumsum(c(TRUE, diff(x) > 1))
  paste(tapply(x, run, function(r) if (length(r) > 1L) paste0(r[1], "-", tail(r, 1)) else r),
    collapse = ", ")
}

share <- function(lines) 100 * mean(lines$value > 0)

for (part in parts) {
  lines <- if (part == "R") lines_of_r() else lines_of_cpp()
  for (file in split(lines, lines$filename)) {
    if (share(file) < least) {
      cat(sprintf("%5.1f %%  %s  %s\n", share(file), file$filename[1],
        ranges(file$line[file$value == 0])))
    }
  }
  cat(sprintf("%s: %.1f %% of %s lines\n", part, share(lines), format(nrow(lines), big.mark = ",")))
}
failed <- unique(readLines(failures))
if (length(failed)) {
  cat("Tests that failed:", failed, sep = "\n  ")
  quit(status = 1)
}
