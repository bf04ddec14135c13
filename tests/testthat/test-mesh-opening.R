# Stiff meshes settle, slack or taut, and turned netting remains wider open than diamond netting.

t90_codend <- function(orientation = "turned", couple = 0.1) {
  plan <- read_gear("t90_codend")$plan
  plan$panels <- lapply(plan$panels, function(panel) {
    panel$orientation <- orientation
    panel$opening_stiffness <- list(couple = couple, angle = "23 deg")
    panel
  })
  settle(as_gear(plan), nodes = 300)
}

widest <- function(state) max(abs(state$position[2, ]))

test_that("T90 codend is wider and shorter than a diamond codend", {
  turned <- t90_codend("turned")
  diamond <- t90_codend("diamond")
  expect_gt(widest(turned), 1.05 * widest(diamond))
  expect_lt(measures(turned)[["length_m"]], measures(diamond)[["length_m"]])
  expect_gt(measures(turned)[["catch_volume_m3"]], measures(diamond)[["catch_volume_m3"]])
})

test_that("stiffer meshes increase the width difference between T90 and diamond", {
  apart <- vapply(c(0.01, 0.03, 0.1), function(couple) {
    widest(t90_codend("turned", couple)) - widest(t90_codend("diamond", couple))
  }, 0)
  expect_true(all(diff(apart) > 0))
  # Small couples change the shape in proportion: 3 times the couple, to about 10 %.
  expect_equal(apart[2] / apart[1], 3, tolerance = 0.1)
})

test_that("default opening stiffness equals the couple of twine bent between knots", {
  si <- gear_si(read_gear("t90_codend"))$panels[[1]]
  # Double twine of 4 mm between knots of 2 d sqrt(2) in bars of 50 mm, by finite differences. Both
  # ends are clamped, with the chord rotated relative to them.
  length <- 0.05 - 0.008 * sqrt(2)
  n <- 401
  h <- length / (n - 1)
  bend <- diff(diag(n), differences = 2) / h^2
  matrix <- 2 * 3e-4 * h * crossprod(bend)
  turn <- 0.01
  held <- c(1, 2, n - 1, n)
  # the slope at both clamps is zero, the far end is displaced by the rotation
  at <- c(0, 0, turn * length, turn * length)
  free <- setdiff(seq_len(n), held)
  inner <- solve(matrix[free, free], -matrix[free, held] %*% at)
  y <- numeric(n)
  y[held] <- at
  y[free] <- inner
  energy <- sum(y * (matrix %*% y)) / 2
  # each knot has one bar per family, and each bar rotates by half of the change of the angle
  expect_equal(2 * energy, si$opening_stiffness$couple * (2 * turn)^2 / 2, tolerance = 0.02)
  expect_equal(sin(si$opening_stiffness$angle / 2), 0.008 * sqrt(2) / 0.05)
})

test_that("soft, thin, knotless or diamond netting has no opening stiffness", {
  limp <- function(...) {
    plan <- panel_in_current_plan
    plan$panels$net <- utils::modifyList(c(plan$panels$net, orientation = "turned"), list(...))
    is.null(gear_si(as_gear(plan))$panels$net$opening_stiffness)
  }
  stiff <- list(diameter = "4 mm", material = "PE")
  thick <- list(mesh_size = "100 mm", twine = stiff)
  expect_false(do.call(limp, thick))
  expect_true(limp(mesh_size = "100 mm", twine = list(diameter = "4 mm", material = "PA")))
  expect_true(limp(mesh_size = "100 mm", twine = list(diameter = "1.9 mm", material = "PE")))
  expect_true(do.call(limp, c(thick, knotted = FALSE)))
  expect_true(do.call(limp, c(thick, orientation = "diamond")))
  expect_true(do.call(limp, c(thick, netting = "bars")))
  expect_true(do.call(limp, c(thick, list(opening_stiffness = list(couple = 0, angle = 0)))))
})

test_that("stiff meshes settle where their twine is slack", {
  # Thin, very slack netting in a current, with knots as stiff as in thick codends.
  plan <- panel_in_current_plan
  for (couple in c(0.01, 0.1)) {
    plan$panels$net$opening_stiffness <- list(couple = couple, angle = 1)
    state <- settle(as_gear(plan), nodes = 300)
    expect_true(state$report$converged)
    expect_lt(state$report$iterations, 600)
  }
})
