# Netting of a plan drawing: columns of panel trapezia with labels and a table next to them. Gear is
# in metres, the sheet in millimetres.

# Returns the columns of a layout, the upper panel first. true_size: TRUE to draw panels at full
# length. Each column is a list. `panels`: data frame with corners (ul, ur, lr, ll), cutting rates
# and `labelled`. `words`, `counts`: matrices of labels, one column per panel. `laced`: ropes and
# pieces along the panels. `heading`, `remark`, `number`: texts above the column, and its number.
# `half`: "left" or "right" if half of a symmetric column is drawn, otherwise "". `outer`: the side
# with the labels. `rows`: TRUE for a table of netting next to it. `named`: TRUE for names only.
# `wall`: TRUE for panels side by side. `joined`: TRUE if it shares the centre line of the previous
# column. `turned`: TRUE if mirrored.
net_columns <- function(figure, true_size = FALSE) {
  layout <- figure$layout
  flat <- layout$panels
  wall <- any(vapply(unique(flat$column), function(c) is_wall(flat[flat$column == c, ]), NA))
  flat <- if (true_size || wall) cbind(flat, broken = FALSE) else shorten_longest(flat)
  said <- layout$columns$heading
  first <- match(c("back", "belly"), sub(" .*", "", said))
  order <- unique(c(first[!is.na(first)], seq_along(said)))
  columns <- lapply(order, function(k) {
    flat_column(flat[flat$column == k, ], layout$columns[k, ], figure)
  })
  names <- c(back = "upper panel", belly = "lower panel", side = "side panel")
  for (k in seq_along(columns)) {
    word <- sub(" .*", "", columns[[k]]$heading)
    if (length(columns) > 1L && word %in% names(names)) {
      columns[[k]]$heading <- sub(word, names[[word]], columns[[k]]$heading, fixed = TRUE)
    }
    columns[[k]]$remark <- sub("back, belly", "upper, lower", columns[[k]]$remark, fixed = TRUE)
    columns[[k]]$words <- panel_labels(columns[[k]], figure$si)
    columns[[k]]$counts <- vapply(columns[[k]]$panels$name, function(name) {
      mesh_number(unlist(figure$si$panels[[name]][c("upper", "lower")]))
    }, character(2))
  }
  pair <- length(columns) > 1L && !anyNA(first) && all(nzchar(c(columns[[1]]$half,
    columns[[2]]$half)))
  if (pair) {
    corners <- columns[[1]]$panels[c("ur", "ul", "ll", "lr")]
    columns[[1]]$panels[c("ul", "ur", "lr", "ll")] <- -corners
    columns[[1]][c("half", "outer", "turned")] <- list("left", "left", TRUE)
    columns[[2]]$joined <- TRUE
  }
  rows <- lapply(columns, function(column) {
    told <- column$panels$labelled
    words <- apply(column$words[, told, drop = FALSE], 2L, paste, collapse = "|")
    paste(round(column$panels$y[told], 3), round(column$panels$depth[told], 3), words)
  })
  for (k in seq_along(columns)) {
    columns[[k]]$number <- k
    columns[[k]]$laced <- column_laced(columns[[k]], figure)
    columns[[k]]$rows <- !columns[[k]]$wall && (k == 1L || !all(rows[[k]] %in% rows[[1L]]))
  }
  columns
}

# Shortens the longest panel if it makes up most of the length of several; `broken` marks it.
shorten_longest <- function(panels) {
  panels$broken <- FALSE
  whole <- max(panels$y + panels$depth)
  longest <- which.max(panels$depth)
  rest <- whole - panels$depth[longest]
  if (length(unique(round(panels$y, 6))) < 3L || panels$depth[longest] <= 0.5 * whole) {
    return(panels)
  }
  from <- panels$y[longest]
  to <- from + panels$depth[longest]
  panels$broken <- panels$depth > 0.5 * whole
  short <- function(y) stats::approx(c(-1, 0, from, to, whole), c(-1, 0, from, from + rest / 2,
    whole - (to - from) + rest / 2), y, ties = "ordered")$y
  bottom <- short(panels$y + panels$depth)
  panels$y <- short(panels$y)
  panels$depth <- bottom - panels$y
  panels
}

