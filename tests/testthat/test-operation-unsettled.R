# What the error says where a gear does not settle.

test_that("advice names slack netting, the line along it, and a law that lets it hang slack", {
  gear <- update(read_gear("midwater_trawl"), netting_drag = "blended")
  state <- suppressWarnings(settle_gear(gear, 300, "cells", NULL))
  lattice <- state$lattice
  # a node of netting that a rope is laced to, in a shape all of whose lines are slack, then none
  node <- intersect(lattice$mesh$cells$node, lattice$mesh$bars$node)[1]
  advised <- function(strain) {
    unsettled_advice(gear, state$si, list(
      lattice = lattice, report = list(worst_node = node),
      strain = rep(strain, length(line_part(lattice)))
    ))
  }
  expect_match(advised(-0.1)[1], "^100 % of the twines of netting `.*` are slack there; the line `")
  expect_match(advised(-0.1)[1], "lengthen it \\(`head_line")
  expect_match(advised(0.1)[1], "^The drag law `blended`")
})

test_that("the error carries the advice", {
  expect_error(with_settle_iterations(2L, settle(read_gear("towed_cable"), 300)),
    "Worst at rope `cable`.*when-it-does-not-settle", class = "codend_error_not_converged")
})
