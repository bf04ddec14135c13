# Calibrations compared with true values, analytical least squares, and the likelihood itself.

towed_sphere <- as_gear(towed_sphere_plan(pieces = list(sphere = list(drag_coefficient = 0.5))))
drag_by_speed <- pi / 16 * 1025 / 2
coefficient <- list(pieces.sphere.drag_coefficient = c(0.2, 1.5))

# Deterministic numbers with a nearly normal distribution.
noise <- function(n) stats::qnorm((((seq_len(n) * 0.6180339887) %% 1) * n + 0.5) / (n + 1))

test_that("calibrate() gives the least squares of a linear model", {
  # drag is C_D times a known number: regression through the origin
  speed <- rep(seq(1, 3, by = 0.25), 2)
  known <- drag_by_speed * speed^2
  drag <- 0.62 * known + 20 * noise(length(speed))
  fit <- calibrate(towed_sphere, data.frame(towing.speed = speed, Drag = drag), coefficient,
    Drag ~ total_drag)
  wanted <- stats::lm(drag ~ known - 1)
  # Where the likelihood is flat to 1e-7, the value is accurate to 1e-4.
  expect_equal(unname(coef(fit)), unname(stats::coef(wanted)), tolerance = 1e-4)
  expect_equal(unname(sqrt(diag(vcov(fit)))), unname(sqrt(diag(stats::vcov(wanted)))),
    tolerance = 1e-3)
  expect_equal(unname(confint(fit, method = "normal", level = 0.9))[1, ],
    unname(stats::confint(wanted, level = 0.9))[1, ], tolerance = 1e-3)
  # For a linear model the likelihood has the same interval; its ends are accurate to 1 % of its
  # half width.
  half <- diff(stats::confint(wanted, level = 0.9)[1, ]) / 2
  expect_lt(max(abs(confint(fit, level = 0.9) - stats::confint(wanted, level = 0.9))), 0.02 * half)
  expect_equal(residuals(fit), unname(stats::residuals(wanted)), tolerance = 1e-2)
  expect_equal(as.double(logLik(fit)), as.double(stats::logLik(wanted)), tolerance = 1e-6)
  expect_equal(attr(logLik(fit), "df"), 2)
  expect_equal(fit$match$error, summary(wanted)$sigma, tolerance = 1e-4)
  expect_identical(nobs(fit), length(speed))
  ahead <- predict(fit, data.frame(towing.speed = 3.5), level = 0.9)
  straight <- stats::predict(wanted, data.frame(known = drag_by_speed * 3.5^2), level = 0.9,
    interval = "prediction")
  expect_equal(unlist(ahead[c("fit", "lower", "upper")], use.names = FALSE), as.vector(straight),
    tolerance = 1e-3)
})

test_that("calibrate() recovers two true values and explain_misfit() names others", {
  true <- update(towed_sphere, pieces.sphere.drag_coefficient = 0.8, pieces.sphere.mass = 150)
  runs <- data.frame(towing.speed = paste(rep(2:6, 3), "knot"))
  found <- vary(true, towing.speed = paste(2:6, "knot"))
  k <- rep(1:5, 3)
  runs$Pull <- found$pull_kN[k] + 0.02 * noise(15)
  runs$Depth <- found$depth_m[k] + 0.05 * noise(15)[15:1]
  fit <- calibrate(towed_sphere, runs,
    c(coefficient, list(pieces.sphere.mass = c("100 kg", "300 kg"))),
    list(Pull ~ pull_kN, Depth ~ depth))
  expect_true(fit$converged)
  off <- (coef(fit) - c(0.8, 150)) / fit$fields$error
  expect_lt(max(abs(off)), 3)
  expect_lt(max(fit$fields$error / c(0.8, 150)), 0.05)
  # If one field is fixed at a wrong value, the misfit identifies it.
  blind <- calibrate(towed_sphere, runs, coefficient, list(Pull ~ pull_kN, Depth ~ depth))
  found <- explain_misfit(blind, fields = c("pieces.sphere.mass", "pieces.sphere.volume",
    "pieces.sphere.diameter"))
  expect_identical(found$inputs$field[1], "pieces.sphere.mass")
  expect_lt(found$inputs$p[1], 1e-4)
  expect_lt(found$inputs$percent[1], -10)
  # A diameter has the same effect as the coefficient.
  expect_lt(found$inputs$own[found$inputs$field == "pieces.sphere.diameter"], 1e-3)
  expect_output(print(found), "pieces.sphere.mass")
  expect_true(all(c("pull_kN", "depth_m") %in%
    found$measurements$measure[found$measurements$matched]))
  expect_gte(min(found$measurements$gain), 1)
})

