# The netting of a plan drawing: columns of trapezia with their counts, cutting rates and ropes.
# Lengths on the page in inches.

plan_label_gap <- 0.06
plan_line <- 0.105
plan_note <- 0.125
column_gap <- 0.12
# A wall this many times as long as deep has a scale of its own along it.
longest_wall <- 5

draw_flat_netting <- function(figure, frame) {
  drawn <- best_draft(figure, frame)
  columns <- drawn$columns
  scale <- drawn$scale
  pen$sheet$scale <- 1000 / (scale[2] * 25.4)
  use <- new_page_use()
  left <- frame[1] + sum(drawn$widths)
  for (k in seq_along(columns)) {
    reach <- column_reach(columns[[k]], scale)
    columns[[k]]$at <- c(left - reach[1L], drawn$top)
    left <- left + diff(reach) + column_gap
  }
  if (!is.null(drawn$rows)) draw_rows(drawn, frame[1], columns[[1L]])
  for (column in columns) draw_column(column, figure, scale, use)
  draw_notes(drawn$notes, frame)
  draw_scale(scale, frame, width_rule(figure))
}

# How wide the netting is drawn, in words.
width_rule <- function(figure) {
  hung <- !is.na(colSums(hung_widths(figure$si, figure$layout$joints)))
  square <- vapply(figure$si$panels, function(p) p$orientation == "square", NA) & !hung
  said <- c(
    if (any(hung)) "as hung on its ropes", if (any(!hung & !square)) "at a hanging ratio of 0.5",
    if (any(square)) "square meshes open"
  )
  paste0("Netting stretched in depth; in width ", paste(said, collapse = " or "), ".")
}

# How panels are explained: in a table beside them, where all columns agree; by numbers and notes
# below, with counts and cutting rates at their edges; or in the notes alone.
plan_ways <- c("table", "edges", "notes")

# The drawing in the first of these ways that is not much smaller than in the next; symmetric
# columns whole, or halved where that helps.
#
# Returns list(columns, rows (of the table, or NULL), widths (of its columns), notes, scale, top,
# bottom).
best_draft <- function(figure, frame) {
  flat <- shorten_longest(figure$layout$panels)
  top <- frame[4] - 0.42
  draft <- function(way, halve) {
    columns <- lapply(seq_len(nrow(figure$layout$columns)), function(k) {
      flat_column(flat[flat$column == k, ], figure$layout$columns[k, ], figure$si, halve)
    })
    rows <- if (way == "table") shared_rows(columns, figure$si)
    if (way == "table" && is.null(rows)) return(NULL)
    detail <- way != "notes"
    if (is.null(rows)) columns <- number_panels(columns, figure$si, detail)
    notes <- if (is.null(rows)) arrange_notes(panel_notes(columns, figure$si, detail), frame)
    bottom <- frame[2] + 0.45 + if (is.null(rows)) plan_note * nrow(notes) + 0.1 else 0
    widths <- table_widths(rows)
    list(
      columns = columns, rows = rows, widths = widths, notes = notes, top = top, bottom = bottom,
      scale = fitting_scale(columns, frame[3] - frame[1] - sum(widths), top - bottom,
        max(flat$y + flat$depth))
    )
  }
  larger <- function(one, other, much) {
    if (is.null(one) || other$scale[2] > much * one$scale[2]) other else one
  }
  best <- NULL
  for (way in plan_ways) {
    whole <- draft(way, FALSE)
    if (is.null(whole)) next
    if (whole$scale[1] >= whole$scale[2]) whole <- larger(whole, draft(way, TRUE), 1.15)
    best <- larger(best, whole, 1.8)
  }
  best
}

# Panels with the longest drawn shorter where it makes up most of the length of several: `broken`
# marks it.
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

