# Search of `find_value()`: Newton steps with exact derivatives, within the ranges of the fields.
#
# The place of a point is the relative change of every field: its change over its initial value, or
# over its range if the initial value is 0. A miss is the difference from a target over the target.

# Largest miss at a solution.
target_tolerance <- 1e-4
# Largest number of settled gears per search, and of shorter trials per step.
most_find_solves <- 40L
most_halvings <- 6L
# A step must reduce the squared misses by this fraction of the reduction that derivatives predict.
least_reduction <- 1e-4
# Weight of the squared changes of fields next to squared misses. It selects the smallest change
# among equal solutions.
change_weight <- 1e-10

# Returns list(point, place, miss and rounding (by target), slopes): the end of the search from a
# point. `rounding`: miss due to whole numbers. `slopes`: derivatives of misses by the place.
search_targets <- function(task, found) {
  last <- task$points$count$n_solves + most_find_solves
  whole <- whole_fields(task$points$fields)
  held <- rep(FALSE, length(whole))
  repeat {
    if (all(is_target_reached(found))) return(found)
    if (is.null(found$slopes)) found <- with_slopes(task, found)
    step <- target_step(task, found, held)
    if (all(abs(found$slopes %*% step) <= target_tolerance)) return(found)
    if (task$points$count$n_solves >= last) {
      abort_not_converged("The search does not converge within {most_find_solves} settled gears.
        Narrow the ranges, or start from a gear that is nearer to the target.", report = NULL)
    }
    nearer <- nearer_point(task, found, step)
    if (is.null(nearer)) return(found)
    # A whole number next to its solution stays, so that the other fields adapt to it.
    held <- held | (whole & abs(step) * task$size < 1)
    found <- nearer
  }
}

is_target_reached <- function(found) abs(found$miss) <= target_tolerance + found$rounding

# `rounding`: by target.
new_found <- function(task, point, rounding = 0) {
  at <- formula_point(task$points, point, task$words)
  value <- vapply(task$targets, function(one) evaluate_formula(one$formula, at)$value, 0)
  list(
    point = point, place = (point$values - task$start) / task$size, value = value,
    miss = (value - target_numbers(task)) / task$scale, rounding = rounding
  )
}

target_numbers <- function(task) vapply(task$targets, `[[`, 0, "target")

with_slopes <- function(task, found) {
  points <- task$points
  by <- known_derivatives(points, found$point, task$of)
  at <- formula_point(points, found$point, task$words, by)
  rows <- lapply(task$targets, function(one) evaluate_formula(one$formula, at)$slope)
  found$slopes <- do.call(rbind, rows) / task$scale *
    rep(task$size / points$width, each = length(rows))
  found
}

# Returns the change of the place that minimises the squared misses, and among equal minima the
# squared place. The fields in `held` stay.
target_step <- function(task, found, held) {
  points <- task$points
  ends <- rbind(points$lower, points$lower + points$width)
  ends <- sweep(sweep(ends, 2L, task$start), 2L, task$size, "/")
  ends[, held] <- rep(found$place[held], each = 2L)
  products <- crossprod(found$slopes)
  products <- products + diag(change_weight * max(diag(products), change_weight), nrow(products))
  along <- drop(crossprod(found$slopes, found$miss - found$slopes %*% found$place))
  least_quadratic(found$place, products, along, ends[1L, ], ends[2L, ]) - found$place
}

# Returns the point after the step, or after the first shorter step that reduces the misses; NULL if
# there is none.
nearer_point <- function(task, found, step) {
  falls <- 2 * sum(found$miss * (found$slopes %*% step))
  settled <- FALSE
  whole <- whole_fields(task$points$fields)
  # Whole numbers leave a miss of half of the effect of one unit of each field.
  rounding <- if (all(whole)) drop(abs(found$slopes) %*% (0.5 / task$size)) else 0
  for (share in 2^-(0:most_halvings)) {
    values <- task$start + (found$place + share * step) * task$size
    values[whole] <- round(values[whole])
    values <- pmin(pmax(values, task$points$lower), task$points$lower + task$points$width)
    if (identical(values, found$point$values)) return(NULL)
    point <- settle_point(task$points, values, found$point$state)
    if (is.null(point)) next
    settled <- TRUE
    nearer <- new_found(task, point, rounding)
    if (all(whole)) nearer$slopes <- secant_slopes(found, nearer)
    reduced <- sum(nearer$miss^2) <= sum(found$miss^2) + least_reduction * share * falls
    if (isTRUE(reduced)) return(nearer)
  }
  if (settled) return(NULL)
  fields <- toString(vapply(seq_along(values), function(k) {
    paste(task$points$fields[[k]]$name, "=", with_field_unit(values[k], task$points$fields[[k]]))
  }, ""))
  abort_not_converged("The gear does not settle with {fields}, on the way to the target. Use a range
    in which it settles.", report = NULL)
}

# Returns slopes that agree with the last step (Broyden 1965, Mathematics of Computation 19:577).
# Whole numbers have no exact derivatives, and new differences would settle two gears per field.
secant_slopes <- function(found, nearer) {
  step <- nearer$place - found$place
  off <- nearer$miss - found$miss - drop(found$slopes %*% step)
  found$slopes + outer(off, step) / sum(step^2)
}

# Searches again from the other ends of the ranges. Returns the better result.
search_far_end <- function(task, found) {
  nearer_lower <- points_scaled(task$points, found$point$values) < 0.5
  far <- task$points$lower + ifelse(nearer_lower, task$points$width, 0)
  other <- tryCatch({
    point <- settle_point(task$points, far, found$point$state)
    if (!is.null(point)) search_targets(task, new_found(task, point, found$rounding))
  }, codend_error_not_converged = function(e) NULL)
  if (is.null(other) || sum(other$miss^2) >= sum(found$miss^2)) found else other
}
