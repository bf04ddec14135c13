# Calibrations: fitted on a coarse mesh, corrected to a fine one (study-refine.R).

# Largest number of cases on the fine mesh. Other cases use the correction of the nearest case.
most_compared <- 8L
# Largest number of fits, and the change at convergence as a fraction of the standard error.
most_refits <- 3L
settled_share <- 0.1

# Corrects the cases to the mesh of the results and fits until the fields converge. Returns
# list(task, fit, nodes, accuracy (remaining error, a fraction)). `task$mesh`: remaining errors by
# match and row.
refine_fit <- function(task, fit) {
  points <- cases_at(task, fit$scaled)$points
  settled <- which(!vapply(points, is.null, NA))
  chosen <- settled[evenly(length(settled), most_compared)]
  near <- nearest_cases(task, points, chosen)
  finer <- task$points$fine
  if (is.null(finer)) return(fit_errors(task, fit, points[chosen], task$cases[chosen], near))
  from <- lapply(points[chosen], `[[`, "state")
  for (round in seq_len(most_refits)) {
    at <- cases_at(task, fit$scaled, slopes = TRUE)
    on_fine <- lapply(task$cases[chosen], points_on, finer)
    fine <- settle_points(on_fine, points_values(task$points, fit$scaled), from)
    good <- !vapply(fine, is.null, NA)
    if (!any(good)) return(fit_errors(task, fit, at$points[chosen], task$cases[chosen], near))
    chosen <- chosen[good]
    on_fine <- on_fine[good]
    fine <- fine[good]
    from <- lapply(fine, `[[`, "state")
    slopes <- derivatives_of_points(on_fine, fine, task$of)
    corrections <- Map(function(k, point, slopes) {
      mesh_correction(task$cases[[k]], at$points[[k]], point, at$slopes[[k]], slopes, task$of)
    }, chosen, fine, slopes)
    near <- nearest_cases(task, at$points, chosen)
    task$cases <- Map(function(case, k) {
      case$correction <- if (!is.na(k)) corrections[[k]]
      case
    }, task$cases, near)
    if (fields_stay(task, fit$scaled)) break
    fit <- fit_fields(task, fit$scaled)
  }
  fit_errors(task, fit, fine, on_fine, near)
}

# Returns TRUE if the next Gauss-Newton step changes each field by at most `settled_share` of its
# standard error. Fields at an end of their range are ignored.
fields_stay <- function(task, scaled) {
  found <- misfit_at(task, scaled, slopes = TRUE)
  free <- scaled > 0 & scaled < 1
  inverse <- tryCatch(
    solve(found$curvature[free, free, drop = FALSE]), error = function(e) NULL
  )
  !is.null(inverse) &&
    all(abs(inverse %*% found$slope[free]) <= settled_share * sqrt(diag(inverse)))
}

# Returns the index in `chosen` of the nearest case, by measures relative to their ranges; NA if the
# case does not settle.
nearest_cases <- function(task, points, chosen) {
  settled <- !vapply(points, is.null, NA)
  fitted <- vapply(points[settled], function(point) {
    plain_measures(point$measures)[task$of]
  }, numeric(length(task$of)))
  fitted <- matrix(fitted, length(task$of))
  width <- apply(fitted, 1L, function(x) diff(range(x)))
  width[width == 0] <- 1
  all <- matrix(NA_real_, length(task$of), length(points))
  all[, settled] <- fitted / width
  vapply(seq_along(points), function(k) {
    if (!settled[k]) return(NA_integer_)
    which.min(colSums((all[, chosen, drop = FALSE] - all[, k])^2))
  }, 0L)
}

# Returns the result of `refine_fit()`. points: of `cases`; near: by case, numbers of points.
fit_errors <- function(task, fit, points, cases, near) {
  formulas <- lapply(task$match, `[[`, "formula")
  shared <- task$points$shared
  points <- Map(with_errors, cases, points, base = list(first_of(shared$fine, shared$start)))
  by_point <- vapply(points, function(point) {
    formula_errors(points_on(task$points, NULL), point, task$words, formulas)
  }, numeric(length(formulas)))
  by_case <- matrix(by_point, length(formulas))[, near, drop = FALSE]
  task$mesh <- lapply(seq_along(task$match), function(k) by_case[k, task$case_of])
  shares <- vapply(seq_along(task$match), function(k) {
    measured <- task$match[[k]]$measured
    stats::median(task$mesh[[k]] / abs(measured), na.rm = TRUE)
  }, 0)
  list(
    task = task, fit = fit, nodes = max(vapply(points, function(point) point$state$mesh$nodes, 0)),
    accuracy = max(c(shares[is.finite(shares)], -Inf))
  )
}

# Returns the covariance of scaled fields due to discretisation errors. The error of a match is
# fully correlated between hauls.
mesh_covariance <- function(task, model, used, error, covariance) {
  n <- nrow(covariance)
  total <- matrix(0, n, n)
  for (k in seq_along(task$match)) {
    off <- task$mesh[[k]][used[[k]]]
    off[!is.finite(off)] <- 0
    slopes <- model[[k]]$slopes[used[[k]], , drop = FALSE]
    shift <- covariance %*% crossprod(slopes, off) / error[k]^2
    total <- total + tcrossprod(shift)
  }
  total
}
