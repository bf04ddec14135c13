speeds <- function(..., paths = list("towing.speed"), unit = "knot", from = "3", to = "5 knot",
                   number = 3) {
  list(paths = paths, unit = unit, from = from, to = to, number = number, ...)
}

test_that("page varies a field with the results of vary()", {
  in_flume("towed_cable", function(session, sent, tank) {
    session$hear(vary_wanted = speeds())
    told <- sent("flume_varied")
    expect_identical(vapply(told, `[[`, NA, "running"), c(TRUE, TRUE, TRUE, FALSE))
    varied <- told[[4]]$varied
    expect_identical(varied[c("path", "unit", "now", "of")],
      list(path = "towing.speed", unit = "knot", now = 4, of = 3L))
    found <- vary("towed_cable", towing.speed = paste(3:5, "knot"), nodes = 300)
    # settled from the same state
    words <- vapply(varied$measures, `[[`, "", "words")
    depth <- varied$measures[[match("body depth", words)]]
    expect_identical(depth$unit, "m")
    expect_equal(unclass(depth$values), found$body_depth_m, tolerance = 1e-6)
    table <- utils::read.csv(saved_file(session, "vary"), check.names = FALSE)
    expect_equal(table$towing.speed_knot, 3:5)
    expect_equal(table$total_drag_kN, found$total_drag_kN, tolerance = 1e-6)
    # an invalid value is reported as such
    session$hear(vary_wanted = speeds(from = "-1", to = "4", number = 2))
    varied <- utils::tail(sent("flume_varied"), 1L)[[1]]$varied
    expect_match(varied$problems[1], "towing.speed", fixed = TRUE)
    expect_identical(unclass(varied$problems)[2], "")
    # the current design has not changed
    expect_identical(tank$gear$plan, read_gear("towed_cable")$plan)
  })
})

test_that("page settles one value at a time until stopped", {
  jobs <- list()
  held <- function(late = FALSE, ...) {
    worker <- direct_worker()
    if (late) worker$ask <- function(kind, make, then, ...) jobs <<- c(jobs, list(list(make, then)))
    worker
  }
  answer <- function() {
    job <- utils::tail(jobs, 1L)[[1]]
    request <- job[[1]]()
    job[[2]](if (!is.null(request)) flume_answer(request, new.env()))
  }
  in_flume("towed_cable", new_worker = held, function(session, sent, tank) {
    session$hear(vary_wanted = speeds())
    expect_length(jobs, 1L)
    answer()
    expect_length(jobs, 2L)
    session$hear(vary_stop = 1)
    expect_false(utils::tail(sent("flume_varied"), 1L)[[1]]$running)
    answer()
    expect_length(jobs, 2L)
    session$hear(vary_wanted = speeds(again = 1))
    session$hear(words = list(number = 2, asked = list(base = "flat_panel")))
    answer()
    expect_length(jobs, 3L)
    expect_false(utils::tail(sent("flume_varied"), 1L)[[1]]$running)
  })
})

test_that("page rejects an unknown field, unit, number or count", {
  in_flume("towed_cable", function(session, sent, tank) {
    wrong <- list(
      speeds(paths = list("towing.sped")), speeds(paths = list("name")), speeds(paths = 3),
      speeds(unit = "m"), speeds(from = "fast"), speeds(from = list(1)), speeds(to = "3"),
      speeds(number = 1e6), speeds(number = "three"), speeds(unit = list("knot"))
    )
    expect_asks_refused(session, sent, "vary_wanted", wrong, "vary")
  })
})
