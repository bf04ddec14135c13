# Margins of ISO 5457 (mm), the left one for filing.
sheet_margin <- c(left = 20, other = 10)

# Allowed text heights (ISO 3098, mm), largest first.
sheet_text_sizes <- list(
  A4 = 1.8, A3 = c(2.5, 1.8), A2 = c(3.5, 2.5), A1 = c(5, 3.5, 2.5)
)

# Returns a gear's drawing on a sheet of a size ("A4"), landscape or portrait. true_size: TRUE for
# netting at equal scales without breaks.
gear_sheet <- function(gear, page, true_size = FALSE) {
  figure <- plan_figure(gear)
  columns <- if (!is.null(figure$layout)) net_columns(figure, true_size)
  best <- NULL
  # With a separate list of netting, only names appear next to panels.
  listed <- lapply(columns, function(column) {
    replace(column, c("rows", "named"), list(FALSE, !column$wall))
  })
  for (way in unique(list(columns, if (!is.null(columns)) listed))) {
    # Prefer labels next to the panels unless a separate list lets the netting be much larger.
    before <- best
    for (t in sheet_text_sizes[[page]]) {
      # Larger letters justify slightly smaller netting.
      much <- if (identical(best, before)) 2 else 1.5
      least <- if (is.null(best)) 0 else much * best$worth
      found <- best_draft(figure, way, sheet_sizes[[page]], drawing_look(t), true_size, least)
      if (!is.null(found)) best <- c(found, list(columns = way))
    }
    if (is.null(figure$layout)) break
  }
  if (is.null(best)) {
    abort_argument(
      "This gear does not fit on {.val {page}} in letters of 1.8 mm; choose a larger {.arg page}."
    )
  }
  draw_draft(best, figure, best$columns)
}

# Returns the best arrangement that fits on the sheet, NULL if there is none. The sheet is landscape
# or portrait; lists are next to or below the netting. `worth` measures the netting's scale, or the
# evenness of the filling without netting; it must exceed `least`.
best_draft <- function(figure, columns, size, look, true_size, least = 0) {
  best <- NULL
  for (page in list(rev(size), size)) {
    frame <- c(sheet_margin[["left"]], sheet_margin[["other"]], page - sheet_margin[["other"]])
    foot <- foot_title_height(look) + length(legend_lines(figure, frame, look)) * look$line + 1
    inner <- c(frame[1] + 2, frame[2] + foot + 2, frame[3] - 2, frame[4] - 2)
    blocks <- info_blocks(figure, columns, look)
    found <- best_arrangement(figure, columns, blocks, inner, look, true_size, least)
    if (is.null(found)) next
    best <- c(found, list(page = page, frame = frame, inner = inner, look = look))
    least <- 1.02 * best$worth
  }
  best
}

# ---- lists, ropes laid straight and rigging as blocks --------------------------------------------

# Returns the blocks in drawing order: list(wide, high (mm), grows (in height), widens, draw =
# function(sheet, left, top, wide, high)).
info_blocks <- function(figure, columns, look) {
  straight <- if (!is.null(figure$ropes)) straight_ropes(figure)
  blocks <- list(
    if (length(straight)) straight_block(straight, look),
    if (length(columns) && columns[[1L]]$named) netting_list(netting_items(columns), look)
  )
  blocks <- append(blocks, lapply(figure$riggings, rigging_block, figure, look), 1L)
  ropes <- lapply(chunks(NROW(figure$ropes), 20L), rope_list, figure, look)
  pieces <- lapply(chunks(NROW(figure$pieces), 12L), piece_list, figure, look)
  Filter(length, c(blocks, ropes, pieces))
}

chunks <- function(n, most) unname(split(seq_len(n), (seq_len(n) - 1L) %/% most))

straight_block <- function(straight, look) {
  each <- vapply(straight, function(rope) {
    (5.2 + length(piece_lines(rope, straight_width(look), look))) * look$line
  }, 0)
  list(
    wide = straight_width(look), high = sum(each), grows = FALSE, widens = TRUE,
    draw = function(sheet, left, top, wide, high) {
      tops <- top - cumsum(c(0, each))
      for (k in seq_along(straight)) draw_straight(sheet, straight[[k]], left, tops[k], wide, look)
    }
  )
}

