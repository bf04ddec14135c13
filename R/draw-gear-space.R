# Returns text dimensions, mm: t = height of capitals, line = line spacing, gap, balloon = radius of
# a number's circle.
drawing_look <- function(t) list(t = t, line = 1.8 * t, gap = 0.8 * t, balloon = 1.15 * t)

# Returns an environment of the occupied space: `boxes` (rows of left, bottom, right, top) and
# `lines` (rows of x0, y0, x1, y1).
new_page_use <- function() {
  use <- new.env(parent = emptyenv())
  use$boxes <- use$lines <- matrix(0, 0L, 4L)
  use
}

take_box <- function(use, box) use$boxes <- rbind(use$boxes, box)

take_lines <- function(use, x, y, closed = FALSE) {
  if (closed) {
    x <- c(x, x[1])
    y <- c(y, y[1])
  }
  n <- length(x)
  use$lines <- rbind(use$lines, cbind(x[-n], y[-n], x[-1L], y[-1L]))
}

is_free <- function(use, box, lines = TRUE) {
  b <- use$boxes
  if (any(b[, 1] < box[3] & b[, 3] > box[1] & b[, 2] < box[4] & b[, 4] > box[2])) return(FALSE)
  !lines || !any(lines_cross_box(use$lines, box))
}

# Returns TRUE for lines (rows of x0, y0, x1, y1) that have a point within a box. `boxes`: a single
# box, or rows with a box per line. A single line may be checked against many boxes.
lines_cross_box <- function(lines, boxes) {
  if (!is.matrix(boxes)) boxes <- matrix(boxes, 1L)
  across <- crossed_span(lines[, 1], lines[, 3], boxes[, 1], boxes[, 3])
  up <- crossed_span(lines[, 2], lines[, 4], boxes[, 2], boxes[, 4])
  pmax(across$enter, up$enter, 0) < pmin(across$leave, up$leave, 1)
}

# Returns the fractions of a line at which it enters and leaves the interval from low to high. If it
# never does, enter exceeds leave.
crossed_span <- function(from, to, low, high) {
  d <- to - from
  a <- (low - from) / d
  b <- (high - from) / d
  enter <- pmin(a, b)
  leave <- pmax(a, b)
  still <- which(rep_len(d == 0, length(enter)))
  if (length(still)) {
    inside <- rep_len(from > low & from < high, length(enter))[still]
    enter[still] <- 2 - 2 * inside
    leave[still] <- 2 * inside - 1
  }
  list(enter = enter, leave = leave)
}

# Reserves and returns the first free position, NULL if there is none. `places`: candidates (n x 2),
# best first. `size`: width and height of the box around them. `from`: points; the line from the
# nearest point to the position must cross no box.
find_space <- function(use, places, size, lines = TRUE, from = NULL) {
  for (k in seq_len(nrow(places))) {
    at <- places[k, ]
    box <- c(at - size / 2, at + size / 2)
    if (!is_free(use, box, lines)) next
    led <- is.null(from) ||
      !any(lines_cross_box(matrix(c(nearest_point(from, at), at), 1L), use$boxes))
    if (!led) next
    take_box(use, box)
    return(at)
  }
  NULL
}

nearest_point <- function(points, to) {
  points[which.min((points[, 1] - to[1])^2 + (points[, 2] - to[2])^2), ]
}

# Spreads labels at heights y to this distance, between bottom and top, by isotonic regression. It
# minimises the sum of squared shifts.
spread_labels <- function(y, distance, bottom, top) {
  order <- order(y)
  n <- length(y)
  apart <- distance * seq_len(n)
  out <- if (n > 1L) stats::isoreg(y[order] - apart)$yf else y - apart
  y[order] <- pmin(pmax(out, bottom - distance), top - apart[n]) + apart
  y
}

wrap_text <- function(text, width, size) {
  words <- strsplit(text, " ", fixed = TRUE)[[1L]]
  lines <- character()
  line <- ""
  for (word in words) {
    longer <- if (nzchar(line)) paste(line, word) else word
    if (nzchar(line) && text_width(longer, size) > width) {
      lines <- c(lines, line)
      line <- word
    } else {
      line <- longer
    }
  }
  c(lines, line)
}

cut_text <- function(text, width, size, bold = FALSE) {
  if (text_width(text, size, bold) <= width) return(text)
  characters <- strsplit(text, "")[[1]]
  for (n in rev(seq_along(characters))) {
    short <- paste0(paste(characters[seq_len(n)], collapse = ""), "...")
    if (text_width(short, size, bold) <= width) return(short)
  }
  ""
}

# Draws a number or letter in a circle (ropes) or a square (pieces).
draw_balloon <- function(sheet, x, y, text, look, square = FALSE) {
  r <- look$balloon * if (nchar(text) > 2L) 1.4 else 1
  if (square) {
    sheet_polygon(sheet, x + c(-r, r, r, -r), y + c(-r, -r, r, r), fill = "white")
  } else {
    sheet_circle(sheet, x, y, r)
  }
  sheet_text(sheet, x, y, text, look$t, 0.5)
}
