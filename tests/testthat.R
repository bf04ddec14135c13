library(testthat)
library(codend)

test_check("codend")
