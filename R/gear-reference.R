# Parses positions and chains: the strings by which parts of a plan refer to each other.

edge_pattern <- "^(-?)([^.]+)[.](upper|lower|left|right)(?:\\[([0-9.]+):([0-9.]+)\\])?$"

# Returns list(kind = "point" | "panel" | "rope", name, place). `place` is NA for a point and a
# corner (upper_left ...) for a panel. For a rope it is start, middle, end, max or a fraction of its
# length.
parse_place <- function(text) {
  open <- regexpr("[", text, fixed = TRUE)
  if (open != -1) {
    return(list(
      kind = "rope", name = substring(text, 1, open - 1),
      place = as.double(substring(text, open + 1, nchar(text) - 1))
    ))
  }
  dot <- regexpr(".", text, fixed = TRUE)
  if (dot == -1) return(list(kind = "point", name = text, place = NA_character_))
  place <- substring(text, dot + 1)
  kind <- if (place %in% c("start", "middle", "end", "max")) "rope" else "panel"
  list(kind = kind, name = substring(text, 1, dot - 1), place = place)
}

# Returns list(panel, edge, from, to, reversed) for one edge of a chain; `from`, `to` in meshes, or
# NA.
parse_edge <- function(text) {
  found <- regexpr(edge_pattern, text, perl = TRUE)
  start <- attr(found, "capture.start")
  piece <- substring(text, start, start + attr(found, "capture.length") - 1)
  list(
    panel = piece[2], edge = piece[3], from = as.double(piece[4]), to = as.double(piece[5]),
    reversed = piece[1] == "-"
  )
}

# Returns the string of a position if it exists. `known`: names of points and ropes; panels.
find_place <- function(text, path, known) {
  place <- parse_place(text)
  names <- switch(place$kind,
    point = known$points, rope = known$ropes, panel = names(known$panels)
  )
  if (!place$name %in% names) {
    abort_reference(text, place$name, names, place$kind, path)
  }
  text
}

# Returns the strings of all positions at a fraction of a rope's length that the gear refers to.
share_places <- function(si) {
  pick <- function(group, fields) lapply(si[[group]], `[`, fields)
  texts <- unlist(c(
    pick("points", "at"), pick("ropes", c("from", "to", "through")),
    pick("seams", c("gathered_at", "held_between")), pick("pieces", "at"), si$measures,
    pick("nets", "wing_ends")
  ), use.names = FALSE)
  grep("^[^.]+\\[[0-9.]+\\]$", unique(as.character(texts)), value = TRUE)
}

find_rope <- function(name, path, known) {
  if (!name %in% known$ropes) abort_reference(name, name, known$ropes, "rope", path)
  name
}

# Returns list(panel, edge, from, to, reversed) for each edge; `from` and `to` are fractions.
find_chain <- function(texts, path, known) {
  lapply(texts, find_edge, path = path, known = known)
}

find_edge <- function(text, path, known) {
  edge <- parse_edge(text)
  panel <- known$panels[[edge$panel]]
  if (is.null(panel)) {
    abort_reference(text, edge$panel, names(known$panels), "panel", path)
  }
  if (is.na(edge$from)) {
    edge$from <- 0
    edge$to <- 1
    return(edge)
  }
  meshes <- switch(edge$edge, upper = panel$upper, lower = panel$lower, panel$deep)
  if (edge$from >= edge$to || edge$to > meshes * (1 + 1e-12)) {
    abort_field(
      path, text,
      sprintf("a range of increasing numbers within the %s meshes of the edge", format(meshes))
    )
  }
  edge$from <- edge$from / meshes
  edge$to <- min(1, edge$to / meshes)
  edge
}

# Returns the line of a piece: list(kind = "rope", name) or list(kind = "chain", edges).
find_run <- function(texts, path, known) {
  if (length(texts) == 1 && !grepl("[.]", texts)) {
    return(list(kind = "rope", name = find_rope(texts, path, known)))
  }
  list(kind = "chain", edges = find_chain(texts, path, known))
}

# Fields of a panel that determine its edges, their lengths and its mesh.
panel_shape_fields <- c(
  "mesh_size", "upper", "lower", "deep", "lost_left", "lost_right", "orientation", "straight_bar"
)

panel_shapes <- function(panels) lapply(panels, `[`, panel_shape_fields)

# Returns the stretched length (m) of an edge: the shortest path along its twines. For i meshes
# across and j down it is 2 max(i, j) bars in diamond netting. In square netting, with i and j in
# bars, it is i + j bars. Hexagonal meshes are shorter across their straight bars.
edge_length <- function(panel, edge) {
  across <- switch(edge,
    upper = panel$upper, lower = panel$lower, left = panel$lost_left, right = panel$lost_right
  )
  down <- if (edge %in% c("left", "right")) panel$deep else 0
  across <- abs(across)
  if (panel$orientation == "square") {
    panel$mesh_size / 2 * (across + down)
  } else if (startsWith(panel$orientation, "hexagonal")) {
    # Steps along straight bars and the adjacent oblique bars go equally far down and across. The
    # rest of the path follows oblique bars, or across, in turned netting, straight bars too.
    short <- panel$mesh_size - 2 * panel$straight_bar
    turned <- panel$orientation == "hexagonal_turned"
    long_way <- if (turned) across else down
    panel$mesh_size * long_way + short * max(0, (if (turned) down else across) - long_way)
  } else {
    panel$mesh_size * max(across, down)
  }
}

chain_length <- function(chain, panels) {
  sum(vapply(chain, function(edge) {
    (edge$to - edge$from) * edge_length(panels[[edge$panel]], edge$edge)
  }, 0))
}
