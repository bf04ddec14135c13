# Runs the code of one guide with the installed codend and writes the guide with its results in
# place of its code, pictures beside it. `make guides` calls it for every guide, so that a guide
# cannot use what an earlier one made or attached.
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
