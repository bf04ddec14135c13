# Names that users have next to codend's names.

test_that("exports do not clash with common packages", {
  lines <- strsplit(readLines(test_path("reference", "common-names.txt")), " ", fixed = TRUE)
  known <- stats::setNames(lapply(lines, `[`, -1L), sub(":$", "", vapply(lines, `[`, "", 1L)))
  expect_true(all(c("dplyr", "tibble", "ggplot2") %in% names(known)))
  own <- c("base", "stats", "utils", "graphics", "grDevices", "methods", "parallel", "splines")
  known <- c(sapply(own, getNamespaceExports, simplify = FALSE), known)
  # codend exports the functions of generics themselves
  own <- setdiff(getNamespaceExports("codend"), c("tidy", "glance", "augment"))
  clashes <- lapply(known, intersect, own)
  expect_identical(Filter(length, clashes), stats::setNames(list(), character()))
})
