test_that("in_preferred() shows measures in the user's units", {
  expect_identical(preferred_of(list(length = "fathom", force = "kN", speed = "furlong", x = 1)),
    list(m = "fathom"))
  expect_identical(unname(preferred_of("nonsense")), list())
  state <- settled("towed_cable", nodes = 300)
  now <- measures(state)
  table <- design_table(list(list(measures = now), list(measures = now)))
  liked <- in_preferred(table, preferred_of(list(length = "fathom", force = "tf", speed = "knot")))
  depth <- match("body depth", table$measure)
  # a fathom is six feet of 0.3048 m; a tonne weighs 9.80665 kN
  expect_equal(liked$values[[1]][depth], now[["body_depth_m"]] / (6 * 0.3048), ignore_attr = TRUE)
  drag <- match("total drag", table$measure)
  expect_equal(liked$values[[1]][drag], now[["total_drag_kN"]] / 9.80665, ignore_attr = TRUE)
  expect_identical(liked$unit[c(depth, drag)], c("fathom", "tf"))
  listed <- displayed_measures(now, now, list(m = "ft"))[[match("body_depth_m", names(now))]]
  expect_identical(listed[c("words", "unit")], list(words = "body depth (ft)", unit = "ft"))
  expect_equal(listed$factor, 1 / 0.3048)
})