# A column ready to draw: list(panels (with corners ul, ur, lr, ll, labels and tag), heading,
# remark, half, wall (panels side by side), detail (whether counts and rates stand at its edges)).
# In a half column x starts at its middle.
flat_column <- function(panels, column, si, halve) {
  wall <- any(beside_another(panels))
  half <- halve && column$symmetric && !wall
  middle <- max(panels$x + panels$upper, panels$x + panels$shift + panels$lower) / 2
  # Of two mirror images the right one has the labels.
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
  rates <- lapply(panels$name, function(name) panel_rates(si$panels[[name]]))
  meshes <- t(vapply(si$panels[panels$name], function(p) c(p$upper, p$lower), numeric(2)))
  panels$across_upper <- mesh_number(meshes[, 1])
  panels$across_lower <- mesh_number(meshes[, 2])
  panels$right_rate <- vapply(rates, `[[`, "", "right")
  left_rate <- vapply(rates, `[[`, "", "left")
  panels$left_rate <- ifelse(inside | left_rate == panels$right_rate, "", left_rate)
  panels$tag <- ""
  list(
    panels = panels, half = half, wall = wall, detail = !wall,
    heading = column$heading,
    remark = paste(c(if (half) "right half", Filter(nzchar, column$alike)), collapse = ", ")
  )
}

# Which panels touch another along a side edge.
beside_another <- function(panels) {
  vapply(seq_len(nrow(panels)), function(k) {
    p <- panels[k, ]
    room <- 1e-6 * p$depth
    other <- panels[-k, ]
    beside <- pmin(abs(other$x - (p$x + p$upper)), abs(other$x + other$upper - p$x)) < room
    any(beside & abs(other$y - p$y) < room & other$upper > 0 & p$upper > 0)
  }, NA)
}

# ---- scale ---------------------------------------------------------------------------------------

# The largest scale (inches per metre, along x and y) at which everything has room.
fitting_scale <- function(columns, room, height, deepest) {
  across <- vapply(columns, function(c) max(c$panels$ur, c$panels$lr) - min(c$panels$ul), 0)
  if (any(vapply(columns, `[[`, NA, "wall")) || length(columns) == 1L) {
    if (sum(across) > longest_wall * deepest) {
      long <- (room - 0.4) / sum(across)
      return(c(long, min(0.4 * height / deepest, 20 * long)))
    }
  }
  low <- 0
  high <- height / deepest
  needs <- function(s) {
    sum(vapply(columns, function(c) diff(column_reach(c, c(s, s))) + column_gap, 0)) - column_gap
  }
  if (needs(high) > room) {
    for (pass in 1:20) {
      s <- (low + high) / 2
      if (needs(s) <= room) low <- s else high <- s
    }
    high <- low
  }
  c(high, high)
}

# How far a column with its labels reaches left and right of its x = 0, inches.
column_reach <- function(column, scale) {
  panels <- column$panels
  left <- scale[1] * min(panels$ul, panels$ll)
  right <- scale[1] * max(panels$ur, panels$lr)
  heading <- pen_width(column$heading, cex = plan_text[["heading"]], font = 2)
  if (column$wall) return(c(left - 0.05, max(right, left + heading) + 0.05))
  said <- side_labels(column, scale)
  wide <- function(text) pen_width(text, cex = plan_text[["label"]])
  left <- min(left, said$left_x - plan_label_gap - wide(said$left))
  right <- max(right, said$right_x + plan_label_gap + wide(said$right), left + heading)
  c(left - 0.02, right)
}