# Prepares a column. For a symmetric column with tapered panels only the right half remains, with x
# from the middle.
flat_column <- function(panels, column, figure) {
  si <- figure$si
  wall <- is_wall(panels)
  tapers <- any(abs(panels$upper - panels$lower) > 1e-9 * panels$upper)
  half <- column$symmetric && !wall && tapers
  middle <- max(panels$x + panels$upper, panels$x + panels$shift + panels$lower) / 2
  # Labels appear on the right panel of a mirrored pair.
  panels$labelled <- !column$symmetric |
    panels$x + (panels$upper + panels$shift + panels$lower) / 2 > middle - 1e-6 * middle
  if (half) {
    panels$x <- panels$x - middle
    panels <- panels[pmax(panels$x + panels$upper, panels$x + panels$shift + panels$lower) > 1e-6, ]
  }
  corners <- t(vapply(seq_len(nrow(panels)), function(k) {
    p <- panels[k, ]
    x <- c(p$x, p$x + p$upper, p$x + p$shift + p$lower, p$x + p$shift)
    if (half) pmax(x, 0) else x
  }, numeric(4)))
  panels[c("ul", "ur", "lr", "ll")] <- corners
  inside <- half & pmax(abs(panels$ul), abs(panels$ll)) < 1e-6
  rates <- lapply(panels$name, function(name) {
    drawn_rates(si$panels[[name]], figure$panels[[name]])
  })
  panels$outer_rate <- vapply(rates, `[[`, "", "right")
  inner <- vapply(rates, `[[`, "", "left")
  # A whole panel with equal cutting rates on both sides is labelled once.
  panels$inner_rate <- ifelse(inside | (!half & inner == panels$outer_rate), "", inner)
  list(
    panels = panels, half = if (half) "right" else "", wall = wall, outer = "right",
    heading = column$heading, remark = column$alike, rows = TRUE, named = FALSE,
    joined = FALSE, turned = FALSE
  )
}

# TRUE if panels are side by side, except for a window in its row.
is_wall <- function(panels) {
  panels <- panels[!panels$hole, ]
  any(vapply(seq_len(nrow(panels)), function(k) {
    p <- panels[k, ]
    room <- 1e-6 * p$depth
    other <- panels[-k, ]
    beside <- pmin(abs(other$x - (p$x + p$upper)), abs(other$x + other$upper - p$x)) < room
    any(beside & abs(other$y - p$y) < room & other$upper > 0 & p$upper > 0)
  }, NA))
}

# Returns the label texts of every panel of a column (`panel_text()`). Different panels of the same
# part, such as a wing and its jib, get the last word of their names.
panel_labels <- function(column, si) {
  name <- column$panels$name
  words <- vapply(name, panel_text, character(4), si = si)
  told <- which(column$panels$labelled)
  for (part in unique(words["part", told])) {
    mine <- told[words["part", told] == part]
    if (ncol(unique(words[, mine, drop = FALSE], MARGIN = 2L)) < 2L) next
    last <- sub(".*_", "", name[mine])
    if (!anyDuplicated(last)) words["part", mine] <- last
  }
  words
}

# ---- all columns ---------------------------------------------------------------------------------

# Returns the netting list: a data frame, one row per make of netting.
netting_items <- function(columns) {
  rows <- do.call(rbind, lapply(columns, function(column) {
    told <- column$panels$labelled
    words <- column$words[, told, drop = FALSE]
    data.frame(
      panel = column$panels$name[told], where = column$heading, part = words[1, ],
      deep = words[2, ],
      mesh = words[3, ], twine = words[4, ]
    )
  }))
  rows <- rows[!duplicated(rows[-1L]), ]
  make <- paste(rows$part, rows$deep, rows$mesh, rows$twine)
  where <- vapply(make, function(m) {
    paste(sub(" panel", "", unique(rows$where[make == m]), fixed = TRUE), collapse = ", ")
  }, "")
  alone <- vapply(rows$part, function(part) length(unique(make[rows$part == part])) == 1L, NA)
  rows$name <- ifelse(alone, rows$part, paste0(rows$part, ", ", where))
  rows[!duplicated(make), ]
}

