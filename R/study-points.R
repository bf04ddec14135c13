# Points of `optimise_gear()` and `calibrate()`: settled gears at values of their free fields.
# Scaled fields are 0 at the lower end of the range and 1 at the upper end.

# fields: from `free_fields()`.
new_points <- function(gear, fields, nodes, netting) {
  count <- new.env(parent = emptyenv())
  count$n_solves <- 0L
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

# Settles the gear at `values`, starting from the state `from`. Returns list(values (rounded if
# whole), gear, state, measures), or NULL if the plan is invalid or the gear does not settle.
settle_point <- function(points, values, from = NULL) {
  whole <- whole_fields(points$fields)
  values[whole] <- round(values[whole])
  gear <- tryCatch(
    set_free(points$gear, points$fields, values), codend_error_plan = function(e) NULL
  )
  if (is.null(gear)) return(NULL)
  points$count$n_solves <- points$count$n_solves + 1L
  state <- tryCatch(
    settled_state(gear, points$nodes, points$netting, from),
    codend_error_not_converged = function(e) NULL
  )
  if (is.null(state)) return(NULL)
  list(values = values, gear = gear, state = state, measures = measures(state))
}

# Returns the derivatives of measures (in their units) by scaled fields, one row per name in `of`.
# If there is no tangent, gears are settled on both sides. NA if this fails too.
point_derivatives <- function(points, point, of) {
  points$count$slopes <- points$count$slopes + 1L
  slopes <- matrix(NA_real_, length(of), length(points$fields), dimnames = list(of, NULL))
  if (!length(of)) return(slopes)
  by <- which(point$values != 0)
  if (length(by)) {
    work <- tangent_work(point$state)
    fields <- sensitivity_fields(point$gear, lapply(points$fields[by], `[[`, "paths"))
    slopes[, by] <- vapply(fields, function(field) {
      field_sensitivities(work, field, secants = FALSE)$slope[of] / field$value
    }, numeric(length(of))) * rep(points$width[by], each = length(of))
    points$count$n_solves <- points$count$n_solves + 2L * sum(whole_fields(points$fields[by]))
  }
  for (k in which(colSums(is.na(slopes)) > 0)) {
    slopes[, k] <- one_sided_derivatives(points, point, k, of)
  }
  slopes
}

# Step of a field for derivatives without a tangent, as a fraction of its range.
side_share <- 0.01

one_sided_derivatives <- function(points, point, k, of) {
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

# Returns list(values, slopes) of measures and fields by all their names, corrected to the fine
# mesh. `exact`: field values before rounding; measures are extrapolated linearly to them.
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

# Additive recurrence whose steps are powers of the root of x^(d+1) = x + 1. Source: Roberts 2018,
# The unreasonable effectiveness of quasirandom sequences.
spread_points <- function(n, dimensions) {
  root <- stats::uniroot(function(x) x^(dimensions + 1) - x - 1, c(1, 2), tol = 1e-14)$root
  (0.5 + outer(seq_len(n), root^-seq_len(dimensions))) %% 1
}

# Returns the mesh correction of each measure; numeric() without a correction.
corrected_by <- function(points, point) {
  found <- points$correction
  if (is.null(found)) return(numeric())
  found$value + drop(found$slope %*% (points_scaled(points, point$values) - found$at))
}
