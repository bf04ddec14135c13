# Fails where R code breaks the rules of .lintr.

files <- system2("git", c("ls-files", shQuote(c("*.R", "*.Rmd"))), stdout = TRUE)
files <- files[file.exists(files)]
found <- do.call(c, lapply(files, lintr::lint, parse_settings = TRUE))
if (length(found) > 0L) {
  found <- as.data.frame(found)
  cat(sprintf("%s:%d: %s", found$filename, found$line_number, found$message), sep = "\n")
  quit(status = 1)
}
