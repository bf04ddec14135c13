test_that("tidy() and glance() of a state return measures and one row", {
  state <- settled("towed_cable", nodes = 300)
  table <- tidy.codend_state(state)
  expect_identical(table$estimate, as.double(measures(state)))
  expect_identical(table$term, names(measures(state)))
  row <- glance.codend_state(state)
  expect_identical(nrow(row), 1L)
  expect_true(row$converged)
  expect_identical(row$nodes, nrow(as.data.frame(state, what = "nodes")))
})

test_that("tidy() covers trajectories and sensitivities", {
  state <- settled("towed_cable", nodes = 300)
  trajectory <- tow(state, until = 4, every = 2,
    schedule = tow_schedule(speed = data.frame(time = c(0, 2), value = c("4 knot", "4.5 knot"))))
  table <- tidy.codend_trajectory(trajectory)
  now <- table[table$time == 4, ]
  expect_identical(now$estimate, as.double(measures(state_at(trajectory, 4))))
  row <- glance.codend_trajectory(trajectory)
  expect_identical(row[c("times", "until", "end")],
    data.frame(times = 3L, until = 4, end = "reached"))
  # tow() itself stops if the energy imbalance exceeds 2 %
  expect_lt(abs(row$energy_imbalance), 0.02)

  slopes <- sensitivities(state, to = "towing.speed", secants = FALSE)
  expect_identical(tidy.codend_sensitivities(slopes)$estimate, slopes$derivative)
})

test_that("generics package dispatches to the tidy methods", {
  skip_if_not_installed("generics")
  state <- settled("towed_cable", nodes = 300)
  expect_identical(generics::tidy(state), tidy.codend_state(state))
  expect_identical(generics::glance(state), glance.codend_state(state))
})

test_that("tidy() covers a calibration and its posterior", {
  runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
  fit <- calibrate("towed_cable", runs, nodes = 20, match = Drag ~ total_drag_kN,
    change = list(ropes.cable.diameter = c("10 mm", "30 mm")))
  table <- tidy.codend_calibration(fit, conf.int = TRUE, conf.level = 0.9)
  expect_identical(table$term, "ropes.cable.diameter")
  expect_identical(table$estimate, unname(coef(fit)))
  expect_identical(table$std.error, sqrt(diag(unname(vcov(fit)))))
  # Student's t of five rows and one field
  expect_equal(table$conf.high - table$estimate, qt(0.95, 4) * table$std.error, tolerance = 1e-12)
  row <- glance.codend_calibration(fit)
  expect_equal(row$AIC, AIC(fit))
  expect_identical(row[c("nobs", "df.residual")], data.frame(nobs = 5L, df.residual = 3L))
  beside <- augment.codend_calibration(fit)
  expect_identical(beside[names(runs)], runs)
  expect_equal(beside$.fitted + beside$.resid, beside$.measured)
  new <- augment.codend_calibration(fit, data.frame(towing.speed = c("7 knot", "8 knot")))
  expect_identical(new$towing.speed, c("7 knot", "8 knot"))
  expect_true(all(new$.lower < new$.fitted & new$.fitted < new$.upper))

  skip_if_not_installed("mcmc")
  draws <- suppressWarnings(sample_posterior(fit, draws = 20, begin = 10))
  table <- tidy.codend_posterior(draws, conf.level = 0.5)
  expect_identical(table$estimate, mean(draws[[1]]))
  expect_identical(table$conf.low, unname(quantile(draws[[1]], 0.25)))
  expect_identical(glance.codend_posterior(draws)$draws, 20L)
})

test_that("tidy() and glance() return the fields and targets of find_value()", {
  found <- find_value("towed_cable", towing.speed = c("3 knot", "5 knot"),
    target = list(body_depth = "400 m"), nodes = 20)
  expect_identical(tidy.codend_found(found), found$fields)
  expect_identical(as.data.frame(found), found$fields)
  expect_identical(glance.codend_found(found)[c("reached", "n_solves")],
    data.frame(reached = found$targets$reached, n_solves = found$n_solves))
})

test_that("tidy() covers an optimum and variations", {
  best <- optimise_gear("towed_cable", minimise = ~ total_drag, nodes = 20,
    change = list(ropes.cable.length = c("900 m", "1100 m")))
  table <- tidy.codend_optimum(best)
  expect_identical(table[c("term", "estimate", "at")], data.frame(term = "ropes.cable.length",
    estimate = best$fields$value, at = "lower"))
  row <- glance.codend_optimum(best)
  expect_true(row$kept && row$converged)
  expect_lt(row$value, row$begun)

  found <- vary("towed_cable", towing.speed = c("3 knot", "4 knot"), nodes = 20)
  table <- tidy.codend_variations(found)
  drag <- table[table$term == "total_drag_kN", ]
  expect_identical(drag$estimate, found$total_drag_kN)
  expect_identical(drag$towing.speed_knot, c(3, 4))
  expect_identical(drag$error, found$error.total_drag_kN)
  expect_identical(unique(drag$unit), "kN")
  expect_identical(glance.codend_variations(found)[c("designs", "settled")],
    data.frame(designs = 2L, settled = 2L))
})
