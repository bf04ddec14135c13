# Fails if R code breaks the rules of .lintr, or if the package's code contains non-ASCII
# characters. R CMD check warns about non-ASCII characters. Write an escape such as "\\u00d8".

files <- system2("git", c("ls-files", shQuote(c("*.R", "*.Rmd"))), stdout = TRUE)
files <- files[file.exists(files)]
broken <- unlist(lapply(files, lintr::lint), recursive = FALSE)
for (one in broken) cat(sprintf("%s:%d: %s\n", one$filename, one$line_number, one$message))
package <- grep("^R/.*[.]R$", files, value = TRUE)
letters_beyond <- package[vapply(package, function(file) {
  any(grepl("[^ -~\t]", readLines(file, warn = FALSE), perl = TRUE, useBytes = TRUE))
}, NA)]
for (file in letters_beyond) cat(file, "contains non-ASCII characters\n")
quit(status = length(broken) + length(letters_beyond) > 0L)
