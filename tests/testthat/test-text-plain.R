test_that("plain_message() returns one line without colours and bullets", {
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

test_that("escape_markup() escapes characters of HTML and XML", {
  skip_if_not_installed("xml2")
  text <- "a \"b\" 'c' <d> & e &amp; f"
  read <- xml2::read_xml(sprintf("<a b=\"%1$s\" c='%1$s'>%1$s</a>", escape_markup(text)))
  expect_identical(xml2::xml_attr(read, "b"), text)
  expect_identical(xml2::xml_attr(read, "c"), text)
  expect_identical(xml2::xml_text(read), text)
})

test_that("plans and pictures do not depend on R's number options", {
  folder <- test_folder()
  made <- function(name, ...) {
    kept <- options(...)
    on.exit(options(kept))
    plans <- c("longline", "midwater_trawl")
    state <- settle(update(read_gear("towed_cable"), ropes.cable.length = 1000.25))
    drawing <- file.path(folder, paste0(name, ".svg"))
    picture <- file.path(folder, paste0(name, ".png"))
    plot(read_gear("gillnet"), drawing)
    plot(state, file = picture)
    slopes <- sensitivities(state, of = "total_drag_kN", fields = "ropes.cable.length")
    best <- optimise_gear(state$gear, minimise = "total_drag_kN",
      change = list(ropes.cable.length = c("999.5 m", "1000.25 m")))
    list(
      picture = unname(tools::md5sum(picture)), slopes = slopes$derivative,
        best = best$fields$value,
      printed = c(capture.output(print(slopes), print(best)), conditions_text(state$si)),
      plans = lapply(plans, function(plan) format(assembly(read_gear(plan)))),
      drawing = unname(tools::md5sum(drawing)), columns = column_figures(c(0.5, 12.25)),
      message = tryCatch(update(state$gear, towing.speed = -1.5), error = conditionMessage)
    )
  }
  plain <- made("plain")
  # the axes of a picture use the session's decimal mark
  expect_identical(made("comma", OutDec = ",", scipen = -9)[-1], plain[-1])
  expect_identical(made("digits", scipen = 100, digits = 4), plain)
})
