# Draws compared with analytical posteriors: the drag of a sphere is linear in its coefficient.

towed_sphere <- as_gear(towed_sphere_plan(pieces = list(sphere = list(drag_coefficient = 0.5))))
drag_by_speed <- pi / 16 * 1025 / 2

# Accuracy of a chain with `effective` independent draws: sd / sqrt(effective) for the mean, about
# sd / sqrt(2 effective) for the standard deviation, about 2 sd / sqrt(effective) for
# quantiles. The tolerance is four times as large.
expect_drawn <- function(draws, mean, sd, low, high) {
  chain <- attr(draws, "chain")
  error <- sd / sqrt(chain$effective)
  expect_lt(abs(chain$mean - mean), 4 * error)
  expect_lt(abs(chain$sd - sd), 3 * error)
  expect_lt(abs(chain$q5 - low), 8 * error)
  expect_lt(abs(chain$q95 - high), 8 * error)
}

test_that("sample_posterior() with known error gives the normal posterior", {
  skip_if_not_installed("mcmc")
  known <- drag_by_speed * 4
  fit <- calibrate(towed_sphere, data.frame(towing.speed = 2, Drag = 0.7 * known),
    list(pieces.sphere.drag_coefficient = normal_value(0.5, 0.1, low = 0.1, high = 2)),
    Drag ~ total_drag, error = 0.05 * known)
  draws <- sample_posterior(fit, draws = 400)
  mean <- (0.7 / 0.05^2 + 0.5 / 0.1^2) / (1 / 0.05^2 + 1 / 0.1^2)
  sd <- 1 / sqrt(1 / 0.05^2 + 1 / 0.1^2)
  expect_drawn(draws, mean, sd, mean - 1.645 * sd, mean + 1.645 * sd)
  expect_gt(attr(draws, "chain")$effective, 50)
  few <- function(...) suppressWarnings(sample_posterior(fit, draws = 20, burn_in = 1, ...))
  expect_identical(few(), few())
  expect_false(identical(few(), few(seed = 2)))
  expect_output(print(draws), "400 draws.*pieces.sphere.drag_coefficient")
})

test_that("sample_posterior() with estimated error gives Student's posterior", {
  skip_if_not_installed("mcmc")
  speed <- rep(2, 5)
  known <- drag_by_speed * speed^2
  drag <- 0.62 * known + 40 * c(1, -1, 0.5, -0.8, 0.3)
  fit <- calibrate(towed_sphere, data.frame(towing.speed = speed, Drag = drag),
    list(pieces.sphere.drag_coefficient = c(0.2, 1.5)), Drag ~ total_drag)
  wanted <- stats::lm(drag ~ known - 1)
  mean <- stats::coef(wanted)[[1]]
  error <- sqrt(stats::vcov(wanted)[1, 1])
  draws <- sample_posterior(fit, draws = 300)
  # with 4 degrees of freedom: a standard deviation of sqrt(4 / 2)
  chain <- attr(draws, "chain")
  expect_lt(abs(chain$q50 - mean), 5 * error / sqrt(chain$effective))
  reach <- (chain$q95 - chain$q5) / 2
  expect_lt(abs(reach / (stats::qt(0.95, 4) * error) - 1), 6 / sqrt(chain$effective))
})

test_that("sample_posterior() warns about few draws", {
  skip_if_not_installed("mcmc")
  fit <- calibrate(towed_sphere, data.frame(towing.speed = 2, Drag = 1500),
    list(pieces.sphere.drag_coefficient = c(0.2, 1.5)), Drag ~ total_drag, error = 100)
  expect_warning(draws <- sample_posterior(fit, draws = 20, burn_in = 5),
    class = "codend_warning_few_draws")
  expect_identical(dim(draws), c(20L, 1L))
})
