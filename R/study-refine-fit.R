# Calibrations: fitted on a coarse mesh, corrected to a fine one (study-refine.R).

# Largest number of cases on the fine mesh. Other cases use the correction of the nearest case.
most_compared <- 8L
# Largest number of fits, and the change at convergence as a fraction of the standard error.
most_refits <- 3L
settled_share <- 0.1

# Corrects the cases and fits until the fields converge. accuracy: a fraction of the measured
# values, or NULL. Returns list(task, fit, nodes, accuracy (remaining error, a fraction)).
# `task$mesh`: remaining errors by match and row.
refine_fit <- function(task, fit, accuracy) {
  points <- cases_at(task, fit$scaled)$points
  chosen <- compared_cases(task, points)
  near <- nearest_cases(task, points, chosen)
  found <- mesh_left(task, points[chosen], near)
  nodes <- case_nodes(points)
  result <- list(task = found$task, fit = fit, nodes = nodes, accuracy = found$share)
  if (is.null(accuracy) || !is.finite(found$share) || is_reached(found$share, accuracy)) {
    return(result)
  }
  finer <- finishing_nodes(nodes, found$share, accuracy)
  from <- lapply(points, `[[`, "state")
  for (round in seq_len(most_refits)) {
    at <- cases_at(task, fit$scaled, slopes = TRUE)
    values <- points_values(task$points, fit$scaled)
    fine <- lapply(chosen, function(k) {
      settle_point(points_on(task$cases[[k]], finer), values, from[[k]])
    })
    good <- !vapply(fine, is.null, NA)
    # A plan can fix its mesh, so that more nodes have no effect.
    if (!any(good) || case_nodes(fine) < least_ratio * nodes) return(result)
    chosen <- chosen[good]
    fine <- fine[good]
    from[chosen] <- lapply(fine, `[[`, "state")
    corrections <- Map(function(k, point) {
      case <- task$cases[[k]]
      mesh_correction(case, at$points[[k]], point, at$slopes[[k]],
        known_derivatives(points_on(case, finer), point, task$of), task$of)
    }, chosen, fine)
    near <- nearest_cases(task, at$points, chosen)
    task$cases <- Map(function(case, k) {
      case$correction <- if (!is.na(k)) corrections[[k]]
      case
    }, task$cases, near)
    before <- fit
    fit <- fit_fields(task, fit$scaled)
    if (max(abs(fit$scaled - before$scaled)) <= same_refined ||
      fields_stay(task, before, fit)) break
  }
  found <- mesh_left(task, fine, near)
  list(task = found$task, fit = fit, nodes = case_nodes(fine), accuracy = found$share)
}

case_nodes <- function(points) {
  nodes <- vapply(points, function(point) first_of(point$state$mesh$nodes, 0L), 0)
  max(nodes)
}

# Returns TRUE if every field changed by at most `settled_share` of its standard error.
fields_stay <- function(task, before, fit) {
  curvature <- misfit_at(task, fit$scaled, slopes = TRUE)$curvature
  error <- tryCatch(sqrt(diag(solve(curvature))), error = function(e) NULL)
  !is.null(error) && all(abs(fit$scaled - before$scaled) <= settled_share * error)
}

compared_cases <- function(task, points) {
  settled <- which(!vapply(points, is.null, NA))
  settled[unique(round(seq(1, length(settled), length.out = min(most_compared, length(settled)))))]
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

# Returns list(task (with errors by match), share (largest median error as a fraction of the data)).
mesh_left <- function(task, points, near) {
  formulas <- lapply(task$match, `[[`, "formula")
  own <- points_on(task$points, NULL)
  by_point <- vapply(points, function(point) {
    formula_errors(own, with_own_errors(own, point), task$words, formulas)
  }, numeric(length(formulas)))
  by_case <- matrix(by_point, length(formulas))[, near, drop = FALSE]
  task$mesh <- lapply(seq_along(task$match), function(k) by_case[k, task$case_of])
  shares <- vapply(seq_along(task$match), function(k) {
    measured <- task$match[[k]]$measured
    stats::median(task$mesh[[k]] / abs(measured), na.rm = TRUE)
  }, 0)
  list(task = task, share = max(c(shares[is.finite(shares)], -Inf)))
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
