# Headline, footrope and ground gear in sections, from the middle outwards. Each section except the
# first is on both sides.

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

# Returns the ropes of a line in sections. The middle one has the name of the line; the others have
# a number and a side, such as `ground_gear_2_port`. `edges`: of its chain; `hung`: the hung line
# along this chain.
section_ropes <- function(name, fields, plan, edges, hung) {
  sections <- fields[[name]]$sections
  lengths <- first_of(hung$lengths, edges$stretched * first_of(unlist(hung$hanging_ratios), 1))
  lapply(section_places(name, sections), function(place) {
    k <- place$section
    own <- section_line(plan[[name]], k)
    if (name == "ground_gear") {
      own <- weighed_line(section_line(fields[[name]], k), own, fields$water$density)
    }
    part <- part_of_chain(edges, lengths, place$extent)
    c(list(along = part$along), own,
      list(lengths = sections[[k]]$length * part$share, role = name))
  })
}

# Returns the rope fields of a section: its own, otherwise those of the line.
section_line <- function(line, k) {
  section <- line$sections[[k]]
  line[names(section)] <- section
  whole <- c("sections", "length", "lengths", "hanging_ratios", "bosom", "floats", "discs")
  line[setdiff(names(line), whole)]
}

# Returns the ropes of a line by name, in order.
rope_names <- function(name, fields) {
  sections <- fields[[name]]$sections
  if (length(sections)) names(section_places(name, sections)) else name
}

# Returns the groups of floats or discs on the sections of a line as pieces. `mounted`: their field;
# `group`: function that makes a piece.
section_pieces <- function(name, mounted, group, fields, plan) {
  sections <- fields[[name]]$sections
  if (is.null(sections)) return(list())
  places <- section_places(name, sections)
  do.call(c, lapply(names(places), function(rope) {
    k <- places[[rope]]$section
    grouped_pieces(group, sections[[k]][[mounted]], plan[[name]]$sections[[k]][[mounted]],
      sections[[k]], paste0(mounted, sub(name, "", rope, fixed = TRUE)),
      sprintf("%s.sections[%d].%s", name, k, mounted), rope)
  }))
}

# Returns list(section, extent) for each rope of a line in sections, by name, in order along the
# line. `extent`: start and end as fractions of the line.
section_places <- function(name, sections) {
  long <- vapply(sections, `[[`, 0, "length")
  ends <- (cumsum(long) - long[1L] / 2) / line_length(list(sections = sections))
  # The headline starts on the port side, the footrope on the starboard side.
  sides <- if (name == "headline") trawl_sides else rev(trawl_sides)
  places <- stats::setNames(list(list(section = 1L, extent = 0.5 + c(-1, 1) * ends[1L])), name)
  for (k in seq_along(long)[-1L]) {
    extent <- 0.5 + ends[c(k - 1L, k)]
    outer <- list(list(section = k, extent = 1 - rev(extent)), list(section = k, extent = extent))
    names(outer) <- paste(name, k, sides, sep = "_")
    places <- c(outer[1L], places, outer[2L])
  }
  places
}

# Returns the length (m) of a line, or NULL if it has none.
line_length <- function(line) {
  if (is.null(line$sections)) return(line$length)
  long <- vapply(line$sections, `[[`, 0, "length")
  2 * sum(long) - long[1L]
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
