# Mirror symmetry of a settled gear, and the error if a gear has no equilibrium. The lane `matrix`
# checks the equilibrium of every shipped gear.

test_that("port and starboard of the midwater trawl are mirror images", {
  for (netting in c("cells", "bars")) {
    # bars: with fewer nodes, the mesh of this trawl is not symmetric (0.15 m at 400 nodes)
    x <- settled("midwater_trawl", nodes = 1500, netting = netting)$position
    # every node's image, (x, -y, z), must lie on a node
    apart <- vapply(seq_len(ncol(x)), function(k) {
      min(colSums((x - x[, k] * c(1, -1, 1))^2))
    }, 0)
    # forces are left at 1e-8 of the largest tension, some 2e5 N, so at 2 mN; a node of this gear
    # resists a move across its twines with its tension over an element's length, at least 2 kN/m
    expect_lt(sqrt(max(apart)), 1e-6, label = netting)
  }
})

test_that("a gear that does not settle is an error that names its part and place", {
  # no solve of this gear ends in one step
  error <- with_settle_iterations(1L, {
    tryCatch(settle(read_gear("towed_cable")), codend_error_not_converged = identity)
  })
  expect_s3_class(error, c("codend_error_not_converged", "codend_error"), exact = FALSE)
  expect_match(conditionMessage(error), "rope `cable`", fixed = TRUE)
  expect_match(conditionMessage(error), "near x = [-0-9.]+ m, y = [-0-9.]+ m, z = [-0-9.]+ m")
  expect_false(error$report$converged)
  expect_gt(error$report$residual, 1e-8)
})
