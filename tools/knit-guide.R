# Runs the code of one guide with the installed codend and writes the guide with its results as
# Markdown, pictures beside it. `make guides` calls it for every guide, so that a guide cannot use
# what an earlier one made or attached.
#   Rscript tools/knit-guide.R GUIDE.Rmd RESULT.md   prints the CPU seconds

guide <- commandArgs(TRUE)[1L]
result <- commandArgs(TRUE)[2L]
copy <- file.path(dirname(result), basename(guide))
dir.create(dirname(result), FALSE, TRUE)
invisible(file.copy(guide, copy, overwrite = TRUE))
markdown <- rmarkdown::render(copy, run_pandoc = FALSE, clean = FALSE, quiet = TRUE)
invisible(file.rename(file.path(dirname(result), basename(markdown)), result))
cat(sprintf("%5.1f s CPU  %s\n", sum(proc.time()[1:2]), guide))
