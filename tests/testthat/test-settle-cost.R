# What settling may cost, in steps and factorisations, never in seconds: a silent loss shows here.

# Steps on the finest level when this was written, by case, and the most that is allowed. Netting
# that goes slack on its way makes the number of steps jump by a half when anything changes, so
# trawls get twice theirs; what stays taut gets half as many again.
settling_steps <- data.frame(
  name = c("towed_cable", "crossing_cables", "flat_panel", "flat_panel", "midwater_trawl",
    "midwater_trawl", "midwater_trawl"),
  netting = c("bars", "bars", "bars", "triangles", "bars", "triangles", "bars"),
  nodes = c(500, 500, 500, 500, 500, 500, 10000),
  steps = c(12, 6, 19, 18, 59, 25, 34),
  most = c(18, 9, 29, 27, 118, 50, 68)
)

test_that("shipped gears settle in few steps, with one factorisation a step", {
  for (k in seq_len(nrow(settling_steps))) {
    case <- settling_steps[k, ]
    report <- settle(read_gear(case$name), nodes = case$nodes, netting = case$netting)$report
    label <- paste(case$name, case$netting, case$nodes)
    expect_lte(report$iterations, case$most, label = label)
    expect_lte(report$factorisations, report$iterations, label = label)
  }
})
