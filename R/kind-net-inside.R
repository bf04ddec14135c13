# Windows in pieces of a net, and separator panels inside it.

# Returns the pieces of a panel, in which each piece with a window is divided into a piece ahead of
# the window, a row with the window, and a piece behind it. `of` is the name of the whole piece.
divided_at_windows <- function(column) {
  rows <- Map(function(piece, name) {
    piece$of <- name
    if (is.null(piece$window)) stats::setNames(list(piece), name) else divided_piece(piece, name)
  }, column, names(column))
  do.call(c, unname(rows))
}

divided_piece <- function(piece, name) {
  window <- piece$window
  meshes <- piece$meshes
  ends <- c(0, window$ahead, window$ahead + window$rows, meshes$deep)
  width <- meshes$front - sum(piece$lost) * ends / meshes$deep
  part <- function(k) {
    own <- piece[setdiff(names(piece), c("window", "cutting"))]
    own$meshes <- list(front = width[k], rear = width[k + 1L], deep = ends[k + 1L] - ends[k])
    own$lost <- piece$lost * own$meshes$deep / meshes$deep
    own
  }
  middle <- part(2L)
  middle$window <- window
  middle$window$left <- window_left(piece)
  stats::setNames(list(part(1L), middle, part(3L)), paste0(name, c("_ahead", "_window", "_behind")))
}

# Returns the panels of a row with a window, from left to right. `own`: fields of the piece as
# given; `lost`: meshes that the row loses along its left and right edge; `window`: as given.
window_pieces <- function(row, own, lost, fields, window) {
  counts <- function(front, rear) list(upper = front, lower = rear, deep = fields$meshes$deep)
  left <- fields$window$left
  right <- fields$meshes$front - left - fields$window$across
  side <- function(front, lost, edges) {
    c(own, list(meshes = counts(front, front - lost),
      lost = stats::setNames(as.list(c(lost, 0)[edges]), c("left", "right")), part = row))
  }
  inside <- window[setdiff(names(window), c("ahead", "rows", "left", "across", "meshes"))]
  meshes <- fields$window$meshes
  list(
    side(left, lost[[1L]], 1:2),
    c(inside, list(meshes = list(upper = meshes$front, lower = meshes$rear, deep = meshes$deep),
      part = "window")),
    side(right, lost[[2L]], 2:1)
  )
}

# Throws an error if a window does not fit into its piece.
check_window <- function(piece, path) {
  window <- piece$window
  meshes <- piece$meshes
  if (isTRUE(piece$pair)) abort_field(path, "given", "omitted in a pair of wings")
  if (length(piece$covers)) abort_field(path, "given", "omitted in a piece with `covers`")
  if (window$ahead + window$rows >= meshes$deep) {
    abort_field(paste0(path, ".rows"), window$rows, sprintf(
      "less than %s, so that the piece has meshes behind the window",
      displayed_count(meshes$deep - window$ahead)
    ))
  }
  left <- window_left(piece)
  width <- meshes$front - sum(piece$lost) * (window$ahead + c(0, window$rows)) / meshes$deep
  room <- min(width - left - window$across)
  if (left <= max(0, piece$lost[["left"]] * window$rows / meshes$deep) || room <= 0) {
    abort_field(paste0(path, ".across"), window$across, sprintf(
      "less than the %s meshes of the piece there, with meshes on both sides",
      displayed_count(min(width))
    ))
  }
  own <- window$mesh_size / if (identical(window$orientation, "square")) 2 else 1
  hole <- c(front = window$across, rear = window$across, deep = window$rows) * piece$mesh_size
  for (edge in names(hole)) {
    check_fit(paste0(path, ".meshes.", edge), window$meshes[[edge]], own, hole[[edge]],
      "the hole in the piece")
  }
}

# Largest ratio of the stretched lengths of a window or separator and of the netting at its edges.
most_inside_slack <- 3

# Throws an error if netting inside a net is much longer or shorter than what it is joined to.
# `count`: its meshes along the edge; `due`: stretched length (m) of the other netting, `other`.
check_fit <- function(path, count, mesh_size, due, other) {
  long <- count * mesh_size
  if (max(long, due) <= most_inside_slack * min(long, due)) return(invisible())
  abort_field(path, count, sprintf(
    "a count for stretched netting within a factor of %s of %s, %s; it is %s long",
    most_inside_slack, other, format_si(due, "length"), format_si(long, "length")
  ))
}

# Returns the meshes of a piece left of its window, at its front; by default it is in the middle.
window_left <- function(piece) {
  width <- piece$meshes$front - sum(piece$lost) * piece$window$ahead / piece$meshes$deep
  first_of(piece$window$left, (width - piece$window$across) / 2)
}

# Returns list(piece, rows, counts) of each separator panel, by name. `columns`, `cells`: of the
# grid.
net_separators <- function(fields, plan, columns, cells) {
  common <- Reduce(intersect, lapply(columns, whole_rows))
  Map(function(separator, given, name) {
    for (end in c("from", "to")) {
      if (!separator[[end]] %in% common) {
        abort_reference(separator[[end]], separator[[end]], common, "row",
          paste("separators", name, end, sep = "."))
      }
    }
    rows <- common[seq(match(separator$from, common), match(separator$to, common))]
    seam <- sum(row_depths(list(columns = columns, cells = cells), "back", rows))
    counts <- separator$meshes
    check_fit(paste("separators", name, "meshes.deep", sep = "."),
      max(counts$deep, abs(counts$upper - counts$lower) / 2), separator$mesh_size, seam,
      "the seam between these rows")
    own <- given[setdiff(names(given), c("from", "to", "seam"))]
    list(piece = c(own, list(part = name)), rows = rows, counts = separator$meshes,
      seam = first_of(separator$seam, "upper"))
  }, fields$separators, plan$separators, names(fields$separators))
}

# Returns the stretched depth (m) of whole rows of a panel.
row_depths <- function(grid, panel, wholes) {
  rows <- grid$columns[[panel]]
  vapply(wholes, function(whole) {
    sum(vapply(cells_of(grid, panel, rows[whole_rows(rows) == whole]), function(cell) {
      cell$mesh_size * cell$counts$deep
    }, 0))
  }, 0)
}

# Returns the edges of separators along a row of the seam between a panel and the next one.
separator_edges <- function(grid, panel, after, row) {
  edges <- Map(function(separator, name) {
    seams <- if (separator$seam == "upper" || length(grid$columns) == 2L) "back" else "belly"
    sides <- c(
      if (panel == seams) c(back = "right", belly = "left")[[seams]],
      if (after == seams) c(back = "left", belly = "right")[[seams]]
    )
    if (!row %in% separator$rows || !length(sides)) return(NULL)
    along <- row_depths(grid, seams, separator$rows)
    ends <- c(0, cumsum(along) / sum(along)) * separator$counts$deep
    k <- match(row, separator$rows)
    edge_range(name, sides[1L], round(ends[k], 9L), round(ends[k + 1L], 9L), separator$counts$deep)
  }, grid$separators, names(grid$separators))
  as.list(unlist(edges, use.names = FALSE))
}
