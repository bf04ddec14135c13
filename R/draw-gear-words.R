# The words of a plan drawing about its panels: a table beside them, or numbers and notes below.

# ---- table of the panels' netting ----------------------------------------------------------------

# What stands beside the panels of a column: a data frame with y, depth (m), part, deep, mesh and
# twine.
table_rows <- function(panels, si) {
  rows <- lapply(seq_len(nrow(panels)), function(k) {
    panel <- si$panels[[panels$name[k]]]
    data.frame(
      y = panels$y[k], depth = panels$depth[k], panel = panels$name[k],
      part = gsub("_", " ", if (is.na(panel$part)) panels$name[k] else panel$part),
      deep = mesh_number(panel$deep), mesh = short_number(in_unit(panel$mesh_size, "mm"), 6),
      twine = trimws(paste(twine_words(panel), mesh_words(panel)))
    )
  })
  rows <- do.call(rbind, rows)
  rows[!duplicated(row_texts(rows)), ]
}

row_texts <- function(rows) {
  paste(round(rows$y, 3), round(rows$depth, 3), rows$part, rows$deep, rows$mesh, rows$twine)
}

# One table for all columns, or NULL where they differ at the same depth.
shared_rows <- function(columns, si) {
  if (any(vapply(columns, `[[`, NA, "wall"))) return(NULL)
  rows <- do.call(rbind, lapply(columns, function(c) table_rows(c$panels, si)))
  rows <- rows[!duplicated(row_texts(rows)), ]
  n <- nrow(rows)
  if (n == 1L) return(rows)
  pairs <- utils::combn(n, 2L)
  bottom <- rows$y + rows$depth
  one <- pairs[1, ]
  other <- pairs[2, ]
  meet <- pmin(bottom[one], bottom[other]) - pmax(rows$y[one], rows$y[other])
  if (any(meet > 1e-6 * max(rows$depth))) NULL else rows
}

table_columns <- c(part = "part", deep = "deep", mesh = "mesh mm", twine = "twine mm")

table_widths <- function(rows) {
  if (is.null(rows)) return(0)
  vapply(names(table_columns), function(c) {
    max(pen_width(c(table_columns[[c]], rows[[c]]), cex = plan_text[["label"]]))
  }, 0) + 0.09
}

draw_rows <- function(drawn, left, column) {
  rows <- drawn$rows
  cex <- plan_text[["label"]]
  middle <- drawn$top - drawn$scale[2] * (rows$y + rows$depth / 2)
  y <- spread_labels(middle, plan_line, drawn$bottom - 0.2, drawn$top - 0.02)
  # Numbers end at the right of their column, words start at its left.
  at <- left + cumsum(c(0, drawn$widths[-4L]))
  at[2:3] <- left + cumsum(drawn$widths)[2:3] - 0.09
  adj <- c(0, 1, 1, 0)
  for (c in 1:4) {
    pen_text(at[c], drawn$top + 0.1, table_columns[[c]], adj = c(adj[c], 0.5), cex = cex,
      font = 3)
    field <- c(part = "", deep = "meshes.deep", mesh = "mesh_size", twine = "twine.diameter")[c]
    for (k in seq_along(y)) {
      ref <- paste0("panels.", rows$panel[k], if (nzchar(field)) ".", field)
      on_sheet(pen$sheet, component = c("panel", "meshes", "mesh_size", "twine")[c], ref = ref,
        draw = pen_text(at[c], y[k], rows[[names(table_columns)[c]]][k], adj = c(adj[c], 0.5),
          cex = cex))
    }
  }
  moved <- abs(y - middle) > 0.02
  right <- left + sum(drawn$widths)
  edge <- vapply(rows$y, function(y) {
    mine <- abs(column$panels$y - y) < 1e-6
    if (any(mine)) min(((column$panels$ul + column$panels$ll) / 2)[mine]) else NA_real_
  }, 0)
  edge <- column$at[1] + drawn$scale[1] * edge
  pen_segments(rep(right - 0.06, sum(moved)), y[moved], edge[moved] - 0.02, middle[moved],
    lwd = 0.4, col = "grey40")
}

# ---- panels explained below the drawing -------------------------------------------------------

# What a note says of a panel; detail: its counts and rates stand in the drawing.
note_words <- function(name, si, detail) {
  panel <- si$panels[[name]]
  across <- unique(mesh_number(c(panel$upper, panel$lower)))
  rates <- sort(unique(Filter(nzchar, panel_rates(panel))))
  paste(c(
    if (!detail) paste(paste(across, collapse = "/"), "across"),
    paste(mesh_number(panel$deep), "deep"),
    paste(short_number(in_unit(panel$mesh_size, "mm"), 6), "mm mesh"),
    paste(twine_words(panel, " mm"), "twine"), Filter(nzchar, mesh_words(panel)),
    if (!detail && length(rates)) paste("cut", paste(rates, collapse = " and "))
  ), collapse = ", ")
}

# Gives panels numbers, the same to those of the same words: P1, P2...
number_panels <- function(columns, si, detail) {
  words <- lapply(columns, function(c) {
    vapply(c$panels$name, note_words, "", si = si, detail = detail && !c$wall)
  })
  known <- unique(unlist(words))
  for (k in seq_along(columns)) {
    columns[[k]]$panels$tag <- paste0("P", match(words[[k]], known))
    columns[[k]]$detail <- detail && !columns[[k]]$wall
  }
  columns
}

panel_notes <- function(columns, si, detail) {
  said <- do.call(rbind, lapply(columns, function(c) {
    words <- vapply(c$panels$name, note_words, "", si = si, detail = detail && !c$wall)
    data.frame(tag = c$panels$tag, name = c$panels$name, words = words)
  }))
  vapply(unique(said$tag), function(tag) {
    mine <- said[said$tag == tag, ]
    names <- gsub("_", " ", mine$name)
    n <- length(names)
    if (n > 3L) names <- paste(names[1L], "to", names[n])
    paste0(tag, "  ", paste(names, collapse = ", "), ": ", mine$words[1L])
  }, "", USE.NAMES = FALSE)
}

# Notes in as many columns as fit beside each other: a matrix of texts.
arrange_notes <- function(notes, frame) {
  wide <- max(pen_width(notes, cex = plan_text[["label"]])) + 0.15
  columns <- max(1, min(length(notes), floor((frame[3] - frame[1]) / wide)))
  rows <- ceiling(length(notes) / columns)
  matrix(c(notes, rep("", rows * columns - length(notes))), rows)
}

draw_notes <- function(notes, frame) {
  if (is.null(notes)) return(invisible())
  room <- (frame[3] - frame[1]) / ncol(notes)
  for (c in seq_len(ncol(notes))) {
    cex <- plan_text[["label"]]
    cex <- cex * min(1, room / max(pen_width(notes[, c], cex = cex)))
    y <- frame[2] + 0.4 + plan_note * (nrow(notes) - seq_len(nrow(notes)))
    pen_text(frame[1] + (c - 1) * room, y, notes[, c], adj = c(0, 0.5), cex = cex)
  }
}

label_wall <- function(column, x, y, use) {
  for (k in seq_len(nrow(column$panels))) {
    p <- column$panels[k, ]
    label_text(x((p$ul + p$ll + p$ur + p$lr) / 4), y(p$y + p$depth * if (p$broken) 0.75 else 0.5),
      p$tag, 0.5, use)
  }
}
