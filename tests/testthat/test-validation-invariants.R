# Mirror symmetry of a settled gear, and the error of a gear without equilibrium. The lane `matrix`
# checks the equilibrium of every shipped gear.

test_that("midwater trawl has mirrored port and starboard sides", {
  for (netting in c("cells", "bars")) {
    # bars: with fewer nodes, the mesh of this trawl is not symmetric (0.15 m at 400 nodes)
    x <- settled("midwater_trawl", nodes = 1500, netting = netting)$position
    # every node's image, (x, -y, z), must coincide with a node
    apart <- vapply(seq_len(ncol(x)), function(k) {
      min(colSums((x - x[, k] * c(1, -1, 1))^2))
    }, 0)
    # The residual is 1e-8 of the largest tension, about 2e5 N, hence 2 mN. The stiffness of a node
    # across its twines is its tension over an element's length, at least 2 kN/m.
    expect_lt(sqrt(max(apart)), 1e-6, label = netting)
  }
})

test_that("settle() without convergence throws an error with part and position", {
  # each solve of this gear needs more than one step
  error <- with_settle_iterations(1L, {
    tryCatch(settle(read_gear("towed_cable")), codend_error_not_converged = identity)
  })
  expect_s3_class(error, c("codend_error_not_converged", "codend_error"), exact = FALSE)
  expect_match(conditionMessage(error), "rope `cable`", fixed = TRUE)
  expect_match(conditionMessage(error), "near x = [-0-9.]+ m, y = [-0-9.]+ m, z = [-0-9.]+ m")
  expect_false(error$report$converged)
  expect_gt(error$report$residual, 1e-8)
})
