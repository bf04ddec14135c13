# Lines in sections. Headline, footrope and ground gear have sections from the middle outwards; each
# one except the first is on both sides. Side lines and belly lines have them from end to end.

# Returns the edges of a chain as a data frame: reversed, piece, edge, from, to (meshes), of (meshes
# of the whole edge), stretched (length in m).
chain_edges <- function(grid, chain) {
  pattern <- "^(-?)(.*)[.](upper|left|right)(?:\\[(.*):(.*)\\])?$"
  parts <- do.call(rbind, regmatches(chain, regexec(pattern, chain, perl = TRUE)))
  rows <- lapply(seq_along(chain), function(k) {
    cell <- Find(function(cell) parts[k, 3L] %in% names(cell$pieces), grid$cells)
    across <- parts[k, 4L] == "upper"
    of <- if (across) cell$counts$upper else cell$counts$deep
    range <- if (nzchar(parts[k, 5L])) as.double(parts[k, 5:6]) else c(0, of)
    whole <- if (across) cell$mesh_size * of else cell$inner_length
    data.frame(reversed = parts[k, 2L] == "-", piece = parts[k, 3L], edge = parts[k, 4L],
      from = range[1L], to = range[2L], of = of, stretched = whole * diff(range) / of)
  })
  do.call(rbind, rows)
}

# Returns the ropes of a line in sections. The first one has the name of the line; the others have a
# number, and a side if they are on both sides, such as `ground_gear_2_port`. `line`: field of the
# plan, `given`: its value; `edges`: of its chain; `lengths`: of a line along them.
section_ropes <- function(name, line, fields, given, edges, lengths) {
  sections <- fields[[line]]$sections
  order <- section_order(name, line, length(sections))
  hung <- hung_sections(sections[order], edges, lengths, paste0(line, ".sections"))
  ends <- c(0, cumsum(hung$spans)) / sum(hung$spans)
  lapply(stats::setNames(seq_along(order), names(order)), function(at) {
    k <- order[[at]]
    own <- section_line(given, k)
    if (line == "ground_gear") {
      own <- weighed_line(section_line(fields[[line]], k), own, fields$water$density)
    }
    part <- part_of_chain(edges, hung$along, ends[at + 0:1])
    c(list(along = part$along), own,
      list(lengths = hung$lengths[at] * part$share, role = line_role(line)))
  })
}

# Largest difference of the netting that sections take and the netting along them, as a fraction.
most_section_slack <- 0.02

# Returns list(lengths, spans, along): the length (m) of each section of a line, the part of the
# line or of the netting that it takes, and the distribution of this quantity on the edges.
# `sections`: in their order along the line; `path`: their field.
#
# Without hanging ratios, sections divide the line, which has the `lengths` along the edges.
# Otherwise they divide the stretched netting, which is length / hanging ratio for each section.
hung_sections <- function(sections, edges, lengths, path) {
  value <- function(field) {
    vapply(sections, function(section) first_of(section[[field]], NA_real_), 0)
  }
  long <- value("length")
  ratio <- value("hanging_ratio")
  if (all(is.na(ratio))) return(list(lengths = long, spans = long, along = lengths))
  netting <- sum(edges$stretched)
  spans <- long / ratio
  open <- is.na(spans)
  rest <- netting - sum(spans[!open])
  # Sections on both sides are one section of the plan.
  by_ratio <- unique(sections[is.na(long)])
  if (all(is.na(long)) && length(sections) == nrow(edges)) {
    spans <- edges$stretched
  } else if (length(by_ratio) > 1L || (length(by_ratio) && anyNA(ratio))) {
    abort_field(path, NULL, paste(
      "lengths and hanging ratios, one of which may be omitted in one section, or one hanging",
      "ratio for each piece of netting along the line,", nrow(edges), "from end to end"
    ), "leaves the netting of several sections undefined")
  } else if (if (any(open)) rest <= 0 else abs(rest) > most_section_slack * netting) {
    abort_field(path, NULL, paste0(
      "within ", 100 * most_section_slack, " %, or less if a section omits its length or hanging ",
      "ratio, of the netting along the line, ", format_si(netting, "length")
    ), paste("takes", format_si(netting - rest, "length"), "of stretched netting"))
  } else {
    spans[open] <- rest * if (length(by_ratio)) 1 / sum(open) else long[open] / sum(long[open])
    spans <- spans * netting / sum(spans)
  }
  long[is.na(long)] <- (ratio * spans)[is.na(long)]
  list(lengths = long, spans = spans, along = edges$stretched)
}

