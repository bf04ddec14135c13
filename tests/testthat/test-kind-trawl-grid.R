test_that("trawl nets join or hang each edge once", {
  for (name in c("poly_noreastern_trawl", "midwater_trawl", "small_midwater_trawl", "pair_trawl",
    "demersal_seine", "beam_trawl")) {
    expect_equal(range(covered_edges(read_gear(name))), c(1, 1), info = name)
  }
})
