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

# By how much measures of a point are corrected, by their names; none without a correction.
corrected_by <- function(points, point) {
  found <- points$correction
  if (is.null(found)) return(numeric())
  found$value + drop(found$slope %*% (points_scaled(points, point$values) - found$at))
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
  point$state$levels <- levels_through(point$state, NULL, points$netting)
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

# An optimum of the coarse lattice on one that leaves `accuracy` (a share of the aim and of limits;
# NULL: none is asked for) in it. run: as find_optimum() gives it; held: fields that stay. Returns
# list(task (with points of the lattice that `run$best` is on and the gear as it was there), run,
# coarse (the task whose coarse lattice is corrected)).
refine_optimum <- function(task, run, accuracy, held = integer()) {
  run$best$point <- with_own_errors(task$points, run$best$point)
  same <- list(task = task, run = run, coarse = task)
  if (is.null(accuracy)) return(same)
  fine <- task$fine
  if (is.null(fine)) {
    error <- task_error(task, run$best)
    if (!is.finite(error) || is_reached(error, accuracy)) return(same)
    nodes <- run$best$point$state$lattice$nodes
    fine <- finer_task(task, finishing_nodes(nodes, error, accuracy))
    # a plan may divide itself
    if (is.null(fine) || fine$base$state$lattice$nodes < least_ratio * nodes) return(same)
  }
  refined <- compare_lattices(task, fine, run, held)
  if (is.null(refined$run)) same else refined
}

# A task on a lattice of more nodes, with the gear as it was; NULL where that does not settle.
finer_task <- function(task, nodes) {
  fine <- task
  fine$points <- points_on(task$points, nodes)
  fine$base <- settle_point(fine$points, task$base$values, task$base$state)
  if (!is.null(fine$base)) fine
}

compare_lattices <- function(task, fine, run, held) {
  coarse <- run$best
  from <- fine$base$state
  best <- NULL
  for (round in seq_len(most_refinements)) {
    exact <- points_values(task$points, coarse$scaled)
    point <- settle_point(fine$points, exact, from)
    if (is.null(point)) break
    from <- point$state
    slopes <- known_slopes(fine$points, point, task$of)
    values <- task_values(fine, point, slopes, exact)
    tried <- list(scaled = coarse$scaled, point = point, values = values)
    add_history(fine, tried)
    if (is.null(best) || is_better(values, best$values)) best <- tried
    if (values$worst <= keep_tolerance &&
      optimality_of(fine, tried, held)$left <= most_optimality) break
    task$points$correction <- NULL
    task$points$correction <- lattice_correction(task$points, coarse$point, point,
      known_slopes(task$points, coarse$point, task$of), slopes, task$of)
    found <- find_optimum(task, coarse$scaled, settles_refinement, held, coarse$point,
      refinement_reach)
    if (is.null(found$best) || max(abs(found$best$scaled - coarse$scaled)) <= same_refined) break
    coarse <- found$best
  }
  if (is.null(best)) return(list())
  best$point <- with_own_errors(fine$points, best$point)
  run$best <- best
  task$fine <- fine
  list(task = fine, run = run, coarse = task)
}

# Scaled fields nearer to one another than this are one optimum.
same_refined <- 1e-5

known_slopes <- function(points, point, of) {
  slopes <- point_slopes(points, point, of)
  slopes[is.na(slopes)] <- 0
  slopes
}

# The largest error that the lattice leaves in the aim and the conditions at a tried point, as a
# share of the aim and of the limits. NA where none is known.
task_error <- function(task, tried) {
  errors <- task_errors(task, tried$point)
  share <- c(errors$aim / max(abs(tried$values$aim), .Machine$double.xmin),
    errors$keep / task$limits)
  share <- share[is.finite(share)]
  if (length(share)) max(share) else NA_real_
}

# The same by aim and condition, in their units.
task_errors <- function(task, point) {
  of <- function(formulas) formula_errors(task$points, point, task$words, formulas)
  left <- of(lapply(task$keep, `[[`, "left"))
  right <- of(lapply(task$keep, `[[`, "right"))
  list(aim = of(list(task$aim)), keep = sqrt(left^2 + right^2))
}

# A lattice of so many nodes and the error (a share) that it leaves, in words.
lattice_words <- function(nodes, error) {
  paste0(nodes, " nodes", if (is.finite(error)) {
    paste0(", which leave an error of ", percent_text(error))
  })
}
