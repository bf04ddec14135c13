# Marks in inches on the sheet that is being drawn.
pen <- new.env(parent = emptyenv())
pen_size <- function(cex) cex * 12 * 0.718 * 25.4 / 72
pen_width <- function(text, cex = 1, font = 1) {
  text <- as.character(text)
  vapply(strsplit(text, "\n", fixed = TRUE), function(lines) {
    max(0, text_width(lines, pen_size(cex), font == 2))
  }, 0) / 25.4
}
pen_text <- function(x, y, text, adj = c(0.5, 0.5), cex = 1, font = 1, ...) {
  n <- max(length(x), length(text), length(y))
  x <- rep_len(x, n)
  y <- rep_len(y, n)
  text <- rep_len(text, n)
  for (k in seq_len(n)) {
    lines <- strsplit(as.character(text[k]), "\n", fixed = TRUE)[[1]]
    size <- pen_size(cex)
    for (l in seq_along(lines)) {
      down <- ((l - 1) - (length(lines) - 1) / 2) * 1.7 * size
      if (length(adj) > 1L && adj[2] == 1) down <- down + size / 2
      sheet_text(pen$sheet, x[k] * 25.4, y[k] * 25.4 - down, lines[l], size, adj[1], font == 2,
        font == 3)
    }
  }
}
pen_segments <- function(x0, y0, x1, y1, lwd = 1, lty = NULL, ...) {
  for (k in seq_along(x0)) {
    pen_lines(c(x0[k], x1[k]), c(y0[k], y1[k]), lwd, if (!is.null(lty)) c(3, 1))
  }
}
pen_lines <- function(x, y = NULL, lwd = 1, dash = NULL, ...) {
  at <- grDevices::xy.coords(x, y)
  sheet_line(pen$sheet, at$x * 25.4, at$y * 25.4, lwd * 0.26, dash)
}
pen_polygon <- function(x, y, col = NA, border = sheet_ink, lwd = 1) {
  sheet_polygon(pen$sheet, x * 25.4, y * 25.4, col, border, lwd * 0.26)
}
pen_rect <- function(x0, y0, x1, y1, col = NA, border = sheet_ink, lwd = 1) {
  n <- max(length(x0), length(x1))
  col <- rep_len(col, n)
  for (k in seq_len(n)) {
    left <- rep_len(x0, n)[k]
    right <- rep_len(x1, n)[k]
    pen_polygon(c(left, right, right, left), c(y0, y0, y1, y1), col[k], border, lwd)
  }
}
pen_points <- function(x, y, pch, bg, cex = 1) {
  sheet_circle(pen$sheet, x * 25.4, y * 25.4, cex * 1.3, bg)
}
