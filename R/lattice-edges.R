# Edges of panels as the lattice divides them: breaks that seams carry from panel to panel, the
# pieces between breaks, and how many elements each piece gets.
#
# Edge ids: 4 (p - 1) + 1 upper, 2 lower, 3 left, 4 right, for panel p.

edge_number <- function(panels, panel, edge) {
  4L * (match(panel, names(panels)) - 1L) + match(edge, c("upper", "lower", "left", "right"))
}

# Stretched length of every edge, m, in the order of edge ids.
edge_lengths <- function(panels) {
  sides <- c("upper", "lower", "left", "right")
  unlist(lapply(panels, function(p) vapply(sides, edge_length, 0, panel = p)), use.names = FALSE)
}

break_tolerance <- 1e-7

merge_breaks <- function(known, new) {
  if (length(new) == length(known) && all(abs(new - known) <= break_tolerance)) return(known)
  before <- length(known)
  for (f in new) if (min(abs(f - known)) > break_tolerance) known <- c(known, f)
  if (length(known) > before) sort.int(known) else known
}

# Breaks (fractions) of every edge, carried through seams and across panels until nothing changes.
# linked: TRUE for panels whose opposite edges must be divided alike.
edge_breaks <- function(chains, linked) {
  edge <- chains$edge
  from <- chains$from
  to <- chains$to
  start <- chains$start
  end <- chains$end
  low <- pmin(from, to) - break_tolerance
  high <- pmax(from, to) + break_tolerance
  breaks <- rep(list(c(0, 1)), 4L * length(linked))
  for (row in which(abs(to - from) != 1)) {
    breaks[[edge[row]]] <- merge_breaks(breaks[[edge[row]]], c(from[row], to[row]))
  }
  seams <- lapply(seq_along(chains$seams$first), function(seam) {
    joined <- chains$seams$first[seam] + seq_len(chains$seams$count[seam]) - 1L
    lapply(joined, function(k) chains$first[k] + seq_len(chains$rows[k]) - 1L)
  })
  edges_of <- lapply(seams, function(seam) edge[unlist(seam)])
  touching <- vector("list", length(breaks))
  for (seam in seq_along(seams)) {
    for (e in edges_of[[seam]]) touching[[e]] <- c(touching[[e]], seam)
  }
  # Whatever has more breaks than its ends must tell its neighbours; a seam of one whole edge with
  # another has nothing to tell until then.
  waiting <- which(lengths(breaks) > 2L)
  many <- lengths(edges_of) > chains$seams$count
  waiting <- union(waiting, unlist(edges_of[many]))
  give <- function(edge, fractions) {
    merged <- merge_breaks(breaks[[edge]], fractions)
    if (length(merged) > length(breaks[[edge]])) {
      breaks[[edge]] <<- merged
      if (!edge %in% waiting) waiting <<- c(waiting, edge)
    }
  }
  while (length(waiting)) {
    e <- waiting[1L]
    waiting <- waiting[-1L]
    if (linked[(e - 1L) %/% 4L + 1L]) give(opposite_edge(e), breaks[[e]])
    for (seam in seams[touching[[e]]]) {
      on_seam <- lapply(seam, function(rows) {
        unlist(lapply(rows, function(k) {
          f <- breaks[[edge[k]]]
          f <- f[f >= low[k] & f <= high[k]]
          start[k] + (f - from[k]) / (to[k] - from[k]) * (end[k] - start[k])
        }))
      })
      union <- Reduce(merge_breaks, on_seam)
      for (k in unlist(seam)) {
        s <- union[union > start[k] - break_tolerance & union < end[k] + break_tolerance]
        give(edge[k], from[k] + (s - start[k]) / (end[k] - start[k]) * (to[k] - from[k]))
      }
    }
  }
  breaks
}

opposite_edge <- function(e) if (e %% 2L == 1L) e + 1L else e - 1L

# Labels 1..n joined by pairs (a, b): the smallest label of each connected group.
joined_labels <- function(n, a, b) {
  label <- seq_len(n)
  repeat {
    la <- label[a]
    lb <- label[b]
    apart <- la != lb
    if (!any(apart)) return(label)
    high <- pmax(la, lb)[apart]
    low <- pmin(la, lb)[apart]
    order <- order(high, -low)
    label[high[order]] <- low[order]
    repeat {
      further <- label[label]
      if (identical(further, label)) break
      label <- further
    }
  }
}

# Pieces of all edges between their breaks, grouped into classes that share one count.
#
# Returns list(edge, from, to, class = of every piece; first, count_of = of every edge, the number of
# pieces before its own and of its own).
edge_pieces <- function(chains, breaks, linked) {
  count_of <- lengths(breaks) - 1L
  first <- cumsum(count_of) - count_of
  edge <- rep.int(seq_along(breaks), count_of)
  all <- as.double(unlist(breaks))
  last <- cumsum(lengths(breaks))
  from <- all[-last]
  to <- all[-(last - count_of)]
  upper <- 4L * (which(linked) - 1L) + 1L
  one_side <- c(upper, upper + 2L)
  along <- along_chains(chains, covered(chains, count_of, function(row) {
    mine <- first[chains$edge[row]] + seq_len(count_of[chains$edge[row]])
    from[mine] > min(chains$from[row], chains$to[row]) - break_tolerance &
      to[mine] < max(chains$from[row], chains$to[row]) + break_tolerance
  }))
  piece <- first[along$edge] + along$k
  joined <- joined_chains(chains$seams)
  list(
    edge = edge, from = from, to = to, first = first, count_of = count_of,
    class = joined_labels(
      length(edge),
      c(sequence(count_of[one_side], first[one_side] + 1L), piece[things_of(along, joined$first)]),
      c(sequence(count_of[one_side], first[one_side + 1L] + 1L),
        piece[things_of(along, joined$other)])
    )
  )
}
