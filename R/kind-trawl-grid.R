# The netting of a trawl as a grid of pieces.
#
# Panels are in clockwise order as seen from the vessel's deck looking aft: back, starboard sides
# from top to bottom, belly, port sides from bottom to top. Seen from outside with its front edge
# up, each panel's left edge is joined to the previous panel.
#
# A grid is list(columns, cells, gathered, separators):
# `columns`: for each panel, the names of its rows from front to rear. Neighbouring panels are
# joined from end to end of each row that both have, and along the rows in between. Side panels may
# end ahead of the last row; then the panels on both sides of them are neighbours behind this row.
# Rows of a piece that a window divides have the name of the whole piece as names of the vector.
# `cells`: the cell of each panel and row, named "panel_row".
# `gathered`: TRUE if each wing tip is gathered at a point, FALSE if a line is laced along the tips.
# `separators`: netting between the seams of both sides, by name (R/kind-net-inside.R).

nothing <- stats::setNames(list(), character())

# Returns the whole row to which each row of a panel belongs.
whole_rows <- function(rows) first_of(names(rows), rows)

# Returns the last row of a panel that belongs to a whole row, or NULL.
rear_row <- function(rows, whole) {
  found <- rows[whole_rows(rows) == whole]
  if (length(found)) found[[length(found)]]
}

# Panels around the net, by their number.
panels_by_number <- list(
  `2` = c("back", "belly"),
  `4` = c("back", "side_starboard", "belly", "side_port"),
  `6` = c(
    "back", "upper_side_starboard", "lower_side_starboard", "belly", "lower_side_port",
    "upper_side_port"
  )
)

panels_around <- function(fields) panels_by_number[[as.character(first_of(fields$panels, 2))]]

# Returns a cell of one piece, of pieces side by side, or of a pair of wings.
#
# `pieces`: panels of the assembly from left to right, by name; `counts`: meshes `upper`, `lower`
# and `deep` of a piece; `mesh_size` in m; `free`: meshes of the left and the right edge without a
# seam, from the front; `covers`: netting over the piece, by name; `gain`: meshes that a wing gains
# along its inner edge; `joined`: meshes behind to which a wing is joined.
#
# `across`: for a row with a window, list(upper, lower) with the meshes across each piece.
new_cell <- function(pieces, counts, mesh_size, free = c(left = 0, right = 0), covers = list(),
                     gain = counts$lower - counts$upper, joined = counts$lower, across = NULL) {
  list(name = if (length(pieces) == 3L) names(pieces)[2L] else names(pieces), pieces = pieces,
    counts = counts, mesh_size = mesh_size, free = free, covers = covers,
    inner_length = mesh_size * max(counts$deep, abs(gain)), joined = joined, across = across)
}

# Returns a cell of two wings, `name`_left and `name`_right, with straight outer edges. `given`:
# their fields except their counts; `flying`: meshes of the outer edges without a seam.
wing_cell <- function(name, given, counts, mesh_size, flying = 0) {
  pieces <- lapply(c(left = "right", right = "left"), function(inner) {
    c(given, list(meshes = counts, tapered = inner, part = "wings"))
  })
  names(pieces) <- paste(name, names(pieces), sep = "_")
  new_cell(pieces, counts, mesh_size, c(left = flying, right = flying))
}

is_pair <- function(cell) length(cell$pieces) == 2L

# Returns the rows at which side panels end, from front to rear, each with the names of the panels
# that end there.
ended_panels <- function(columns) {
  wholes <- lapply(columns, function(rows) unique(whole_rows(rows)))
  last <- vapply(wholes, function(rows) rows[length(rows)], "")
  last <- last[!names(last) %in% c("back", "belly")]
  back <- wholes$back
  last <- last[last %in% back[-length(back)] & last %in% wholes$belly]
  ended <- split(names(last), factor(last, back))
  ended[lengths(ended) > 0L]
}

# Returns the pairs of neighbouring panels: list(panel, after, columns) each. `columns`: the rows of
# both panels along which they are neighbours.
neighbours <- function(columns) {
  active <- names(columns)
  ended <- ended_panels(columns)
  pairs <- list()
  from <- stats::setNames(rep(0L, length(active)), active)
  for (k in seq_len(length(ended) + 1L)) {
    row <- names(ended)[k]
    to <- if (is.na(row)) lengths(columns) else {
      vapply(columns, function(rows) length(rows) + 1L - match(row, rev(whole_rows(rows))), 0L)
    }
    stretch <- lapply(stats::setNames(nm = active), function(panel) {
      columns[[panel]][seq_len(to[[panel]] - from[[panel]]) + from[[panel]]]
    })
    after <- c(active[-1L], active[1L])
    for (i in seq_along(active)) {
      name <- paste(active[i], after[i], sep = "_")
      own <- stretch[c(active[i], after[i])]
      if (!is.null(pairs[[name]])) own <- Map(c, pairs[[name]]$columns, own)
      pairs[[name]] <- list(panel = active[i], after = after[i], columns = own)
    }
    from <- to
    if (!is.na(row)) active <- setdiff(active, ended[[k]])
  }
  pairs
}

