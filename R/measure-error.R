# The error that a lattice leaves in measures, from the coarser lattices that a gear was settled on.
#
# Richardson's estimate: with an error that falls as the length of elements to the power p, two
# lattices of m and n nodes, whose measures differ by d, leave |d| / ((n / m)^(p / 2) - 1) in the
# finer one, as n grows with the square of 1 / length. The power is 1: netting converges with 0.5
# to 2, edges and slack netting with 1. From three lattices it is the observed one, between these
# bounds. One difference may vanish by chance: an error is at least what is usual, as a share, among
# the measures of the gear, and at least a floor. Tensions and other forces carry the drag, along
# ropes whose part of it may move by chance: their share is at least that of the drag.

usual_order <- 1
least_order <- 0.75
greatest_order <- 1.5
# Lattices whose nodes differ by less than this factor tell nothing.
least_ratio <- 1.5
# Times their difference at most: that of near lattices is of their counts more than of their size.
most_times <- 2
# A lattice of fewer nodes tells only where there is no other: on it a trawl has a handful of meshes
# across a panel, and its errors follow no power.
fair_nodes <- 400
# Of a measure itself.
error_floor <- 2e-4
# Of slack netting, on 1,500 nodes: a third of it and more vanishes as trawls are divided further,
# by steps that two lattices may miss (`make errors`). It falls with the length of elements.
slack_floor <- 0.2
slack_floor_nodes <- 1500

# What is told where it is missed, a share of the main measures.
usual_accuracy <- 0.01

# Kinds of measures that settle() aims its accuracy at: opening, spread, drag.
main_kinds <- c("spread", "height", "area", "volume", "enclosed_volume", "catch_volume",
  "catch_surface", "total_drag")

# Errors of measures (named numbers, as shown) of a state on a lattice of so many nodes; NA where
# no other lattice tells. levels: list of list(nodes, values), coarse to fine; forces: which of the
# measures are forces; drag: which is the whole drag; slack: which is the share of slack netting.
estimate_errors <- function(values, nodes, levels, forces = integer(), drag = integer(),
                            slack = integer()) {
  error <- setNames(rep(NA_real_, length(values)), names(values))
  ratio <- vapply(levels, function(level) nodes / level$nodes, 0)
  levels <- levels[pmax(ratio, 1 / ratio) >= least_ratio]
  if (!length(levels)) return(error)
  size <- vapply(levels, `[[`, 0, "nodes")
  if (max(size) >= fair_nodes) levels <- levels[size >= fair_nodes]
  at <- function(level) unname(level$values[names(values)])
  last <- levels[[length(levels)]]
  off <- plain(values) - at(last)
  order <- rep(usual_order, length(values))
  left <- numeric(length(values))
  if (length(levels) > 1L) {
    before <- levels[[length(levels) - 1L]]
    off_before <- at(last) - at(before)
    ratio_before <- last$nodes / before$nodes
    if (nodes > last$nodes && ratio_before >= least_ratio) {
      order <- observed_order(off, off_before, nodes / last$nodes, ratio_before)
      # Where a measure goes to and fro the way before tells what may still be left.
      swings <- which(off * off_before < 0)
      left[swings] <- (abs(off_before) * ratio_before^(-usual_order / 2))[swings]
    }
  }
  times <- pmin(1 / abs((nodes / last$nodes)^(order / 2) - 1), most_times)
  error[] <- pmax(abs(off) * times, left)
  size <- abs(plain(values))
  share <- error / size
  share <- share[is.finite(share) & share > 0]
  usual <- if (length(share)) stats::median(share) else 0
  error <- pmax(error, usual * size, error_floor * size)
  error[slack] <- pmax(error[slack], slack_floor * sqrt(slack_floor_nodes / nodes) * size[slack])
  if (length(drag)) error[forces] <- pmax(error[forces], (error / size)[drag[1L]] * size[forces])
  error
}

plain <- function(values) unname(as.double(values))

# The power with which differences between lattices fall; ratios: of nodes.
observed_order <- function(off, off_before, ratio, ratio_before) {
  # Differences of h^p - (h r)^p: for like ratios their quotient is r^p.
  found <- 2 * log(abs(off_before / off)) / log(sqrt(ratio * ratio_before))
  found[!is.finite(found)] <- usual_order
  found[off * off_before < 0] <- usual_order
  pmin(pmax(found, least_order), greatest_order)
}

# The lattices that the measures of a state, `values` as shown, may be compared with, from coarse to
# fine: list(nodes, values). See state_levels().
levels_of <- function(state, values) {
  if (is.null(state$levels)) return(list())
  levels <- state$levels$own()
  # without levels to carry the other gear is not measured
  if (is.null(state$levels$values) || !length(levels)) return(levels)
  carry_levels(levels, state$levels$values(), values)
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
    plainly <- now + (then - old)
    level$values <- setNames(ifelse(is.finite(scaled), scaled, plainly), names)
    level
  })
}

# The largest error of the main measures, as a share: of the measure itself or, among several of one
# kind, of the largest. NA where none is known.
main_error <- function(measures) {
  kind <- attr(measures, "kind")
  main <- kind %in% main_kinds
  error <- attr(measures, "error")[main]
  size <- abs(plain_measures(measures))[main]
  share <- unname(error / stats::ave(size, kind[main], FUN = max))
  share <- share[is.finite(share)]
  if (length(share)) max(share) else NA_real_
}

# Most nodes that an accuracy is sought with.
most_accurate_nodes <- 1e5

# Nodes that would leave the error asked for, where so many leave this one: an error of first order
# falls with their square root.
nodes_for <- function(nodes, error, asked) nodes * (error / asked)^2

percent_text <- function(share) paste(format(signif(100 * share, 2)), "%")
