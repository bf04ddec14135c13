# Builds the last release of codend from its commit, to run next to this tree.
last_release <- c(version = "0.1.0", commit = "f0c6b56")
# Its sources, which are not tracked by git, with its library in `library`.
release_folder <- file.path("bench", "release", last_release[["version"]])

# R libraries of the versions to run; "" for R's own.
versions <- c(release = file.path(release_folder, "library"), now = "")

# Builds the last release unless it exists.
build_release <- function() {
  library <- versions[["release"]]
  if (dir.exists(file.path(library, "codend"))) return(invisible())
  unlink(release_folder, recursive = TRUE)
  dir.create(library, recursive = TRUE)
  sources <- tempfile(fileext = ".tar")
  log <- tempfile()
  on.exit(unlink(c(sources, log)))
  run <- function(command, ...) {
    if (system2(command, c(...), stdout = log, stderr = log) != 0) {
      stop("release ", last_release[["version"]], " could not be built:\n",
        paste(utils::tail(readLines(log), 20), collapse = "\n"))
    }
  }
  run("git", "archive", "--output", sources, last_release[["commit"]])
  utils::untar(sources, exdir = release_folder)
  drop_absent_packages(file.path(release_folder, "DESCRIPTION"))
  Sys.setenv(MAKEFLAGS = paste0("-j", parallel::detectCores()))
  on.exit(Sys.unsetenv("MAKEFLAGS"), add = TRUE)
  run(file.path(R.home("bin"), "R"), "CMD", "INSTALL", "--no-docs", "--no-test-load",
    paste0("--library=", library), release_folder)
}

# Removes packages that only the release's plots need; codend no longer installs them.
drop_absent_packages <- function(file) {
  description <- read.dcf(file, keep.white = "Imports")
  wanted <- trimws(strsplit(description[, "Imports"], ",")[[1]])
  here <- nzchar(vapply(sub(" .*", "", wanted), function(name) system.file(package = name), ""))
  description[, "Imports"] <- paste(wanted[here], collapse = ", ")
  write.dcf(description, file, keep.white = "Imports")
}
