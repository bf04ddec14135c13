# Edges of panels as the lattice divides them: breaks that seams carry from panel to panel, the
# pieces between breaks, and how many elements each piece gets.
#
# Edge ids: 4 (p - 1) + 1 upper, 2 lower, 3 left, 4 right, for panel p.

edge_number <- function(panels, panel, edge) {
  4L * (match(panel, names(panels)) - 1L) + match(edge, c("upper", "lower", "left", "right"))
}

break_tolerance <- 1e-7

# Known breaks, in order, with those of the new ones that are not known yet.
merge_breaks <- function(known, new) {
  if (length(new) == length(known) && all(abs(new - known) <= break_tolerance)) return(known)
  for (f in new) {
    if (min(abs(f - known)) > break_tolerance) known <- append(known, f, sum(known < f))
  }
  known
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
  for (k in seq_along(chains$marks$edge)) {
    e <- chains$marks$edge[k]
    breaks[[e]] <- merge_breaks(breaks[[e]], chains$marks$fraction[k])
  }
  rows_of <- function(chain) chains$first[chain] + seq_len(chains$rows[chain]) - 1L
  # Chains of seams come first in the table.
  seam_of <- rep.int(seq_along(chains$seams$count), chains$seams$count)
  seam_of <- rep.int(seam_of, chains$rows[seq_along(seam_of)])
  joined_edge <- edge[seq_along(seam_of)]
  # Whatever has more breaks than its ends must tell its neighbours; a seam of one whole edge with
  # another has nothing to tell until then.
  waiting <- which(lengths(breaks) > 2L)
  many <- tabulate(seam_of, length(chains$seams$count)) > chains$seams$count
  waiting <- union(waiting, joined_edge[many[seam_of]])
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
    for (seam in unique(seam_of[joined_edge == e])) {
      joined <- chains$seams$first[seam] + seq_len(chains$seams$count[seam]) - 1L
      on_seam <- NULL
      for (chain in joined) {
        on_chain <- unlist(lapply(rows_of(chain), function(k) {
          f <- breaks[[edge[k]]]
          f <- f[f >= low[k] & f <= high[k]]
          start[k] + (f - from[k]) / (to[k] - from[k]) * (end[k] - start[k])
        }))
        on_seam <- if (is.null(on_seam)) on_chain else merge_breaks(on_seam, on_chain)
      }
      for (k in unlist(lapply(joined, rows_of))) {
        s <- on_seam[on_seam > start[k] - break_tolerance & on_seam < end[k] + break_tolerance]
        give(edge[k], from[k] + (s - start[k]) / (end[k] - start[k]) * (to[k] - from[k]))
      }
    }
  }
  breaks
}

opposite_edge <- function(e) if (e %% 2L == 1L) e + 1L else e - 1L

# Pieces of all edges between their breaks, grouped into classes that share one count.
#
# Returns list(edge, from, to, class = of every piece; first, count_of = of every edge, the number
# of pieces before its own and of its own).
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
