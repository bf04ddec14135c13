# Places and chains: the texts by which parts of a plan name each other, taken apart.

edge_pattern <- "^(-?)([^.]+)[.](upper|lower|left|right)(?:\\[([0-9.]+):([0-9.]+)\\])?$"

# Takes a place apart.
# Returns list(kind = "point" | "panel" | "rope", name, place), where place is NA for a point, the
# corner (upper_left ...) of a panel, and start, middle, end, max or a share of its length of a
# rope.
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

# Takes one edge of a chain apart.
# Returns list(panel, edge, from, to, reversed); from and to are still meshes (NA: the whole edge).
parse_edge <- function(text) {
  found <- regexpr(edge_pattern, text, perl = TRUE)
  start <- attr(found, "capture.start")
  piece <- substring(text, start, start + attr(found, "capture.length") - 1)
  list(
    panel = piece[2], edge = piece[3], from = as.double(piece[4]), to = as.double(piece[5]),
    reversed = piece[1] == "-"
  )
}

# The text of a place, once it is known to exist. `known` lists the names of points and ropes, and
# the panels.
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

# Places at a share of a rope's length, as texts, that the parts of a gear name.
share_places <- function(si) {
  pick <- function(group, fields) lapply(si[[group]], `[`, fields)
  texts <- unlist(c(
    pick("points", "at"), pick("ropes", c("from", "to", "through")),
    pick("seams", c("gathered_at", "held_between")), pick("pieces", "at"), si$measures
  ), use.names = FALSE)
  grep("^[^.]+\\[[0-9.]+\\]$", unique(as.character(texts)), value = TRUE)
}

find_rope <- function(name, path, known) {
  if (!name %in% known$ropes) abort_reference(name, name, known$ropes, "rope", path)
  name
}

# A chain of edges that exist: list(panel, edge, from, to, reversed), from and to as fractions.
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
  if (edge$from >= edge$to || edge$to > meshes) {
    abort_field(
      path, text,
      sprintf("a range of growing numbers within the %s meshes of that edge", format(meshes))
    )
  }
  edge$from <- edge$from / meshes
  edge$to <- edge$to / meshes
  edge
}

# What a piece is spread along: list(kind = "rope", name) or list(kind = "chain", edges).
find_run <- function(texts, path, known) {
  if (length(texts) == 1 && !grepl("[.]", texts)) {
    return(list(kind = "rope", name = find_rope(texts, path, known)))
  }
  list(kind = "chain", edges = find_chain(texts, path, known))
}

# What places and chains know of a panel: the fields that its edges, their lengths and its division
# go by. Twine, knots and drag are not among them.
panel_shape_fields <- c(
  "mesh_size", "upper", "lower", "deep", "taper_left", "taper_right", "orientation", "straight_bar"
)

panel_shapes <- function(panels) lapply(panels, `[`, panel_shape_fields)

# Stretched length (m) of an edge: the shortest way along its twines. Across i and down j meshes
# that is 2 max(i, j) bars in diamond netting and, i and j counting bars, i + j bars in square;
# hexagonal meshes are shorter across their straight bars.
edge_length <- function(panel, edge) {
  loss <- panel$upper - panel$lower
  across <- switch(edge,
    upper = panel$upper, lower = panel$lower,
    left = loss * panel$taper_left, right = loss * panel$taper_right
  )
  down <- if (edge %in% c("left", "right")) panel$deep else 0
  across <- abs(across)
  if (panel$orientation == "square") {
    panel$mesh_size / 2 * (across + down)
  } else if (startsWith(panel$orientation, "hexagonal")) {
    # Steps along the straight bars and the oblique ones beside them go down and across alike; what
    # is left goes along oblique bars, or across, where turned, along straight ones too.
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