# Labels left and right of a column's panels: a data frame with left, right (text), left_x, right_x
# and y (of the middle of the edges, inches from the column's origin), middle (text within the
# panel), inside (whether the counts have room within the panel).
side_labels <- function(column, scale) {
  panels <- column$panels
  wide <- function(text) pen_width(text, cex = plan_text[["label"]])
  upper <- scale[1] * (panels$ur - panels$ul)
  lower <- scale[1] * (panels$lr - panels$ll)
  inside <- scale[2] * panels$depth > 2 * plan_line + 0.03 &
    (upper > wide(panels$across_upper) + 0.06 | panels$across_upper == "0") &
    (lower > wide(panels$across_lower) + 0.06 | panels$across_lower == "0")
  counts <- ifelse(panels$across_upper == panels$across_lower, panels$across_upper,
    paste0(panels$across_upper, "/", panels$across_lower))
  # How far a slanting edge comes towards a label beside its middle.
  clear <- function(across) {
    abs(scale[1] * across) * pmin(plan_line / 2 / (scale[2] * panels$depth), 0.5)
  }
  # The number of a panel stands in its middle where three lines fit.
  roomy <- inside & scale[2] * panels$depth > 3 * plan_line + 0.03
  outside <- ifelse(nzchar(panels$tag) & !roomy, panels$tag, "")
  if (column$detail) {
    outside <- trimws(paste(outside, ifelse(inside, "", counts), panels$right_rate))
  }
  data.frame(
    # Between wings there is little room.
    left = ifelse(column$detail & panels$labelled,
      sub("+", "+\n", panels$left_rate, fixed = TRUE), ""),
    right = ifelse(panels$labelled, gsub(" +", " ", outside), ""),
    middle = ifelse(roomy, panels$tag, ""),
    left_x = scale[1] * (panels$ul + panels$ll) / 2 - clear(panels$ul - panels$ll),
    right_x = scale[1] * (panels$ur + panels$lr) / 2 + clear(panels$ur - panels$lr),
    y = -scale[2] * (panels$y + panels$depth / 2), inside = inside
  )
}

# ---- columns -------------------------------------------------------------------------------------

draw_column <- function(column, figure, scale, use) {
  panels <- column$panels
  x <- function(m) column$at[1] + scale[1] * m
  y <- function(m) column$at[2] - scale[2] * m
  for (k in seq_len(nrow(panels))) {
    p <- panels[k, ]
    on_sheet(pen$sheet, component = "panel", ref = paste0("panels.", p$name), draw = {
      pen_polygon(x(c(p$ul, p$ur, p$lr, p$ll)), y(p$y + c(0, 0, p$depth, p$depth)),
        border = plan_ink, lwd = 0.8, col = "#F2F4F6")
    })
    beyond <- if (column$wall) 0 else 0.05
    if (p$broken) {
      draw_break(x(min(p$ul, p$ll)) - beyond, x(max(p$ur, p$lr)) + beyond, y(p$y + p$depth / 3))
    }
  }
  if (column$half) {
    span <- range(panels$y, panels$y + panels$depth)
    pen_segments(x(0), y(span[1]) + 0.12, x(0), y(span[2]) - 0.12, lty = "1242", lwd = 0.8)
  }
  left <- x(min(panels$ul, panels$ll))
  pen_text(left, column$at[2] + 0.34, column$heading, adj = c(0, 0.5), font = 2,
    cex = plan_text[["heading"]])
  pen_text(left, column$at[2] + 0.22, column$remark, adj = c(0, 0.5), font = 3,
    cex = plan_text[["label"]])
  laced <- drawn_laced(column, figure, x, y)
  for (k in which(laced$thick)) {
    pen_segments(laced$x0[k], laced$y0[k], laced$x1[k], laced$y1[k], lwd = 2.6)
  }
  if (column$wall) label_wall(column, x, y, use) else label_column(column, scale, x, y, use)
  place_balloons(laced, use)
}

draw_break <- function(left, right, y) {
  zigzag <- function(y) {
    at <- seq(left, right, length.out = 9L)
    list(x = at, y = y + rep_len(c(0, 0.03, 0, -0.03), 9L))
  }
  upper <- zigzag(y + 0.025)
  lower <- zigzag(y - 0.025)
  pen_polygon(c(upper$x, rev(lower$x)), c(upper$y, rev(lower$y)), col = "white", border = NA)
  pen_lines(upper, lwd = 0.6)
  pen_lines(lower, lwd = 0.6)
}