# Draws all columns from the left. scale: mm of sheet per metre of gear, along and deep; top: y of
# their top. Returns x of the right end, mm.
draw_columns <- function(sheet, columns, figure, scale, left, top, look, use) {
  at <- vapply(seq_along(columns), function(k) {
    reach <- column_reach(columns[[k]], figure, scale, look)
    if (!columns[[k]]$joined) left <<- left - reach[1L]
    here <- left
    joined <- k < length(columns) && columns[[k + 1L]]$joined
    if (!joined) left <<- left + reach[2L] + 4 * look$gap
    here
  }, 0)
  # All netting comes first, because labels of one half must not cover the other half.
  for (part in list(draw_netting, label_netting)) {
    for (k in seq_along(columns)) part(sheet, columns[[k]], figure, scale, c(at[k], top), look, use)
  }
  left - 4 * look$gap
}

columns_width <- function(columns, figure, scale, look) {
  each <- vapply(columns, column_reach, numeric(2), figure = figure, scale = scale, look = look)
  joined <- vapply(columns, `[[`, NA, "joined")
  # A joined pair extends left of the first and right of the second column.
  each[1, joined] <- 0
  each[2, which(joined) - 1L] <- 0
  sum(each[2, ] - each[1, ]) + 4 * look$gap * sum(!joined[-1L])
}

# Returns a lower bound of the columns' width (mm) without drawing them: netting, cutting rates and
# netting table.
least_width <- function(columns, scale, look) {
  each <- vapply(columns, function(column) {
    told <- column$panels$labelled
    p <- column$panels[told, ]
    right <- column$outer == "right"
    outer <- (if (right) p$ur + p$lr else -p$ul - p$ll) / 2
    inner <- if (nzchar(column$half)) 0 else max(-column$panels[c("ul", "ll")])
    if (column$wall) return(scale[1] * (max(outer) + inner))
    rows <- if (column$rows) {
      words <- column$words[, told, drop = FALSE]
      8 * look$gap + sum(column_widths(words, panel_columns$heading, look))
    }
    max(scale[1] * outer + look$gap + text_width(p$outer_rate, look$t)) + sum(rows) +
      scale[1] * inner
  }, 0)
  joined <- vapply(columns, `[[`, NA, "joined")
  sum(each) + 4 * look$gap * sum(!joined[-1L])
}

columns_height <- function(columns) {
  max(vapply(columns, function(c) max(c$panels$y + c$panels$depth), 0))
}

# Returns the extent of a column to the left and right of its x = 0 (mm), cached per scale and text
# size.
column_reach <- function(column, figure, scale, look) {
  key <- paste(column$number, column$named, look$t, paste(signif(scale, 12), collapse = " "))
  known <- figure$reaches[[key]]
  if (!is.null(known)) return(known)
  scratch <- new_sheet(c(1, 1))
  use <- new_page_use()
  draw_netting(scratch, column, figure, scale, c(0, 0), look, use)
  label_netting(scratch, column, figure, scale, c(0, 0), look, use)
  boxes <- vapply(scratch$items, item_box, numeric(4))
  figure$reaches[[key]] <- c(min(boxes[1, ]), max(boxes[3, ]))
}

# Height of the headings above the netting, in text lines: two lines of heading and the table's
# head.
heading_lines <- 4.2

