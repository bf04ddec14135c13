# Runs the code of one guide with the installed codend. Writes the guide with its results, and its
# pictures next to it. `make guides` calls this script for every guide, so each guide runs in a new
# session.
#   Rscript tools/knit-guide.R GUIDE.Rmd RESULT.Rmd   prints the CPU seconds

guide <- commandArgs(TRUE)[1L]
result <- commandArgs(TRUE)[2L]
folder <- tempfile("guide")
dir.create(folder)
stopifnot(file.copy(guide, folder))
copy <- file.path(folder, basename(guide))
markdown <- rmarkdown::render(copy, run_pandoc = FALSE, clean = FALSE, quiet = TRUE,
  envir = new.env())
stopifnot(file.rename(file.path(folder, basename(markdown)), copy))
made <- setdiff(list.files(folder, full.names = TRUE), copy)
stopifnot(file.copy(c(made, copy), dirname(result), overwrite = TRUE, recursive = TRUE))
cat(sprintf("%5.1f s CPU  %s\n", sum(proc.time()[1:2]), guide))
