# Returns the ropes and pieces along a column's panels as straight lines. Columns: label, square
# (TRUE for a piece), thick (TRUE for a rope), rope, x0, y0, x1, y1 (m).
column_laced <- function(column, figure) {
  ropes <- figure$layout$laced
  ropes$label <- as.character(figure$ropes$item[match(ropes$kind, figure$ropes$kind)])
  ropes$square <- rep(FALSE, nrow(ropes))
  all <- rbind(ropes, laced_pieces(figure))
  all <- all[all$panel %in% column$panels$name, ]
  panels <- column$panels[match(all$panel, column$panels$name), ]
  sign <- if (column$turned) -1 else 1
  ends <- vapply(seq_len(nrow(all)), function(k) {
    a <- edge_point(panels[k, ], all$edge[k], all$from[k])
    b <- edge_point(panels[k, ], all$edge[k], all$to[k])
    # Half a column keeps the lines to the right of the middle.
    if (nzchar(column$half)) {
      if (max(a[1], b[1]) < -1e-6) return(rep(NA_real_, 4L))
      if (a[1] < 0) a <- b + (a - b) * b[1] / (b[1] - a[1])
      if (b[1] < 0) b <- a + (b - a) * a[1] / (a[1] - b[1])
    }
    c(sign * a[1], a[2], sign * b[1], b[2])
  }, numeric(4))
  ends <- matrix(ends, 4L)
  lines <- data.frame(
    label = all$label, square = all$square, thick = !all$square, rope = all$rope,
    x0 = ends[1, ], y0 = ends[2, ], x1 = ends[3, ], y1 = ends[4, ]
  )
  lines[!is.na(lines$x0), ]
}

drawn_laced <- function(lines, x, y) {
  lines[c("x0", "x1")] <- lapply(lines[c("x0", "x1")], x)
  lines[c("y0", "y1")] <- lapply(lines[c("y0", "y1")], y)
  lines[sqrt((lines$x1 - lines$x0)^2 + (lines$y1 - lines$y0)^2) > 1e-3, ]
}

# Returns pieces spread along ropes or edges, in the form of `laced_edges()` with their letters.
laced_pieces <- function(figure) {
  laced <- figure$layout$laced
  rows <- lapply(names(figure$si$pieces), function(name) {
    along <- figure$si$pieces[[name]]$along
    if (is.null(along)) return(NULL)
    mine <- if (along$kind == "rope") laced[laced$rope == along$name, ] else {
      do.call(rbind, lapply(along$edges, function(e) {
        data.frame(rope = "", kind = "", panel = e$panel, edge = e$edge, from = e$from, to = e$to)
      }))
    }
    if (!nrow(mine)) return(NULL)
    item <- vapply(figure$pieces$parts, function(parts) name %in% parts, NA)
    cbind(mine, label = figure$pieces$item[item], square = TRUE)
  })
  do.call(rbind, rows)
}

# Draws a balloon for each label of a column, on its longest line with free space.
place_balloons <- function(sheet, lines, look, use) {
  for (label in unique(lines$label)) {
    mine <- lines[lines$label == label, ]
    mine <- mine[order(-sqrt((mine$x1 - mine$x0)^2 + (mine$y1 - mine$y0)^2)), ]
    share <- c(0.5, 0.62, 0.38, 0.74, 0.26, 0.86, 0.14, 0.95, 0.05)
    on <- do.call(rbind, lapply(seq_len(min(8L, nrow(mine))), function(k) {
      cbind(
        mine$x0[k] + share * (mine$x1[k] - mine$x0[k]),
        mine$y0[k] + share * (mine$y1[k] - mine$y0[k])
      )
    }))
    size <- rep(2 * look$balloon + 0.4, 2L)
    at <- find_space(use, on, size, lines = FALSE)
    if (is.null(at)) {
      # Otherwise the balloon goes next to its line, with a leader.
      far <- 2.6 * look$balloon * rbind(c(-1, 0), c(1, 0), c(0, 1), c(0, -1))
      away <- do.call(rbind, lapply(1:3, function(m) {
        do.call(rbind, lapply(1:4, function(d) on + rep(m * far[d, ], each = nrow(on))))
      }))
      at <- find_space(use, away, size, from = on)
      if (is.null(at)) next
      near <- nearest_point(on, at)
      on_sheet(sheet, component = "leader", layer = "NAMES",
        draw = sheet_line(sheet, c(near[1], at[1]), c(near[2], at[2])))
    }
    square <- mine$square[1L]
    on_sheet(sheet, component = if (square) "piece" else "rope",
      ref = if (square || !nzchar(mine$rope[1L])) "" else paste0("ropes.", mine$rope[1L]),
      layer = if (square) "PIECES" else "ROPES",
      draw = draw_balloon(sheet, at[1], at[2], label, look, square))
  }
}