draw_netting <- function(sheet, column, figure, scale, at, look, use) {
  panels <- column$panels
  x <- function(m) at[1] + scale[1] * m
  y <- function(m) at[2] - scale[2] * m
  for (k in seq_len(nrow(panels))) {
    p <- panels[k, ]
    cx <- x(c(p$ul, p$ur, p$lr, p$ll))
    cy <- y(p$y + c(0, 0, p$depth, p$depth))
    on_sheet(sheet, component = "panel", ref = paste0("panels.", p$name), layer = "NETTING",
      draw = sheet_polygon(sheet, cx, cy, sheet_fill, width = sheet_width[["middle"]]))
    take_lines(use, cx, cy, closed = TRUE)
    if (p$broken) {
      beyond <- if (column$wall || nzchar(column$half)) 0 else 1
      draw_break(sheet, x(min(p$ul, p$ll)) - beyond, x(max(p$ur, p$lr)) + beyond,
        y(p$y + p$depth / 3))
    }
  }
  span <- c(0, max(panels$y + panels$depth))
  if (nzchar(column$half)) {
    cy <- c(y(span[1]) + look$t, y(span[2]) - look$t)
    on_sheet(sheet, component = "centre_line", layer = "CENTRE_LINES",
      draw = sheet_line(sheet, x(c(0, 0)), cy, dash = c(6, 1.5, 1, 1.5)))
    take_lines(use, x(c(0, 0)), cy)
  }
  laced <- drawn_laced(column$laced, x, y)
  for (k in which(laced$thick)) {
    on_sheet(sheet, component = "rope", ref = paste0("ropes.", laced$rope[k]), layer = "ROPES",
      draw = sheet_line(sheet, c(laced$x0[k], laced$x1[k]), c(laced$y0[k], laced$y1[k]),
        sheet_width[["thick"]]))
  }
}

label_netting <- function(sheet, column, figure, scale, at, look, use) {
  panels <- column$panels
  x <- function(m) at[1] + scale[1] * m
  y <- function(m) at[2] - scale[2] * m
  if (column$wall) {
    label_wall(sheet, column, figure, x, y, look, use)
    draw_heading(sheet, column, x(min(panels$ul, panels$ll)), 0, at[2] + 7 * look$line, look,
      use)
  } else {
    label_column(sheet, column, figure, scale, at, look, use)
  }
  place_balloons(sheet, drawn_laced(column$laced, x, y), look, use)
}

# Draws the heading at the centre line of a half column, or at the left edge of a whole column.
draw_heading <- function(sheet, column, x, across, top, look, use) {
  remark <- c(if (nzchar(column$half)) paste(column$half, "half"), column$remark)
  wide <- max(text_width(column$heading, look$t, TRUE), text_width(paste(remark, collapse = ", "),
    look$t))
  take_box(use, c(x - across * wide, top + 1.9 * look$line, x + (1 - across) * wide,
    top + 3.9 * look$line))
  on_sheet(sheet, component = "heading", layer = "NAMES", draw = {
    sheet_text(sheet, x, top + 3.4 * look$line, column$heading, look$t, across, bold = TRUE)
    sheet_text(sheet, x, top + 2.4 * look$line, paste(remark[nzchar(remark)], collapse = ", "),
      look$t, across, italic = TRUE)
  })
}

draw_break <- function(sheet, left, right, y) {
  zigzag <- function(y) {
    at <- seq(left, right, length.out = 9L)
    list(x = at, y = y + rep_len(c(0, 0.8, 0, -0.8), 9L))
  }
  upper <- zigzag(y + 0.7)
  lower <- zigzag(y - 0.7)
  on_sheet(sheet, component = "break", layer = "NETTING", draw = {
    sheet_polygon(sheet, c(upper$x, rev(lower$x)), c(upper$y, rev(lower$y)), "white", NA)
    sheet_line(sheet, upper$x, upper$y)
    sheet_line(sheet, lower$x, lower$y)
  })
}

