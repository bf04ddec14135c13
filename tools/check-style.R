# Fails where R code breaks the rules of .lintr, and where the package's has letters beyond ASCII,
# which R CMD check warns of ("\\u00d8" stands for one).

files <- system2("git", c("ls-files", shQuote(c("*.R", "*.Rmd"))), stdout = TRUE)
files <- files[file.exists(files)]
broken <- unlist(lapply(files, lintr::lint), recursive = FALSE)
for (one in broken) cat(sprintf("%s:%d: %s\n", one$filename, one$line_number, one$message))
package <- grep("^R/.*[.]R$", files, value = TRUE)
letters_beyond <- package[vapply(package, function(file) {
  any(grepl("[^ -~\t]", readLines(file, warn = FALSE), perl = TRUE, useBytes = TRUE))
}, NA)]
for (file in letters_beyond) cat(file, "has letters beyond ASCII\n")
quit(status = length(broken) + length(letters_beyond) > 0L)
