# Returns the overlaps of a drawing as strings: two labels whose boxes intersect, a line through a
# label, or a label outside the frame. Boxes use the font's metrics, less 0.1 mm. A line that a
# white circle or box hides behind a label does not count.
overlaps <- function(sheet) {
  kind <- vapply(sheet$items, `[[`, "", "kind")
  text <- which(kind == "text")
  boxes <- vapply(sheet$items[text], item_box, numeric(4)) + c(0.1, 0.1, -0.1, -0.1)
  words <- vapply(sheet$items[text], `[[`, "", "text")
  meet <- outer(seq_along(text), seq_along(text), function(i, j) {
    i < j & boxes[1, i] < boxes[3, j] & boxes[3, i] > boxes[1, j] & boxes[2, i] < boxes[4, j] &
      boxes[4, i] > boxes[2, j]
  })
  pairs <- which(meet, arr.ind = TRUE)
  margin <- sheet_margin[["other"]]
  page <- sheet$page
  out <- boxes[1, ] < sheet_margin[["left"]] | boxes[2, ] < margin |
    boxes[3, ] > page[1] - margin | boxes[4, ] > page[2] - margin
  c(
    paste(words[pairs[, 1]], words[pairs[, 2]], sep = " / ")[seq_len(nrow(pairs))],
    paste(words[out], "leaves the frame")[seq_len(sum(out))],
    crossed_texts(sheet, text, boxes, words)
  )
}

crossed_texts <- function(sheet, text, boxes, words) {
  lines <- do.call(rbind, lapply(which(vapply(sheet$items, `[[`, "", "kind") != "text"),
    function(k) cbind(item_segments(sheet$items[[k]]), k)))
  covers <- which(vapply(sheet$items, function(item) identical(item$fill, "white"), NA))
  covered <- vapply(sheet$items[covers], item_box, numeric(4))
  unlist(lapply(seq_along(text), function(i) {
    box <- boxes[, i]
    over <- covers[covered[1, ] <= box[1] + 0.5 & covered[2, ] <= box[2] + 0.5 &
      covered[3, ] >= box[3] - 0.5 & covered[4, ] >= box[4] - 0.5 & covers < text[i]]
    seen <- lines[lines[, 5] > max(0, over), , drop = FALSE]
    crossed <- lines_cross_box(seen[, 1:4, drop = FALSE], box)
    if (any(crossed)) {
      paste(words[i], "is crossed by a", sheet$items[[seen[which(crossed)[1], 5]]]$component)
    }
  }))
}

item_segments <- function(item) {
  x <- item$x
  y <- item$y
  if (item$kind == "circle") {
    turn <- seq(0, 2 * pi, length.out = 25L)
    x <- item$x + item$radius * cos(turn)
    y <- item$y + item$radius * sin(turn)
  }
  if (item$kind == "polygon") {
    x <- c(x, x[1])
    y <- c(y, y[1])
  }
  n <- length(x)
  cbind(x[-n], y[-n], x[-1L], y[-1L])
}