put_text <- function(sheet, use, x, y, text, look, across, component, ref = "", layer = "NAMES") {
  on_sheet(sheet, component = component, ref = ref, layer = layer,
    draw = sheet_text(sheet, x, y, text, look$t, across))
  wide <- text_width(text, look$t)
  take_box(use, c(x - across * wide, y - look$line / 2, x + (1 - across) * wide,
    y + look$line / 2))
}

label_column <- function(sheet, column, figure, scale, at, look, use) {
  panels <- column$panels
  sign <- if (column$outer == "left") -1 else 1
  towards <- if (sign < 0) 1 else 0
  counted <- put_counts(sheet, column, scale, at, look, use)
  inner <- put_inner_rates(sheet, column, scale, at, look, use)
  rows <- which(panels$labelled)
  middle <- at[2] - scale[2] * (panels$y[rows] + panels$depth[rows] / 2)
  # Panels side by side with the same netting, such as two wings of a whole panel, share a line.
  key <- paste(round(middle, 3), apply(column$words[, rows, drop = FALSE], 2L, toString))
  line <- match(key, key)
  y <- middle
  firsts <- unique(line)
  y[firsts] <- spread_labels(middle[firsts], look$line, -Inf, at[2])
  y <- y[line]
  ends <- numeric(length(rows))
  for (k in seq_along(rows)) {
    p <- panels[rows[k], ]
    ref <- paste0("panels.", p$name)
    counts <- unique(column$counts[, rows[k]])
    words <- c(
      if (column$named) column$words["part", rows[k]],
      if (!counted[rows[k]]) paste(counts, collapse = "/"), p$outer_rate,
      if (nzchar(inner[rows[k]])) paste("inner", inner[rows[k]])
    )
    words <- paste(words[nzchar(words)], collapse = " ")
    edge <- outer_edge(column, scale, at, y[k] + c(-0.5, 0.5) * look$line)
    x <- edge + sign * look$gap
    if (!any(line[seq_len(k - 1L)] == line[k])) {
      put_text(sheet, use, x, y[k], words, look, towards, "cutting", paste0(ref, ".cutting"),
        "CUTTING")
    }
    ends[k] <- x + sign * text_width(words, look$t)
    if (abs(y[k] - middle[k]) > 0.3 * look$line) {
      own <- outer_edge(column, scale, at, middle[k] + c(-0.01, 0.01))
      on_sheet(sheet, component = "leader", layer = "NAMES",
        draw = sheet_line(sheet, c(own, x - sign * 0.2 * look$gap), c(middle[k], y[k])))
    }
  }
  if (column$rows) {
    put_rows(sheet, column, rows[!duplicated(line)], y[!duplicated(line)],
      at[2], sign * max(sign * ends) + sign * 2 * look$gap, look)
  }
  x <- if (nzchar(column$half)) at[1] - towards * 2 * look$gap else {
    at[1] + scale[1] * min(panels$ul, panels$ll)
  }
  across <- if (sign < 0) 1 else 0
  draw_heading(sheet, column, x + if (sign > 0 && nzchar(column$half)) look$gap else 0, across,
    at[2], look, use)
}

outer_edge <- function(column, scale, at, heights) {
  p <- column$panels
  right <- column$outer == "right"
  upper <- at[1] + scale[1] * (if (right) p$ur else p$ul)
  lower <- at[1] + scale[1] * (if (right) p$lr else p$ll)
  top <- at[2] - scale[2] * p$y
  deep <- scale[2] * p$depth
  share <- function(h) pmin(pmax((top - h) / deep, 0), 1)
  met <- top >= min(heights) & top - deep <= max(heights)
  if (!any(met)) met <- which.min(abs(top - deep - mean(heights)))
  found <- c(
    (upper + share(heights[1]) * (lower - upper))[met],
    (upper + share(heights[2]) * (lower - upper))[met]
  )
  if (right) max(found) else min(found)
}

