# What every settled gear must satisfy: mirror symmetry, balance of forces, and a plain error where
# there is no balance to find.

shipped <- gears()$name
quick <- function(name, ...) {
  # bars: with fewer, this trawl's lattice is no mirror image of itself (0.15 m at 400 nodes)
  nodes <- switch(name, purse_seine = 300, 1500)
  settled(name, nodes = nodes, ...)
}

test_that("port and starboard of the midwater trawl are mirror images", {
  for (netting in c("cells", "bars")) {
    x <- quick("midwater_trawl", netting = netting)$position
    # every node's image, (x, -y, z), must lie on a node
    apart <- vapply(seq_len(ncol(x)), function(k) {
      min(colSums((x - x[, k] * c(1, -1, 1))^2))
    }, 0)
    # forces are left at 1e-8 of the largest tension, some 2e5 N, so at 2 mN; a node of this gear
    # resists a move across its twines with its tension over an element's length, at least 2 kN/m
    expect_lt(sqrt(max(apart)), 1e-6, label = netting)
  }
})

test_that("supports carry the sum of all external forces", {
  cases <- c(lapply(shipped, list), list(list("midwater_trawl", netting = "bars")))
  for (case in cases) {
    state <- do.call(quick, case)
    external <- rowSums(matrix(engine_array(state, "load"), 3L)) +
      rowSums(vapply(state$forces, rowSums, numeric(3)))
    held <- as.logical(engine_array(state, "held"))
    reactions <- -rowSums(state$force[, held, drop = FALSE])
    # what supports miss is what free nodes keep, each 1e-8 of the largest tension at most; sums of
    # so many forces round by far less than 1e-12 of it a node
    free <- state$force[, !held, drop = FALSE]
    label <- paste(case, collapse = " ")
    rounding <- 1e-12 * state$report$largest_tension * engine_array(state, "nodes")
    expect_lt(max(abs(reactions + external - rowSums(free))), rounding, label = label)
    expect_lte(sqrt(max(colSums(free^2))), 1e-8 * state$report$largest_tension, label = label)
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
