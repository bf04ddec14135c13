# Uncertainties compared with analytical solutions, differences of settled gears, and random true
# values.

# A sphere on a thin line: the sphere has all the drag, and its pull is known.
# `...`: other uncertainties.
known_sphere <- function(...) {
  plan <- towed_sphere_plan(ropes = list(line = list(axial_stiffness = "12 MN")))
  uncertain <- list(
    towing.speed = "1 %", pieces.sphere.mass = "4 %", pieces.sphere.volume = "0 %",
    pieces.sphere.diameter = "0 %", ropes.line.length = "0 %", ropes.line.diameter = "0 %",
    multipliers.piece_drag = "5 %"
  )
  uncertain[...names()] <- list(...)
  update(as_gear(plan), uncertain = uncertain)
}

row_of <- function(found, measure) found$measures[found$measures$measure == measure, ]

test_that("uncertainty() of a towed sphere equals the analytical budget", {
  state <- settle(known_sphere())
  found <- uncertainty(state)
  drag <- 0.47 * pi / 16 * 1025 * 2^2 / 2
  weight <- 9.81 * (200 - 0.01 * 1025)
  pull <- sqrt(drag^2 + weight^2)
  model <- measure_residuals(measures(state))$sd[names(measures(state)) == "total_drag_kN"]
  row <- row_of(found, "total_drag_kN")
  # drag is proportional to the multiplier and the speed squared; the line's drag is 1e-8 of the
  # total
  expect_equal(row$coefficients, 0.05 * drag / 1000, tolerance = 1e-5)
  expect_equal(row$conditions, 0.02 * drag / 1000, tolerance = 1e-5)
  expect_equal(row$plan, 0, tolerance = 1e-5)
  expect_equal(row$model, model * drag / 1000, tolerance = 1e-5)
  expect_equal(row$error,
    sqrt((0.05^2 + 0.02^2 + model^2) * (drag / 1000)^2 + row$mesh^2), tolerance = 1e-5)
  # the pull by the mass: 9.81 weight / pull
  row <- row_of(found, "pull_kN")
  expect_equal(row$plan, 0.04 * 200 * 9.81 * weight / pull / 1000, tolerance = 1e-3)
  largest <- found$sources[found$sources$measure == "pull_kN", ][1L, ]
  expect_identical(largest$source, "pieces sphere mass")
  expect_equal(largest$percent, 100 * (largest$contribution / row$error)^2)
  # almost linear and normal: Student's t with the effective degrees of freedom (JCGM 100:2008,
  # G.4). 2,000 draws give the limits to about 2 %.
  reach <- qt(0.95, row$freedom) * row$error
  expect_equal(c(row$value - row$lower, row$upper - row$value), c(reach, reach), tolerance = 0.03)
})

test_that("uncertainty() intervals follow ranges and curvature to both sides", {
  drag <- function(state) row_of(uncertainty(state), "total_drag_kN")
  with_speed <- function(uncertainty) {
    known_sphere(towing.speed = uncertainty, multipliers.piece_drag = "0 %",
      pieces.sphere.mass = "0 %")
  }
  state <- settle(with_speed("2 m/s to 2.4 m/s"))
  row <- drag(state)
  model <- row$model
  # Drag is proportional to the square of the speed, and the speed is uniform between both ends. The
  # analytical quantiles include the model error by simulation.
  set.seed(1)
  freedom <- measure_residuals(measures(state))$freedom[names(measures(state)) == "total_drag_kN"]
  truth <- row$value * runif(1e6, 1, 1.2)^2 + model * rt(1e6, freedom)
  expect_equal(c(row$lower, row$upper), unname(quantile(truth, c(0.05, 0.95))), tolerance = 0.02)
  expect_gt(row$upper - row$value, 2 * (row$value - row$lower))
  # a wide speed
  wide <- drag(settle(with_speed("30 %")))
  truth <- wide$value * (1 + 0.3 * rnorm(1e6))^2 + model * rt(1e6, freedom)
  expect_equal(c(wide$lower, wide$upper), unname(quantile(truth, c(0.05, 0.95))), tolerance = 0.06)
})

