# The error that a lattice leaves in measures, from other lattices of the same gear.
#
# A measure y on a lattice with elements of length h is taken as Y + a h^p + e: the drift a h^p
# falls with a power p, and e, different on every lattice, is what depends on how rows of elements
# happen to lie; its standard deviation is a share of the drift's. Y, which is not known, is fitted
# to all lattices by generalised least squares (Aitken 1936), and the error reported is the root
# mean square of y - Y given them. Orders p are weighed by their likelihood: three lattices that
# drift one way show theirs. The size of drift and scatter together is estimated from the measure's
# own differences and, as one lattice's difference may vanish by chance, from what is usual in
# measures of its class.
#
# The numbers below are for all gears and measures. They are from the shipped gears and 20 drawn at
# random, on 11 lattices of 250 to 12,000 nodes each, and were checked on others (`make errors`).

# Orders that are weighed: netting converges with 0.5 to 2.
error_orders <- c(0.75, 1, 1.5)
# Scatter as a share of the drift, on the same lattice.
scatter_share <- 0.25
# Lattices whose nodes differ by less than this factor say too little.
least_ratio <- 1.5
# A lattice of fewer nodes counts only where there is no other: on it a trawl has a handful of
# meshes across a panel.
fair_nodes <- 400
# Measures whose usual share is known: fewer of a class take that of all.
least_class <- 3L
# How far places and lengths change is a tenth of how far openings do, as a share of themselves.
place_share <- 0.1
# What is left at least, as a share of a measure, on lattices of netting with so many nodes: of 6
# bottom trawls drawn at random 2 changed by 1 to 2 % beyond 4,000 nodes and hardly before. It falls
# with the length of elements.
error_floor <- 2e-3
floor_nodes <- 1500
# Of slack netting the floor is larger, and it is uncertain by this share of a row of elements also
# where none is slack.
slack_floor <- 0.1
# Of a measure itself, at least.
least_share <- 1e-5

# What is reported where it is missed, a share of the main measures.
usual_accuracy <- 0.01

# Kinds of measures that settle() aims its accuracy at: opening, spread, drag.
main_kinds <- c("spread", "height", "area", "volume", "enclosed_volume", "catch_volume",
  "catch_surface", "total_drag")
# Drag that is a smaller share of the weights in water than this is no main measure.
light_drag <- 0.01

# Classes of measures whose errors are alike as shares of themselves.
error_classes <- function(kinds, units) {
  found <- rep("opening", length(kinds))
  found[units %in% c(names(plan_units$force), "kW", "l/h")] <- "force"
  found[kinds %in% c("ground_friction", "pull_used")] <- "force"
  found[kinds %in% c("depth", "least_depth", "greatest_depth", "length", "distance")] <- "place"
  found[kinds %in% c("slack_netting", "largest_panel_twine_tension", "most_loaded_twine_tension",
    "rope_on_ground")] <- "netting"
  found
}

# Errors of measures (named numbers, as shown) of a state on a lattice of so many nodes; NA where
# there is no other lattice. levels: list of list(nodes, values); class: of each measure, of
# error_classes(); slack: which is the share of slack netting, of gears that have netting.
estimate_errors <- function(values, nodes, levels, class = rep("opening", length(values)),
                            slack = integer()) {
  error <- setNames(rep(NA_real_, length(values)), names(values))
  levels <- fair_levels(levels, nodes)
  if (!length(levels) || !length(values)) return(error)
  size <- abs(plain(values))
  others <- vapply(levels, function(level) plain(level$values[names(values)]), size)
  others <- matrix(others, length(size))
  count <- vapply(levels, `[[`, 0, "nodes")
  # a measure that other lattices do not have is uncertain by itself
  lost <- which(rowSums(is.finite(others)) == 0L & is.finite(plain(values)))
  known <- is.finite(others) & is.finite(plain(values))
  for (which in split(seq_along(size), apply(known, 1L, paste, collapse = ""))) {
    use <- known[which[1L], ]
    if (any(use)) {
      error[which] <- fitted_errors(
        cbind(others[which, use, drop = FALSE], plain(values)[which]), c(count[use], nodes),
        class[which]
      )
    }
  }
  error[lost] <- size[lost]
  if (length(slack)) error <- floored_errors(error, size, nodes, class, slack)
  error
}

plain <- function(values) unname(as.double(values))

# Those of other lattices that count for one of so many nodes.
fair_levels <- function(levels, nodes) {
  size <- vapply(levels, function(level) as.double(level$nodes), 0)
  keep <- pmax(size / nodes, nodes / size) >= least_ratio
  if (any(keep & size >= fair_nodes)) keep <- keep & size >= fair_nodes
  levels[keep]
}

