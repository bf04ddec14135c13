test_that("a message becomes one line without a terminal's colours and bullets", {
  text <- c("Rope {.field a!} is {.val {3}}.", x = "It must be i > 4.", i = "Look.", "*" = "One.",
    v = "Done.", "!" = "Mind.", ">" = "Next.", " " = "Last.")
  said <- "Rope a! is 3. It must be i > 4. Look. One. Done. Mind. Next. Last."
  for (unicode in c(TRUE, FALSE)) {
    local_reproducible_output(unicode = unicode, crayon = TRUE)
    expect_identical(plain_message(tryCatch(cli::cli_abort(text), error = identity)), said)
    expect_identical(plain_message(tryCatch(cli::cli_warn(text), warning = identity)), said)
  }
  expect_identical(plain_message(simpleError("i is\n  not > 3")), "i is not > 3")
})

test_that("text may hold what HTML and XML mark with", {
  skip_if_not_installed("xml2")
  text <- "a \"b\" 'c' <d> & e &amp; f"
  read <- xml2::read_xml(sprintf("<a b=\"%1$s\" c='%1$s'>%1$s</a>", escape_markup(text)))
  expect_identical(xml2::xml_attr(read, "b"), text)
  expect_identical(xml2::xml_attr(read, "c"), text)
  expect_identical(xml2::xml_text(read), text)
})
