# Studies step on a coarse lattice and answer for a fine one.
#
# What the fine lattice says otherwise at a point, of measures and of their slopes, is added to what
# the coarse one says near it; the search goes on with that, and both are compared again where it
# leads. Where it stays, value and slopes are the fine lattice's (N. M. Alexandrov and R. M. Lewis,
# An overview of first-order model management for engineering optimization, Optimization and
# Engineering 2, 2001). Lattices differ by little that varies slowly, so few fine ones are settled.

# Points of a study on a lattice of so many nodes, without a correction.
points_on <- function(points, nodes) {
  points$nodes <- nodes
  points$correction <- NULL
  points
}

# What a fine lattice's measures `of` differ by from a coarse one's, at two points of the same
# fields: list(at (scaled fields), value, slope (by scaled field)).
lattice_correction <- function(points, coarse, fine, coarse_slopes, fine_slopes, of) {
  slope <- fine_slopes - coarse_slopes
  slope[!is.finite(slope)] <- 0
  list(
    at = points_scaled(points, coarse$values), slope = slope,
    value = plain_measures(fine$measures)[of] - plain_measures(coarse$measures)[of]
  )
}

# Slopes of a point as those of corrected measures.
corrected_slopes <- function(points, slopes) {
  if (is.null(points$correction)) slopes else slopes + points$correction$slope[rownames(slopes), ]
}

# Errors that the lattice leaves in formulas at a point, in their units: of independent errors of
# the measures in them. NA where a measure's is not known.
formula_errors <- function(points, point, words, formulas) {
  at <- formula_point(points, point, words)
  error <- attr(point$measures, "error")[words$column] * words$factor
  vapply(formulas, function(formula) {
    named <- intersect(formula$names, words$name)
    known <- as.list(at$values[formula$names])
    parts <- vapply(named, function(name) {
      eval(formula$slopes[[name]], known) * error[match(name, words$name)]
    }, 0)
    sqrt(sum(parts^2))
  }, 0)
}

# A point whose measures have errors of its own design, where a search hands on those of the gear
# that it began from: by one more lattice of it.
with_own_errors <- function(points, point) {
  point$state$levels <- new_levels(netting = points$netting)
  point$measures <- measures(point$state)
  point
}

# Nodes of the lattice on which a study ends: so many times more as the error (a share) of one of
# `nodes` asks for, within what settle() goes on by.
finishing_nodes <- function(nodes, error, accuracy) {
  growth <- min(max(nodes_for(1, error, accuracy), least_growth), most_growth)
  min(nodes * growth, most_accurate_nodes)
}

# Lattices on which an optimum is compared at most, and how far it goes in between, as a share of
# the ranges.
most_refinements <- 6L

refinement_reach <- 0.25

# Settled coarse gears at most for each.
settles_refinement <- 40L

# Scaled fields nearer to one another than this are one optimum.
same_refined <- 1e-5

known_slopes <- function(points, point, of) {
  slopes <- point_slopes(points, point, of)
  slopes[is.na(slopes)] <- 0
  slopes
}

# A lattice of so many nodes and the error (a share) that it leaves, in words.
lattice_words <- function(nodes, error) {
  paste0(nodes, " nodes", if (is.finite(error)) {
    paste0(", which leave an error of ", percent_text(error))
  })
}
