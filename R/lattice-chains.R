# All chains of a gear as one table, and what lies along them: pieces of edges, or nodes.
#
# A row is one edge of one chain, and the rows of a chain follow each other. In the table are
# edge: id of the panel's edge; from, to: the fractions of it between which the chain runs, from >
# to where reversed; start, end: the fractions of the chain's stretched length there.

# Returns the table with first, rows (first row and number of rows of every chain) and who has
# which chains: seams = list(first, count) of the chains of every seam that joins edges; laced,
# run = chain of every rope that is laced and of every piece that is spread along edges, by name;
# marks = list(edge, fraction) of the places at a share of a laced rope's length;
# gathered = list(chain, at) of all chains gathered in a place; held = list(between = names of the
# two points, chain) of every seam held on a line, by name.
gear_chains <- function(si) {
  edges <- lapply(si$seams, `[[`, "edges")
  gathered <- !vapply(lapply(si$seams, `[[`, "gathered_at"), is.null, NA)
  laced <- Filter(Negate(is.null), lapply(si$ropes, `[[`, "along"))
  spread <- Filter(function(piece) identical(piece$along$kind, "chain"), si$pieces)
  groups <- list(
    unlist(unname(edges[!gathered]), recursive = FALSE), laced,
    lapply(spread, function(piece) piece$along$edges),
    unlist(unname(edges[gathered]), recursive = FALSE)
  )
  size <- lengths(groups)
  ids <- lapply(1:4, function(k) sum(size[seq_len(k - 1L)]) + seq_len(size[k]))
  in_seam <- unname(lengths(edges[!gathered]))
  first <- cumsum(in_seam) - in_seam + 1L
  between <- lapply(si$seams[!gathered], `[[`, "held_between")
  held <- !vapply(between, is.null, NA)
  table <- chain_table(do.call(c, lapply(groups, unname)), si$panels)
  c(
    table,
    list(
      marks = chain_marks(si, table, setNames(ids[[2]], names(laced))),
      seams = list(first = first, count = in_seam),
      laced = setNames(ids[[2]], names(laced)), run = setNames(ids[[3]], names(spread)),
      gathered = list(
        chain = ids[[4]],
        at = rep(vapply(si$seams[gathered], `[[`, "", "gathered_at"), lengths(edges[gathered]))
      ),
      held = Map(list, between = between[held], chain = first[held])
    )
  )
}

chain_marks <- function(si, chains, laced) {
  places <- lapply(si$share_places, parse_place)
  places <- Filter(function(place) place$name %in% names(laced), places)
  row <- vapply(places, function(place) {
    chain <- laced[[place$name]]
    rows <- chains$first[chain] + seq_len(chains$rows[chain]) - 1L
    rows[findInterval(place$place, chains$start[rows], all.inside = FALSE)]
  }, 0L)
  at <- vapply(places, `[[`, 0, "place")
  within <- (at - chains$start[row]) / (chains$end[row] - chains$start[row])
  list(
    edge = chains$edge[row],
    fraction = chains$from[row] + within * (chains$to[row] - chains$from[row])
  )
}

chain_table <- function(chains, panels) {
  rows <- lengths(chains)
  parsed <- unlist(chains, recursive = FALSE)
  edge <- edge_number(panels, vapply(parsed, `[[`, "", "panel"), vapply(parsed, `[[`, "", "edge"))
  reversed <- vapply(parsed, `[[`, NA, "reversed")
  low <- from <- vapply(parsed, `[[`, 0, "from")
  high <- to <- vapply(parsed, `[[`, 0, "to")
  from[reversed] <- high[reversed]
  to[reversed] <- low[reversed]
  first <- cumsum(rows) - rows + 1L
  start <- rep(0, length(edge))
  end <- rep(1, length(edge))
  for (chain in which(rows > 1L)) {
    mine <- seq.int(first[chain], length.out = rows[chain])
    long <- abs(to[mine] - from[mine]) * vapply(parsed[mine], function(e) {
      edge_length(panels[[e$panel]], e$edge)
    }, 0)
    if (sum(long) == 0) long[] <- 1
    reached <- cumsum(long) / sum(long)
    start[mine] <- c(0, reached[-length(reached)])
    end[mine] <- reached
  }
  list(edge = edge, from = from, to = to, start = start, end = end, first = first, rows = rows)
}

# Pairs of a seam's first chain and each of its others.
joined_chains <- function(seams) {
  list(
    first = rep.int(seams$first, seams$count - 1L),
    other = sequence(seams$count - 1L, seams$first + 1L)
  )
}

# Which of the things numbered 1, 2, ... along its edge every row covers.
#
# number: of things on every edge; inside: function(row) telling which of them lie in the row, asked
# where it does not run along the whole edge.
# Returns list(begin, way, number): the first in the chain's direction, 1 or -1, and how many.
covered <- function(chains, number, inside) {
  number <- number[chains$edge]
  low <- rep.int(1L, length(number))
  for (row in which(abs(chains$to - chains$from) != 1)) {
    found <- which(inside(row))
    number[row] <- length(found)
    if (length(found)) low[row] <- found[1L]
  }
  reversed <- chains$from > chains$to
  list(begin = low + reversed * (number - 1L), way = 1L - 2L * reversed, number = number)
}

# The things that the rows cover, chain after chain.
#
# Returns list(edge, row, k = edge, row and number along the edge of each; first, count = by chain,
# where its things begin among these and how many they are).
along_chains <- function(chains, covered) {
  row <- rep.int(seq_along(chains$edge), covered$number)
  before <- c(0L, cumsum(covered$number))
  list(
    edge = chains$edge[row], row = row, k = sequence(covered$number, covered$begin, covered$way),
    first = before[chains$first] + 1L,
    count = before[chains$first + chains$rows] - before[chains$first]
  )
}

# Where the things of these chains are among all.
things_of <- function(along, chain) sequence(along$count[chain], along$first[chain])