rigging_block <- function(rigging, figure, look) {
  layer <- rigging$nodes$layer
  list(
    wide = (max(layer) + 1.5) * (8 * look$t + 2 * look$balloon),
    high = (3 + max(table(layer), 2) * 4.2) * look$line + sum(next_space(rigging, look)),
    grows = TRUE, widens = TRUE,
    draw = function(sheet, left, top, wide, high) {
      draw_rigging(sheet, figure, rigging, c(left, top - high, left + wide, top), look)
    }
  )
}

# words: one row per column. bold: TRUE if the first column is bold.
column_widths <- function(words, heading, look, bold = FALSE) {
  vapply(seq_along(heading), function(c) {
    max(text_width(c(heading[c], words[c, ]), look$t, bold && c == 1L))
  }, 0)
}

# Draws a table of texts at heights y. `words`: one row per column. `columns`: data frame of
# component, field and across, as `panel_columns`. `refs`: assembly field of each item. `mark`:
# function that draws the symbol of item k.
put_string <- function(sheet, words, columns, refs, at, y, look, mark = function(k) NULL) {
  for (k in seq_along(y)) {
    for (c in seq_len(nrow(columns))) {
      on_sheet(sheet, component = columns$component[c], ref = paste0(refs[k], columns$field[c]),
        layer = "TABLES", draw = {
          if (c == 1L) mark(k)
          sheet_text(sheet, at[c], y[k], words[c, k], look$t, columns$across[c])
        })
    }
  }
}

# Returns such a table as a block. pitch: mm between items; first: mm in front of the text, reserved
# for mark(sheet, x, y, k).
text_block <- function(words, columns, refs, look, pitch = look$line, first = 0, mark = NULL) {
  wide <- column_widths(words, columns$heading, look, bold = TRUE)
  gap <- 1.5 * look$gap
  n <- length(wide)
  list(
    wide = first + sum(wide) + (n - 1) * gap, high = 1.5 * look$line + pitch * ncol(words),
    grows = FALSE, widens = FALSE,
    draw = function(sheet, left, top, wide_given, high) {
      at <- left + first + cumsum(c(0, wide[-n] + gap)) + columns$across * wide
      on_sheet(sheet, component = "heading", layer = "TABLES", draw = {
        for (c in seq_len(n)) {
          sheet_text(sheet, if (c == 1L) left else at[c], top - look$line / 2, columns$heading[c],
            look$t, columns$across[c], bold = c == 1L, italic = c > 1L)
        }
      })
      y <- top - look$line - (seq_len(ncol(words)) - 0.5) * pitch
      put_string(sheet, words, columns, refs, at, y, look, function(k) {
        if (!is.null(mark)) mark(sheet, left, y[k], k)
      })
    }
  )
}

rope_list <- function(rows, figure, look) {
  items <- figure$ropes[rows, ]
  words <- vapply(seq_len(nrow(items)), function(k) rope_item_text(items[k, ]), character(4))
  columns <- data.frame(
    heading = c("Ropes", "length m", "\u00d8 mm", "E"),
    component = c("rope", "length", "diameter", "hanging_ratio"),
    field = c("", ".length", ".diameter", ".hanging_ratio"), across = c(0, 1, 0, 0)
  )
  if (!any(nzchar(words["hanging", ]))) columns$heading[4L] <- ""
  text_block(words, columns, paste0("ropes.", items$first), look, 2 * look$balloon + 0.6,
    2 * look$balloon + look$gap, function(sheet, x, y, k) {
      draw_balloon(sheet, x + look$balloon, y, items$item[k], look)
    })
}

netting_list <- function(items, look) {
  columns <- panel_columns
  columns$heading[1L] <- "Netting"
  text_block(t(as.matrix(items[c("name", "deep", "mesh", "twine")])), columns,
    paste0("panels.", items$panel), look)
}