# Draws mesh counts at the upper and lower edges of panels with enough space. Returns TRUE for each
# panel that needs no further count.
put_counts <- function(sheet, column, scale, at, look, use) {
  panels <- column$panels
  vapply(seq_len(nrow(panels)), function(k) {
    p <- panels[k, ]
    if (!p$labelled) return(TRUE)
    texts <- column$counts[, k]
    deep <- scale[2] * p$depth
    down <- 0.95 * look$t
    wide <- function(share) scale[1] * ((1 - share) * (p$ur - p$ul) + share * (p$lr - p$ll))
    share <- c(1.6 * look$t / deep, 1 - 1.6 * look$t / deep)
    fits <- deep > 4.2 * look$t && all(
      (vapply(share, wide, 0) > text_width(texts, look$t) + 2 * look$gap) | texts == "0"
    )
    if (!fits) return(FALSE)
    for (e in 1:2) {
      if (texts[e] == "0") next
      f <- c(down / deep, 1 - down / deep)[e]
      left <- (1 - f) * p$ul + f * p$ll
      right <- (1 - f) * p$ur + f * p$lr
      put_text(sheet, use, at[1] + scale[1] * (left + right) / 2, at[2] - scale[2] *
        (p$y + f * p$depth), texts[e], look, 0.5, "meshes",
        paste("panels", p$name, "meshes", c("upper", "lower")[e], sep = "."), "COUNTS")
    }
    TRUE
  }, NA)
}

# Draws the cutting rates of edges that face the centre line, or of the left edge of a whole panel.
# The text goes next to the edge or inside the panel. Returns the rates without free space, "" for
# all other panels.
put_inner_rates <- function(sheet, column, scale, at, look, use) {
  panels <- column$panels
  left_over <- rep("", nrow(panels))
  for (k in which(panels$labelled & nzchar(panels$inner_rate))) {
    p <- panels[k, ]
    right <- column$outer == "right"
    ends <- if (right) c(p$ul, p$ll) else c(p$ur, p$lr)
    text <- p$inner_rate
    size <- c(text_width(text, look$t) + look$gap, look$line)
    f <- c(0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1)
    y <- at[2] - scale[2] * (p$y + f * p$depth)
    edge <- at[1] + scale[1] * (ends[1] + f * (ends[2] - ends[1]))
    slope <- abs(scale[1] * (ends[2] - ends[1])) / (scale[2] * p$depth) * look$line / 2
    away <- size[1] / 2 + look$gap + slope
    sign <- if (right) -1 else 1
    other <- if (right) c(p$ur, p$lr) else c(p$ul, p$ll)
    wide <- scale[1] * abs((1 - f) * (other[1] - ends[1]) + f * (other[2] - ends[2]))
    within <- function(far) which(far + size[1] / 2 < wide)
    near <- away + 4 * look$t
    places <- rbind(
      cbind(edge + sign * away, y), cbind(edge - sign * away, y)[within(away), ],
      cbind(edge + sign * near, y), cbind(edge - sign * near, y)[within(near), ]
    )
    # The space beyond the centre line is reserved for the other half.
    own <- !nzchar(column$half) | -sign * (places[, 1] - at[1]) >= size[1] / 2
    where <- find_space(use, places[own, , drop = FALSE], size)
    if (is.null(where)) {
      left_over[k] <- text
      next
    }
    on_sheet(sheet, component = "cutting", ref = paste0("panels.", p$name, ".cutting"),
      layer = "CUTTING", draw = sheet_text(sheet, where[1], where[2], text, look$t, 0.5))
  }
  left_over
}

put_rows <- function(sheet, column, rows, y, top, near, look) {
  words <- column$words[, rows, drop = FALSE]
  wide <- column_widths(words, panel_columns$heading, look)
  left <- if (column$outer == "left") near - sum(wide) - 6 * look$gap else near
  at <- left + cumsum(c(0, wide[-4L] + 2 * look$gap)) + panel_columns$across * wide
  on_sheet(sheet, component = "heading", layer = "TABLES", draw = for (c in seq_len(4L)) {
    sheet_text(sheet, at[c], top + 1.2 * look$line, panel_columns$heading[c], look$t,
      panel_columns$across[c], italic = TRUE)
  })
  put_string(sheet, words, panel_columns, paste0("panels.", column$panels$name[rows]), at, y, look)
}

