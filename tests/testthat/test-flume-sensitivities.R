test_that("page receives sensitivities to a field", {
  in_flume("towed_cable", function(session, sent, tank) {
    opened <- tank$measures
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
    more <- tank$measures[["body_depth_m"]] - opened[["body_depth_m"]]
    expect_equal(more / 10, unclass(told[[1]]$slope)[depth], tolerance = 0.02)

    session$hear(slopes_wanted = list(number = 2))
    told <- sent("flume_sensitivities")[[1]]$fields
    expect_gt(length(told), 1L)
    found <- sensitivities(tank$state)
    rows <- found[found$field == "towing.speed", ]
    speed <- Find(function(one) identical(unclass(one$paths), "towing.speed"), told)
    expect_identical(unclass(speed$elasticity), rows$elasticity[is.finite(rows$derivative)])
    table <- utils::read.csv(saved_file(session, "slopes"))
    expect_equal(table$derivative, found$derivative, tolerance = 1e-12)
  })
})

test_that("page shows intervals next to the errors of the current design", {
  in_flume("towed_cable", function(session, sent, tank) {
    last_of <- function(type) utils::tail(sent(type), 1L)[[1L]]
    expect_null(last_of("flume_measures")$level)
    session$hear(intervals_wanted = TRUE)
    found <- tank$uncertainty
    expect_identical(found$measures, uncertainty(tank$state)$measures)
    at <- match("body_depth_m", names(tank$measures))
    told <- last_of("flume_measures")
    expect_identical(told$level, 90)
    row <- found$measures[found$measures$measure == "body_depth_m", ]
    expect_identical(c(told$lower[at], told$upper[at]), c(row$lower, row$upper))
    expect_equal(unclass(told$error)[at], row$mesh)
    # computed again for another design, and only on request
    ask(session, ropes.cable.length = list(value = 900, unit = "m"))
    expect_identical(tank$uncertainty$measures, uncertainty(tank$state)$measures)
    session$hear(intervals_wanted = FALSE)
    expect_null(last_of("flume_measures")$level)
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
  })
})
