# Returns data.frame(panel, edge, from, to, other, other_edge, other_from, other_to): one row per
# joined stretch of an edge, listed once from each of its two panels. `from`, `to`: fractions of the
# edge; a reversed edge has from > to.
seam_joints <- function(si) {
  joints <- list(data.frame(panel = character(), edge = character(), from = numeric(),
    to = numeric(), other = character(), other_edge = character(), other_from = numeric(),
    other_to = numeric()))
  for (seam in si$seams) {
    if (!is.null(seam$gathered_at) || length(seam$edges) < 2L) next
    first <- chain_spans(seam$edges[[1]], si$panels)
    for (chain in seam$edges[-1L]) {
      joints <- c(joints, list(span_pairs(first, chain_spans(chain, si$panels))))
    }
  }
  joints <- do.call(rbind, joints)
  turned <- joints[c(5:8, 1:4)]
  names(turned) <- names(joints)
  rbind(joints, turned)
}

# Returns the edges of a chain with their start and end as fractions of the chain length.
chain_spans <- function(chain, panels) {
  long <- vapply(chain, function(edge) {
    (edge$to - edge$from) * edge_length(panels[[edge$panel]], edge$edge)
  }, 0)
  if (sum(long) == 0) long[] <- 1
  end <- cumsum(long) / sum(long)
  pick <- function(field, type) vapply(chain, `[[`, type, field)
  reversed <- pick("reversed", NA)
  data.frame(
    panel = pick("panel", ""), edge = pick("edge", ""), start = c(0, end[-length(end)]), end = end,
    from = ifelse(reversed, pick("to", 0), pick("from", 0)),
    to = ifelse(reversed, pick("from", 0), pick("to", 0))
  )
}

span_pairs <- function(a, b) {
  pairs <- expand.grid(a = seq_len(nrow(a)), b = seq_len(nrow(b)))
  low <- pmax(a$start[pairs$a], b$start[pairs$b])
  high <- pmin(a$end[pairs$a], b$end[pairs$b])
  met <- high - low > 1e-6
  pairs <- pairs[met, ]
  at <- function(spans, k, s) {
    spans <- spans[k, ]
    spans$from + (s - spans$start) / (spans$end - spans$start) * (spans$to - spans$from)
  }
  data.frame(
    panel = a$panel[pairs$a], edge = a$edge[pairs$a],
    from = at(a, pairs$a, low[met]), to = at(a, pairs$a, high[met]),
    other = b$panel[pairs$b], other_edge = b$edge[pairs$b],
    other_from = at(b, pairs$b, low[met]), other_to = at(b, pairs$b, high[met])
  )
}
