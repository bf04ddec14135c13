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

# A parsed chain as a table: edge id, from and to (fractions of the edge, from > to where reversed),
# and start and end (fractions of the chain's stretched length).
chain_table <- function(chain, panels, lengths) {
  edge <- vapply(chain, function(e) edge_number(panels, e$panel, e$edge), 0L)
  from <- vapply(chain, function(e) if (e$reversed) e$to else e$from, 0)
  to <- vapply(chain, function(e) if (e$reversed) e$from else e$to, 0)
  long <- abs(to - from) * lengths[edge]
  if (sum(long) == 0) long[] <- 1
  end <- cumsum(long) / sum(long)
  list(edge = edge, from = from, to = to, start = c(0, end[-length(end)]), end = end,
       length = sum(long))
}

break_tolerance <- 1e-7

merge_breaks <- function(known, new) {
  before <- length(known)
  for (f in new) if (min(abs(f - known)) > break_tolerance) known <- c(known, f)
  if (length(known) > before) sort.int(known) else known
}

# Fractions of the chain at which its edges break.
chain_breaks <- function(chain, breaks) {
  unlist(lapply(seq_along(chain$edge), function(k) {
    f <- breaks[[chain$edge[k]]]
    lo <- min(chain$from[k], chain$to[k]) - break_tolerance
    hi <- max(chain$from[k], chain$to[k]) + break_tolerance
    f <- f[f >= lo & f <= hi]
    chain$start[k] + (f - chain$from[k]) / (chain$to[k] - chain$from[k]) *
      (chain$end[k] - chain$start[k])
  }))
}

# Breaks (fractions) of every edge, carried through seams and across panels until nothing changes.
# laced: chains that break edges where they begin and end, but join nothing.
# linked: TRUE for panels whose opposite edges must be divided alike.
edge_breaks <- function(panels, seams, laced, linked) {
  breaks <- rep(list(c(0, 1)), 4L * length(panels))
  for (chain in c(unlist(seams, recursive = FALSE), laced)) {
    for (k in seq_along(chain$edge)) {
      e <- chain$edge[k]
      breaks[[e]] <- merge_breaks(breaks[[e]], c(chain$from[k], chain$to[k]))
    }
  }
  edges_of <- lapply(seams, function(seam) unlist(lapply(seam, `[[`, "edge")))
  touching <- split(rep(seq_along(seams), lengths(edges_of)), unlist(edges_of))
  # Whatever has more breaks than its ends must tell its neighbours; a seam of one whole edge with
  # another has nothing to tell until then.
  waiting <- which(lengths(breaks) > 2L)
  many <- vapply(seams, function(seam) any(lengths(lapply(seam, `[[`, "edge")) > 1L), NA)
  waiting <- union(waiting, unlist(edges_of[many]))
  while (length(waiting)) {
    e <- waiting[1L]
    waiting <- waiting[-1L]
    give <- function(edge, fractions) {
      merged <- merge_breaks(breaks[[edge]], fractions)
      if (length(merged) > length(breaks[[edge]])) {
        breaks[[edge]] <<- merged
        waiting <<- union(waiting, edge)
      }
    }
    if (linked[(e - 1L) %/% 4L + 1L]) give(opposite_edge(e), breaks[[e]])
    for (seam in seams[touching[[as.character(e)]]]) {
      union <- Reduce(merge_breaks, lapply(seam, chain_breaks, breaks = breaks))
      for (chain in seam) {
        for (k in seq_along(chain$edge)) {
          s <- union[union > chain$start[k] - break_tolerance &
                       union < chain$end[k] + break_tolerance]
          give(chain$edge[k], chain$from[k] + (s - chain$start[k]) /
            (chain$end[k] - chain$start[k]) * (chain$to[k] - chain$from[k]))
        }
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
edge_pieces <- function(panels, seams, breaks, linked) {
  pieces_of <- lengths(breaks) - 1L
  first <- cumsum(c(0L, pieces_of[-length(pieces_of)]))
  edge <- rep(seq_along(breaks), pieces_of)
  from <- unlist(lapply(breaks, function(f) f[-length(f)]))
  to <- unlist(lapply(breaks, function(f) f[-1L]))
  a <- b <- integer()
  for (p in which(linked)) {
    e <- 4L * (p - 1L)
    a <- c(a, first[e + 1L] + seq_len(pieces_of[e + 1L]), first[e + 3L] + seq_len(pieces_of[e + 3L]))
    b <- c(b, first[e + 2L] + seq_len(pieces_of[e + 2L]), first[e + 4L] + seq_len(pieces_of[e + 4L]))
  }
  in_chain <- function(chain) {
    unlist(lapply(seq_along(chain$edge), function(k) {
      e <- chain$edge[k]
      inside <- which(edge == e &
                        from > min(chain$from[k], chain$to[k]) - break_tolerance &
                        to < max(chain$from[k], chain$to[k]) + break_tolerance)
      if (chain$from[k] > chain$to[k]) rev(inside) else inside
    }))
  }
  for (seam in seams) {
    first_chain <- in_chain(seam[[1]])
    for (chain in seam[-1]) {
      a <- c(a, first_chain)
      b <- c(b, in_chain(chain))
    }
  }
  list(edge = edge, from = from, to = to, first = first, count_of = pieces_of,
       class = joined_labels(length(edge), a, b))
}
