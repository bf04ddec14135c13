# Seeds the faults of tools/faults.csv one at a time in a copy of the sources and says which of them
# the tests notice: a fault that no test notices survives.
#   Rscript tools/faults.R              all of them
#   Rscript tools/faults.R 1 5 20:30    some, by their row
# `file` has `from` once, in the place of which `to` is put. A fault of the engine meets the
# engine's own tests, then as one of R the package tests of `tests`, one file after another until
# one fails; FAULTS=all goes on with all other files. Works in a temporary folder, with the codend
# that is installed, whose R code is put in place anew for a fault of R and which is installed anew
# for any other. Fails where a fault survives.

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

# The package of the copy, compiled anew.
install <- function() {
  options <- c("CMD", "INSTALL", "--no-docs", "--no-test-load", "--no-byte-compile", "-l", library,
    copy)
  quietly(file.path(R.home("bin"), "R"), options)
}

# Runs with the arguments copy, file of tests, whether the copy's R code takes the installed one's
# place.
run <- file.path(copy, "run.R")
writeLines(r"(
given <- commandArgs(TRUE)
here <- loadNamespace("codend")
if (given[3] == "TRUE") {
  for (name in ls(here, all.names = TRUE)) unlockBinding(name, here)
  for (file in Sys.glob(file.path(given[1], "R", "*.R"))) {
    # a namespace that is loaded takes no new names, which two lines would give it for a moment
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

# Whether a file of package tests passes in the copy, or as it was installed from there.
passes <- function(name, installed) {
  file <- file.path(copy, "tests", "testthat", paste0("test-", name, ".R"))
  own <- if (installed) paste0("R_LIBS=", library, ":", paste(.libPaths(), collapse = ":"))
  quietly(file.path(R.home("bin"), "Rscript"), c(run, copy, file, !installed),
    env = c(own, "NOT_CRAN=true"))
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
