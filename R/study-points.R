# A gear settled at values of its free fields, with the slopes of what is asked of it by them: what
# optimise_gear() and calibrate() step between. Fields are scaled: 0 at the lower end of their
# range and
# 1 at the upper.

# What all points of a study share. gear: with the base plan; fields: of free_fields().
new_points <- function(gear, fields, nodes, netting) {
  count <- new.env(parent = emptyenv())
  count$settles <- 0L
  count$slopes <- 0L
  list(
    gear = gear, fields = fields, nodes = nodes, netting = netting, count = count,
    lower = lower_ends(fields), width = upper_ends(fields) - lower_ends(fields),
    size = vapply(fields, function(field) {
      if (nzchar(field$unit) && !field$whole) unit_size(plain_unit(field$unit)) else 1
    }, 0)
  )
}

points_scaled <- function(points, values) (values - points$lower) / points$width
points_values <- function(points, scaled) points$lower + scaled * points$width

# A point: list(values (in the fields' units, whole where they must be), gear, state, measures), or
# NULL where the plan does not allow it or it does not settle. from: a state to start from.
settle_point <- function(points, values, from = NULL) {
  whole <- whole_fields(points$fields)
  values[whole] <- round(values[whole])
  gear <- tryCatch(
    set_free(points$gear, points$fields, values), codend_error_plan = function(e) NULL
  )
  if (is.null(gear)) return(NULL)
  points$count$settles <- points$count$settles + 1L
  state <- tryCatch(
    settled_state(gear, points$nodes, points$netting, from),
    codend_error_not_converged = function(e) NULL
  )
  if (is.null(state)) return(NULL)
  list(values = values, gear = gear, state = state, measures = measures(state))
}

# Slopes of measures, in their units, by the scaled fields: a matrix with a row per name in `of`. By
# the tangent, or where there is none between gears settled on both sides. NA where neither is.
point_slopes <- function(points, point, of) {
  points$count$slopes <- points$count$slopes + 1L
  slopes <- matrix(NA_real_, length(of), length(points$fields), dimnames = list(of, NULL))
  if (!length(of)) return(slopes)
  by <- which(point$values != 0)
  if (length(by)) {
    work <- tangent_work(point$state)
    fields <- slope_fields(point$gear, lapply(points$fields[by], `[[`, "paths"))
    slopes[, by] <- vapply(fields, function(field) {
      field_slopes(work, field, secants = FALSE)$slope[of] / field$value
    }, numeric(length(of))) * rep(points$width[by], each = length(of))
    points$count$settles <- points$count$settles + 2L * sum(whole_fields(points$fields[by]))
  }
  for (k in which(colSums(is.na(slopes)) > 0)) {
    slopes[, k] <- side_slopes(points, point, k, of)
  }
  slopes
}

# Share of its range that a field is moved by for slopes without a tangent.
side_share <- 0.01

side_slopes <- function(points, point, k, of) {
  step <- side_share * points$width[k]
  if (points$fields[[k]]$whole) step <- max(1, round(step))
  ends <- point$values[k] + c(-1, 1) * step
  ends <- pmin(pmax(ends, points$lower[k]), points$lower[k] + points$width[k])
  sides <- lapply(ends, function(end) {
    if (end == point$values[k]) return(point)
    values <- point$values
    values[k] <- end
    settle_point(points, values, point$state)
  })
  for (side in 1:2) if (is.null(sides[[side]])) {
    sides[[side]] <- point
    ends[side] <- point$values[k]
  }
  if (ends[1L] == ends[2L]) return(rep(NA_real_, length(of)))
  values <- lapply(sides, function(side) plain_measures(side$measures)[of])
  (values[[2L]] - values[[1L]]) / (ends[2L] - ends[1L]) * points$width[k]
}

# What formulas are evaluated at: list(values, slopes) of measures by all their names and of fields
# by their first path, corrected for what a finer lattice says. exact: the values at which the
# fields are to be, where whole numbers were rounded: measures follow their slopes there.
formula_point <- function(points, point, words, slopes = NULL, exact = point$values) {
  measured <- plain_measures(point$measures)
  more <- corrected_by(points, point)
  measured[names(more)] <- measured[names(more)] + more
  found <- measured[words$column]
  names(found) <- words$name
  paths <- vapply(points$fields, function(field) field$paths[1L], "")
  by <- NULL
  if (!is.null(slopes)) {
    rows <- match(words$column, rownames(slopes))
    by <- slopes[rows, , drop = FALSE]
    off <- (exact - point$values) / points$width
    if (any(off != 0)) found <- found + drop(by %*% off)
    by <- rbind(by * words$factor, diag(points$width * points$size, length(paths)))
    rownames(by) <- c(words$name, paths)
  }
  list(values = c(found * words$factor, setNames(exact * points$size, paths)), slopes = by)
}

# n points spread over the unit cube: an additive recurrence whose steps are powers of the root of
# x^(d+1) = x + 1 (Roberts 2018, The unreasonable effectiveness of quasirandom sequences).
spread_points <- function(n, dimensions) {
  root <- stats::uniroot(function(x) x^(dimensions + 1) - x - 1, c(1, 2), tol = 1e-14)$root
  (0.5 + outer(seq_len(n), root^-seq_len(dimensions))) %% 1
}

# By how much measures of a point are corrected, by their names; none without a correction.
corrected_by <- function(points, point) {
  found <- points$correction
  if (is.null(found)) return(numeric())
  found$value + drop(found$slope %*% (points_scaled(points, point$values) - found$at))
}
