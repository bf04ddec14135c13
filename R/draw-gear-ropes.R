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

# Returns the ropes along the netting that are also drawn straight, at most five. A line in sections
# is one of them. Each is a list. `name`, `length` (m), `words`: of the whole. `items`: its rows of
# the rope list. `ropes`: names of its sections in order. `parts`: data frame of words and length
# (m), one row per section, or per part of the net along a single rope. `pieces`: data frame of the
# pieces along it (`pieces_along()`), or NULL.
straight_ropes <- function(figure) {
  si <- figure$si
  found <- lapply(rope_chains(si, figure$layout$joints), function(ropes) {
    items <- figure$ropes[match(vapply(ropes, rope_kind, "", si = si), figure$ropes$kind), ]
    parts <- if (length(ropes) == 1L) rope_parts(ropes, si) else {
      data.frame(words = "", length = items$length)
    }
    pieces <- pieces_along(ropes, figure)
    if (is.null(pieces) && (!si$ropes[[ropes[1L]]]$role %in% mouth_lines || nrow(parts) < 2L)) {
      return(NULL)
    }
    list(items = items[!duplicated(items$item), ], ropes = ropes, parts = parts, pieces = pieces)
  })
  found <- Filter(Negate(is.null), found)
  # Identical ropes, such as those on both sides, are drawn once.
  utils::head(found[!duplicated(lapply(found, function(rope) rope$items$item))], 5L)
}

mouth_lines <- c("headline", "footrope", "ground_gear", "float_line", "lead_line")

# Returns the names of the ropes along netting as a list of chains. A rope continues the previous
# one if both have the same role and it starts at the same panel, or at one that is joined to it.
rope_chains <- function(si, joints) {
  laced <- Filter(function(name) !is.null(si$ropes[[name]]$along), names(si$ropes))
  role <- vapply(laced, function(name) si$ropes[[name]]$role, "")
  first <- vapply(laced, function(name) si$ropes[[name]]$along[[1L]]$panel, "")
  last <- vapply(laced, function(name) rev(si$ropes[[name]]$along)[[1L]]$panel, "")
  n <- length(laced)
  follows <- vapply(seq_len(n)[-1L], function(k) {
    met <- c(last[k - 1L], joints$other[joints$panel == last[k - 1L]])
    identical(role[[k]], role[[k - 1L]]) && !is.na(role[k]) && first[k] %in% met
  }, NA)
  unname(split(laced, cumsum(c(TRUE, !follows)[seq_len(n)])))
}

# Returns the lengths (m) of a rope along consecutive panels. Edges of one panel are merged. The
# bosom is along the edges ahead of or behind netting between two wings.
rope_parts <- function(name, si) {
  rope <- si$ropes[[name]]
  along <- rope$along
  netting <- vapply(seq_along(along), function(k) chain_length(along[k], si$panels), 0)
  share <- if (is.null(rope$shares)) netting / sum(netting) else rope$shares
  panel <- vapply(along, `[[`, "", "panel")
  side <- which(vapply(along, `[[`, "", "edge") %in% c("left", "right"))
  k <- seq_along(along)
  bosom <- k > min(side, Inf) & k < max(side, -Inf) & !k %in% side
  words <- if (any(bosom)) ifelse(bosom, "bosom", "wing") else rep("", length(along))
  key <- if (any(bosom)) ifelse(bosom, "bosom", panel) else words
  run <- cumsum(c(TRUE, key[-1L] != key[-length(key)]))
  data.frame(
    words = words[!duplicated(run)], length = as.vector(tapply(share * rope$length, run, sum))
  )
}

# Returns the pieces along the ropes of a chain, one row per group. `at`, `apart`: position of the
# first one and distance to the next (m); `high`, `wide`: size across and along the rope (m), `size`
# in words.
pieces_along <- function(ropes, figure) {
  si <- figure$si
  length <- vapply(si$ropes[ropes], `[[`, 0, "length")
  start <- cumsum(c(0, length))
  rows <- lapply(names(si$pieces), function(name) {
    piece <- si$pieces[[name]]
    k <- if (identical(piece$along$kind, "rope")) match(piece$along$name, ropes) else NA
    if (is.na(k)) return(NULL)
    item <- which(vapply(figure$pieces$parts, function(parts) name %in% parts, NA))[1]
    # From end to end, or each in the middle of its own stretch, as in the mesh.
    apart <- diff(piece$extent) * length[[k]] / (piece$number - piece$end_to_end)
    # Discs are cylinders, other pieces spheres.
    is_disc <- piece$role %in% "disc"
    high <- if (is_disc) 4 / pi * piece$volume / piece$area else (6 / pi * piece$volume)^(1 / 3)
    data.frame(
      letter = figure$pieces$item[item], number = piece$number,
      at = start[k] + piece$extent[1] * length[[k]] + if (piece$end_to_end) 0 else apart / 2,
      apart = apart, name = figure$pieces$name[item], ref = paste0("pieces.", name),
      disc = is_disc, high = high, wide = if (is_disc) piece$area / high else high,
      size = if (piece$role %in% c("disc", "float")) {
        paste0(" \u00d8", short_number(in_unit(high, "mm"), 3))
      } else {
        ""
      }
    )
  })
  do.call(rbind, rows)
}

