# The errors that lattices leave in measures: what the engine computes them from
# (src/engine/measure/measure_errors.hpp has how), and what is made of them.

# What is reported where it is missed, a share of the main measures.
usual_accuracy <- 0.01

# Kinds of measures that settle() aims its accuracy at: opening, spread, drag.
main_kinds <- c("spread", "height", "area", "volume", "enclosed_volume", "catch_volume",
  "catch_surface", "total_drag")
# Drag that is a smaller share of the weights in water than this is no main measure.
light_drag <- 0.01

# Standard errors of a state's measures (state_values()), SI, by name; NA where no other lattice
# says more. Those of a moment of a tow are of its lattice and its steps.
state_errors <- function(state, found = state_values(state)) {
  names <- names(found$values)
  levels <- levels_of(state, found$values)
  error <- estimate_errors(found$values, found$kinds, state$lattice$nodes, levels,
    first_of(state$step_accuracy, 0))
  # where the start had no such measure
  if (!is.null(state$time)) error[!names %in% names(state$compared$levels[[1L]]$values)] <- NA
  setNames(error, names)
}

# The same of named values (SI) on a lattice of so many nodes. kinds: their entries in the
# registries; levels: list of list(nodes, values).
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

# The lattices that the measures of a state, `values` in SI, may be compared with, from coarse to
# fine: list(nodes, values). See new_levels().
levels_of <- function(state, values) {
  compared <- state$compared
  if (!is.null(compared)) {
    if (is.null(compared$values)) return(compared$levels)
    return(carry_levels(compared$levels, compared$values, values))
  }
  if (is.null(state$levels)) return(list())
  base <- state$levels$base
  if (is.null(base)) return(own_levels(state))
  levels <- own_levels(base)
  # without levels to carry the other gear is not measured
  if (length(levels)) carry_levels(levels, base_values(base), values) else list()
}

# What the moments of a tow take of the state that it starts from: list(levels, values), SI;
# NULL where its errors are not known.
compared_lattices <- function(state) {
  values <- state_values(state)$values
  levels <- levels_of(state, values)
  if (length(levels)) list(levels = levels, values = values)
}

# The levels of a state that began from another gear's: theirs, scaled with its measures. Gears that
# differ little in shape have like errors, as shares.
carry_levels <- function(levels, values_from, values) {
  lapply(levels, function(level) {
    names <- intersect(intersect(names(level$values), names(values_from)), names(values))
    old <- plain(values_from[names])
    now <- plain(values[names])
    then <- unname(level$values[names])
    scaled <- now * then / old
    # what was nothing adds what the level has of it
    level$values <- setNames(ifelse(is.finite(scaled), scaled, now + then), names)
    level
  })
}

# The largest error of the main measures, as a share: of the measure itself or, among several of one
# kind, of the largest. Of a gear without any, of its forces. NA where none is known.
main_error <- function(measures) {
  kind <- attr(measures, "kind")
  main <- attr(measures, "main")
  error <- attr(measures, "error")[main]
  size <- abs(plain_measures(measures))[main]
  share <- unname(error / stats::ave(size, kind[main], FUN = max))
  share <- share[is.finite(share)]
  if (length(share)) max(share) else NA_real_
}

# Which measures are main ones. light: whether drag is little next to the weights.
main_measures <- function(kind, units, light) {
  main <- kind %in% setdiff(main_kinds, if (light) "total_drag")
  if (any(main)) main else units %in% names(plan_units$force) & kind != "total_drag"
}

# Most nodes that an accuracy is sought with.
most_accurate_nodes <- 1e5

# Nodes that would leave the error asked for, where so many leave this one: an error of first order
# falls with their square root.
nodes_for <- function(nodes, error, asked) nodes * (error / asked)^2

percent_text <- function(share) {
  paste(with_plain_numbers(format(signif(100 * share, 2))), "%")
}