piece_list <- function(rows, figure, look) {
  items <- figure$pieces[rows, ]
  first <- 2 * look$balloon + look$gap
  wide <- 42 * look$t
  lines <- lapply(seq_len(nrow(items)), function(k) {
    name <- paste0(items$name[k], if (items$count[k] > 1) paste0(", ", items$count[k], " off"))
    wrap_text(paste0(name, if (nzchar(items$words[k])) paste0(": ", items$words[k])),
      wide - first, look$t)
  })
  pitch <- pmax(lengths(lines) * look$line, 2 * look$balloon) + 0.6
  list(
    wide = wide, high = 1.5 * look$line + sum(pitch), grows = FALSE, widens = FALSE,
    draw = function(sheet, left, top, wide_given, high) {
      on_sheet(sheet, component = "heading", layer = "TABLES", draw = sheet_text(sheet, left,
        top - look$line / 2, "Floats, weights, boards (of each)", look$t, bold = TRUE))
      y <- top - look$line - look$balloon - 0.2 - c(0, cumsum(pitch))
      for (k in seq_along(lines)) {
        on_sheet(sheet, component = "piece", ref = items$ref[k], layer = "TABLES", draw = {
          draw_balloon(sheet, left + look$balloon, y[k], items$item[k], look, square = TRUE)
          sheet_lines(sheet, left + first, y[k], lines[[k]], look)
        })
      }
    }
  )
}

# ---- arrangements --------------------------------------------------------------------------------

# Distributes blocks over at most n columns in their order. Returns list(column (of each block),
# wide (of each column), high) with the least possible height.
packed_blocks <- function(blocks, n, gap) {
  high <- vapply(blocks, `[[`, 0, "high")
  fill <- function(most) {
    column <- integer(length(high))
    at <- 1L
    used <- 0
    for (k in seq_along(high)) {
      if (used > 0 && used + gap + high[k] > most + 1e-6) {
        at <- at + 1L
        used <- 0
      }
      used <- used + (if (used > 0) gap else 0) + high[k]
      column[k] <- at
    }
    column
  }
  # The least height is always a sum of consecutive blocks.
  ends <- cumsum(high + gap)
  sums <- sort(unique(as.vector(outer(ends, c(0, ends), "-"))) - gap)
  for (most in sums[sums >= max(high) - 1e-6]) {
    column <- fill(most)
    if (max(column) > n) next
    wide <- as.vector(tapply(vapply(blocks, `[[`, 0, "wide"), column, max))
    return(list(column = column, wide = wide, high = most))
  }
}

packed_width <- function(pack, gap) sum(pack$wide) + (length(pack$wide) - 1) * gap

# Returns the arrangement with the highest worth above `least`, NULL if no such arrangement fits:
# list(worth, scale, net, blocks, place, packed). `net` and `place` are the areas of netting and
# blocks (left, bottom, right, top).
best_arrangement <- function(figure, columns, blocks, inner, look, true_size, least = 0) {
  gap <- 2 * look$line
  room <- inner[3:4] - inner[1:2]
  found <- NULL
  add <- function(worth, scale, net, place, pack) {
    if (worth <= least) return()
    found <<- list(
      worth = worth, scale = scale, net = net, place = place, packed = pack, blocks = blocks
    )
    least <<- 1.02 * worth
  }
  fitting <- function(wide, high) {
    fitting_scale(columns, figure, wide, high, look, true_size, least)
  }
  if (is.null(columns)) {
    for (n in 1:4) {
      pack <- if (length(blocks)) packed_blocks(blocks, n, gap)
      whole <- packed_width(pack, gap)
      if (is.null(pack) || pack$high > room[2] || whole > room[1]) next
      # Prefer blocks that fill the width.
      add(whole / room[1], NULL, NULL, inner, pack)
    }
    return(found)
  }
  if (!length(blocks)) {
    scale <- fitting(room[1], room[2])
    if (!is.null(scale)) add(prod(scale), scale, inner, NULL, NULL)
    return(found)
  }
  for (n in 1:4) {
    pack <- packed_blocks(blocks, n, gap)
    whole <- packed_width(pack, gap)
    if (is.null(pack) || max(pack$column) < n || whole > room[1]) next
    if (pack$high <= room[2]) {
      scale <- fitting(room[1] - whole - gap, room[2])
      if (!is.null(scale)) {
        split <- inner[3] - whole
        add(prod(scale), scale, c(inner[1:2], split - gap, inner[4]),
          c(split, inner[2], inner[3], inner[4]), pack)
      }
    }
    high <- room[2] - pack$high - gap
    if (high > 0) {
      scale <- fitting(room[1], high)
      if (!is.null(scale)) {
        split <- inner[2] + pack$high
        add(prod(scale), scale, c(inner[1], split + gap, inner[3:4]), c(inner[1:3], split), pack)
      }
    }
  }
  found
}