label_text <- function(x, y, text, adj, use) {
  cex <- plan_text[["label"]]
  pen_text(x, y, text, adj = c(adj, 0.5), cex = cex)
  wide <- pen_width(text, cex = cex)
  half <- plan_line / 2 * lengths(strsplit(text, "\n", fixed = TRUE))
  take_box(use, c(x - adj * wide, y - half, x + (1 - adj) * wide, y + half))
}

label_column <- function(column, scale, x, y, use) {
  panels <- column$panels
  said <- side_labels(column, scale)
  high <- column$at[2]
  for (k in which(said$inside)) {
    p <- panels[k, ]
    centred <- if (column$half && p$ul < 1e-6) NA else 0.5
    put <- function(from, to, y, text, edge) {
      if (text == "0") return(invisible())
      ref <- paste("panels", p$name, "meshes", edge, sep = ".")
      on_sheet(pen$sheet, component = "meshes", ref = ref, draw = {
        if (is.na(centred)) label_text(x(from) + 0.04, y, text, 0, use)
        else label_text(x((from + to) / 2), y, text, 0.5, use)
      })
    }
    put(p$ul, p$ur, y(p$y) - plan_line / 2 - 0.01, p$across_upper, "upper")
    put(p$ll, p$lr, y(p$y + p$depth) + plan_line / 2 + 0.01, p$across_lower, "lower")
    if (nzchar(said$middle[k])) {
      label_text(x((p$ul + p$ur + p$ll + p$lr) / 4), y(p$y + p$depth / 2), said$middle[k], 0.5, use)
    }
  }
  at <- spread_labels(high + said$y, plan_line, -Inf, high)
  for (k in which(nzchar(said$right))) {
    edge <- column$at[1] + said$right_x[k]
    label_text(edge + plan_label_gap, at[k], said$right[k], 0, use)
    if (abs(at[k] - high - said$y[k]) > 0.03) {
      pen_segments(edge + 0.01, high + said$y[k], edge + plan_label_gap - 0.01, at[k],
        lwd = 0.4, col = "grey40")
    }
  }
  for (k in which(nzchar(said$left))) {
    edge <- column$at[1] + said$left_x[k]
    label_text(edge - plan_label_gap, high + said$y[k], said$left[k], 1, use)
  }
}

# ---- scale bar and what holds for all ------------------------------------------------------------

# rule: how wide netting is drawn.
draw_scale <- function(scale, frame, rule) {
  cex <- plan_text[["label"]]
  bar <- function(left, per_metre, words) {
    lengths <- as.vector(outer(c(1, 2, 5), 10^(-4:4)))
    length <- max(lengths[lengths * per_metre <= 1.3])
    ends <- left + c(0, 0.5, 1) * length * per_metre
    y <- frame[2] + 0.1
    pen_rect(ends[1:2], y, ends[2:3], y + 0.04, col = c(plan_ink, "white"),
      border = plan_ink, lwd = 0.6)
    pen_text(ends[c(1, 3)], y + 0.1, c("0", paste(short_number(length), "m")), cex = cex)
    said <- paste0(words, "1 : ", short_number(39.37 / (per_metre), 3))
    pen_text(ends[3] + 0.2, y + 0.03, said, adj = c(0, 0.5), cex = cex)
    ends[3] + 0.2 + pen_width(said, cex = cex)
  }
  left <- frame[1] + 0.05
  if (scale[1] == scale[2]) {
    left <- bar(left, scale[1], "")
  } else {
    left <- bar(left, scale[1], "along ")
    left <- bar(left + 0.35, scale[2], "deep ")
  }
  rules <- c(
    rule, "Numbers at edges: meshes across the whole panel (upper/lower). N, T, B: cutting rate."
  )
  pen_text(left + 0.3, frame[2] + c(0.12, 0.02), rules, adj = c(0, 0.5), cex = 0.9 * cex,
    font = 3)
}
