# Studies search on a coarse mesh and report results of a fine mesh.
#
# The difference between both meshes, in measures and their derivatives, corrects the coarse mesh
# near a point. The search continues with this correction, and its end point is compared again. At
# convergence, values and derivatives equal the fine mesh. Source: N. M. Alexandrov and R. M. Lewis,
# An overview of first-order model management for engineering optimization, Optimization and
# Engineering 2, 2001. The difference varies slowly, so few fine solutions are needed.

# Returns the points with another number of nodes and without a correction.
points_on <- function(points, nodes) {
  points$nodes <- nodes
  points$correction <- NULL
  points
}

# Returns the correction of measures: list(at (scaled fields), value, slope (by scaled field)).
mesh_correction <- function(points, coarse, fine, coarse_slopes, fine_slopes, of) {
  slope <- fine_slopes - coarse_slopes
  slope[!is.finite(slope)] <- 0
  list(
    at = points_scaled(points, coarse$values), slope = slope,
    value = plain_measures(fine$measures)[of] - plain_measures(coarse$measures)[of]
  )
}

corrected_derivatives <- function(points, slopes) {
  if (is.null(points$correction)) slopes else slopes + points$correction$slope[rownames(slopes), ]
}

# Returns the error of each formula, in its unit. Errors of measures are treated as independent.
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

# Returns a point with errors of its measures: the relative errors of the gear as given, or errors
# from one more mesh. base: the settled gear as given, or NULL.
with_errors <- function(points, point, base = NULL) {
  point <- complete_point(points, point)
  point$state$levels <- new_levels(netting = points$netting, base = base)
  point$measures <- measures(point$state)
  point
}

# Largest number of mesh comparisons, and the distance between them as a fraction of the ranges.
most_refinements <- 6L

refinement_reach <- 0.25

# Largest number of settled coarse gears per comparison.
solves_for_refinement <- 40L

# Optima within this distance (scaled fields) are identical.
same_refined <- 1e-5

known_derivatives <- function(points, point, of) {
  slopes <- point_derivatives(points, point, of)
  slopes[is.na(slopes)] <- 0
  slopes
}

mesh_size_text <- function(nodes, error) {
  paste0(nodes, " nodes", if (is.finite(error)) {
    paste0(", with an error of ", percent_text(error))
  })
}
