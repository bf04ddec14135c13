# Errors of measures, estimated from other meshes.

# Values with an error c h^p on meshes with these node counts, the same fraction of each value.
with_error <- function(nodes, p, share = c(a = 30, b = 6), exact = c(a = 10, b = 2)) {
  list(nodes = nodes, values = exact + share * nodes^(-p / 2))
}
fine_values <- function(p, nodes = 1600) with_error(nodes, p)$values
left <- function(p, nodes = 1600) unname(abs(fine_values(p, nodes) - c(10, 2)))

# Estimated errors of measures by class in SI, computed by the engine for one kind of each class.
kinds_of_class <- c(
  opening = "angle", force = "pull_used", place = "length", netting = "rope_on_ground",
  slack = "slack_netting"
)
errors_of <- function(values, nodes, levels, class = rep("opening", length(values))) {
  kinds <- lapply(kinds_of_class[class], function(kind) list(kind = kind))
  setNames(estimate_errors(values, kinds, nodes, levels, tolerance = 0), names(values))
}

# Error from residual and time steps for measures whose values are equal on all meshes.
left_errors <- function(values, kinds, tolerance, step_accuracy) {
  names(values) <- kinds
  kinds <- lapply(kinds, function(kind) list(kind = kind))
  level <- list(list(nodes = 600, values = values))
  found <- function(...) estimate_errors(values, kinds, 1600, level, ...)
  sqrt(found(step_accuracy, tolerance)^2 - found(0, 0)^2)
}

test_that("error estimate of first order needs two meshes", {
  # uncertainty of scatter and other orders: 20 % for a mesh with a very different size
  for (other in c(400, 12000, 40000)) {
    found <- errors_of(fine_values(1), 1600, list(with_error(other, 1)))
    expect_equal(unname(found), left(1), tolerance = 0.25, label = other)
  }
})

test_that("error estimate detects the order from monotonic meshes", {
  ratio <- function(p) {
    levels <- lapply(c(400, 800, 1600, 3200), with_error, p = p)
    unname(errors_of(fine_values(p, 6400), 6400, levels) / left(p, 6400))
  }
  # Twice the estimate covers the error. With order 1 alone, the estimate of order 1.5 would be 2.4
  # times too large.
  expect_lt(max(ratio(1.5)), 1.7)
  expect_gt(min(ratio(1)), 0.5)
  expect_gt(min(ratio(1.5)), max(ratio(1)))
})

test_that("error estimate covers drift and scatter without being too wide", {
  # Monte Carlo: measures y = 1 + s (a h + 0.25 e h) with a and e normal, s from 0.1 to 10 %
  set.seed(42)
  nodes <- c(600, 4000, 1500)
  h <- sqrt(1500 / nodes)
  sums <- vapply(1:200, function(k) {
    size <- 10^-stats::runif(1, 1, 3)
    off <- size * (outer(stats::rnorm(20), h) + 0.25 * matrix(stats::rnorm(60), 20) %*% diag(h))
    values <- 1 + off
    rownames(values) <- paste0("m", 1:20)
    found <- errors_of(values[, 3], 1500, lapply(1:2, function(k) {
      list(nodes = nodes[k], values = values[, k])
    }))
    c(mean(abs(off[, 3]) <= 2 * found), stats::median(found / abs(off[, 3])))
  }, numeric(2))
  # 95 % of a normal distribution is within 2 standard deviations, and the median ratio is 1 / 0.67.
  # Weighting several orders, with one true order, widens both slightly.
  expect_gte(mean(sums[1, ]), 0.93)
  expect_lte(mean(sums[1, ]), 0.99)
  expect_lte(mean(sums[2, ]), 2)
})

test_that("error orders have weights by the likelihood of mesh differences", {
  nodes <- c(400, 900, 2500)
  values <- rbind(a = c(10.5, 10.31, 10.2), b = c(2.02, 2.05, 1.99))
  levels <- lapply(1:2, function(k) list(nodes = nodes[k], values = values[, k]))
  found <- errors_of(values[, 3], nodes[3], levels, c("force", "force"))
  # the same from differences to the last mesh, which exclude the constant
  differ <- cbind(diag(2), -1)
  h <- sqrt(nodes[3] / nodes)
  by_order <- lapply(c(0.75, 1, 1.5), function(order) {
    covariance <- outer(h^order, h^order) + diag((0.25 * h)^2)
    of_differences <- differ %*% covariance %*% t(differ)
    d <- differ %*% t(values)
    squares <- diag(t(d) %*% solve(of_differences, d))
    # too few per class: the median of both
    own <- stats::median(sqrt(squares / 2) / values[, 3]) * values[, 3]
    variance <- (own^2 + squares) / 3
    # least squares of a constant, each mesh weighted by its covariance
    root <- solve(t(chol(covariance)))
    constant <- lm.fit(root %*% rep(1, 3), root %*% t(values))$coefficients
    list(
      weight = variance^(-3 / 2) / sqrt(det(of_differences)),
      square = (values[, 3] - constant)^2 + variance / sum((root %*% rep(1, 3))^2)
    )
  })
  weight <- vapply(by_order, `[[`, numeric(2), "weight")
  square <- vapply(by_order, `[[`, numeric(2), "square")
  expect_equal(found, sqrt(rowSums(weight * square) / rowSums(weight)), ignore_attr = TRUE)
})