# ---- ropes laid straight -------------------------------------------------------------------------

# Returns the ropes along the netting that are also drawn straight, at most five. Each is a list.
# `item`, `name`: its row of the rope list and its name. `parts`: data frame of words and length
# (m), one row per part of the net. `pieces`: data frame of the pieces along it (`pieces_along()`),
# or NULL.
straight_ropes <- function(figure) {
  si <- figure$si
  found <- lapply(which(figure$ropes$laced), function(k) {
    item <- figure$ropes[k, ]
    parts <- rope_parts(item$first, si)
    pieces <- pieces_along(item$first, figure)
    mouth <- grepl("headline|footrope|ground gear|float line|lead line", item$name)
    if (is.null(pieces) && (!mouth || nrow(parts) < 2L)) return(NULL)
    list(item = item, name = item$first, parts = parts, pieces = pieces)
  })
  utils::head(Filter(Negate(is.null), found), 5L)
}

# Returns the lengths (m) of a rope along consecutive parts of the net. Edges of the same part are
# merged.
rope_parts <- function(name, si) {
  rope <- si$ropes[[name]]
  along <- rope$along
  netting <- vapply(seq_along(along), function(k) chain_length(along[k], si$panels), 0)
  share <- if (is.null(rope$shares)) netting / sum(netting) else rope$shares
  panel <- vapply(along, `[[`, "", "panel")
  edge <- vapply(along, `[[`, "", "edge")
  part <- vapply(panel, function(p) first_of(si$panels[[p]]$part, NA_character_), "")
  words <- ifelse(part %in% "wings", "wing",
    ifelse(edge %in% c("upper", "lower") & any(part %in% "wings"), "bosom", ""))
  key <- paste(words, ifelse(nzchar(words), sub("^[^_]*_", "", panel), ""))
  run <- cumsum(c(TRUE, key[-1L] != key[-length(key)]))
  data.frame(
    words = words[!duplicated(run)], length = as.vector(tapply(share * rope$length, run, sum))
  )
}

pieces_along <- function(rope, figure) {
  rows <- lapply(names(figure$si$pieces), function(name) {
    piece <- figure$si$pieces[[name]]
    if (!identical(piece$along$kind, "rope") || !identical(piece$along$name, rope)) return(NULL)
    item <- which(vapply(figure$pieces$parts, function(parts) name %in% parts, NA))[1]
    disc <- figure$discs[[name]]
    data.frame(
      letter = figure$pieces$item[item], number = piece$number, from = piece$extent[1],
      to = piece$extent[2], name = figure$pieces$name[item], ref = paste0("pieces.", name),
      ends = piece$end_to_end, diameter = first_of(disc$diameter, NA_real_),
      width = first_of(disc$width, NA_real_)
    )
  })
  do.call(rbind, rows)
}

# Returns diameter and width (m) of the discs on a plan's ground gear, by the names of their pieces
# (`grouped_pieces()`).
plan_discs <- function(plan) {
  groups <- plan$ground_gear$discs
  if (is.null(groups)) return(list())
  if (!is.null(names(groups))) groups <- list(discs = groups) else {
    names(groups) <- paste0("discs_", seq_along(groups))
  }
  lapply(groups, function(group) lapply(group[c("diameter", "width")], quantity_si, "length"))
}

straight_width <- function(look) 34 * look$t
straight_height <- function(rope, look) {
  (5.2 + length(piece_lines(rope, straight_width(look), look))) * look$line
}

