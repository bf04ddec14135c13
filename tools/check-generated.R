# Fails if help, NAMESPACE or the registration of C++ functions differ from the output of their
# generators. Works on a copy. Needs codend installed from the same sources.

copy <- tempfile("generated")
dir.create(copy)
invisible(file.copy(c("DESCRIPTION", "NAMESPACE", "R", "man", "src"), copy, recursive = TRUE))
register <- normalizePath("tools/register.R")
here <- setwd(copy)
said <- utils::capture.output({
  suppressMessages(roxygen2::roxygenise(load_code = "installed"))
  source(register, local = TRUE)
})

generated <- function(folder) {
  files <- list.files(folder, recursive = TRUE)
  grep("^(DESCRIPTION|NAMESPACE|man/.*[.]Rd|R/cpp11[.]R|src/cpp11[.]cpp)$", files, value = TRUE)
}
setwd(here)
files <- union(generated("."), generated(copy))
in_step <- function(file) {
  both <- file.path(c(".", copy), file)
  all(file.exists(both)) && length(unique(lapply(both, readLines, warn = FALSE))) == 1L
}
stale <- files[!vapply(files, in_step, NA)]
if (length(stale) > 0L) {
  cat("These files do not match their sources:", stale, sep = "\n  ")
  cat("Run: Rscript -e 'roxygen2::roxygenise(load_code = \"installed\")'\n")
  cat("and: Rscript tools/register.R\n")
  quit(status = 1)
}
