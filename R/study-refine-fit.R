# A calibration that is fitted on a coarse lattice and answers for a fine one (study-refine.R), and
# what is left of the lattice's error in its fields.

# Cases that are settled on the fine lattice at most; others take the correction of the nearest.
most_compared <- 8L
# Fits at most, and by what share of its standard error a field may still change.
most_refits <- 3L
settled_share <- 0.1

# Fits with cases corrected until the fields stay. accuracy: a share of what is fitted, or NULL.
# Returns list(task, fit, nodes, accuracy (what is left, as a share)); task$lattice has the errors
# that are left, by match and row of the data.
refine_fit <- function(task, fit, accuracy) {
  points <- cases_at(task, fit$scaled)$points
  chosen <- compared_cases(task, points)
  near <- nearest_cases(task, points, chosen)
  found <- lattice_left(task, points[chosen], near)
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
    # a plan may divide itself
    if (!any(good) || case_nodes(fine) < least_ratio * nodes) return(result)
    chosen <- chosen[good]
    fine <- fine[good]
    from[chosen] <- lapply(fine, `[[`, "state")
    corrections <- Map(function(k, point) {
      case <- task$cases[[k]]
      lattice_correction(case, at$points[[k]], point, at$slopes[[k]],
        known_slopes(points_on(case, finer), point, task$of), task$of)
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
  found <- lattice_left(task, fine, near)
  list(task = found$task, fit = fit, nodes = case_nodes(fine), accuracy = found$share)
}

case_nodes <- function(points) {
  nodes <- vapply(points, function(point) first_of(point$state$lattice$nodes, 0L), 0)
  max(nodes)
}

# Whether a fit moved no field by more than a share of its standard error.
fields_stay <- function(task, before, fit) {
  curvature <- misfit_at(task, fit$scaled, slopes = TRUE)$curvature
  error <- tryCatch(sqrt(diag(solve(curvature))), error = function(e) NULL)
  !is.null(error) && all(abs(fit$scaled - before$scaled) <= settled_share * error)
}

# Cases spread evenly over those that settle.
compared_cases <- function(task, points) {
  settled <- which(!vapply(points, is.null, NA))
  settled[unique(round(seq(1, length(settled), length.out = min(most_compared, length(settled)))))]
}

# For every case which of some is nearest in what is fitted, as a share of its range; NA where it
# does not settle.
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

# A task with the errors that the lattice leaves in what is fitted, at points of which every case
# has that of number `near`, and the largest as a share of what is measured: list(task, share).
lattice_left <- function(task, points, near) {
  formulas <- lapply(task$match, `[[`, "formula")
  own <- points_on(task$points, NULL)
  by_point <- vapply(points, function(point) {
    formula_errors(own, with_own_errors(own, point), task$words, formulas)
  }, numeric(length(formulas)))
  by_case <- matrix(by_point, length(formulas))[, near, drop = FALSE]
  task$lattice <- lapply(seq_along(task$match), function(k) by_case[k, task$case_of])
  shares <- vapply(seq_along(task$match), function(k) {
    measured <- task$match[[k]]$measured
    stats::median(task$lattice[[k]] / abs(measured), na.rm = TRUE)
  }, 0)
  list(task = task, share = max(c(shares[is.finite(shares)], -Inf)))
}

# What the lattice's errors make of fields' covariance, scaled: each match is off alike in all
# hauls.
# covariance: of the fields, scaled; used: rows by match.
lattice_covariance <- function(task, model, used, error, covariance) {
  n <- nrow(covariance)
  total <- matrix(0, n, n)
  for (k in seq_along(task$match)) {
    off <- task$lattice[[k]][used[[k]]]
    off[!is.finite(off)] <- 0
    slopes <- model[[k]]$slopes[used[[k]], , drop = FALSE]
    shift <- covariance %*% crossprod(slopes, off) / error[k]^2
    total <- total + tcrossprod(shift)
  }
  total
}
