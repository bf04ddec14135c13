# Seeds the faults of tools/faults.csv one at a time in a copy of the sources and says which of them
# the tests notice: a fault that no test notices survives.
#   Rscript tools/faults.R              all of them
#   Rscript tools/faults.R 1 5 20:30    some, by their row
# `file` has `from` once, in the place of which `to` is put. A fault of the engine meets the
# engine's own tests, then as one of R the package tests of `tests`, one file after another until
# one fails; FAULTS=all goes on with all other files. Works in a temporary folder, with the codend
# that is installed for what a fault does not change. Fails where a fault survives.

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

# The package of the copy, compiled anew where the engine has the fault.
install <- function(engine) {
  options <- c("CMD", "INSTALL", "--no-docs", "--no-test-load", "--no-byte-compile",
    if (!engine) "--no-libs", "-l", library, copy)
  if (!quietly(file.path(R.home("bin"), "R"), options)) return(FALSE)
  own <- file.path(library, "codend", "libs")
  engine || file.copy(system.file("libs", package = "codend"), dirname(own), recursive = TRUE)
}

# Whether a file of package tests passes in the copy.
passes <- function(name) {
  run <- sprintf(paste0(
    "library(testthat); .libPaths(c('%s', .libPaths())); library(codend, lib.loc = '%s'); ",
    "found <- as.data.frame(test_file('%s', package = 'codend', load_package = 'installed', ",
    "reporter = 'silent')); quit(status = any(found$failed > 0 | found$error))"
  ), library, library, file.path(copy, "tests", "testthat", paste0("test-", name, ".R")))
  quietly(file.path(R.home("bin"), "Rscript"), c("-e", shQuote(run)))
}

# What notices a fault, or NA.
noticed_by <- function(fault) {
  engine <- startsWith(fault$file, "src/engine")
  if (engine && !quietly("make", c("-s", "-C", file.path(copy, "tests", "engine"), "run"))) {
    return("the engine's tests")
  }
  files <- strsplit(fault$tests, " ")[[1L]]
  if (Sys.getenv("FAULTS") == "all") {
    every <- sub("^test-(.*)[.]R$", "\\1", list.files("tests/testthat", "^test-.*[.]R$"))
    files <- union(files, every)
  }
  if (!length(files)) return(NA)
  if (!install(engine)) stop("codend with the fault ", fault$to, " could not be installed")
  for (name in files) if (!passes(name)) return(name)
  NA
}

survives <- vapply(rows, function(k) {
  fault <- faults[k, ]
  file <- file.path(copy, fault$file)
  text <- readChar(file, file.size(file), useBytes = TRUE)
  at <- gregexpr(fault$from, text, fixed = TRUE, useBytes = TRUE)[[1L]]
  if (length(at) != 1L || at < 0L) stop(fault$file, " does not have once: ", fault$from)
  cat(sub(fault$from, fault$to, text, fixed = TRUE, useBytes = TRUE), file = file)
  by <- noticed_by(fault)
  cat(text, file = file)
  cat(sprintf("%d %s: %s\n    %s\n", k, fault$file, if (is.na(by)) "SURVIVES" else
    paste("dies by", by), fault$to))
  is.na(by)
}, NA)
unlink(copy, recursive = TRUE)
cat(sum(!survives), " of ", length(rows), " faults die\n", sep = "")
quit(status = any(survives))