test_that("uncertainty() warns of a range in which the gear does not settle", {
  gear <- update(read_gear("towed_cable"),
    ropes.cable.length = list(value = "100 m", uncertainty = "80 %"))
  warning <- expect_warning(uncertainty(settle(gear), "body_depth_m"),
    class = "codend_warning_range")
  expect_match(conditionMessage(warning), "ropes.cable.length: [0-9]+ %")
})

test_that("uncertainty() uses the covariance of multipliers from measurements", {
  table <- package_table("uncertainty_multipliers.csv")
  covariance <- as.matrix(table[-1])
  expect_identical(names(table)[-1], table$multiplier)
  expect_true(all(eigen(covariance, TRUE, TRUE)$values > 0))
  found <- uncertainty(settle(update(read_gear("towed_cable"), ropes.cable.segments = 20)),
    "body_depth_m")
  rows <- found$sources[found$sources$group == "coefficients", ]
  shared <- match(force_multipliers[table$multiplier], rows$source)
  sd <- sqrt(diag(covariance))
  # published standard uncertainties (uncertainty.csv): 15 % across ropes, 50 % along them
  expect_equal(rows$share[shared[1:2]], c(0.15, 0.5) * sd[1:2], ignore_attr = TRUE)
  effect <- ifelse(is.na(shared), 0, rows$contribution[shared]) / sd
  own <- rows$contribution[-shared[!is.na(shared)]]
  row <- row_of(found, "body_depth_m")
  expect_equal(row$coefficients, sqrt(drop(effect %*% covariance %*% effect) + sum(own^2)))
  # without covariances the part differs
  expect_gt(abs(row$coefficients / sqrt(sum(rows$contribution^2)) - 1), 1e-4)
  # a multiplier with an uncertainty in the plan is independent
  given <- update(read_gear("towed_cable"), uncertain = list(multipliers.rope_normal_drag = "5 %"))
  sources <- multiplier_sources(given)
  at <- which(vapply(sources, `[[`, "", "multiplier") == "rope_normal_drag")
  expect_identical(source_correlation(sources)[at, ], diag(length(sources))[at, ])
})

test_that("derivatives by multipliers equal differences without a new mesh", {
  state <- settled("poly_noreastern_trawl", nodes = 400)
  sources <- multiplier_sources(state$gear)
  for (k in seq_along(sources)) sources[[k]][c("share", "off")] <- list(1e-3, 0)
  work <- tangent_work(state)
  before <- work$cost$factorisations
  main <- c("total_drag_kN", "headline_height_m", "door_spread_m", "warp_tension_port_kN")
  for (name in c("rope_normal_drag", "screen_drag", "knot_drag", "board_lift", "ground_friction",
    "ground_gear_weight")) {
    source <- sources[[match(name, names(force_multipliers))]]
    slope <- field_sensitivities(work, source_field(source, state$gear$plan),
      secants = FALSE)$slope[main]
    sides <- vapply(c(0.999, 1.001), function(factor) {
      gear <- do.call(update, c(list(state$gear), setNames(list(factor), paste0("multipliers.",
        name))))
      plain_measures(measures(settle(gear, nodes = 400, from = state)))[main]
    }, numeric(4))
    secant <- unname((sides[, 2] - sides[, 1]) / 0.002)
    # settled to 1e-6 of the largest tension over a step of 2e-3; third-order curvature
    expect_equal(unname(slope), secant, tolerance = 5e-3, info = name)
  }
})

test_that("kinks of slack netting contribute as in settled gears", {
  state <- settled("cage", nodes = 400)
  sources <- uncertainty_sources(state$gear)
  names(sources) <- vapply(sources, `[[`, "", "name")
  sources <- sources[c("twine diameters", "diameters of ropes and wires")]
  found <- source_contributions(state, sources, follow = 0L)$spread
  work <- tangent_work(state)
  whole <- vapply(sources, function(source) {
    sides <- secant_derivatives(work, source_field(source, state$gear$plan), source$share)
    (sides$below + sides$above) / 2 * source$share
  }, work$values)
  main <- c("total_drag_kN", "bottom_depth_m")
  # the drag by the current is nonlinear in d over 10 %
  expect_equal(found[main, ], whole[main, ], tolerance = 0.1, ignore_attr = TRUE)
  # the twines of one cell are 0.1 % of the netting, a fifth of the result
  slack <- found["slack_netting_percent", 1L] / whole["slack_netting_percent", 1L]
  expect_gt(slack, 1 / 2)
  expect_lt(slack, 2)
})