cells_of <- function(grid, panel, rows) grid$cells[sprintf("%s_%s", panel, rows)]

column_cells <- function(grid, panel) cells_of(grid, panel, grid$columns[[panel]])

# Returns an edge of a piece between two meshes of its `whole` meshes; NULL without meshes.
edge_range <- function(piece, edge, from, to, whole) {
  if (to - from <= 0) return(NULL)
  name <- paste0(piece, ".", edge)
  if (from == 0 && to == whole) return(name)
  count <- function(x) format(x, digits = 15)
  paste0(name, "[", count(from), ":", count(to), "]")
}

# Returns the parts of a cell's outer edge on one side: list(free, joined).
cell_edge <- function(cell, side) {
  piece <- names(cell$pieces)[if (side == "left") 1L else length(cell$pieces)]
  deep <- cell$counts$deep
  free <- cell$free[[side]]
  list(
    free = edge_range(piece, side, 0, free, deep),
    joined = edge_range(piece, side, free, deep, deep)
  )
}

# Returns the free or joined outer edges of cells on one side, from front to rear.
outer_edges <- function(cells, side, part) {
  unlist(lapply(unname(cells), function(cell) cell_edge(cell, side)[[part]]))
}

backwards <- function(edges) if (length(edges)) paste0("-", rev(edges))

# Returns the front of a panel from its left to its right end: list(left, inner, right, wings).
# `left`, `right`: chains of wing tips and free outer edges; `inner`: chain of the inner edges of
# wings and of the front between them; `wings`: cells of wings.
panel_front <- function(grid, panel) {
  cells <- unname(column_cells(grid, panel))
  wings <- cells[seq_len(match(FALSE, vapply(cells, is_pair, NA)) - 1L)]
  behind <- cells[[length(wings) + 1L]]
  front <- behind$counts$upper
  base <- if (length(wings)) wings[[length(wings)]]$joined else 0
  piece <- function(k) vapply(wings, function(wing) names(wing$pieces)[k], "")
  tip <- function(k) {
    if (!length(wings) || grid$gathered) return(NULL)
    across <- cells[[1L]]$counts$upper
    edge_range(piece(k)[1L], "upper", 0, across, across)
  }
  list(
    left = c(backwards(outer_edges(cells, "left", "free")), tip(1L)),
    inner = c(
      if (length(wings)) paste0(piece(1L), ".right"),
      edge_range(names(behind$pieces), "upper", base, front - base, front),
      if (length(wings)) backwards(paste0(piece(2L), ".left"))
    ),
    right = c(tip(2L), outer_edges(cells, "right", "free")),
    wings = wings
  )
}

# Returns the lines around the mouth as chains of edges, by name. Lines without edges are omitted.
mouth_chains <- function(grid) {
  around <- names(grid$columns)
  fronts <- lapply(stats::setNames(nm = around), panel_front, grid = grid)
  belly <- match("belly", around)
  side <- function(k) {
    unlist(lapply(fronts[k], `[`, c("left", "inner", "right")), use.names = FALSE)
  }
  Filter(length, list(
    headline = fronts$back$inner,
    side_line_starboard = c(fronts$back$right, side(seq_len(belly)[-c(1L, belly)]),
      fronts$belly$left),
    footrope = fronts$belly$inner,
    side_line_port = c(fronts$belly$right, side(seq_along(around)[-seq_len(belly)]),
      fronts$back$left)
  ))
}

# Returns the wing ends as points at the ends of headline and footrope, clockwise. The order sets
# the numbers of nodes: slack netting converges faster with this order.
wing_end_points <- function(grid) {
  end <- function(panel, side) {
    cell <- column_cells(grid, panel)[[1L]]
    piece <- names(cell$pieces)[if (side == "left") 1L else length(cell$pieces)]
    # The headline starts at the inner corner of a wing tip.
    corner <- if (is_pair(cell)) setdiff(c("left", "right"), side) else side
    list(at = paste0(piece, ".upper_", corner))
  }
  list(
    upper_port = end("back", "left"), upper_starboard = end("back", "right"),
    lower_starboard = end("belly", "left"), lower_port = end("belly", "right")
  )
}

# Returns the edges of a cell as chains: its pieces side by side, and each cover.
whole_edges <- function(cell, edge) {
  c(list(paste0(names(cell$pieces), ".", edge)), sprintf("%s.%s", names(cell$covers), edge))
}