# ---- walls ---------------------------------------------------------------------------------------

# Labels panels that are side by side: inside the panel, or below or above the wall with a leader.
label_wall <- function(sheet, column, figure, x, y, look, use) {
  panels <- column$panels
  words <- lapply(panels$name, wall_text, si = figure$si)
  middle <- x((panels$ul + panels$ur + panels$ll + panels$lr) / 4)
  room <- x(pmin(panels$ur, panels$lr)) - x(pmax(panels$ul, panels$ll)) - 2 * look$gap
  deep <- y(panels$y) - y(panels$y + panels$depth)
  out <- integer()
  for (k in seq_len(nrow(panels))) {
    for (lines in list(1:4, c(1, 1, 2, 2), c(1, 1, 1, 1))) {
      wide <- vapply(split(words[[k]], lines), function(w) {
        sum(text_width(w, look$t)) + (length(w) - 1) * 2 * look$gap
      }, 0)
      fits <- max(wide) < room[k] && deep[k] > (max(lines) + 1.2) * look$line
      if (fits) break
    }
    if (!fits) {
      out <- c(out, k)
      next
    }
    top <- (y(panels$y[k]) + y(panels$y[k] + panels$depth[k]) + max(lines) * look$line) / 2
    put_wall_text(sheet, use, panels$name[k], words[[k]], lines, middle[k], top, look)
  }
  if (length(out)) lead_wall_text(sheet, use, panels, words, out, x, y, look)
}

# lines: the line number of each text; top: y of the first line.
put_wall_text <- function(sheet, use, name, words, lines, x, top, look) {
  ref <- paste0("panels.", name, c("", ".meshes.upper", ".mesh_size", ".twine.diameter"))
  component <- c("panel", "meshes", "mesh_size", "twine")
  for (l in unique(lines)) {
    mine <- which(lines == l)
    wide <- text_width(words[mine], look$t)
    left <- x - (sum(wide) + (length(mine) - 1) * 2 * look$gap) / 2
    for (m in seq_along(mine)) {
      put_text(sheet, use, left, top - (l - 0.5) * look$line, words[mine[m]], look, 0,
        component[mine[m]], ref[mine[m]])
      left <- left + wide[m] + 2 * look$gap
    }
  }
}

# Draws the labels that do not fit into their panels in rows below and above the wall, with leaders.
lead_wall_text <- function(sheet, use, panels, words, out, x, y, look) {
  wide <- vapply(words, function(w) max(text_width(w, look$t)), 0) + 2 * look$gap
  middle <- x((panels$ul + panels$ur + panels$ll + panels$lr) / 4)
  high <- 4 * look$line
  out <- out[order(middle[out], panels$y[out])]
  span <- range(x(c(panels$ul, panels$ll)), x(c(panels$ur, panels$lr)))
  step <- max(wide[out])
  # Panels in the upper half of the wall are labelled above it.
  centre <- panels$y + panels$depth / 2
  sides <- 1L + (centre[out] < mean(range(panels$y, panels$y + panels$depth)) - 1e-6)
  for (side in unique(sides)) {
    mine <- out[sides == side]
    cx <- spread_labels(middle[mine], step, span[1] + step / 2, span[2] - step / 2)
    edge <- if (side == 1L) min(y(panels$y + panels$depth)) else max(y(panels$y))
    top <- if (side == 1L) edge - 3 * look$line else edge + 3 * look$line + high
    for (k in seq_along(mine)) {
      p <- panels[mine[k], ]
      put_wall_text(sheet, use, p$name, words[[mine[k]]], 1:4, cx[k], top, look)
      # The leader ends inside its panel and is vertical if possible.
      side_of <- x(c(max(p$ul, p$ll), min(p$ur, p$lr)))
      start <- c(cx[k], if (side == 1L) top else top - high)
      end <- clear_end(use, start, side_of[1] + diff(side_of) * c(0.5, 0.35, 0.65, 0.2, 0.8),
        y(p$y + p$depth / 2))
      on_sheet(sheet, component = "leader", layer = "NAMES", draw = {
        sheet_line(sheet, c(end[1], start[1]), c(end[2], start[2]))
        sheet_circle(sheet, end[1], end[2], 0.3, sheet_ink)
      })
      take_lines(use, c(end[1], start[1]), c(end[2], start[2]))
    }
  }
}

