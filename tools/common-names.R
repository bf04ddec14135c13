# Stores the exported names of common packages that are installed here:
#   Rscript tools/common-names.R
# tests/testthat/test-names.R compares codend's names with them and with the names of base R
# packages.
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