draw_straight <- function(sheet, rope, x, top, wide, look) {
  on_sheet(sheet, component = "rope", ref = paste0("ropes.", rope$name), layer = "ROPES", draw = {
    draw_balloon(sheet, x + look$balloon, top - look$line / 2, rope$item$item, look)
    sheet_text(sheet, x + 2 * look$balloon + look$gap, top - look$line / 2,
      cut_text(straight_text(rope), wide - 2 * look$balloon - look$gap, look$t), look$t)
  })
  y <- top - 3.4 * look$line
  end <- x + wide
  bounds <- x + wide * c(0, cumsum(rope$parts$length)) / sum(rope$parts$length)
  on_sheet(sheet, component = "rope", ref = paste0("ropes.", rope$name), layer = "ROPES", draw = {
    sheet_line(sheet, c(x, end), c(y, y), sheet_width[["thick"]])
    for (b in bounds) sheet_line(sheet, c(b, b), y + c(-0.6, 0.6) * look$t)
  })
  shown <- short_number(round(rope$parts$length, 2), 6)
  long <- trimws(paste(rope$parts$words, shown))
  centre <- (utils::head(bounds, -1L) + bounds[-1L]) / 2
  tight <- text_width(long, look$t) + look$gap >= diff(bounds)
  long[tight] <- shown[tight]
  if (any(text_width(long, look$t) + look$gap >= diff(bounds))) {
    long <- cut_text(paste(shown, collapse = " + "), wide, look$t)
    centre <- (x + end) / 2
  }
  on_sheet(sheet, component = "length", ref = paste0("ropes.", rope$name, ".length"),
    layer = "TABLES", draw = {
      for (k in seq_along(long)) {
        sheet_text(sheet, centre[k], y + 1.2 * look$line, long[k], look$t, 0.5)
      }
    })
  draw_pieces_along(sheet, rope, x, y, wide, look)
}

straight_text <- function(rope) {
  item <- rope$item
  make <- trimws(paste0(item$material, " \u00d8", short_number(in_unit(item$diameter, "mm"))))
  paste0(item$name, "  ", short_number(round(item$length, 2), 6), " m  ", make,
    if (!is.na(item$hanging)) sprintf("  E %.2f", item$hanging))
}

# Draws a disc as seen from ahead, in proportion to the largest on its rope. step: mm to the next
# disc.
draw_disc <- function(sheet, x, y, disc, largest, step, look) {
  high <- 0.95 * look$t * disc$diameter / largest
  half <- max(min(high * disc$width / disc$diameter, step / 3), 0.2)
  sheet_polygon(sheet, x + half * c(-1, 1, 1, -1), y + high * c(-1, -1, 1, 1), fill = "white",
    width = sheet_width[["thin"]])
}

# Draws the pieces along a rope, each separately if space allows, with number and spacing below.
draw_pieces_along <- function(sheet, rope, x, y, wide, look) {
  pieces <- rope$pieces
  if (is.null(pieces)) return(invisible())
  for (k in seq_len(nrow(pieces))) {
    p <- pieces[k, ]
    apart <- share_apart(p)
    share <- p$from + apart * (seq_len(p$number) - if (p$ends) 1 else 0.5)
    step <- wide * apart
    radius <- min(0.8 * look$t, step / 2.5)
    shown <- if (radius < 0.3) share[unique(round(seq(1, p$number, length.out = 40)))] else share
    is_disc <- !is.na(p$diameter)
    on_sheet(sheet, component = "piece", ref = p$ref, layer = "PIECES", draw = {
      for (s in shown) {
        if (is_disc) {
          draw_disc(sheet, x + s * wide, y, p, max(pieces$diameter, na.rm = TRUE), step, look)
        } else {
          sheet_circle(sheet, x + s * wide, y, max(radius, 0.3))
        }
      }
    })
  }
  lines <- piece_lines(rope, wide, look)
  on_sheet(sheet, component = "piece", ref = pieces$ref[1], layer = "PIECES",
    draw = sheet_lines(sheet, x, y - 1.3 * look$line, lines, look))
}

# Returns the spacing of pieces as a fraction of the rope: from end to end, or each in the middle of
# its own stretch, as in the mesh.
share_apart <- function(pieces) (pieces$to - pieces$from) / (pieces$number - pieces$ends)

piece_lines <- function(rope, wide, look) {
  pieces <- rope$pieces
  if (is.null(pieces)) return(character())
  size <- ifelse(is.na(pieces$diameter), "",
    paste0(" \u00d8", short_number(in_unit(pieces$diameter, "mm"))))
  each <- ifelse(pieces$number > 1, paste0(", ", pieces$number, " off, ",
    short_number(rope$item$length * share_apart(pieces), 3), " m apart"), "")
  # Merge identical groups, such as those on both wings.
  said <- paste0(pieces$letter, ": ", pieces$name, size, each)
  alike <- table(factor(said, unique(said)))
  said <- paste0(names(alike), ifelse(alike > 1, paste0(", ", alike, " groups"), ""))
  wrap_text(paste(said, collapse = "; "), wide, look$t)
}
