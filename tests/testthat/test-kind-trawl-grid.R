# Returns the covered fraction of each edge of netting by seams and lines of the mouth.
covered_edges <- function(gear) {
  si <- gear_si(gear)
  mouth <- Filter(function(rope) rope$role %in% c("headline", "footrope", "side_line"), si$ropes)
  chains <- c(lapply(si$seams, `[[`, "edges"), lapply(mouth, function(rope) list(rope$along)))
  edges <- unlist(unlist(unname(chains), recursive = FALSE), recursive = FALSE)
  table <- data.frame(
    edge = vapply(edges, function(edge) paste0(edge$panel, ".", edge$edge), ""),
    part = vapply(edges, function(edge) edge$to - edge$from, 0)
  )
  all <- outer(names(si$panels), c("upper", "lower", "left", "right"), paste, sep = ".")
  found <- tapply(table$part, factor(table$edge, all), sum)
  meshes <- vapply(si$panels, function(panel) {
    c(panel$upper, panel$lower, panel$deep, panel$deep)
  }, numeric(4))
  found[t(meshes) > 0]
}

test_that("trawl nets join or hang each edge once", {
  for (name in c("poly_noreastern_trawl", "midwater_trawl", "small_midwater_trawl", "pair_trawl",
    "demersal_seine", "beam_trawl")) {
    expect_equal(range(covered_edges(read_gear(name))), c(1, 1), info = name)
  }
})
