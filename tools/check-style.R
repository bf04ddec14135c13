# Fails where R code breaks the rules of .lintr.

files <- system2("git", c("ls-files", shQuote(c("*.R", "*.Rmd"))), stdout = TRUE)
files <- files[file.exists(files)]
broken <- unlist(lapply(files, lintr::lint), recursive = FALSE)
for (one in broken) cat(sprintf("%s:%d: %s\n", one$filename, one$line_number, one$message))
quit(status = length(broken) > 0L)