# The root mean square of what the last column of values (measures x lattices) is off, by the fit to
# all of them. nodes: of the lattices.
fitted_errors <- function(values, nodes, class) {
  last <- ncol(values)
  length <- sqrt(nodes[last] / nodes)
  freedom <- last - 1
  size <- abs(values[, last])
  fits <- lapply(error_orders, function(order) {
    covariance <- outer(length^order, length^order) + diag((scatter_share * length)^2, last)
    weight <- solve(covariance)
    total <- sum(weight)
    rest <- weight - outer(rowSums(weight), rowSums(weight)) / total
    squares <- pmax(rowSums((values %*% rest) * values), 0)
    usual <- usual_shares(sqrt(squares / freedom) / size, class) * size
    variance <- (usual^2 + squares) / (1 + freedom)
    off <- values[, last] - drop(values %*% rowSums(weight)) / total
    spread <- as.numeric(determinant(covariance)$modulus) + log(total)
    list(
      square = off^2 + variance / total,
      likelihood = -(1 + freedom) / 2 * log(variance + .Machine$double.xmin) - spread / 2
    )
  })
  column <- function(what) matrix(unlist(lapply(fits, `[[`, what)), nrow(values))
  likelihood <- column("likelihood")
  share <- exp(likelihood - apply(likelihood, 1L, max))
  sqrt(rowSums(share * column("square")) / rowSums(share))
}

# What is usual of a class of measures, as a share of each: the median of its shares.
usual_shares <- function(share, class) {
  counts <- is.finite(share) & share > 1e-9
  median_of <- function(which) if (any(which)) stats::median(share[which]) else 0
  every <- median_of(counts)
  of <- vapply(unique(class), function(one) {
    mine <- counts & class == one
    if (sum(mine) >= least_class) return(median_of(mine))
    if (one == "place") place_share * every else every
  }, 0)
  pmax(unname(of[class]), least_share)
}

# Errors with what lattices of netting leave at least.
floored_errors <- function(error, size, nodes, class, slack) {
  at_size <- sqrt(floor_nodes / nodes)
  floor <- error_floor * at_size * size * (class != "place")
  floor[slack] <- slack_floor * (at_size * size[slack] + 100 / sqrt(nodes))
  sqrt(error^2 + floor^2)
}

# What a balance leaves in measures (as shown) that vanish: in forces the share of the largest one
# that settle() ends at, in lengths that of the longest, and what follows from these in areas and
# volumes.
balance_errors <- function(values, units) {
  size <- abs(plain(values))
  largest <- function(of) max(0, size[of], na.rm = TRUE)
  error <- numeric(length(size))
  powers <- c(m = 1, m2 = 2, m3 = 3)
  for (unit in names(powers)) error[units == unit] <- largest(units == "m")^powers[[unit]]
  for (unit in names(plan_units$force)) error[units == unit] <- largest(units == unit)
  settle_tolerance * error
}

# The lattices that the measures of a state, `values` as shown, may be compared with, from coarse to
# fine: list(nodes, values). See state_levels().
levels_of <- function(state, values) {
  compared <- state$compared
  if (!is.null(compared)) {
    if (is.null(compared$values)) return(compared$levels)
    return(carry_levels(compared$levels, compared$values, values))
  }
  if (is.null(state$levels)) return(list())
  levels <- state$levels$own()
  # without levels to carry the other gear is not measured
  if (is.null(state$levels$values) || !length(levels)) return(levels)
  carry_levels(levels, state$levels$values(), values)
}

# What the moments of a tow take of the state that it starts from: list(levels, values), plain
# numbers; NULL where its errors are not known.
compared_lattices <- function(state) {
  values <- plain_measures(measures(state))
  levels <- levels_of(state, values)
  if (length(levels)) list(levels = levels, values = values)
}

# By how much a step of a march may be off, as a standard error of a measure: of the places that it
# follows from one and a half times the accuracy that steps are held to (on gears that were tried
# positions stay within three), of forces 2.5 % at the usual one and as its root: with 0.01 and with
# 0.3 m nine tenths of the forces of a purse seine that is shot are off by 4 and 9 % at most, of a
# trawl that shoots its warps by 0.03 and 0.15 %. An opening has two sides, an area two lengths, a
# volume three.
step_places <- 1.5
step_forces <- 0.25

# Such errors of measures (as shown) with these units; accuracy: m.
step_errors <- function(values, units, accuracy) {
  place <- step_places * accuracy
  size <- abs(plain(values))
  error <- 0 * size
  error[units == "m"] <- place
  error[units == "m2"] <- (2 * place * sqrt(size))[units == "m2"]
  error[units == "m3"] <- (3 * place * size^(2 / 3))[units == "m3"]
  forces <- units %in% c(names(plan_units$force), "kW")
  error[forces] <- step_forces * sqrt(accuracy) * size[forces]
  error
}

# The errors of a moment of a tow: of its lattice and its steps; NA where its start had no such
# measure.
moment_errors <- function(error, state, values, units) {
  error[!names(values) %in% names(state$compared$levels[[1L]]$values)] <- NA
  sqrt(error^2 + step_errors(values, units, state$step_accuracy)^2)
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