# ---- drawing -------------------------------------------------------------------------------------

draw_draft <- function(draft, figure, columns) {
  sheet <- new_sheet(draft$page)
  look <- draft$look
  frame <- draft$frame
  on_sheet(sheet, component = "frame", layer = "SHEET", draw = sheet_polygon(sheet,
    frame[c(1, 3, 3, 1)], frame[c(2, 2, 4, 4)], width = sheet_width[["thick"]]))
  if (!is.null(columns)) {
    sheet$scale <- 1000 / draft$scale[2]
    net <- draft$net
    # Centre the netting in its area.
    spare <- net[3] - net[1] - columns_width(columns, figure, draft$scale, look)
    deep <- columns_height(columns) * draft$scale[2]
    wall <- any(vapply(columns, `[[`, NA, "wall"))
    above <- (heading_lines + if (wall) 8 else 0) * look$line
    low <- net[4] - net[2] - above - deep - (if (wall) 7 else 1) * look$line
    draw_columns(sheet, columns, figure, draft$scale, net[1] + max(0, spare / 2),
      net[4] - above - max(0, low / 2), look, new_page_use())
  }
  draw_blocks(sheet, draft)
  draw_foot(sheet, figure, draft)
  sheet
}

# Draws the blocks. Columns with blocks that widen, if any, share the spare width. Growing blocks
# and the gaps between blocks take up the remaining height.
draw_blocks <- function(sheet, draft) {
  if (is.null(draft$packed)) return(invisible())
  gap <- 2 * draft$look$line
  column <- draft$packed$column
  n <- max(column)
  place <- draft$place
  widens <- tapply(vapply(draft$blocks, `[[`, NA, "widens"), column, any)
  widens <- if (any(widens)) widens / sum(widens) else 1 / n
  spare <- place[3] - place[1] - packed_width(draft$packed, gap)
  wide <- draft$packed$wide + as.vector(spare * widens)
  left <- place[1] + cumsum(c(0, wide + gap))
  # Without netting, the rigging is the main drawing and may grow without limit.
  most <- if (is.null(draft$net)) Inf else 0.8
  for (c in seq_len(n)) {
    mine <- draft$blocks[column == c]
    high <- vapply(mine, `[[`, 0, "high")
    spare <- place[4] - place[2] - sum(high) - (length(mine) - 1) * gap
    grows <- vapply(mine, `[[`, NA, "grows")
    if (any(grows)) high[grows] <- high[grows] + min(spare, most * sum(high[grows])) / sum(grows)
    top <- place[4]
    rest <- place[4] - place[2] - sum(high) - (length(mine) - 1) * gap
    for (k in seq_along(mine)) {
      mine[[k]]$draw(sheet, left[c], top, wide[c], high[k])
      top <- top - high[k] - gap - rest / max(1, length(mine) - 1) * 0.6
    }
  }
}

# ---- title and legend ----------------------------------------------------------------------------

legend_lines <- function(figure, frame, look) {
  words <- c(
    if (!is.null(figure$layout)) {
      c(
        width_rule(figure),
        "Meshes at edges are across the whole panel (upper/lower). N points, T meshes, B bars."
      )
    },
    if (any(figure$ropes$laced)) "E hanging ratio.",
    if (!is.null(figure$ropes)) "Rope lengths are for one rope."
  )
  if (!length(words)) return(character())
  wrap_text(paste(words, collapse = " "), frame[3] - frame[1] - 4, look$t)
}

foot_title_height <- function(look) 3.4 * look$line + 2