test_that("error estimate ignores measures identical on all meshes", {
  # three measures in 1 + h / 100 and two that differ only by rounding
  nodes <- c(400, 900, 2500)
  moving <- outer(c(a = 1, b = 2, c = 3), 1 + sqrt(2500 / nodes) / 100)
  errors <- function(values) {
    levels <- lapply(1:2, function(k) list(nodes = nodes[k], values = values[, k]))
    errors_of(values[, 3], 2500, levels)
  }
  with_still <- errors(rbind(moving, d = 0.1, e = 4000 / 3))
  expect_equal(with_still[1:3], errors(moving), tolerance = 1e-12)
})

test_that("mesh levels of another gear scale with its measures", {
  level <- list(nodes = 600, values = c(a = 2, none = 3))
  found <- carry_levels(list(level), c(a = 4, none = 0), c(a = 8, none = 1))[[1]]
  expect_identical(found, list(nodes = 600, values = c(a = 4, none = 4)))
})

test_that("error estimate uses very coarse meshes only without better ones", {
  crude <- list(nodes = 250, values = c(a = 30, b = 1))
  fair <- with_error(600, 1)
  alone <- errors_of(fine_values(1), 1600, list(fair))
  expect_identical(errors_of(fine_values(1), 1600, list(crude, fair)), alone)
  expect_gt(errors_of(fine_values(1), 1600, list(crude))[["a"]], 10 * alone[["a"]])
})

test_that("error estimate of an unusually stable measure stays near its class", {
  # three measures per class with differences of 1 %, and one with 0
  values <- c(a = 10, b = 10.1, c = 10.1, d = 10.1, e = 1, f = 1.05, g = 1.05, h = 1.05)
  level <- list(nodes = 600, values = c(rep(10, 4), rep(1, 4)))
  names(level$values) <- names(values)
  class <- rep(c("opening", "force"), each = 4)
  found <- unname(errors_of(values, 1600, list(level), class))
  # the mean of its own square, 0, and the usual one
  expect_equal(found[1], found[2] / sqrt(2), tolerance = 0.25)
  expect_equal(found[5], found[6] / sqrt(2), tolerance = 0.25)
  # the other class is five times as uncertain
  expect_equal(found[5] / 1, 5 * found[1] / 10, tolerance = 0.05)
})

test_that("error estimate of forces does not depend on tiny drag", {
  # a mooring of 8 kN in still water, whose drag is negligible and changes by 100 %
  values <- c(tension = 8.1, other = 4.05, third = 2, drag = 1e-9)
  level <- list(nodes = 600, values = c(tension = 8.11, other = 4.06, third = 2.001, drag = -1e-9))
  found <- errors_of(values, 1600, list(level), rep("force", 4))
  expect_lt(found[["tension"]], 0.05)
  expect_lt(found[["drag"]], 1e-8)
  # the error is at least the solver's residual, 1e-8 of the largest force
  expect_equal(
    left_errors(c(8.1, 4, 2, 0), c("tension", "drag", "lift", "total_drag"), 1e-6, 0),
    rep(8.1e-6, 4), tolerance = 1e-3
  )
  expect_equal(
    left_errors(c(3, 20, 0, 0), c("spread", "height", "area", "volume"), 1e-6, 0),
    c(20, 20, 400, 8000) * 1e-6, tolerance = 1e-3
  )
  still <- settle(update(read_gear("gillnet"), water.current.speed = "0 m/s"), nodes = 300)
  error <- attr(measures(still), "error")
  expect_true(all(is.finite(error)))
  expect_lt((error / plain_measures(measures(still)))[["anchor_tension_port_kN"]], 0.2)
  # and such a drag is not a main measure
  expect_false(attr(measures(still), "main")[["total_drag_kN"]])
  expect_lt(main_error(measures(still)), 0.1)
  slow <- settle(update(read_gear("gillnet"), water.current.speed = "0.15 m/s"), nodes = 300)
  expect_true(attr(measures(slow), "main")[["total_drag_kN"]])
})

