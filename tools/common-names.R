# Sets down the names that the packages most used beside codend export, as far as they are installed
# here: Rscript tools/common-names.R. tests/testthat/test-names.R compares codend's own with them,
# and with those of R's own packages, which are there wherever it runs.
packages <- c(
  "dplyr", "tibble", "tidyr", "readr", "purrr", "stringr", "forcats", "lubridate", "ggplot2",
  "data.table", "magrittr", "rlang", "generics", "scales", "knitr", "rmarkdown", "shiny",
  "jsonlite", "httr", "MASS", "lattice", "Matrix", "mgcv", "nlme", "survival", "nnet", "xml2",
  "yaml", "units"
)
there <- packages[vapply(packages, requireNamespace, NA, quietly = TRUE)]
lines <- vapply(there, function(package) {
  plain <- grep("^[a-z][A-Za-z0-9_.]*$", getNamespaceExports(package), value = TRUE)
  names <- sort(plain, method = "radix")
  paste(c(paste0(package, ":"), names), collapse = " ")
}, "")
writeLines(lines, "tests/testthat/reference/common-names.txt")
cat(length(there), "packages\n")
