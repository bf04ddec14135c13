test_that("as.data.frame() and tidy() of a state return the same measures", {
  state <- settled("towed_cable", nodes = 300)
  table <- as.data.frame(state)
  found <- measures(state)
  expect_identical(table, data.frame(measure = names(found), value = as.double(found),
    error = unname(attr(found, "error")), unit = unname(attr(found, "unit"))))
  expect_identical(tidy(state), table)
  expect_identical(tidy(found), table)
  expect_identical(attr(measures(state), "error"), setNames(table$error, table$measure))
  row <- glance.codend_state(state)
  expect_identical(nrow(row), 1L)
  expect_true(row$converged)
  expect_identical(row$nodes, nrow(as.data.frame(state, what = "nodes")))
})

test_that("as.data.frame() of a trajectory returns long and wide tables", {
  state <- settled("towed_cable", nodes = 300)
  trajectory <- tow(state, until = 4, every = 2,
    schedule = tow_schedule(speed = data.frame(time = c(0, 2), value = c("4 knot", "4.5 knot"))))
  table <- tidy(trajectory)
  expect_named(table, c("time_s", "measure", "value", "error", "unit", "time_error", "mesh_error"))
  now <- measures(state_at(trajectory, 4))
  expect_identical(table$value[table$time_s == 4], as.double(now))
  wide <- as.data.frame(trajectory, wide = TRUE)
  expect_identical(wide$time_s, trajectory$time)
  expect_equal(unlist(wide[wide$time_s == 4, -1]), plain_measures(now))
  row <- glance.codend_trajectory(trajectory)
  expect_identical(row[c("times", "until", "end")],
    data.frame(times = 3L, until = 4, end = "reached"))
  # tow() itself stops if the energy imbalance exceeds 2 %
  expect_lt(abs(row$energy_imbalance), 0.02)

  slopes <- sensitivities(state, fields = "towing.speed", secants = FALSE)
  expect_identical(tidy(slopes)$derivative, slopes$derivative)
  expect_identical(class(as.data.frame(slopes)), "data.frame")
})

test_that("codend exports the generics of tidy tables", {
  # without library(generics), as in a script
  for (name in c("tidy", "glance", "augment")) {
    expect_identical(getExportedValue("codend", name), getExportedValue("generics", name))
  }
  state <- settled("towed_cable", nodes = 300)
  expect_identical(codend::tidy(state), as.data.frame(state))
  expect_identical(codend::glance(state), glance.codend_state(state))
})

test_that("glance() of studies of one state returns their size in one row", {
  state <- settled("towed_cable", nodes = 300)
  slopes <- sensitivities(state, fields = c("towing.speed", "ropes.cable.length"), secants = FALSE)
  row <- glance.codend_sensitivities(slopes)
  expect_identical(row[c("name", "fields", "measures")], data.frame(name = state$gear$plan$name,
    fields = 2L, measures = nrow(slopes) %/% 2L))
  found <- uncertainty(state, level = 0.8)
  row <- glance.codend_uncertainty(found)
  expect_identical(row[c("measures", "level")],
    data.frame(measures = nrow(as.data.frame(found)), level = 0.8))
  ends <- trade_off("towed_cable", list(drag = ~ total_drag, pull = ~ ship_tension),
    change = list(towing.speed = c("3 knot", "4 knot")), points = 3, nodes = 20)
  expect_identical(glance.codend_trade_off(ends)$points, nrow(ends))
})