test_that("uncertainty() intervals contain random truths at their stated rate", {
  gear <- update(read_gear("towed_cable"), ropes.cable.segments = 20)
  state <- settle(gear)
  found <- uncertainty(state, c("body_depth_m", "ship_tension_kN"))
  sources <- uncertainty_sources(gear)
  set.seed(20260401)
  n <- 150
  truth <- vapply(seq_len(n), function(k) {
    fields <- unlist(lapply(sources, function(source) {
      field <- common_field(gear$plan, source$paths)
      share <- max(rnorm(1, source$off, source$share), -0.9)
      # correlations of multipliers are irrelevant, because one multiplier dominates
      setNames(lapply(field$parts, function(part) field_text(part$value * (1 + share), part)),
        source$paths)
    }), recursive = FALSE)
    measures(settle(do.call(update, c(list(gear), fields)), from = state))[found$measures$measure]
  }, numeric(2))
  model <- found$measures$model
  truth <- truth + model * matrix(rnorm(2 * n), 2)
  inside <- rowMeans(truth >= found$measures$lower & truth <= found$measures$upper)
  # binomial: 0.9 +- 3 sqrt(0.9 0.1 / 150), and t with few degrees of freedom is wider
  expect_true(all(inside > 0.9 - 0.075))
  expect_true(all(inside < 0.995))
})

test_that("uncertainty(method = \"samples\") agrees with derivatives for a smooth gear", {
  state <- settle(known_sphere())
  line <- uncertainty(state, "total_drag_kN")
  drawn <- uncertainty(state, "total_drag_kN", method = "samples", samples = 60)
  # 60 well spread draws give a standard deviation to about 5 %
  expect_equal(drawn$measures$error, line$measures$error, tolerance = 0.08)
  expect_equal(drawn$measures$upper, line$measures$upper, tolerance = 0.03)
  expect_identical(drawn$cost$n_solves, 60)
})

test_that("uncertainty() names the analytically most useful measurement", {
  found <- uncertainty(settle(known_sphere()))
  best <- found$next_measurement[found$next_measurement$measure == "total_drag_kN", ][1L, ]
  row <- row_of(found, "total_drag_kN")
  # the pull is mostly weight: the speed is the most useful, 2 % of the drag
  expect_identical(best$measurement, "towing speed")
  expect_equal(best$remaining_sd, sqrt(row$error^2 - (0.02 * row$value)^2), tolerance = 1e-4)
  expect_output(print(found), "best next measurement")
})

test_that("all twine of a net has the same relative diameter error", {
  sources <- field_sources(settled_gear("poly_noreastern_trawl"))
  twine <- Find(function(source) source$name == "twine diameters", sources)
  plan <- settled_gear("poly_noreastern_trawl")$plan
  values <- vapply(twine$paths, function(path) plan_field(plan, path)$value, "")
  expect_gt(length(unique(values)), 1L)
  gear <- scaled_gear(settled_gear("poly_noreastern_trawl"), common_field(plan, twine$paths), 0.1)
  now <- vapply(twine$paths, function(path) plan_field(gear$plan, path)$value, "")
  expect_equal(vapply(now, quantity_si, 0, "length") / vapply(values, quantity_si, 0, "length"),
    rep(1.1, length(values)), ignore_attr = TRUE)
  # every row of the table is readable and has a source
  table <- uncertainty_table
  expect_true(all(is.finite(vapply(table$uncertainty, table_share, 0))))
  expect_true(all(nzchar(table$source)))
  expect_identical(table$field[table$group == "coefficients"], names(force_multipliers))
})