# Returns the end of a leader at height y that crosses no text: straight above or below its start if
# possible, otherwise at the first suitable x. The first candidate is the fallback.
clear_end <- function(use, start, x, y) {
  if (start[1] >= min(x) && start[1] <= max(x)) x <- c(start[1], x)
  inner <- use$boxes + rep(c(0.3, 0.3, -0.3, -0.3), each = nrow(use$boxes))
  for (one in x) {
    line <- matrix(c(start, one, y), 1L)
    if (!any(lines_cross_box(line, inner))) return(c(one, y))
  }
  c(x[1], y)
}

# ---- scale ---------------------------------------------------------------------------------------

# Usual drawing scales: 1 to these numbers times powers of ten.
scale_steps <- c(1, 1.25, 1.5, 1.75, 2, 2.5, 3, 3.5, 4, 4.5, 5, 6, 7, 8, 9)

scale_series <- function(least) {
  all <- as.vector(outer(scale_steps, 10^(-1:5)))
  all[all >= least * (1 - 1e-9)]
}

# Returns the largest usual scale at which the columns fit: mm of sheet per metre of gear, along and
# deep. NULL if they do not fit or the product of both does not exceed `least`. true_size: TRUE for
# equal scales.
fitting_scale <- function(columns, figure, room, height, look, true_size = FALSE, least = 0) {
  deepest <- columns_height(columns)
  wall <- any(vapply(columns, `[[`, NA, "wall"))
  above <- heading_lines * look$line
  height <- height - above - 3 * look$line - if (wall) 14 * look$line else 0
  if (height <= 0) return(NULL)
  across <- sum(vapply(columns, function(c) {
    max(c$panels$ur, c$panels$lr) - min(c$panels$ul, c$panels$ll)
  }, 0))
  alone <- length(columns) == 1L && !nzchar(columns[[1]]$half)
  if (alone && !true_size && across > 6 * deepest) {
    # A long wall gets different scales along and deep, with a ratio of at most 20.
    side <- if (wall) 4 * look$gap else columns_width(columns, figure, c(1e-6, 1e-6), look)
    free <- room - side - 2 * look$gap
    if (free <= 0) return(NULL)
    long <- 1000 / scale_series(1000 * across / free)[1]
    deep <- 1000 / scale_series(1000 * deepest / min(height, 0.6 * room))[1]
    return(c(long, min(deep, 20 * long)))
  }
  tried <- scale_series(1000 * max(deepest / height, across / room))
  # Columns that fit at a scale may not fit at a smaller one, because counts move out of small
  # panels.
  for (one in utils::head(tried, 14L)) {
    scale <- rep(1000 / one, 2L)
    if (prod(scale) <= least) break
    if (least_width(columns, scale, look) > room) next
    if (columns_width(columns, figure, scale, look) <= room) return(scale)
  }
  NULL
}

width_rule <- function(figure) {
  hung <- !is.na(colSums(hung_widths(figure$si, figure$layout$joints)))
  square <- vapply(figure$si$panels, function(p) p$orientation == "square", NA) & !hung
  said <- c(
    if (any(hung)) "as hung on its ropes", if (any(!hung & !square)) "at a hanging ratio of 0.5",
    if (any(square)) "square meshes open"
  )
  paste0("Netting stretched in depth; in width ", paste(said, collapse = " or "), ".")
}