draw_foot <- function(sheet, figure, draft) {
  frame <- draft$frame
  look <- draft$look
  t <- look$t
  top <- frame[2] + foot_title_height(look)
  lines <- legend_lines(figure, frame, look)
  on_sheet(sheet, component = "legend", layer = "TITLE", draw = {
    sheet_lines(sheet, frame[1] + 2, top + 0.5 + (length(lines) - 0.5) * look$line, lines, look,
      italic = TRUE)
    sheet_line(sheet, frame[c(1, 3)], c(top, top), sheet_width[["middle"]])
  })
  wide <- frame[3] - frame[1]
  name <- names(sheet_sizes)[vapply(sheet_sizes, function(s) all(s == sort(draft$page)), NA)]
  cells <- c(max(0.3 * wide, wide - 66 * t), min(44 * t, 0.45 * wide), 0)
  cells[3] <- wide - sum(cells)
  left <- frame[1] + c(0, cumsum(cells)[1:2])
  for (x in left[-1L]) {
    on_sheet(sheet, component = "frame", layer = "TITLE",
      draw = sheet_line(sheet, c(x, x), c(frame[2], top)))
  }
  row <- function(k) top - 1 - (k - 0.5) * 1.13 * look$line
  room <- cells - 4
  large <- if (text_width(figure$title, 1.4 * t, TRUE) <= room[1]) 1.4 * t else t
  on_sheet(sheet, component = "name", ref = "name", layer = "TITLE", draw = sheet_text(sheet,
    left[1] + 2, row(1), cut_text(figure$title, room[1], large, TRUE), large, bold = TRUE))
  on_sheet(sheet, component = "source", layer = "TITLE", draw = {
    source <- if (nzchar(figure$source)) paste("Source:", figure$source) else ""
    said <- wrap_text(source, room[1], t)
    if (length(said) > 2L) {
      said <- c(said[1], cut_text(paste0(said[2], " and more in the plan"), room[1], t))
      if (!endsWith(said[2], "plan")) {
        said[2] <- paste(cut_text(said[2], room[1] - text_width(" (more in the plan)", t), t),
          "(more in the plan)")
      }
    }
    for (k in seq_along(said)) sheet_text(sheet, left[1] + 2, row(k + 1), said[k], t)
  })
  draw_scale_bar(sheet, draft$scale, left[2] + 2, row, room[2], look)
  on_sheet(sheet, component = "sheet", layer = "TITLE", draw = {
    sheet_text(sheet, left[3] + 2, row(1), cut_text(name, room[3], t, TRUE), t, bold = TRUE)
    sheet_text(sheet, left[3] + 2, row(2), cut_text("Drawn by codend", room[3], t), t)
  })
}

draw_scale_bar <- function(sheet, scale, left, row, room, look) {
  t <- look$t
  ratio <- function(s) paste("1 :", short_number(1000 / s, 5))
  on_sheet(sheet, component = "scale", layer = "TITLE", draw = {
    if (is.null(scale)) {
      sheet_text(sheet, left, row(1), "Not to scale", t, bold = TRUE)
    } else {
      said <- if (scale[1] == scale[2]) paste("Scale", ratio(scale[1])) else {
        paste0("Scale ", ratio(scale[1]), " along, ", ratio(scale[2]), " deep")
      }
      sheet_text(sheet, left, row(1), said, t, bold = TRUE)
      lengths <- as.vector(outer(c(1, 2, 5), 10^(-4:4)))
      words <- function(l) paste(short_number(l), "m")
      fits <- lengths * scale[1] + text_width("5000 m", t) + 3 * t <= room
      long <- max(lengths[fits])
      ends <- left + c(0, 0.5, 1) * long * scale[1]
      y <- row(2) + c(-0.25, 0.25) * t
      for (k in 1:2) {
        sheet_polygon(sheet, ends[c(k, k + 1, k + 1, k)], y[c(1, 1, 2, 2)],
          c(sheet_ink, "white")[k])
      }
      sheet_text(sheet, ends[3] + t, row(2), words(long), t)
    }
    units <- if (is.null(scale)) "Ropes in m, \u00d8 in mm" else {
      "Mesh size and \u00d8 in mm, ropes in m, twine in tex"
    }
    sheet_text(sheet, left, row(3), cut_text(units, room, t), t)
  })
}
