# Seeds the faults of tools/faults.csv one at a time in a copy of the sources and reports which ones
# the tests detect. A fault survives if no test detects it. Fails if a fault survives.
#   Rscript tools/faults.R              all faults
#   Rscript tools/faults.R 1 5 20:30    faults by row number
#
# The single occurrence of `from` in `file` is replaced by `to`. Faults of the engine run the engine
# tests first. All faults then run the package tests of `tests`, one file at a time until one fails.
# FAULTS=all continues with all other files. Works in a temporary folder. A fault in R code is
# loaded into the installed codend; for any other fault codend is installed again.

faults <- utils::read.csv("tools/faults.csv")
rows <- unlist(lapply(commandArgs(TRUE), function(one) eval(str2lang(one))))
if (!length(rows)) rows <- seq_len(nrow(faults))

copy <- tempfile("faults-")
dir.create(copy)
tracked <- system2("git", "ls-files", stdout = TRUE)
tracked <- tracked[file.exists(tracked) & !grepl("^gallery/", tracked)]
for (folder in unique(dirname(tracked))) {
  dir.create(file.path(copy, folder), showWarnings = FALSE, recursive = TRUE)
}
stopifnot(file.copy(tracked, file.path(copy, tracked)))
library <- file.path(copy, "library")
dir.create(library)

quietly <- function(command, arguments, ...) {
  suppressWarnings(system2(command, arguments, stdout = FALSE, stderr = FALSE, ...)) == 0L
}

# Installs the package from the copy.
install <- function() {
  options <- c("CMD", "INSTALL", "--no-docs", "--no-test-load", "--no-byte-compile", "-l", library,
    copy)
  quietly(file.path(R.home("bin"), "R"), options)
}

# Script that runs one test file. Arguments: copy, test file, "TRUE" to load the copy's R code into
# the installed package.
run <- file.path(copy, "run.R")
writeLines(r"(
given <- commandArgs(TRUE)
here <- loadNamespace("codend")
if (given[3] == "TRUE") {
  for (name in ls(here, all.names = TRUE)) unlockBinding(name, here)
  for (file in Sys.glob(file.path(given[1], "R", "*.R"))) {
    # A loaded namespace accepts no new names, which two lines define temporarily.
    for (one in parse(file, keep.source = FALSE)) try(eval(one, here), silent = TRUE)
  }
  methods <- parseNamespaceFile(basename(given[1]), dirname(given[1]), FALSE)$S3methods
  for (k in seq_len(nrow(methods))) {
    home <- if (is.na(methods[k, 4])) here else loadNamespace(methods[k, 4])
    method <- get(paste(methods[k, 1], methods[k, 2], sep = "."), here)
    registerS3method(methods[k, 1], methods[k, 2], method, home)
  }
}
found <- as.data.frame(testthat::test_file(given[2], package = "codend",
  load_package = "installed", reporter = "silent"))
quit(status = any(found$failed > 0 | found$error))
)", run)

# TRUE if a package test file passes with the copy, or with the package installed from it.
passes <- function(name, installed) {
  file <- file.path(copy, "tests", "testthat", paste0("test-", name, ".R"))
  own <- if (installed) paste0("R_LIBS=", library, ":", paste(.libPaths(), collapse = ":"))
  quietly(file.path(R.home("bin"), "Rscript"), c(run, copy, file, !installed),
    env = c(own, "NOT_CRAN=true"))
}

# Returns the tests that detect a fault, or NA.
noticed_by <- function(fault) {
  engine <- startsWith(fault$file, "src/engine")
  if (engine && !quietly("make", c("-s", "-C", file.path(copy, "tests", "engine"), "run"))) {
    return("the engine tests")
  }
  files <- strsplit(fault$tests, " ")[[1L]]
  if (Sys.getenv("FAULTS") == "all") {
    every <- sub("^test-(.*)[.]R$", "\\1", list.files("tests/testthat", "^test-.*[.]R$"))
    files <- union(files, every)
  }
  if (!length(files)) return(NA)
  installed <- !startsWith(fault$file, "R/")
  if (installed && !install()) stop("codend with the fault ", fault$to, " could not be installed")
  for (name in files) if (!passes(name, installed)) return(name)
  NA
}

survives <- vapply(rows, function(k) {
  fault <- faults[k, ]
  file <- file.path(copy, fault$file)
  text <- readChar(file, file.size(file), useBytes = TRUE)
  at <- gregexpr(fault$from, text, fixed = TRUE, useBytes = TRUE)[[1L]]
  if (length(at) != 1L || at < 0L) stop(fault$file, " does not contain exactly once: ", fault$from)
  cat(sub(fault$from, fault$to, text, fixed = TRUE, useBytes = TRUE), file = file)
  by <- noticed_by(fault)
  cat(text, file = file)
  cat(sprintf("%d %s: %s\n    %s\n", k, fault$file, if (is.na(by)) "SURVIVES" else
    paste("detected by", by), fault$to))
  is.na(by)
}, NA)
unlink(copy, recursive = TRUE)
cat(sum(!survives), " of ", length(rows), " faults detected\n", sep = "")
quit(status = any(survives))