test_that("calibrate() starts from known priors and reduces their uncertainty", {
  gear <- known_sphere()
  priors <- known_priors(gear, c("multipliers.piece_drag", "pieces.sphere.mass"))
  expect_equal(priors[[1L]]$numbers[1:2], c(1, 0.05))
  drag <- 0.47 * pi / 16 * 1025 * 2^2 / 2 / 1000
  runs <- data.frame(Drag = 1.03 * drag + c(-1, 0, 1) * 0.001 * drag)
  fit <- calibrate(gear, runs, change = "multipliers.piece_drag", match = Drag ~ total_drag_kN,
    error = 0.01 * drag)
  # normal prior and data: weights 1 / 0.05^2 and 3 / 0.01^2
  weight <- c(1 / 0.05^2, 3 / 0.01^2)
  expect_equal(fit$fields$value, sum(weight * c(1, 1.03)) / sum(weight), tolerance = 1e-4)
  expect_equal(fit$fields$error, 1 / sqrt(sum(weight)), tolerance = 1e-3)
  before <- row_of(uncertainty(settle(gear)), "total_drag_kN")
  after <- row_of(uncertainty(fit), "total_drag_kN")
  expect_equal(after$coefficients / after$value, fit$fields$error / fit$fields$value,
    tolerance = 1e-3)
  expect_lt(after$coefficients, before$coefficients / 4)
  expect_wrong(calibrate(gear, runs, change = "towing.nothing", match = Drag ~ total_drag_kN))
})

test_that("optimise_gear() satisfies lower() with its probability", {
  skip_if_not_installed("nloptr")
  gear <- known_sphere()
  state <- settle(gear)
  row <- row_of(uncertainty(state), "depth_m")
  limit <- row$value
  change <- list(ropes.line.length = c("5 m", "40 m"))
  best <- optimise_gear(gear, ~ropes.line.length, ~ lower(depth, 0.9) >= limit, change)
  reach <- qt(0.9, row$freedom) * row$error / row$value
  expect_equal(measures(best$state)[["depth_m"]], limit / (1 - reach), tolerance = 1e-4)
  expect_wrong(optimise_gear(gear, ~ropes.line.length, ~ lower(depth, 2) >= 3, change))
  expect_wrong(optimise_gear(gear, ~ropes.line.length, ~ lower(depht, 0.9) >= 3, change))
})

test_that("uncertainty plot shows all measures or one", {
  found <- uncertainty(settle(known_sphere()))
  for (sources in list(NULL, "pull_kN")) {
    file <- tempfile(fileext = ".png")
    plot(found, sources = sources, file = file)
    expect_gt(file.size(file), 2000)
  }
})

test_that("summary, report and command line show uncertainty()", {
  state <- settle(known_sphere())
  found <- uncertainty(state)
  expect_match(format(summary(state, uncertainty = found)), "pull +1[.]8.* kN +90 %: ", all = FALSE)
  expect_wrong(summary(state, uncertainty = 3))
  file <- tempfile(fileext = ".html")
  report(state, file, uncertainty = found)
  page <- paste(readLines(file), collapse = " ")
  expect_match(page, "Uncertainty of the results", fixed = TRUE)
  expect_match(page, "standard uncertainty", fixed = TRUE)
  record <- jsonlite::fromJSON(state_json(state, found))$uncertainty
  expect_equal(record$pull_kN$lower, row_of(found, "pull_kN")$lower, tolerance = 1e-13)
})

test_that("contributions on the mesh of uncertainty() agree with those on a fine mesh", {
  state <- settled("gillnet", nodes = 2500)
  sources <- uncertainty_sources(state$gear)
  mesh <- coarse_state(state)
  expect_lt(mesh$mesh$nodes, 1000)
  spread <- function(of) sqrt(rowSums(source_contributions(of, sources)$spread^2))
  # The contributions of the shipped gears change by up to 5 % from 600 to 3,800 nodes in the main
  # measures.
  main <- printed_measures(measures(state))
  expect_equal(spread(mesh)[main], spread(state)[main], tolerance = 0.05)
})
