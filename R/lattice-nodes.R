# Nodes of a lattice: points, ropes and panels number their own, and seams, laced ropes and names
# for one place make them the same.

# The division of a gear: for each panel its grid or its edges, for each rope its nodes; all in one
# numbering 1..n of nodes. `bars` tells which panels are lattices of bars.
#
# Returns list(nodes, points = node of each point, fraction, edge_node = fractions of an edge at its
# nodes, and these nodes, one edge after the other, count, before = of every edge, how many are its
# own and before them, grids = per panel of cells, ropes = list(node, at = fraction of its
# length) by name, held_edges = the same of every seam held on a line, with the names of its two
# points (between), runs = the same of the chains that pieces are spread along, places = node of
# every point, panel corner and start, middle and end of a rope, by its text).
divide <- function(si, frame, counts, rope_count, bars) {
  chains <- frame$chains
  count <- tabulate(rep.int(frame$pieces$edge, counts), length(frame$pieces$count_of)) + 1L
  before <- cumsum(count) - count
  fraction <- edge_fractions(frame$pieces, counts)
  points <- length(si$points)
  on <- number_edges(count, bars, points)
  edge_node <- function(edge, k) on$offset[edge] + on$step[edge] * k
  ends <- list(
    first = matrix(edge_node(seq_along(count), 1L), 4L),
    last = matrix(edge_node(seq_along(count), count), 4L)
  )
  a <- b <- list()
  same <- function(x, y) {
    a[[length(a) + 1L]] <<- x
    b[[length(b) + 1L]] <<- y
  }

  cover <- covered(chains, count, function(row) {
    f <- fraction[before[chains$edge[row]] + seq_len(count[chains$edge[row]])]
    f > min(chains$from[row], chains$to[row]) - break_tolerance &
      f < max(chains$from[row], chains$to[row]) + break_tolerance
  })
  # Where one edge of a chain ends and the next begins there are two names for one node.
  later <- seq_along(chains$edge)[-chains$first]
  sooner <- later - 1L
  same(
    edge_node(chains$edge[sooner],
      cover$begin[sooner] + cover$way[sooner] * (cover$number[sooner] - 1L)),
    edge_node(chains$edge[later], cover$begin[later])
  )
  cover$begin[later] <- cover$begin[later] + cover$way[later]
  cover$number[later] <- cover$number[later] - 1L
  along <- along_chains(chains, cover)
  node <- edge_node(along$edge, along$k)
  joined <- joined_chains(chains$seams)
  same(node[things_of(along, joined$first)], node[things_of(along, joined$other)])
  same(ends$first[c(1L, 2L), bars], rbind(ends$first[3L, bars], ends$last[3L, bars]))
  same(ends$last[c(1L, 2L), bars], rbind(ends$first[4L, bars], ends$last[4L, bars]))
  # The tip of a pointed panel is one node, gathered in a place or not.
  tips <- which(vapply(si$panels, function(p) c(p$upper, p$lower, 1, 1) == 0, logical(4)))
  on_tip <- rep.int(tips, count[tips] - 1L)
  k <- sequence(count[tips] - 1L)
  same(edge_node(on_tip, k), edge_node(on_tip, k + 1L))

  row <- along$row
  at <- chains$start[row] +
    (fraction[before[along$edge] + along$k] - chains$from[row]) /
      (chains$to[row] - chains$from[row]) * (chains$end[row] - chains$start[row])
  run <- function(chain) {
    things <- things_of(along, chain)
    list(node = node[things], at = at[things])
  }
  held_edges <- lapply(chains$held, function(held) {
    found <- run(held$chain)
    same(found$node[c(1L, length(found$node))], match(held$between, names(si$points)))
    c(found, held["between"])
  })
  last <- points + sum(on$size)
  ropes <- lapply(setNames(seq_along(si$ropes), names(si$ropes)), function(r) {
    rope <- si$ropes[[r]]
    if (!is.null(rope$along)) {
      chain <- chains$laced[[names(si$ropes)[r]]]
      laced <- run(chain)
      if (!is.null(rope$shares)) laced$at <- rope_fraction(laced$at, chains, chain, rope$shares)
      return(laced)
    }
    # One that slides has an element from place to place.
    through <- length(rope$through)
    count <- if (through) through + 1L else rope_count[r]
    ids <- last + seq_len(count + 1L)
    last <<- last + count + 1L
    list(node = ids, at = seq(0, 1, length.out = length(ids)))
  })
  places <- name_places(si, ends, ropes)
  for (r in names(ropes)) {
    rope <- si$ropes[[r]]
    if (is.null(rope$along)) {
      same(places[paste0(r, c(".start", ".end"))], places[c(rope$from, rope$to)])
      same(ropes[[r]]$node[1L + seq_along(rope$through)], places[rope$through])
    }
  }
  for (name in names(si$points)) {
    if (!is.null(si$points[[name]]$at)) same(places[name], places[si$points[[name]]$at])
  }
  gathered <- chains$gathered
  same(
    node[things_of(along, gathered$chain)],
    rep.int(places[gathered$at], along$count[gathered$chain])
  )

  label <- joined_labels(last, unlist(a), unlist(b))
  number <- match(label, unique(label))
  renumber <- function(run) list(node = number[run$node], at = run$at)
  grids <- vector("list", length(bars))
  for (p in which(!bars)) {
    grids[[p]] <- matrix(number[on$base[p] + seq_len(on$size[p])], count[4L * p - 3L])
  }
  list(
    nodes = max(number, 0L),
    points = setNames(number[seq_len(points)], names(si$points)),
    fraction = fraction, edge_node = number[sequence(count, on$offset + on$step, on$step)],
    count = count, before = before,
    grids = grids,
    ropes = lapply(ropes, renumber),
    held_edges = lapply(held_edges, function(edge) c(renumber(edge), edge["between"])),
    runs = lapply(chains$run, function(chain) renumber(run(chain))),
    places = setNames(number[places], names(places))
  )
}