test_that("netting keeps a minimum error if two meshes agree", {
  values <- c(slack = 0, spread = 60, depth = 40)
  share <- function(nodes, netting = "slack") {
    level <- list(nodes = 600, values = values)
    (errors_of(values, nodes, list(level), c(netting, "opening", "place")) / values)[-1L]
  }
  # 0.2 % of an opening with 1,500 nodes, and 0.1 % with elements of half the length
  expect_equal(share(1500)[["spread"]], 2e-3, tolerance = 1e-3)
  expect_equal(share(6000)[["spread"]], 1e-3, tolerance = 1e-3)
  # no such minimum for depths, and for gear without netting
  expect_lt(share(1500)[["depth"]], 1e-4)
  expect_lt(share(1500, "netting")[["spread"]], 1e-4)
})

test_that("slack netting has a minimum error with few nodes", {
  levels <- list(list(nodes = 400, values = c(slack = 0.1, b = 20)))
  slack <- function(nodes, value = 0.1) {
    levels[[1]]$values[["slack"]] <- value
    errors_of(c(slack = value, b = 20.01), nodes, levels, c("slack", "opening"))[["slack"]]
  }
  # the survey trawl's 11.0 % becomes 7.9 % with 8 times the nodes; with no slack netting the error
  # is a fraction of a row
  expect_gte(slack(1500), 0.01)
  expect_lt(slack(6000), 0.6 * slack(1500))
  expect_gt(slack(1500, 0), 0.001)
})

test_that("error estimate is NA for meshes of nearly equal size", {
  found <- errors_of(c(a = 1), 1600, list(list(nodes = 1500, values = c(a = 2))))
  expect_identical(found, c(a = NA_real_))
  expect_identical(errors_of(c(a = 1), 1600, NULL), c(a = NA_real_))
})

test_that("every measure has a finite error with few nodes", {
  for (name in c("gillnet", "t90_codend", "crossing_cables", "longline", "cage")) {
    found <- measures(settle(name, nodes = 300))
    expect_true(all(is.finite(attr(found, "error"))), label = name)
    expect_true(is.finite(main_error(found)), label = name)
  }
})

test_that("finer meshes are within twice the estimated error", {
  # `make errors` measures 100 gears and requires 90 %.
  hits <- unlist(lapply(c("gillnet", "beam_trawl", "cage"), function(name) {
    told <- measures(settle(name, nodes = 550))
    true <- measures(settle(name, nodes = 4400))
    error <- attr(told, "error")
    abs(as.double(told) - as.double(true[names(told)])) <= 2 * error
  }))
  expect_gte(mean(hits), 0.9)
})

test_that("errors appear in tables, summaries and JSON of measures", {
  state <- settle("gillnet", nodes = 550)
  error <- attr(measures(state), "error")
  expect_true(all(is.finite(error)))
  table <- as.data.frame(state, what = "measures")
  expect_identical(table$error, unname(error))
  expect_match(format(summary(state)), "m +computed to [0-9]", all = FALSE)
  expect_match(format(summary(state)), "Discretisation error", all = FALSE)
  expect_identical(attr(measures(state)[2:3], "error"), error[2:3])
  record <- jsonlite::fromJSON(state_json(state))$measures
  expect_identical(vapply(record, `[[`, 0, "error"), error)
  # transferred to another design: the same relative error
  near <- settle(update(read_gear("gillnet"), water.current.speed = "0.155 m/s"), nodes = 550,
    from = state)
  # slack netting also has an error of a fraction of a row
  share <- function(found) {
    (attr(found, "error") / plain_measures(found))[names(found) != "slack_netting_percent"]
  }
  expect_equal(share(measures(near)), share(measures(state)), tolerance = 1e-9)
})

test_that("settle(accuracy = ) refines the mesh or warns", {
  coarse <- settle("cage", nodes = 550)
  wanted <- main_error(measures(coarse)) / 2
  finer <- settle("cage", nodes = 550, accuracy = wanted)
  expect_lte(main_error(measures(finer)), wanted)
  expect_gt(finer$mesh$nodes, 2 * 550 * 0.9)
  expect_warning(settle("towed_cable", accuracy = "0.0001 %"), class = "codend_warning_accuracy")
})

