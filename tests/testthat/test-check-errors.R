test_that("abort_as() raises every error with its class and fields", {
  code <- asNamespace("codend")
  raises <- function(name) {
    f <- get(name, code)
    is.function(f) && "cli_abort" %in% all.names(body(f))
  }
  expect_identical(Filter(raises, ls(code, all.names = TRUE)), "abort_as")

  length <- "long"
  e <- expect_error(abort_argument("{.arg length} is {.val {length}}."))
  expect_s3_class(e, c("codend_error_argument", "codend_error"))
  expect_match(conditionMessage(e), "`length` is \"long\".", fixed = TRUE)
  # strings of a plan or user appear unchanged
  e <- expect_error(abort_plan("a {b} <c>", "path", 3))
  expect_s3_class(e, c("codend_error_plan", "codend_error"))
  expect_identical(conditionMessage(e), "a {b} <c>")
  expect_identical(e[c("path", "value")], list(path = "path", value = 3))
  expect_error(abort_usage("{a}"), "{a}", fixed = TRUE, class = "codend_error_usage")
  e <- expect_error(abort_engine("no {b}", "bars.rest"), class = "codend_error_engine")
  expect_match(conditionMessage(e), "no {b}", fixed = TRUE)
  expect_identical(e$field, "bars.rest")
})