# Fractions of a rope's length at fractions of its chain's stretched length, where it has these
# shares of its length along the chain's edges.
rope_fraction <- function(at, chains, chain, shares) {
  ends <- chains$end[chains$first[chain] + seq_along(shares) - 1L]
  stats::approx(c(0, ends), c(0, cumsum(shares) / sum(shares)), at, rule = 2)$y
}

# Fractions of its edge at every node of an edge, one edge after the other.
edge_fractions <- function(pieces, counts) {
  within <- rep.int(pieces$from, counts) + rep.int(pieces$to - pieces$from, counts) *
    (sequence(counts) - 1L) / rep.int(counts, counts)
  # Every edge ends at 1.
  edges <- seq_along(pieces$count_of)
  c(within, rep.int(1, length(edges)))[order(c(rep.int(pieces$edge, counts), edges))]
}

# Which of all nodes on edges begins the stretch between two nodes of its edge that each x (fraction
# of the edge) lies in.
cell_of <- function(x, edge, on) {
  cell <- on$before[edge] + 1L
  # Edges of one stretch need no search.
  many <- which(on$count[edge] > 2L)
  if (!length(many)) return(cell)
  ends <- seq_along(on$fraction)
  order <- order(
    c(rep.int(seq_along(on$count), on$count), edge[many]), c(on$fraction, x[many]),
    rep.int(0:1, c(length(ends), length(many)))
  )
  reached <- integer(length(order))
  reached[order] <- cumsum(order <= length(ends))
  found <- reached[-ends]
  last <- (on$before + on$count - 1L)[edge[many]]
  beyond <- found > last
  found[beyond] <- last[beyond]
  sooner <- found < cell[many]
  found[sooner] <- cell[many][sooner]
  cell[many] <- found
  cell
}

# Consecutive runs of x, of these lengths.
split_runs <- function(x, lengths) {
  last <- cumsum(lengths)
  lapply(seq_along(lengths), function(k) x[seq.int(last[k] - lengths[k] + 1L, last[k])])
}

# How panels number the nodes of their edges, before these are joined: those of a panel of cells
# are its grid's, those of a panel of bars follow each other.
#
# count: nodes of every edge; from: nodes numbered before.
# Returns list(base, size = of every panel, how many nodes are numbered before its own and its own;
# offset, step = the k-th node of edge e is offset[e] + step[e] k).
number_edges <- function(count, bars, from) {
  count <- matrix(count, 4L)
  columns <- count[1L, ]
  size <- columns * count[3L, ]
  size[bars] <- as.integer(colSums(count))[bars]
  base <- from + cumsum(size) - size
  offset <- rbind(base, base + size - columns, base + 1L - columns, base, deparse.level = 0L)
  step <- rbind(1L, 1L, columns, columns, deparse.level = 0L)
  offset[2L, bars] <- (base + columns)[bars]
  offset[3L, bars] <- (base + columns + count[2L, ])[bars]
  offset[4L, bars] <- (base + size - count[4L, ])[bars]
  step[, bars] <- 1L
  list(base = base, size = size, offset = as.vector(offset), step = as.vector(step))
}

# Nodes of all places by their texts: points, then corners of panels, then starts, middles and ends
# of ropes, then the nodes nearest to places at a share of a rope's length (a laced rope has one
# there).
name_places <- function(si, ends, ropes) {
  corners <- rbind(ends$first[1L, ], ends$last[1L, ], ends$first[2L, ], ends$last[2L, ])
  of_ropes <- vapply(ropes, function(rope) {
    n <- length(rope$node)
    rope$node[c(1L, which.min(abs(rope$at - 0.5)), n)]
  }, integer(3))
  named <- function(names, places) {
    if (length(names)) paste0(rep(names, each = length(places)), ".", places)
  }
  shares <- si$share_places
  at_shares <- vapply(lapply(shares, parse_place), function(place) {
    rope <- ropes[[place$name]]
    rope$node[which.min(abs(rope$at - place$place))]
  }, 0)
  setNames(c(seq_along(si$points), corners, of_ropes, at_shares), c(
    names(si$points),
    named(names(si$panels), c("upper_left", "upper_right", "lower_left", "lower_right")),
    named(names(si$ropes), c("start", "middle", "end")), shares
  ))
}
