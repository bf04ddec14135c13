# Discretisation errors of measures. The method is in src/engine/measure/measure_errors.hpp.

# Relative error of the main measures above which summaries report a missed target.
usual_accuracy <- 0.01

# Kinds of measures that define the accuracy of settle(): openings, spreads and drag.
main_kinds <- c("spread", "height", "area", "volume", "enclosed_volume", "catch_volume",
  "catch_surface", "total_drag")
# Drag below this fraction of the weights in water is not a main measure.
light_drag <- 0.01

# Returns standard errors of a state's measures (SI, by name). NA: no other mesh is comparable. In a
# tow, the errors include the error in time.
state_errors <- function(state, found = state_values(state)) {
  names <- names(found$values)
  levels <- levels_of(state, found$values)
  in_time <- state$compared$time_error
  error <- estimate_errors(found$values, found$kinds, state$mesh$nodes, levels,
    if (is.null(in_time)) first_of(state$step_accuracy, 0) else 0)
  if (!is.null(in_time)) error <- sqrt(error^2 + unname(in_time[names])^2)
  # the initial state lacks these measures, so their errors are unknown
  known <- unlist(lapply(levels, function(level) names(level$values)))
  if (!is.null(state$time)) error[!names %in% known] <- NA
  setNames(error, names)
}

# Error in time over its difference from a run with a quarter of the accuracy: 5/3 for a scheme of
# second order with an error limit per step, 2 if errors grow with the square root of the accuracy.
time_error_share <- 2

# Returns standard errors in time of measures at several times, from their values with the tow's
# accuracy and with a tighter one (measures x times). A difference may vanish by chance, so that
# half of the variance is the mean square over all times.
time_errors <- function(coarse, tight) {
  squares <- (time_error_share * (tight - coarse))^2
  sqrt((squares + rowMeans(squares, na.rm = TRUE)) / 2)
}

# Returns standard errors (SI) of named values on a mesh with this number of nodes. `kinds`: their
# entries in the registries; `levels`: list of list(nodes, values).
estimate_errors <- function(values, kinds, nodes, levels, step_accuracy = 0,
                            tolerance = settle_tolerance) {
  kinds <- vapply(kinds, `[[`, "", "kind")
  others <- lapply(levels, function(level) plain(level$values[names(values)]))
  nodes <- c(nodes, vapply(levels, `[[`, 0, "nodes"))
  engine_measure_errors(
    unname(kinds), as.double(nodes), c(plain(values), unlist(others)), tolerance, step_accuracy
  )
}

plain <- function(values) unname(as.double(values))

# Returns the mesh levels for comparison with a state's measures (`values`, SI), coarse to fine:
# list of list(nodes, values). See new_levels().
levels_of <- function(state, values) {
  compared <- state$compared
  if (!is.null(compared)) {
    carry <- function(levels, from) {
      if (is.null(from)) levels else carry_levels(levels, from, values)
    }
    coarse <- if (!is.null(compared$coarse)) list(compared$coarse)
    return(c(carry(coarse, compared$last), carry(compared$levels, compared$values)))
  }
  if (is.null(state$levels)) return(list())
  base <- state$levels$base
  if (is.null(base)) return(own_levels(state))
  levels <- own_levels(base)
  # avoid measuring the base state if it has no levels
  if (length(levels)) carry_levels(levels, base_values(base), values) else list()
}

# Returns list(levels, values) in SI of the state that a tow starts from; NULL if its errors are
# unknown.
compared_meshes <- function(state) {
  values <- state_values(state)$values
  levels <- levels_of(state, values)
  if (length(levels)) list(levels = levels, values = values)
}

# Returns mesh levels from another gear, scaled by the ratio of the measures. This assumes that
# gears of similar shape have the same relative errors.
carry_levels <- function(levels, values_from, values) {
  lapply(levels, function(level) {
    names <- intersect(intersect(names(level$values), names(values_from)), names(values))
    old <- plain(values_from[names])
    now <- plain(values[names])
    then <- unname(level$values[names])
    scaled <- now * then / old
    # a ratio to zero is undefined: use the level's own value as the difference
    level$values <- setNames(ifelse(is.finite(scaled), scaled, now + then), names)
    level
  })
}

# Returns the largest relative error of the main measures; NA if unknown. The reference is the
# largest measure of the same kind. Gears without main measures use their forces.
main_error <- function(measures) {
  kind <- attr(measures, "kind")
  main <- attr(measures, "main")
  error <- attr(measures, "error")[main]
  size <- abs(plain_measures(measures))[main]
  share <- unname(error / stats::ave(size, kind[main], FUN = max))
  share <- share[is.finite(share)]
  if (length(share)) max(share) else NA_real_
}

# Returns a logical vector: TRUE for main measures. `light`: drag is small compared with the
# weights.
main_measures <- function(kind, units, light) {
  main <- kind %in% setdiff(main_kinds, if (light) "total_drag")
  if (any(main)) main else units %in% names(plan_units$force) & kind != "total_drag"
}

# Maximum number of nodes in the search for an accuracy.
most_accurate_nodes <- 1e5

# Number of nodes for the required error. A first-order error falls with the square root of the
# number of nodes.
nodes_for <- function(nodes, error, asked) nodes * (error / asked)^2

percent_text <- function(share) {
  paste(with_plain_numbers(format(signif(100 * share, 2))), "%")
}
