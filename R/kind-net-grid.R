# The grid of a net from the field `net`.

# Panels of the grid by panel of the field `net`, from starboard to port.
grid_panels <- list(
  upper = "back", lower = "belly", side = c("side_starboard", "side_port"),
  upper_side = c("upper_side_starboard", "upper_side_port"),
  lower_side = c("lower_side_starboard", "lower_side_port")
)

# Returns the grid of the field `net`. `fields`, `plan`: completed by `complete_net()`.
net_grid <- function(fields, plan) {
  cells <- columns <- list()
  for (name in names(fields$net)) {
    rows <- names(fields$net[[name]])
    sizes <- vapply(plan$net[[name]], function(piece) show_value(piece$mesh_size), "")
    check_column(fields$net[[name]], sizes, paste0("net.", name))
    for (row in rows[lengths(lapply(fields$net[[name]], `[[`, "window")) > 0L]) {
      check_window(fields$net[[name]][[row]], paste("net", name, row, "window", sep = "."))
    }
    fields$net[[name]] <- divided_at_windows(fields$net[[name]])
    rows <- names(fields$net[[name]])
    given <- plan$net[[name]][vapply(fields$net[[name]], `[[`, "", "of")]
    for (panel in grid_panels[[name]]) {
      columns[[panel]] <- stats::setNames(rows, vapply(fields$net[[name]], `[[`, "", "of"))
      cells[paste(panel, rows, sep = "_")] <-
        Map(net_cell, rows, fields$net[[name]], given, MoreArgs = list(panel = panel))
    }
  }
  around <- panels_around(fields)
  gathered <- unlist(lapply(fields$net, function(column) isTRUE(column[[1L]]$gathered)))
  grid <- list(columns = columns[around], cells = cells, gathered = all(gathered),
    separators = net_separators(fields, plan, columns, cells))
  check_ends(grid)
  for (pair in neighbours(grid$columns)) grid <- check_stretches(grid, pair, fields$net)
  grid
}

# Throws an error if a side panel ends at a row that other panels lack, or ahead of a cover.
check_ends <- function(grid) {
  ended <- ended_panels(grid$columns)
  active <- names(grid$columns)
  for (row in names(ended)) {
    name <- net_panel_of(ended[[row]][1L])
    path <- paste("net", name, row, sep = ".")
    for (panel in active) {
      last <- rear_row(grid$columns[[panel]], row)
      if (is.null(last)) {
        abort_plan(sprintf(paste(
          "Plan field `%s` is the last piece of its panel, but the panel `%s` has no piece of this",
          "name. Side panels end together with a row of all panels. Rename a piece."
        ), path, net_panel_of(panel)), path)
      }
      behind <- grid$columns[[panel]][match(last, grid$columns[[panel]]) + 1L]
      if (!is.na(behind) && length(grid$cells[[paste(panel, behind, sep = "_")]]$covers)) {
        abort_field(paste("net", net_panel_of(panel), behind, "covers", sep = "."), "given",
          sprintf("omitted in the piece behind the last piece of the panel `%s`", name))
      }
    }
    active <- setdiff(active, ended[[row]])
  }
}

# Largest ratio of the stretched widths that are joined.
most_taken_up <- 2

# Largest difference of the stretched lengths of seamed edges, as a fraction.
most_seam_slack <- 0.1

