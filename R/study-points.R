# Points of `optimise_gear()` and `calibrate()`: settled gears at values of their free fields.
# Scaled fields are 0 at the lower end of the range and 1 at the upper end.

# fields: from `free_fields()`. states: from `first_states()`. file: of the record, or NULL.
new_points <- function(gear, fields, nodes, netting, states = NULL, file = NULL) {
  list(
    gear = gear, fields = fields, nodes = nodes, netting = netting,
    fine = if (!is.null(states$fine)) nodes_of(states$fine),
    count = new_count(),
    shared = list2env(parent = emptyenv(), list(
      start = states$coarse, fine = states$fine, record = open_record(file)
    )),
    lower = lower_ends(fields), width = upper_ends(fields) - lower_ends(fields),
    size = vapply(fields, function(field) {
      if (nzchar(field$unit) && !field$whole) unit_size(plain_unit(field$unit)) else 1
    }, 0)
  )
}

new_count <- function() list2env(list(n_solves = 0L, slopes = 0L), parent = emptyenv())

points_scaled <- function(points, values) (values - points$lower) / points$width
points_values <- function(points, scaled) points$lower + scaled * points$width

# Settles the gear as given, before a search. Returns list(coarse (state on the mesh of the search),
# fine (state on the mesh of the results, as from settle(); NULL if it is the same mesh)).
first_states <- function(gear, nodes, netting, accuracy) {
  fine <- accurate_state(gear, nodes, netting, accuracy)
  search <- requested_nodes(gear, nodes)
  if (fine$mesh$nodes < least_ratio * search) return(list(coarse = fine))
  list(coarse = settled_state(gear, search, netting, fine), fine = fine)
}

# Settles the gear at `values`, starting from the state `from`. Returns list(values (rounded if
# whole), gear, state, measures (without errors)), or NULL if the plan is invalid or the gear does
# not settle. A recorded point has neither gear nor state; `complete_point()` adds them.
settle_point <- function(points, values, from = NULL) {
  settle_points(list(points), values, list(first_of(from, points$shared$start)))[[1L]]
}

# Settles the gears of `cases`, points that differ in their gear, at the same values. from: list of
# states; NULL settles a gear from scratch.
settle_points <- function(cases, values, from) {
  first <- cases[[1L]]
  whole <- whole_fields(first$fields)
  values[whole] <- round(values[whole])
  first$count$n_solves <- first$count$n_solves + length(cases)
  record <- first$shared$record
  keys <- vapply(cases, record_key, "", values, "measures")
  points <- lapply(keys, function(key) {
    found <- recorded(record, key)
    if (!is.null(found)) list(values = values, measures = setNames(found$numbers, found$names))
  })
  left <- which(vapply(points, is.null, NA))
  points[left] <- on_workers("settle_alone", lapply(cases[left], bare_points), from[left], values)
  add_to_record(record, lapply(left, function(k) {
    found <- points[[k]]$measures
    list(key = keys[k], names = names(found), numbers = as.double(found), n_solves = 1L)
  }))
  lapply(points, function(point) if (length(point$measures)) point)
}

# Returns the parts of points that a worker needs.
bare_points <- function(points) {
  points[c("gear", "fields", "nodes", "netting", "lower", "width")]
}

settle_alone <- function(points, from, values) {
  gear <- tryCatch(
    set_free(points$gear, points$fields, values), codend_error_plan = function(e) NULL
  )
  if (is.null(gear)) return(NULL)
  state <- tryCatch(
    settled_state(gear, points$nodes, points$netting, from),
    codend_error_not_converged = function(e) NULL
  )
  if (is.null(state)) return(NULL)
  found <- state_values(state)
  list(
    values = values, gear = gear, state = state,
    measures = numbers_in_display_units(found$values, measure_units(found$kinds))
  )
}

# Returns a point with its gear and state, which recorded points lack.
complete_point <- function(points, point) {
  if (!is.null(point$state)) return(point)
  settle_alone(points, points$shared$start, point$values)
}

# Returns the derivatives of measures (in their units) by scaled fields, one row per name in `of`.
# If there is no tangent, gears are settled on both sides. NA if this fails too.
point_derivatives <- function(points, point, of) {
  derivatives_of_points(list(points), list(point), of)[[1L]]
}

# Returns point_derivatives() of each point of `cases`.
derivatives_of_points <- function(cases, points, of) {
  first <- cases[[1L]]
  count <- first$count
  record <- first$shared$record
  keys <- mapply(function(case, point) {
    record_key(case, point$values, paste(of, collapse = " "))
  }, cases, points)
  slopes <- lapply(keys, recorded, record = record)
  left <- which(vapply(slopes, is.null, NA))
  settled <- Map(complete_point, cases[left], points[left])
  slopes[left] <- on_workers("derive_alone", lapply(cases[left], bare_points), settled, of)
  add_to_record(record, lapply(left, function(k) c(slopes[[k]], key = keys[k])))
  count$slopes <- count$slopes + length(cases)
  count$n_solves <- count$n_solves + sum(vapply(slopes, `[[`, 0L, "n_solves"))
  lapply(slopes, function(one) {
    matrix(one$numbers, length(of), length(first$fields), dimnames = list(of, NULL))
  })
}

# Returns list(numbers (derivatives, measures x fields), names, n_solves).
derive_alone <- function(points, point, of) {
  points$count <- new_count()
  slopes <- matrix(NA_real_, length(of), length(points$fields), dimnames = list(of, NULL))
  by <- which(point$values != 0)
  if (length(by) && length(of)) {
    work <- tangent_work(point$state)
    fields <- sensitivity_fields(point$gear, lapply(points$fields[by], `[[`, "paths"))
    slopes[, by] <- vapply(fields, function(field) {
      field_sensitivities(work, field, FALSE, search_tangent)$slope[of] / field$value
    }, numeric(length(of))) * rep(points$width[by], each = length(of))
    points$count$n_solves <- 2L * sum(whole_fields(points$fields[by]))
  }
  for (k in which(colSums(is.na(slopes)) > 0)) {
    slopes[, k] <- one_sided_derivatives(points, point, k, of)
  }
  list(numbers = as.vector(slopes), names = of, n_solves = points$count$n_solves)
}

one_sided_derivatives <- function(points, point, k, of) {
  step <- 0.01 * points$width[k]
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
  off_mesh <- points$correction
  if (!is.null(off_mesh)) {
    more <- off_mesh$slope %*% (points_scaled(points, point$values) - off_mesh$at)
    more <- off_mesh$value + drop(more)
    measured[names(more)] <- measured[names(more)] + more
  }
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