test_that("as.data.frame() of a calibration and its posterior returns fields", {
  runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
  fit <- calibrate("towed_cable", runs, nodes = 20, match = Drag ~ total_drag_kN,
    change = list(ropes.cable.diameter = c("10 mm", "30 mm")))
  table <- as.data.frame(fit, level = 0.9)
  expect_named(table, c("field", "value", "error", "unit", "lower", "upper", "begun", "at"))
  expect_identical(table$field, "ropes.cable.diameter")
  expect_identical(table$value, unname(coef(fit)))
  expect_identical(table$error, sqrt(diag(unname(vcov(fit)))))
  # Student's t of five rows and one field
  expect_equal(table$upper - table$value, qt(0.95, 4) * table$error, tolerance = 1e-12)
  expect_identical(tidy(fit), as.data.frame(fit))
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
  draws <- suppressWarnings(sample_posterior(fit, draws = 20, burn_in = 10))
  table <- as.data.frame(draws, level = 0.5)
  expect_identical(names(table)[1:6], c("field", "value", "error", "unit", "lower", "upper"))
  expect_identical(table$value, mean(draws[[1]]))
  expect_identical(table$lower, unname(quantile(draws[[1]], 0.25)))
  expect_identical(dim(as.data.frame(draws, wide = TRUE)), c(20L, 1L))
  expect_identical(glance.codend_posterior(draws)$draws, 20L)
})

test_that("tidy() and glance() return the fields and targets of find_value()", {
  found <- find_value("towed_cable", towing.speed = c("3 knot", "5 knot"),
    target = list(body_depth = "400 m"), nodes = 20)
  expect_identical(tidy(found), found$fields)
  expect_identical(as.data.frame(found), found$fields)
  expect_identical(glance.codend_found(found)[c("reached", "n_solves")],
    data.frame(reached = found$targets$reached, n_solves = found$n_solves))
})

test_that("as.data.frame() of an optimum returns its fields", {
  best <- optimise_gear("towed_cable", minimise = ~ total_drag, nodes = 20,
    change = list(ropes.cable.length = c("900 m", "1100 m")))
  table <- tidy(best)
  expect_identical(table, data.frame(field = "ropes.cable.length", value = best$fields$value,
    error = NA_real_, unit = "m", lower = 900, upper = 1100, begun = 1000, at = "lower"))
  row <- glance.codend_optimum(best)
  expect_true(row$kept && row$converged)
  expect_lt(row$value, row$begun)
})

test_that("as.data.frame() of variations returns a row per design and measure", {
  found <- vary("towed_cable", towing.speed = c("3 knot", "4 knot"), nodes = 20)
  table <- as.data.frame(found)
  expect_named(table, c("towing.speed_knot", "measure", "value", "error", "unit"))
  drag <- table[table$measure == "total_drag_kN", ]
  expect_identical(drag$value, found$total_drag_kN)
  expect_identical(drag$towing.speed_knot, c(3, 4))
  expect_identical(drag$error, errors_by_design(found)$total_drag_kN)
  expect_identical(unique(drag$unit), "kN")
  expect_identical(tidy(found), table)
  expect_identical(glance.codend_variations(found)[c("designs", "settled")],
    data.frame(designs = 2L, settled = 2L))
  # base functions keep the wide shape
  expect_identical(dim(cbind(found, crew = 1:2)), dim(found) + 0:1)
  crew <- data.frame(towing.speed_knot = c(4, 3), crew = c("b", "a"))
  both <- merge(found, crew)
  expect_identical(both$crew, c("a", "b"))
  expect_identical(both$total_drag_kN, found$total_drag_kN)
  expect_identical(dim(merge(found, found)), dim(found))
  expect_identical(transform(found, twice = 2 * total_drag_kN)$twice, 2 * found$total_drag_kN)
})

test_that("errors of variations follow their rows and columns", {
  found <- vary("towed_cable", towing.speed = c("3 knot", "4 knot", "5 knot"), nodes = 20)
  whole <- errors_by_design(found)
  expect_identical(names(whole), setdiff(names(found), c("settled", "problem", "warning")))
  sorted <- found[c(3, 1), ]
  expect_identical(errors_by_design(sorted)$total_drag_kN, whole$total_drag_kN[c(3, 1)])
  # other packages sort rows and keep the attributes
  attributes(sorted)$row.names <- 1:2
  expect_identical(errors_by_design(sorted)$towing.speed_knot, c(5, 3))
  some <- found[c("towing.speed_knot", "total_drag_kN")]
  expect_identical(errors_by_design(some), whole[names(some)])
  some$share <- some$total_drag_kN / 20
  expect_identical(errors_by_design(some)$share, rep(NA_real_, 3))
  expect_wrong(errors_by_design(found["total_drag_kN"]), "lacks the fields or errors")
})
