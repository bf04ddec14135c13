define_finding("number of panels", function(gear, state) {
  if (!first_of(gear$plan$kind, "") %in% trawls_of_panels || !is.null(gear$plan$panels) ||
    !is.null(gear$plan$net)) {
    return(list())
  }
  taken <- plan_node(gear$plan)$properties$panels[["default"]]
  list(finding("number of panels", "panels", taken, template("{n} panels", n = taken), n = taken))
})

define_finding("warp end", function(gear, state) {
  si <- gear_si(gear)
  if (length(si$nets) < 2L || is.null(si$ground)) return(list())
  warps <- ropes_of_role(si, "warp")
  warps <- warps[!nzchar(net_of_names(warps, si))]
  loaded <- unlist(c(lapply(si$pieces, `[[`, "at"), lapply(si$otter_boards, `[[`, "points")))
  starts <- vapply(si$ropes[warps], `[[`, "", "from")
  lapply(warps, function(name) {
    rope <- si$ropes[[name]]
    if (any(c(rope$from, rope$to) %in% loaded) || rope$to %in% starts) return(NULL)
    finding("warp end", paste("rope", name), 0, "0 kg")
  })
})

# Kinds whose field `panels` is the number of panels around a section.
trawls_of_panels <- c("bottom_trawl", "pair_trawl", "midwater_trawl")

# Seams take up a few percent. A larger ratio means gathered netting, as at a bosom, or a wrong
# count. Netting that is hung on a rope has its own hanging ratio.
greatest_seam_ratio <- 1.2

define_finding("seam", function(gear, state) {
  si <- gear_si(gear)
  hung <- edge_keys(lapply(si$ropes, `[[`, "along"))
  lapply(names(si$seams), function(name) {
    seam <- si$seams[[name]]
    if (!is.null(seam$gathered_at) || length(seam$edges) < 2L ||
      any(edge_keys(seam$edges) %in% hung)) {
      return(NULL)
    }
    long <- vapply(seam$edges, chain_length, 0, panels = si$panels)
    if (min(long) <= 0 || max(long) <= greatest_seam_ratio * min(long)) return(NULL)
    ratio <- max(long) / min(long)
    finding("seam", paste("seam", name), ratio, template("ratio {n}", n = figures(ratio)),
      short = format_si(min(long), "length"), long = format_si(max(long), "length"))
  })
})

# Returns the panels and edges of chains of edges as strings.
edge_keys <- function(chains) {
  edges <- unlist(unname(chains), recursive = FALSE)
  vapply(edges, function(edge) paste(edge$panel, edge$edge), "")
}
