# Twines that the viewer draws if meshes are too small to draw each one.
#
# Every panel has two drawn coordinates, linear functions of its twine coordinates. The viewer draws
# twines at multiples of a power of two. Both coordinates are continuous across seams, except for
# sign, exchange and a power of two. So every drawn twine continues across a seam, or ends there if
# the other panel is drawn more coarsely.

# Returns list(scale, offset (2 x panels)). Drawn coordinates are twine coordinates divided by
# `scale`, plus `offset`. The scale is at least 1 and below 2.
drawn_twines <- function(si) drawn_coordinates(panel_shapes(si$panels), si$seams)

drawn_coordinates <- remembered(new_drawn_coordinates)

new_drawn_coordinates <- function(panels, seams) {
  joints <- seam_joints(list(panels = panels, seams = seams))
  n <- length(panels)
  scale <- rep(NA_real_, n)
  offset <- matrix(0, 2L, n)
  links <- drawn_links(panels, joints)
  while (anyNA(scale)) {
    ready <- which(!is.na(scale[links$first]) & is.na(scale[links$second]))
    if (length(ready)) {
      made <- continued_coordinates(links, ready[1L], scale, offset)
      p <- links$second[ready[1L]]
    } else {
      p <- c(links$first[is.na(scale[links$first])], which(is.na(scale)))[1L]
      made <- list(scale = 1, offset = mirrored_offset(panels[[p]]))
    }
    scale[p] <- made$scale
    offset[, p] <- made$offset
  }
  power <- 2^floor(log2(scale) + 1e-6)
  list(scale = scale / power, offset = offset * rep(power, each = 2L))
}

# Returns the offset at which a panel's twines are symmetric about its middle line. They then meet
# the twines of a mirror image next to it.
mirrored_offset <- function(panel) {
  c(-edge_twines(panel, "upper", if (is_square(panel)) 0.5 else 1)[1L], 0)
}

# Returns twine coordinates (2 x fractions) at fractions of a panel's edge.
edge_twines <- function(panel, edge, fraction) {
  one <- rep(1, length(fraction))
  switch(edge,
    upper = twine_coordinates(panel, fraction, 0 * one),
    lower = twine_coordinates(panel, fraction, one),
    left = twine_coordinates(panel, 0 * one, fraction),
    right = twine_coordinates(panel, one, fraction)
  )
}

# Returns the joints across which drawn coordinates are continued, best first: joints across the
# net, then by mismatch of twine ratios, number of common joints and length. `from`, `to`: twine
# coordinates of the ends, 2 x 2, an end per column. `pair`: the family of the first panel that
# continues in each family of the second.
drawn_links <- function(panels, joints) {
  ends <- function(panel, edge, from, to) {
    Map(function(panel, edge, from, to) edge_twines(panels[[panel]], edge, c(from, to)),
      panel, edge, from, to, USE.NAMES = FALSE)
  }
  from <- ends(joints$panel, joints$edge, joints$from, joints$to)
  to <- ends(joints$other, joints$other_edge, joints$other_from, joints$other_to)
  is_across <- function(edge) edge %in% c("upper", "lower")
  across <- is_across(joints$edge) & is_across(joints$other_edge)
  length <- abs(joints$to - joints$from) * as.double(mapply(function(panel, edge) {
    edge_length(panels[[panel]], edge)
  }, joints$panel, joints$edge))
  mirrored <- !across | (joints$edge == joints$other_edge) ==
    ((joints$to > joints$from) == (joints$other_to > joints$other_from))
  unlike <- matrix(vapply(seq_along(from), function(k) {
    c(unlike_run(from[[k]], to[[k]], 1:2), unlike_run(from[[k]], to[[k]], 2:1))
  }, numeric(2L)), 2L)
  swapped <- ifelse(abs(unlike[1L, ] - unlike[2L, ]) < 1e-6, mirrored, unlike[2L, ] < unlike[1L, ])
  meetings <- stats::ave(length, paste(joints$panel, joints$other), FUN = base::length)
  best <- order(-across, round(pmin(unlike[1L, ], unlike[2L, ]), 6L), -meetings, -length)
  links <- list(
    first = match(joints$panel, names(panels)), second = match(joints$other, names(panels)),
    from = from, to = to, pair = lapply(swapped, function(s) if (s) 2:1 else 1:2)
  )
  lapply(links, `[`, best)
}

# Number of twine coordinates along a joint. ends: see `drawn_links()`.
run_along <- function(ends) ends[, 2L] - ends[, 1L]

# Returns the mismatch of the twine ratios of both families across a joint. It is 1e3 if a family
# runs along the joint on one side only.
unlike_run <- function(from, to, pair) {
  from <- abs(run_along(from))[pair]
  to <- abs(run_along(to))
  ends <- from > 1e-9 & to > 1e-9
  if (all(ends)) return(abs(diff(log(to / from))))
  if (any(ends) && identical(from > 1e-9, to > 1e-9)) 0 else 1e3
}

# Returns the coordinates of a link's second panel that continue those from its first.
continued_coordinates <- function(links, k, scale, offset) {
  first <- links$first[k]
  known <- links$from[[k]] / scale[first] + offset[, first]
  own <- links$to[[k]]
  pair <- links$pair[[k]]
  # A family along the joint has no ends to continue, so both families continue the other.
  pair <- ifelse(abs(run_along(known)[pair]) < 1e-9 & abs(run_along(own)) > 1e-9, 3L - pair, pair)
  ends <- abs(run_along(own)) > 1e-9 & abs(run_along(known)[pair]) > 1e-9
  ratio <- abs(run_along(own) / run_along(known)[pair])[ends]
  new_scale <- if (length(ratio)) exp(mean(log(ratio))) else 1
  sign <- ifelse(run_along(own) * run_along(known)[pair] < 0, -1, 1)
  list(scale = new_scale, offset = sign * known[pair, 1L] - own[, 1L] / new_scale)
}