# Throws an error if the rows of a panel cannot be joined. `column`: checked pieces of the panel;
# `sizes`: their mesh sizes as in the plan.
check_column <- function(column, sizes, path) {
  rows <- names(column)
  pair <- vapply(column, function(piece) isTRUE(piece$pair), NA)
  at <- function(k, ...) paste(path, rows[k], ..., sep = ".")
  late <- which(pair & seq_along(pair) > match(FALSE, pair, length(pair)))[1L]
  if (!is.na(late)) {
    abort_field(at(late, "pair"), TRUE,
      "omitted behind a whole piece: wings are ahead of whole pieces")
  }
  if (all(pair)) abort_field(at(length(rows), "pair"), TRUE, "omitted in the last piece of a panel")
  for (k in seq_along(rows)) {
    piece <- column[[k]]
    if (max(flying_meshes(piece)) > piece$meshes$deep) {
      abort_field(at(k, "flying"), piece$flying,
        paste("at most the depth of the piece,", displayed_count(piece$meshes$deep), "meshes"))
    }
    if (k == length(rows)) next
    behind <- column[[k + 1L]]
    front <- behind$meshes$front
    rear <- if (pair[k] && !pair[k + 1L]) first_of(piece$joined, piece$meshes$rear) else front
    joint <- sprintf("`%s` has %s meshes of %s at the rear and `%s` has %s of %s in front",
      at(k), displayed_count(piece$meshes$rear), sizes[k], at(k + 1L), displayed_count(front),
      sizes[k + 1L])
    if (pair[k] && !pair[k + 1L] && 2 * rear > front + 1e-9) {
      abort_plan(paste0("Plan field ", joint, ": both wings together must not be wider. ",
        "Change a count."), at(k, "meshes", "rear"), piece$meshes$rear)
    }
    ratio <- piece$meshes$rear * piece$mesh_size / (rear * behind$mesh_size)
    if (!isTRUE(ratio >= 1 / most_taken_up && ratio <= most_taken_up)) {
      abort_plan(paste0("Plan field ", joint, ": their stretched widths must be within a ratio of ",
        most_taken_up, ". Change a count."), at(k, "meshes", "rear"), piece$meshes$rear)
    }
  }
}

# Returns the grid with free edges where the next panel has no row, ahead of the first common row (a
# topless net). Throws an error if seamed stretches differ in length.
check_stretches <- function(grid, pair, net) {
  columns <- pair$columns
  stretch <- row_stretches(columns)
  sides <- c("right", "left")
  for (name in unique(unlist(stretch))) {
    rows <- Map(function(rows, stretch) rows[stretch == name], columns, stretch)
    field <- lapply(names(rows), net_panel_of)
    path <- function(k) paste("net", field[[k]], unique(whole_rows(rows[[k]])), sep = ".")
    at <- function(k) paste0("`", path(k), "`", collapse = " and ")
    if (!all(lengths(rows))) {
      k <- which(lengths(rows) > 0L)
      if (name != "wings" || grid$gathered) {
        abort_plan(sprintf(paste(
          "Plan field %s has no piece beside it in the panel `%s`: only the pieces ahead of the",
          "first common row may have a free edge. Add a piece, or give rows the same name."
        ), at(k), field[[3L - k]]), path(k)[1L])
      }
      for (cell in paste(names(rows)[k], rows[[k]], sep = "_")) {
        grid$cells[[cell]]$free[[sides[k]]] <- grid$cells[[cell]]$counts$deep
      }
      next
    }
    for (k in 1:2) {
      covered <- lengths(lapply(cells_of(grid, names(rows)[k], rows[[k]]), `[[`, "covers")) > 0L
      if (length(path(k)) > 1L && any(covered)) {
        piece <- whole_rows(rows[[k]])[covered][1L]
        abort_field(paste("net", field[[k]], piece, "covers", sep = "."), "given",
          sprintf("omitted in a piece that the panel `%s` does not have", field[[3L - k]]))
      }
    }
    long <- vapply(1:2, function(k) {
      pieces <- net[[field[[k]]]][rows[[k]]]
      sum(vapply(pieces, seamed_length, 0, side = sides[k], panel = names(rows)[k]))
    }, 0)
    if (min(long) < max(long) * (1 - most_seam_slack)) {
      abort_plan(sprintf(paste(
        "Plan field %s is %s long along the seam and %s is %s: seamed edges must agree within",
        "%.0f %%. Change the depth of a piece or its `flying` meshes%s."
      ), at(1L), format_si(long[1L], "length"), at(2L), format_si(long[2L], "length"),
      100 * most_seam_slack,
      if (name == "wings") "" else ", or give rows that end at different places different names"),
      path(1L)[1L])
    }
  }
  grid
}