test_that("settle() by default refines to 1 % or reports the miss", {
  most <- codend:::nodes_per_net * codend:::extra_ratio
  coarse <- settle("pair_trawl", nodes = 1500)
  expect_null(coarse$report$accuracy_aimed_at)
  expect_gt(main_error(measures(coarse)), 0.011)
  aimed <- settle("pair_trawl")
  error <- main_error(measures(aimed))
  expect_lt(error, main_error(measures(coarse)))
  expect_true(error <= 0.011 || aimed$mesh$nodes > 0.9 * most)
  # a mesh has up to a sixth more nodes than requested
  expect_lt(aimed$mesh$nodes, 1.18 * most)
  expect_match(capture.output(print(aimed)), "target 1 %, reached [0-9.]+ %", all = FALSE)
  expect_match(format(summary(aimed)), "(target 1 %)", fixed = TRUE, all = FALSE)
  # from a state: its mesh, and no target
  again <- settle(update(aimed$gear, towing.speed = "3.3 knot"), from = aimed)
  expect_identical(engine_array(again, "nodes"), engine_array(aimed, "nodes"))
  expect_null(again$report$accuracy_aimed_at)
  # a result within 1 % at once is not refined
  expect_identical(settle("stow_net")$position, settle("stow_net", nodes = 1500)$position)
})

test_that("errors of a tow cover finer meshes and a tighter accuracy", {
  faster <- function(...) {
    tow("poly_noreastern_trawl", until = 40, every = 10, schedule = tow_schedule(speed = data.frame(
      time = c(0, 20), value = c("3 knot", "3.5 knot")
    )), ...)
  }
  towed <- faster(nodes = 300)
  coarse <- as.data.frame(towed)
  reference <- faster(nodes = 1200, accuracy = 0.001)
  fine <- as.data.frame(reference)
  tight <- as.data.frame(faster(nodes = 300, accuracy = 0.001))
  expect_identical(fine$measure, coarse$measure)
  within <- function(value, other, error) mean(abs(value - other) <= 2 * error + 1e-9 * abs(other))
  expect_gte(within(coarse$value, fine$value, coarse$error), 0.9)
  moved <- coarse$time_s > 0
  # measures of one tow are correlated: 90 % holds for many tows (bench/results/tow-errors.md)
  expect_gte(within(coarse$value[moved], tight$value[moved], coarse$time_error[moved]), 0.8)
  # not by large errors: a median of the ratio of 3 is the aim
  expect_lt(median((coarse$time_error / abs(coarse$value - tight$value))[moved], na.rm = TRUE), 4)
  expect_equal(coarse$error^2, coarse$time_error^2 + coarse$mesh_error^2, tolerance = 1e-9)
  # at the start there is only the error of the settled gear
  at <- coarse$time_s == 0
  start <- measures(settle("poly_noreastern_trawl", nodes = 300))
  expect_equal(coarse$mesh_error[at], unname(attr(start, "error")), tolerance = 1e-6)
  # summary values, with the same reference
  most <- summary(towed)
  expect_equal(most$greatest, as.vector(tapply(coarse$value, coarse$measure, max)[most$measure]))
  expect_gte(within(most$greatest, summary(reference)$greatest, most$greatest_error), 0.9)
  expect_gte(within(most$mean, summary(reference)$mean, most$mean_error), 0.9)
  expect_gte(within(most$least_at_s, summary(reference)$least_at_s, most$least_at_s_error), 0.8)
})

test_that("errors of a shot gear come from another mesh of its tow", {
  shot <- function(nodes) tow("purse_seine", until = 60, every = 30, nodes = nodes, accuracy = 0.3)
  start <- shot(250)
  coarse <- as.data.frame(start)
  expect_true(all(is.finite(coarse$error)))
  on <- as.data.frame(tow(start, until = 70))
  expect_true(all(is.finite(on$error[on$time_s == 70])))
  share <- function(table, time) {
    with(table[table$time_s == time & table$measure == "lead_line_depth_quarter_m", ],
      mesh_error / value)
  }
  expect_equal(share(on, 70), share(coarse, 60), tolerance = 0.05)
  # a third mesh: the bottom of the net moves differently from the gear at rest
  fine <- as.data.frame(shot(600))
  off <- abs(coarse$value - fine$value)
  exact <- off <= 1e-7 * abs(fine$value)
  # 54 values: 0.9 less two standard deviations of the fraction
  expect_gte(mean((off <= 2 * coarse$error | exact)[coarse$time_s > 0]), 0.8)
  expect_gt(coarse$error[coarse$time_s == 60 & coarse$measure == "enclosed_volume_m3"], 0)
})

test_that("short initial warps keep an error for every measure", {
  shooting <- as.data.frame(tow("midwater_trawl", until = 20, every = 20, nodes = 300))
  expect_true(all(is.finite(shooting$error[is.finite(shooting$value)])))
})
