# Optima: searched on a coarse mesh, corrected to a fine one (study-refine.R).

# Moves an optimum to the mesh of the results. `run`: from `find_optimum()`. `held`: numbers of
# fixed fields. Returns list(task (on the mesh of `run$best`), run, coarse (task on the coarse
# mesh)).
refine_optimum <- function(task, run, held = integer()) {
  if (!is.null(task$fine)) {
    fine <- task
    fine$points <- points_on(task$points, task$points$fine)
    fine$base <- task$fine
    refined <- compare_meshes(task, fine, run, held)
    if (!is.null(refined$run)) return(refined)
  }
  run$best$point <- with_errors(task$points, run$best$point)
  list(task = task, run = run, coarse = task)
}

compare_meshes <- function(task, fine, run, held) {
  coarse <- run$best
  from <- fine$base$state
  best <- NULL
  for (round in seq_len(most_refinements)) {
    exact <- points_values(task$points, coarse$scaled)
    point <- settle_point(fine$points, exact, from)
    if (is.null(point)) break
    from <- point$state
    slopes <- known_derivatives(fine$points, point, task$of)
    values <- task_values(fine, point, slopes, exact)
    tried <- list(scaled = coarse$scaled, point = point, values = values)
    add_history(fine, tried)
    if (is.null(best) || is_better(values, best$values)) best <- tried
    if (values$worst <= keep_tolerance &&
      optimality_of(fine, tried, held)$left <= most_optimality) break
    task$points$correction <- NULL
    task$points$correction <- mesh_correction(task$points, coarse$point, point,
      known_derivatives(task$points, coarse$point, task$of), slopes, task$of)
    found <- find_optimum(task, coarse$scaled, solves_for_refinement, held, coarse$point,
      refinement_reach)
    if (is.null(found$best) || max(abs(found$best$scaled - coarse$scaled)) <= same_refined) break
    coarse <- found$best
  }
  if (is.null(best)) return(list())
  best$point <- with_errors(fine$points, best$point)
  run$best <- best
  list(task = fine, run = run, coarse = task)
}

# Returns the largest error, as a fraction of the objective and the limits. NA if all are unknown.
task_error <- function(task, tried) {
  errors <- task_errors(task, tried$point)
  share <- c(errors$objective / max(abs(tried$values$objective), .Machine$double.xmin),
    errors$keep / task$limits)
  share <- share[is.finite(share)]
  if (length(share)) max(share) else NA_real_
}

# Returns the discretisation errors of the objective and conditions, in their units.
task_errors <- function(task, point) {
  of <- function(formulas) formula_errors(task$points, point, task$words, formulas)
  left <- of(lapply(task$keep, `[[`, "left"))
  right <- of(lapply(task$keep, `[[`, "right"))
  list(objective = of(list(task$objective)), keep = sqrt(left^2 + right^2))
}