# Returns the seams between the pieces of a cell that are side by side.
inner_seams <- function(cell) {
  pieces <- names(cell$pieces)
  if (length(pieces) < 3L) return(list())
  seams <- Map(function(left, right) {
    list(edges = c(paste0(left, ".right"), paste0(right, ".left")))
  }, pieces[-length(pieces)], pieces[-1L])
  stats::setNames(seams, paste0(pieces[-length(pieces)], "_", pieces[-1L]))
}

# Returns list(panels, seams, points) of a grid: its pieces and covers, joined around the net and
# end to end, and gathered at the point `codline`.
join_grid <- function(grid) {
  joints <- cell_joints(grid)
  sides <- side_seams(grid)
  ring <- vapply(joints, `[[`, NA, "ring")
  joined <- function(joints) do.call(c, lapply(unname(joints), rear_seams))
  ended <- unlist(ended_panels(grid$columns), use.names = FALSE)
  last <- lapply(setdiff(names(grid$columns), ended), function(panel) {
    whole_edges(rev(column_cells(grid, panel))[[1L]], "lower")
  })
  tips <- unlist(lapply(unname(sides), `[[`, "gathered_at"))
  list(
    panels = c(
      do.call(c, lapply(unname(grid$cells), function(cell) c(cell$pieces, cell$covers))),
      lapply(grid$separators, `[[`, "piece")
    ),
    seams = c(joined(joints[!ring]), sides, joined(joints[ring]),
      do.call(c, lapply(unname(grid$cells), inner_seams)),
      list(codline_gathered = list(edges = unlist(last), gathered_at = "codline"))),
    points = stats::setNames(rep(list(nothing), length(tips) + 1L), c(tips, "codline"))
  )
}

joined_grid <- remembered(join_grid)

# Returns the joints between cells and the cells behind them, in the order of the cells: list(cell,
# behind, ring, name, left, right) each. `ring`: TRUE for a piece of a row that all panels have;
# `left`, `right`: parts of the rear edges of ended side panels next to the cell.
cell_joints <- function(grid) {
  ended <- ended_panels(grid$columns)
  rings <- Reduce(intersect, grid$columns)
  joints <- lapply(names(grid$columns), function(panel) {
    rows <- grid$columns[[panel]]
    cells <- paste(panel, rows, sep = "_")
    lapply(stats::setNames(seq_along(rows)[-1L], cells[-length(cells)]), function(k) {
      cell <- grid$cells[[cells[k - 1L]]]
      ring <- rows[k - 1L] %in% rings && !is_pair(cell)
      whole <- whole_rows(rows)[k - 1L]
      beside <- function(side) {
        if (whole_rows(rows)[k] != whole) ended_neighbour(grid, panel, whole, ended[[whole]], side)
      }
      list(cell = cell, behind = grid$cells[[cells[k]]], ring = ring,
        name = if (ring) paste(cells[k - 1L], rows[k], sep = "_") else cell$name,
        left = beside("left"), right = beside("right"))
    })
  })
  joints <- unlist(joints, recursive = FALSE)
  joints[intersect(names(grid$cells), names(joints))]
}

# Returns the part of the rear edge of an ended side panel that is joined behind the next panel:
# list(edge, width (m)), or NULL. A single side panel is divided in the middle. `ended`: panels that
# end at this row; `side`: side of the panel at which the ended panel is.
ended_neighbour <- function(grid, panel, row, ended, side) {
  around <- names(grid$columns)[vapply(grid$columns, function(rows) row %in% whole_rows(rows), NA)]
  turn <- if (side == "left") -1L else 1L
  next_to <- function(k) around[(k - 1L) %% length(around) + 1L]
  at <- match(panel, around)
  first <- next_to(at + turn)
  if (!first %in% ended) return(NULL)
  cell <- grid$cells[[paste(first, rear_row(grid$columns[[first]], row), sep = "_")]]
  meshes <- cell$counts$lower
  range <- c(0, meshes)
  if (!next_to(at + 2L * turn) %in% ended) {
    range <- if (side == "left") c(meshes / 2, meshes) else c(0, meshes / 2)
  }
  if (meshes == 0) return(NULL)
  list(edge = edge_range(names(cell$pieces), "lower", range[1L], range[2L], meshes),
    width = cell$mesh_size * diff(range))
}

