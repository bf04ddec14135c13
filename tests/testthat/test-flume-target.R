wanted <- function(..., paths = list("ropes.cable.length"), measure = "body_depth_m",
                   target = "450 m", unit = "m") {
  list(paths = paths, measure = measure, target = target, unit = unit, ...)
}

test_that("page finds the field value of find_value() for a required measure", {
  in_flume("towed_cable", function(session, sent, tank) {
    session$hear(target_wanted = wanted())
    found <- sent("flume_target")[[1]]
    expect_true(found$reached)
    expect_identical(unclass(found$paths), "ropes.cable.length")
    same <- find_value("towed_cable", ropes.cable.length = c("500 m", "1500 m"),
      target = list(body_depth = "450 m"), nodes = 300)
    expect_equal(found$value, same$fields$value, tolerance = 1e-5)
    expect_identical(found$unit, "m")
    expect_identical(found[c("measure", "measure_unit", "target")],
      list(measure = "body depth", measure_unit = "m", target = 450))
    expect_equal(found$result, 450, tolerance = 1e-4)
    # bare numbers are in the displayed unit
    session$hear(target_wanted = wanted(target = "246,06", unit = "fathom"))
    expect_equal(sent("flume_target")[[1]]$value, found$value, tolerance = 1e-4)
    # the page, not the worker, changes the design
    expect_identical(tank$gear$plan, read_gear("towed_cable")$plan)
  })
})

test_that("page reports the nearest value if a target is out of reach", {
  in_flume("towed_cable", function(session, sent, tank) {
    session$hear(target_wanted = wanted(target = "5000"))
    found <- sent("flume_target")[[1]]
    expect_false(found$reached)
    expect_identical(found[c("low", "high", "value", "unit", "target")],
      list(low = 500, high = 1500, value = 1500, unit = "m", target = 5000))
  })
})

test_that("page rejects an unknown measure, field or target", {
  in_flume("towed_cable", function(session, sent, tank) {
    wrong <- list(
      wanted(measure = "depth"), wanted(measure = 3), wanted(paths = list("name")),
      wanted(paths = 3), wanted(target = "deep"), wanted(target = list(1)),
      wanted(target = "3 kN"), wanted(target = "")
    )
    expect_asks_refused(session, sent, "target_wanted", wrong, "target")
  })
})
