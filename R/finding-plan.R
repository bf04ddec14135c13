define_finding("number of panels", "plan",
  "The plan of a trawl omits `panels`. The default is 2 for a bottom trawl and 4 for a midwater
  trawl.",
  function(gear, state) {
    if (!first_of(gear$plan$kind, "") %in% trawls_of_panels || !is.null(gear$plan$panels) ||
      !is.null(gear$plan$net)) {
      return(list())
    }
    taken <- plan_node(gear$plan)$properties$panels[["default"]]
    list(finding("panels", taken, template("{n} panels", n = taken),
      template("the field is missing; codend assumes {n} panels for this trawl.", n = taken),
      "Add the number of panels of the net."))
  }
)

define_finding("warp end", "plan",
  "A warp of a rig of several nets ends without a door, clump, weight or further warp.",
  function(gear, state) {
    si <- gear_si(gear)
    if (length(si$nets) < 2L || is.null(si$ground)) return(list())
    warps <- ropes_of_role(si, "warp")
    warps <- warps[!nzchar(net_of_names(warps, si))]
    loaded <- unlist(c(lapply(si$pieces, `[[`, "at"), lapply(si$otter_boards, `[[`, "points")))
    starts <- vapply(si$ropes[warps], `[[`, "", "from")
    lapply(warps, function(name) {
      rope <- si$ropes[[name]]
      if (any(c(rope$from, rope$to) %in% loaded) || rope$to %in% starts) return(NULL)
      finding(paste("rope", name), 0, "0 kg",
        template("its end has no door, clump or weight."),
        "Add a piece or an otter board at this point.", field = "to")
    })
  },
  rank = 1L
)

# Kinds whose field `panels` is the number of panels around a section.
trawls_of_panels <- c("bottom_trawl", "pair_trawl", "midwater_trawl")

# Seams take up a few percent. A larger ratio means gathered netting, as at a bosom, or a wrong
# count. Netting that is hung on a rope has its own hanging ratio.
greatest_seam_ratio <- 1.2

define_finding("seam", "plan",
  "A seam joins edges that differ in stretched length by more than 20 %. This check omits seams
  along ropes.",
  function(gear, state) {
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
      finding(paste("seam", name), ratio, template("ratio {n}", n = figures(ratio)),
        template("it joins an edge of {short} to an edge of {long} (stretched).",
          short = format_si(min(long), "length"), long = format_si(max(long), "length")),
        "Check the mesh counts along both edges.")
    })
  }
)

# Returns the panels and edges of chains of edges as strings.
edge_keys <- function(chains) {
  edges <- unlist(unname(chains), recursive = FALSE)
  vapply(edges, function(edge) paste(edge$panel, edge$edge), "")
}

unless_na <- function(x) if (is.na(x)) NULL else x
