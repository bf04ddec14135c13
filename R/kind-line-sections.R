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
# plan, `given`: its value; `edges`: of its chain; `hung`: the hung line along this chain.
section_ropes <- function(name, line, fields, given, edges, hung) {
  sections <- fields[[line]]$sections
  lengths <- first_of(hung$lengths, edges$stretched * first_of(unlist(hung$hanging_ratios), 1))
  lapply(section_places(name, line, sections), function(place) {
    k <- place$section
    own <- section_line(given, k)
    if (line == "ground_gear") {
      own <- weighed_line(section_line(fields[[line]], k), own, fields$water$density)
    }
    part <- part_of_chain(edges, lengths, place$extent)
    c(list(along = part$along), own,
      list(lengths = sections[[k]]$length * part$share, role = line_role(line)))
  })
}

# Returns the rope fields of a section: its own, otherwise those of the line.
section_line <- function(line, k) {
  section <- line$sections[[k]]
  line[names(section)] <- section
  whole <- c("sections", "length", "lengths", "hanging_ratios", "bosom", "floats", "discs", "until")
  line[setdiff(names(line), whole)]
}

# Returns the ropes of a line by name, in order.
rope_names <- function(name, fields, line = name) {
  sections <- fields[[line]]$sections
  if (length(sections)) names(section_places(name, line, sections)) else name
}

# Returns the groups of floats or discs on the sections of a line as pieces. `mounted`: their field;
# `group`: function that makes a piece; `lines`: names of the ropes of each line, by field.
section_pieces <- function(line, mounted, group, fields, plan, lines) {
  sections <- fields[[line]]$sections
  main <- c(headline = "floats", ground_gear = "discs")
  if (is.null(sections)) return(list())
  do.call(c, lapply(lines[[line]], function(rope) {
    # Ropes of sections behind the first have the number of their section.
    k <- sub(paste0("^", line_role(line), "_([0-9]+)_.*$"), "\\1", rope)
    k <- if (k == rope) 1L else as.integer(k)
    name <- if (identical(unname(main[line]), mounted)) {
      paste0(mounted, sub(line, "", rope, fixed = TRUE))
    } else {
      paste(rope, mounted, sep = "_")
    }
    grouped_pieces(group, sections[[k]][[mounted]], plan[[line]]$sections[[k]][[mounted]],
      sections[[k]], name, sprintf("%s.sections[%d].%s", line, k, mounted), rope)
  }))
}

# Lines whose sections follow from one end to the other, not from the middle outwards.
lines_from_end <- c("side_lines", "belly_lines")

# Returns list(section, extent) for each rope of a line in sections, by name, in order along its
# chain. `extent`: start and end as fractions of the line.
section_places <- function(name, line, sections) {
  long <- vapply(sections, `[[`, 0, "length")
  if (line %in% lines_from_end) {
    ends <- c(0, cumsum(long)) / sum(long)
    role <- line_role(line)
    names <- c(name, vapply(seq_along(long)[-1L], function(k) {
      sub(role, paste(role, k, sep = "_"), name, fixed = TRUE)
    }, ""))
    places <- lapply(seq_along(long), function(k) list(section = k, extent = ends[c(k, k + 1L)]))
    names(places) <- names
    # Side lines run from the upper to the lower wing end, but their port chains upwards.
    if (line == "belly_lines" || !endsWith(name, "_port")) return(places)
    return(rev(lapply(places, function(place) {
      list(section = place$section, extent = 1 - rev(place$extent))
    })))
  }
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
line_length <- function(given, line = "") {
  if (is.null(given$sections)) return(given$length)
  long <- vapply(given$sections, `[[`, 0, "length")
  if (line %in% lines_from_end) sum(long) else 2 * sum(long) - long[1L]
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
