# An optimum that is found with a coarse lattice, led to that of a fine one (study-refine.R).

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
