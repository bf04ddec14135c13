# Ropes and pieces that run along the netting of a plan drawing.

# What runs along a column's panels, as straight lines on the page: a data frame with label, square
# (a piece), thick (a rope) and x0, y0, x1, y1.
drawn_laced <- function(column, figure, x, y) {
  ropes <- figure$layout$laced
  ropes$label <- as.character(figure$ropes$item[match(ropes$kind, figure$ropes$kind)])
  ropes$square <- rep(FALSE, nrow(ropes))
  all <- rbind(ropes, laced_pieces(figure))
  all <- all[all$panel %in% column$panels$name, ]
  panels <- column$panels[match(all$panel, column$panels$name), ]
  ends <- vapply(seq_len(nrow(all)), function(k) {
    a <- edge_point(panels[k, ], all$edge[k], all$from[k])
    b <- edge_point(panels[k, ], all$edge[k], all$to[k])
    # In half a column, only what is right of the middle.
    if (column$half) {
      if (max(a[1], b[1]) < -1e-6) return(rep(NA_real_, 4L))
      if (a[1] < 0) a <- b + (a - b) * b[1] / (b[1] - a[1])
      if (b[1] < 0) b <- a + (b - a) * a[1] / (a[1] - b[1])
    }
    c(a, b)
  }, numeric(4))
  ends <- matrix(ends, 4L)
  lines <- data.frame(
    label = all$label, square = all$square, thick = !all$square,
    x0 = x(ends[1, ]), y0 = y(ends[2, ]), x1 = x(ends[3, ]), y1 = y(ends[4, ])
  )
  long <- sqrt((lines$x1 - lines$x0)^2 + (lines$y1 - lines$y0)^2)
  lines[!is.na(long) & long > 1e-3, ]
}

# Pieces spread along ropes or edges, in the form of laced_edges() with their letters.
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

# A balloon for each label of a column, on the longest of its lines that has room.
place_balloons <- function(lines, use) {
  for (label in unique(lines$label)) {
    mine <- lines[lines$label == label, ]
    mine <- mine[order(-sqrt((mine$x1 - mine$x0)^2 + (mine$y1 - mine$y0)^2)), ]
    places <- do.call(rbind, lapply(seq_len(min(8L, nrow(mine))), function(k) {
      share <- c(0.5, 0.62, 0.38, 0.74, 0.26, 0.86, 0.14, 0.95, 0.05)
      cbind(
        mine$x0[k] + share * (mine$x1[k] - mine$x0[k]),
        mine$y0[k] + share * (mine$y1[k] - mine$y0[k])
      )
    }))
    at <- find_room(use, places, c(0.19, 0.18))
    if (is.null(at)) at <- places[1L, ]
    draw_balloon(at[1], at[2], label, mine$square[1L])
  }
}