test_that("calibrate() fits hauls of a fine mesh with few nodes", {
  plan <- towed_sphere_plan()
  plan$ropes$line <- list(from = "ship", to = "end", length = "100 m", diameter = "20 mm",
    axial_stiffness = "10 MN", mass_per_length = 1)
  gear <- as_gear(plan)
  speed <- c(1.2, 1.6, 2, 2.4, 2.8)
  runs <- data.frame(towing.speed = speed,
    Depth = vary(gear, towing.speed = speed, nodes = 400)$depth_m + 0.02 * noise(5))
  off <- function(accuracy) {
    fit <- calibrate(gear, runs, list(ropes.line.length = c("60 m", "200 m")), Depth ~ depth_m,
      nodes = 4, accuracy = accuracy)
    ends <- confint(fit, method = "normal")
    # the mesh error is part of the interval
    expect_true(ends[1L] < 100 && ends[2L] > 100)
    c(abs(unname(coef(fit)) - 100), fit$fields$mesh)
  }
  coarse <- off(NULL)
  fine <- off("0.05 %")
  expect_true(all(fine < coarse / 3))
})

test_that("calibrate() weights a prior and known errors correctly", {
  # One haul with error s and a prior of mean m and deviation t: their weighted mean.
  known <- drag_by_speed * 4
  runs <- data.frame(towing.speed = 2, Drag = 0.7 * known)
  fit <- calibrate(towed_sphere, runs,
    list(pieces.sphere.drag_coefficient = normal_value(0.5, 0.1, low = 0.1, high = 2)),
    Drag ~ total_drag, error = 0.05 * known)
  expect_equal(unname(coef(fit)), (0.7 / 0.05^2 + 0.5 / 0.1^2) / (1 / 0.05^2 + 1 / 0.1^2),
    tolerance = 1e-4)
  expect_equal(fit$fields$error, 1 / sqrt(1 / 0.05^2 + 1 / 0.1^2), tolerance = 1e-3)
})

test_that("calibrate() reports a field at the end of its range", {
  known <- drag_by_speed * c(1, 4, 9, 16)
  fit <- calibrate(towed_sphere, data.frame(towing.speed = 1:4, Drag = 2 * known), coefficient,
    Drag ~ total_drag)
  expect_identical(fit$fields$at, "upper")
  expect_equal(fit$fields$value, 1.5, tolerance = 1e-3)
  expect_true(is.na(fit$fields$error))
  expect_output(print(fit), "upper end of its range")
})

test_that("calibrate() skips missing measurements and settles identical rows once", {
  known <- drag_by_speed * c(1, 4, 1, 4)
  runs <- data.frame(towing.speed = c(1, 2, 1, 2), Drag = c(0.6, 0.61, 0.59, 0.6) * known,
    Depth = c(9, NA, NA, NA))
  fit <- calibrate(towed_sphere, runs, coefficient, list(Drag ~ total_drag, Depth ~ depth),
    error = c(NA, 5))
  expect_length(fit$task$cases, 2)
  expect_identical(fit$match$hauls, c(4L, 1L))
  expect_picture(fit)
  expect_output(print(summary(fit)), "Furthest off")
})
