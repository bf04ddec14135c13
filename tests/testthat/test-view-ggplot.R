skip_if_not_installed("ggplot2")

layer <- function(plot, k) ggplot2::layer_data(plot, k)

test_that("a plane shows every line in its colour", {
  state <- settled("midwater_trawl", nodes = 500)
  plot <- ggplot2::autoplot(state, plane = "xz")
  drawing <- state_drawing(state)
  every <- lapply(seq_along(plot$layers), function(k) layer(plot, k))
  every <- Filter(function(data) "xend" %in% names(data), every)
  lines <- do.call(rbind, lapply(every, `[`, c("x", "y", "xend", "yend", "colour")))
  expect_equal(nrow(lines), length(drawing$ropes$tension) + length(drawing$netting$tension))
  # depth grows downwards: ggplot's reversed scale holds its negative
  expect_setequal(round(c(lines$y, lines$yend), 6),
    round(c(drawing$ropes$from[3, ], drawing$ropes$to[3, ], drawing$netting$from[3, ],
      drawing$netting$to[3, ]), 6))
  scale <- tension_scale(drawing$netting$tension, "netting")
  taut <- drawing$netting$tension > 0
  expect_setequal(intersect(lines$colour, scale$colours),
    c(intersect(tension_colours(scale, drawing$netting$tension[taut]), scale$colours)))
})

test_that("a gear without netting, and one that is slack, have pictures", {
  expect_s3_class(ggplot2::ggplot_build(ggplot2::autoplot(settled("towed_cable"))), "ggplot_built")
  state <- unsettled(sheets_plan)
  state$bar_tension[] <- 0
  state$u_tension[] <- 0
  state$v_tension[] <- 0
  expect_s3_class(ggplot2::ggplot_build(ggplot2::autoplot(state, plane = "yz")), "ggplot_built")
})

test_that("facets hold the values of their tables", {
  tow <- tow("towed_cable", until = 20, every = 10)
  built <- layer(ggplot2::autoplot(tow, measures = "body_depth_m"), 1)
  expect_equal(built$y, as.data.frame(tow)$value[as.data.frame(tow)$measure == "body_depth_m"])

  found <- vary("towed_cable", towing.speed = 2:3, ropes.cable.length = c("300 m", "400 m"))
  built <- layer(ggplot2::autoplot(found, measures = "total_drag_kN"), 2)
  expect_equal(sort(built$y), sort(found$total_drag_kN))
  expect_setequal(built$colour, series_colours(2))

  x <- tensions_along(settled("crossing_cables"))
  built <- layer(ggplot2::autoplot(x), 1)
  expect_equal(range(built$y), range(x$tension_kN))
})