# Returns the rope fields of a section: its own, otherwise those of the line.
section_line <- function(line, k) {
  section <- line$sections[[k]]
  line[names(section)] <- section
  whole <- c("sections", "length", "lengths", "hanging_ratio", "hanging_ratios", "bosom", "floats",
    "discs", "until")
  line[setdiff(names(line), whole)]
}

# Returns the ropes of a line by name, in order.
rope_names <- function(name, fields, line = name) {
  sections <- fields[[line]]$sections
  if (length(sections)) names(section_order(name, line, length(sections))) else name
}

# Returns the groups of floats or discs on the sections of a line as pieces. `mounted`: their field;
# `group`: function that makes a piece; `net`: result of `trawl_net()`.
section_pieces <- function(line, mounted, group, fields, plan, net) {
  sections <- fields[[line]]$sections
  main <- c(headline = "floats", ground_gear = "discs")
  if (is.null(sections)) return(list())
  do.call(c, lapply(net$lines[[line]], function(rope) {
    # Ropes of sections behind the first have the number of their section.
    k <- sub(paste0("^", line_role(line), "_([0-9]+)_.*$"), "\\1", rope)
    k <- if (k == rope) 1L else as.integer(k)
    name <- if (identical(unname(main[line]), mounted)) {
      paste0(mounted, sub(line, "", rope, fixed = TRUE))
    } else {
      paste(rope, mounted, sep = "_")
    }
    grouped_pieces(group, sections[[k]][[mounted]], plan[[line]]$sections[[k]][[mounted]],
      list(length = sum(net$ropes[[rope]]$lengths)), name,
      sprintf("%s.sections[%d].%s", line, k, mounted), rope)
  }))
}

# Lines whose sections follow from one end to the other, not from the middle outwards.
lines_from_end <- c("side_lines", "belly_lines")

# Returns the section of each rope of a line in `count` sections, by name, in order along its chain.
section_order <- function(name, line, count) {
  behind <- seq_len(count)[-1L]
  if (line %in% lines_from_end) {
    role <- line_role(line)
    numbered <- vapply(behind, function(k) sub(role, paste(role, k, sep = "_"), name), "")
    order <- stats::setNames(seq_len(count), c(name, numbered))
    # Side lines run from the upper to the lower wing end, but their port chains upwards.
    return(if (line == "side_lines" && endsWith(name, "_port")) rev(order) else order)
  }
  # The headline starts on the port side, the footrope on the starboard side.
  sides <- if (name == "headline") trawl_sides else rev(trawl_sides)
  on <- function(side) stats::setNames(behind, sprintf("%s_%d_%s", name, behind, side))
  c(rev(on(sides[1L])), stats::setNames(1L, name), on(sides[2L]))
}

# TRUE if a section of a line has a hanging ratio.
hung_by_sections <- function(given) "hanging_ratio" %in% unlist(lapply(given$sections, names))

# Returns the length (m) of a line, or NULL if it has a hanging ratio.
line_length <- function(given, line) {
  if (is.null(given$sections)) return(given$length)
  if (hung_by_sections(given)) return(NULL)
  sections <- given$sections[section_order(line, line, length(given$sections))]
  sum(vapply(sections, `[[`, 0, "length"))
}

# Returns list(along, share): the part of a chain between two fractions of the length of its line,
# and the fractions of this part on each edge.
part_of_chain <- function(edges, lengths, extent) {
  ends <- c(0, cumsum(lengths) / sum(lengths))
  low <- pmax(extent[1L], ends[-length(ends)])
  high <- pmin(extent[2L], ends[-1L])
  use <- which(high - low > 1e-9)
  along <- vapply(use, function(k) {
    edge <- edges[k, ]
    inside <- (c(low[k], high[k]) - ends[k]) / (ends[k + 1L] - ends[k])
    if (edge$reversed) inside <- 1 - rev(inside)
    span <- round(edge$from + inside * (edge$to - edge$from), 9L)
    paste0(if (edge$reversed) "-",
      edge_range(edge$piece, edge$edge, span[1L], span[2L], edge$of))
  }, "")
  list(along = along, share = (high - low)[use] / sum((high - low)[use]))
}
