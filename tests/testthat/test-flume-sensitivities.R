test_that("page receives sensitivities to a field in its preferred units", {
  in_flume("towed_cable", function(session, sent, tank) {
    session$hear(slopes_wanted = list(paths = list("ropes.cable.length"), number = 1))
    told <- sent("flume_sensitivities")[[1]]$fields
    expect_length(told, 1L)
    expect_identical(unclass(told[[1]]$paths), "ropes.cable.length")
    expect_identical(told[[1]]$unit, "m")
    found <- sensitivities(tank$state, fields = "ropes.cable.length")
    expect_identical(unclass(told[[1]]$slope), found$derivative)
    # Compared with a design settled with the larger value. The sensitivity is within 0.5 % of 1 %
    # steps to both sides where it is marked as smooth.
    depth <- match("body depth", told[[1]]$measures)
    expect_true(told[[1]]$smooth[depth])
    ask(session, ropes.cable.length = list(value = 1010, unit = "m"))
    more <- tank$measures[["body_depth_m"]] - tank$kept[[1]]$measures[["body_depth_m"]]
    expect_equal(more / 10, unclass(told[[1]]$slope)[depth], tolerance = 0.02)
    # sensitivities of another design are discarded
    expect_null(tank$slopes)

    session$hear(preferred = list(length = "fathom"))
    session$hear(slopes_wanted = list(number = 2))
    told <- sent("flume_sensitivities")[[1]]$fields
    expect_gt(length(told), 1L)
    depth <- match("body depth", told[[1]]$measures)
    expect_identical(unclass(told[[1]]$units)[depth], "fathom")
    found <- sensitivities(tank$state)
    expect_equal(unclass(told[[1]]$slope)[depth], found$derivative[depth] / 1.8288,
      tolerance = 1e-12)
    # percent for 10 % more, to the displayed digits
    speed <- found$elasticity[found$measure == "body_depth_m" & found$field == "towing.speed"]
    rows <- table_of(session, "slopes")$rows
    expect_true(any(grepl(signed(10 * speed, 1L), unlist(rows), fixed = TRUE)))
    table <- utils::read.csv(saved_file(session, "slopes"))
    expect_equal(table$derivative, found$derivative, tolerance = 1e-12)
  })
})

test_that("page shows intervals next to the errors of the current design", {
  in_flume("towed_cable", function(session, sent, tank) {
    last_of <- function(type) utils::tail(sent(type), 1L)[[1L]]
    expect_null(last_of("flume_measures")$intervals)
    session$hear(intervals_wanted = TRUE)
    found <- tank$uncertainty
    expect_identical(found$measures, uncertainty(tank$state)$measures)
    at <- match("body_depth_m", names(tank$measures))
    told <- last_of("flume_measures")
    expect_identical(told$level, 90)
    row <- found$measures[found$measures$measure == "body_depth_m", ]
    said <- sprintf("90 %%: %.0f to %.0f", row$lower, row$upper)
    expect_identical(unclass(told$intervals)[at], said)
    expect_equal(unclass(told$error)[at], row$mesh)
    # the same string as in a summary
    expect_match(gsub(" +", " ", format(summary(tank$state, uncertainty = found))), said,
      fixed = TRUE, all = FALSE)
    # in the page's preferred units
    session$hear(preferred = list(length = "fathom"))
    expect_identical(unclass(last_of("flume_measures")$intervals)[at],
      sprintf("90 %%: %.0f to %.0f", row$lower / 1.8288, row$upper / 1.8288))
    # computed again for another design, and only on request
    ask(session, ropes.cable.length = list(value = 900, unit = "m"))
    expect_identical(tank$uncertainty$measures, uncertainty(tank$state)$measures)
    session$hear(intervals_wanted = FALSE)
    expect_null(last_of("flume_measures")$intervals)
    ask(session, ropes.cable.length = list(value = 950, unit = "m"))
    expect_null(tank$uncertainty)
  })
})

test_that("page rejects sensitivities to unknown fields", {
  in_flume("towed_cable", function(session, sent, tank) {
    wrong <- list(list("ropes.cable.lenght"), list(3), list(list("a")), list(strrep("a", 5000)),
      list("towing.speed", "ropes.cable.length"))
    wrong <- lapply(wrong, function(paths) list(paths = paths))
    expect_asks_refused(session, sent, "slopes_wanted", wrong, "slopes")
    expect_null(tank$slopes)
  })
})

test_that("sensitivity_tables() marks sensitivities that are not smooth with a star", {
  state <- settled("towed_cable", nodes = 300)
  slopes <- sensitivities(state, fields = c("towing.speed", "ropes.cable.length"))
  slopes$smooth[slopes$field == "towing.speed"] <- FALSE
  rows <- sensitivity_tables(slopes)[[1L]]$rows
  cells <- Find(function(row) row[1L] == "body depth", rows)
  expect_match(cells[2L], " \\*$")
  expect_no_match(cells[3L], "*", fixed = TRUE)
  expect_length(sensitivity_tables(NULL), 0L)
})