straight_width <- function(look) 34 * look$t
draw_straight <- function(sheet, rope, x, top, wide, look) {
  refs <- paste0("ropes.", rope$ropes)
  left <- x
  for (k in seq_len(nrow(rope$items))) {
    on_sheet(sheet, component = "rope", ref = paste0("ropes.", rope$items$first[k]),
      layer = "ROPES", draw = draw_balloon(sheet, left + look$balloon, top - look$line / 2,
        rope$items$item[k], look))
    left <- left + 2 * look$balloon + look$gap
  }
  on_sheet(sheet, component = "rope", ref = refs[1L], layer = "ROPES", draw = sheet_text(sheet,
    left, top - look$line / 2, cut_text(straight_text(rope), x + wide - left, look$t), look$t))
  y <- top - 3.4 * look$line
  # Pieces at the ends are within the width.
  line <- x + look$t + c(0, wide - 2 * look$t)
  bounds <- line[1] + diff(line) * c(0, cumsum(rope$parts$length)) / sum(rope$parts$length)
  on_sheet(sheet, component = "rope", ref = refs[1L], layer = "ROPES", draw = {
    sheet_line(sheet, line, c(y, y), sheet_width[["thick"]])
    for (b in bounds) sheet_line(sheet, c(b, b), y + c(-0.6, 0.6) * look$t)
  })
  shown <- short_number(round(rope$parts$length, 2), 6)
  long <- trimws(paste(rope$parts$words, shown))
  centre <- (utils::head(bounds, -1L) + bounds[-1L]) / 2
  tight <- text_width(long, look$t) + look$gap >= diff(bounds)
  long[tight] <- shown[tight]
  if (any(text_width(long, look$t) + look$gap >= diff(bounds))) {
    long <- cut_text(paste(shown, collapse = " + "), wide, look$t)
    centre <- mean(line)
    refs <- refs[1L]
  }
  for (k in seq_along(long)) {
    on_sheet(sheet, component = "length", ref = paste0(rep_len(refs, length(long))[k], ".length"),
      layer = "TABLES", draw = sheet_text(sheet, centre[k], y + 1.2 * look$line, long[k], look$t,
        0.5))
  }
  if (is.null(rope$pieces)) return(invisible())
  draw_pieces_along(sheet, rope$pieces, line[1], y, diff(line) / sum(rope$parts$length), look)
  on_sheet(sheet, component = "piece", ref = rope$pieces$ref[1], layer = "PIECES",
    draw = sheet_lines(sheet, x, y - 1.3 * look$line, piece_lines(rope, wide, look), look))
}

straight_text <- function(rope) {
  items <- rope$items
  make <- unique(trimws(paste0(items$material, " \u00d8",
    short_number(in_unit(items$diameter, "mm")))))
  paste0(items$name[1], "  ", short_number(round(sum(rope$parts$length), 2), 6), " m",
    if (length(make) == 1L) paste0("  ", make),
    if (nrow(items) == 1L && !is.na(items$hanging)) sprintf("  E %.2f", items$hanging))
}

# Draws the pieces along a rope as seen from ahead: floats as circles, discs as bars. All have the
# same scale, at which the largest is as high as two letters, or less to keep them apart. `scale`:
# mm of sheet per metre of rope.
draw_pieces_along <- function(sheet, pieces, x, y, scale, look) {
  apart <- ifelse(pieces$number > 1, pieces$apart, Inf)
  # Pieces without a volume, such as a canvas, look like the largest.
  pieces[pieces$high == 0, c("high", "wide")] <- max(pieces$high, 1e-3)
  half <- min(0.95 * look$t / pieces$high, scale * apart / pieces$wide / 2.5)
  for (k in seq_len(nrow(pieces))) {
    p <- pieces[k, ]
    at <- x + scale * (p$at + p$apart * (seq_len(p$number) - 1))
    size <- pmax(half * c(p$wide, p$high), if (p$disc) 0.2 else 0.3)
    # Floats that are too small to see stand for several.
    if (!p$disc && size[1] == 0.3) at <- at[unique(round(seq(1, p$number, length.out = 40)))]
    on_sheet(sheet, component = "piece", ref = p$ref, layer = "PIECES", draw = for (one in at) {
      if (p$disc) {
        sheet_polygon(sheet, one + size[1] * c(-1, 1, 1, -1), y + size[2] * c(-1, -1, 1, 1),
          fill = "white")
      } else {
        sheet_circle(sheet, one, y, size[1])
      }
    })
  }
}

piece_lines <- function(rope, wide, look) {
  pieces <- rope$pieces
  if (is.null(pieces)) return(character())
  each <- ifelse(pieces$number > 1,
    paste0(", ", pieces$number, " off, ", short_number(pieces$apart, 3), " m apart"), "")
  # Merge identical groups, such as those on both wings.
  said <- paste0(pieces$letter, ": ", pieces$name, pieces$size, each)
  alike <- table(factor(said, unique(said)))
  said <- paste0(names(alike), ifelse(alike > 1, paste0(", ", alike, " groups"), ""))
  wrap_text(paste(said, collapse = "; "), wide, look$t)
}
