# The error message of a gear that fails to settle.

test_that("advice names slack netting, its line and the drag model", {
  gear <- update(read_gear("midwater_trawl"), netting_drag = "blended")
  state <- suppressWarnings(settle_gear(gear, 300, "cells", NULL))
  mesh <- state$mesh
  # a node of netting with a laced rope, in a shape with all lines slack, then all taut
  node <- intersect(mesh$model$cells$node, mesh$model$bars$node)[1]
  advised <- function(strain) {
    unsettled_advice(gear, state$si, list(
      mesh = mesh, report = list(worst_node = node),
      strain = rep(strain, length(line_part(mesh)))
    ))
  }
  expect_match(advised(-0.1)[1], "^100 % of the twines of netting `.*` are slack there; the line `")
  expect_match(advised(-0.1)[1], "lengthen it \\(`headline")
  expect_match(advised(0.1)[1], "^The drag model `blended`")
})

test_that("error of settle() contains the advice", {
  expect_error(with_settle_iterations(2L, settle(read_gear("towed_cable"), 300)),
    "Worst at rope `cable`.*when-it-does-not-settle", class = "codend_error_not_converged")
})