# Returns the seams of a joint. A pair of wings is joined to the pair behind it, or to both ends of
# the front edge behind it.
rear_seams <- function(joint) {
  cell <- joint$cell
  behind <- joint$behind
  rear <- whole_edges(cell, "lower")
  front <- whole_edges(behind, "upper")
  # Returns one pair of edges for each of `edges`, with ranges of a piece's edge by their `widths`.
  ranged <- function(edges, widths, piece, edge, whole) {
    ends <- c(0, cumsum(widths) / sum(widths)) * whole
    joint$name <<- paste0(joint$name, c("_left", "", "_right"))[widths > 0]
    Map(function(own, from, to) list(own, edge_range(piece, edge, from, to, whole)),
      edges[widths > 0], ends[-4L][widths > 0], ends[-1L][widths > 0])
  }
  after <- names(behind$pieces)
  edges <- if (!is.null(joint$left) || !is.null(joint$right)) {
    ranged(list(joint$left$edge, rear[[1L]], joint$right$edge),
      c(first_of(joint$left$width, 0), cell$mesh_size * cell$counts$lower,
        first_of(joint$right$width, 0)), after, "upper", behind$counts$upper)
  } else if (!is.null(cell$across)) {
    ranged(rear[[1L]], cell$across$lower, after, "upper", behind$counts$upper)
  } else if (!is.null(behind$across)) {
    ranged(front[[1L]], behind$across$upper, names(cell$pieces), "lower", cell$counts$lower)
  } else if (!is_pair(cell)) {
    list(c(rear, front))
  } else if (is_pair(behind)) {
    Map(c, rear[[1L]], front[[1L]])
  } else {
    rear <- rear[[1L]]
    base <- cell$joined
    across <- behind$counts$upper
    range <- function(from, to) edge_range(after, "upper", from, to, across)
    list(c(rear[1L], range(0, base)), c(rear[2L], range(across - base, across)))
  }
  stats::setNames(lapply(unname(edges), function(edges) list(edges = edges)), joint$name)
}

# Returns the seams along the sides of neighbouring panels, row by row from the front. Those of the
# wings are followed by the seams of gathered wing tips.
side_seams <- function(grid) {
  pairs <- neighbours(grid$columns)
  stretches <- lapply(pairs, seam_stretches, grid = grid)
  seams <- list()
  for (row in unique(c("wings", unlist(lapply(stretches, names))))) {
    for (k in names(pairs)) {
      # In a gathered net of two panels, upper and lower wings have separate ends.
      apart <- row == "wings" && grid$gathered && length(grid$columns) == 2L
      edges <- if (!apart) stretches[[k]][[row]]
      if (length(edges)) seams[[paste(row, k, sep = "_")]] <- list(edges = edges)
      # Pairs behind an ended side panel have no wings.
      front <- match(k, names(pairs)) <= length(grid$columns)
      if (row == "wings" && front) {
        seams <- c(seams, tip_seams(grid, pairs[[k]]$panel, pairs[[k]]$after))
      }
    }
  }
  seams
}

# Returns the stretch of the seam between two panels to which each row of both belongs: each whole
# row that both have, and the rows in between. Stretches are named after their row; "wings" is the
# stretch ahead of the first common row. `rows`: of both panels.
row_stretches <- function(rows) {
  wholes <- lapply(rows, whole_rows)
  both <- intersect(wholes[[1L]], wholes[[2L]])
  between <- c("wings", paste0("behind_", both))
  lapply(wholes, function(rows) {
    shared <- rows %in% both
    ifelse(shared, rows, between[cumsum(shared & !duplicated(rows)) + 1L])
  })
}

# Returns the joined chains of edges of each stretch of the seam of a pair of panels, by name.
seam_stretches <- function(pair, grid) {
  stretch <- row_stretches(pair$columns)
  chains <- function(name) {
    sides <- Map(function(panel, stretch, side) {
      cells <- cells_of(grid, panel, pair$columns[[panel]][stretch == name])
      covers <- names(do.call(c, lapply(unname(cells), `[[`, "covers")))
      chain <- outer_edges(cells, side, "joined")
      if (length(chain)) c(list(chain), paste0(covers, rep(paste0(".", side), length(covers))))
    }, names(stretch), stretch, c("right", "left"))
    if (!all(lengths(sides))) return(NULL)
    c(unlist(unname(sides), recursive = FALSE),
      separator_edges(grid, pair$panel, pair$after, name))
  }
  lapply(stats::setNames(nm = unique(unlist(stretch, use.names = FALSE))), chains)
}

# Returns the seams that gather the wing tips between a panel and the next one: at one wing end, or
# in a net of two panels at two.
tip_seams <- function(grid, panel, after) {
  if (!grid$gathered) return(list())
  first <- lapply(c(panel, after), function(panel) names(column_cells(grid, panel)[[1L]]$pieces))
  tips <- paste0(c(first[[1L]][2L], first[[2L]][1L]), ".upper")
  ends <- c(
    switch(panel, back = "upper_starboard", belly = "lower_port"),
    switch(after, back = "upper_port", belly = "lower_starboard")
  )
  seams <- lapply(unique(ends), function(end) list(edges = tips[ends == end], gathered_at = end))
  stats::setNames(seams, paste0("tip_", unique(ends)))
}