net_panel_of <- function(panel) {
  names(grid_panels)[vapply(grid_panels, function(panels) panel %in% panels, NA)]
}

# Returns the stretched length (m) of one edge of a piece.
edge_depth <- function(piece, edge) {
  lost <- piece$lost[edge]
  piece$mesh_size * max(piece$meshes$deep, abs(lost), na.rm = TRUE)
}

# Returns the stretched length (m) of the seamed part of a piece's outer edge.
seamed_length <- function(piece, side, panel) {
  if (endsWith(panel, "_port")) side <- setdiff(c("left", "right"), side)
  edge <- if (isTRUE(piece$pair)) "outer" else side
  edge_depth(piece, edge) * (1 - flying_meshes(piece)[[side]] / piece$meshes$deep)
}

# Returns the meshes of the left and right edge of a piece, or of its mirror image, without a seam.
flying_meshes <- function(piece, mirrored = FALSE) {
  free <- first_of(piece$flying, 0)
  free <- if (is.list(free)) unlist(free[c("left", "right")]) else c(left = free, right = free)
  if (mirrored) c(left = free[["right"]], right = free[["left"]]) else free
}

# Fields of a piece that are not fields of a panel of the assembly.
piece_fields <- c("pair", "gathered", "window", "meshes", "cutting", "flying", "joined", "covers")

# Returns the cutting rates of a piece by edge. One rate applies to both edges of a whole piece, or
# to the inner edges of wings, whose outer edges are then straight.
edge_rates <- function(cutting, edges) {
  if (!is_text(cutting)) return(cutting)
  stats::setNames(list(cutting, if (edges[1L] == "inner") "AN" else cutting), edges)
}

# Returns the cell of a piece. The port side is the mirror image of the starboard side.
net_cell <- function(row, fields, given, panel) {
  own <- given[setdiff(names(given), piece_fields)]
  counts <- list(upper = fields$meshes$front, lower = fields$meshes$rear, deep = fields$meshes$deep)
  rates <- edge_rates(given$cutting, names(fields$lost))
  mirrored <- endsWith(panel, "_port")
  sides <- if (mirrored) c("right", "left") else c("left", "right")
  # `sides`: edge of the piece at its left and right.
  piece <- function(sides) {
    lost <- stats::setNames(as.list(fields$lost[sides]), c("left", "right"))
    cutting <- stats::setNames(lapply(sides, function(side) rates[[side]]), c("left", "right"))
    cutting <- Filter(Negate(is.null), cutting)
    c(own, list(meshes = counts, lost = lost), if (length(cutting)) list(cutting = cutting),
      list(part = row))
  }
  name <- paste(panel, row, sep = "_")
  across <- NULL
  flying <- flying_meshes(fields, mirrored)
  pieces <- if (!is.null(fields$window)) {
    if (mirrored) {
      fields$window$left <- fields$meshes$front - fields$window$left - fields$window$across
    }
    inside <- window_pieces(row, own, unname(fields$lost[sides]), fields, given$window)
    counts_of <- function(edge) vapply(inside, function(piece) piece$meshes[[edge]], 0)
    across <- lapply(list(upper = "upper", lower = "lower"), counts_of)
    across <- lapply(across, replace, 2L, fields$window$across)
    stats::setNames(inside, paste0(name, c("_left", "", "_right")))
  } else if (isTRUE(fields$pair)) {
    stats::setNames(list(piece(c("outer", "inner")), piece(c("inner", "outer"))),
      paste0(name, c("_left", "_right")))
  } else {
    stats::setNames(list(piece(sides)), name)
  }
  covers <- given$covers
  if (length(covers)) names(covers) <- paste(name, names(covers), sep = "_")
  new_cell(pieces, counts, fields$mesh_size, flying, covers,
    gain = if (isTRUE(fields$pair)) -fields$lost[["inner"]] else 0,
    joined = first_of(fields$joined, counts$lower), across = across)
}
