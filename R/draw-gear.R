# The plan of a gear drawn flat, as net makers draw it.

#' Draw the plan of a gear
#'
#' The gear's netting laid flat, its rigging and the list of its ropes and pieces, on one page, as
#' in the FAO Catalogue of Fishing Gear Designs (FAO, 1972 and 1978; drawing after ISO 3169): panels
#' that follow each other stand in columns, front edge up, as deep as their netting is stretched and
#' half as wide as it is stretched, at one scale. What hangs between two ropes of known hanging
#' ratio is as wide as these; square netting has its own width. Of columns that are alike one is
#' drawn, and of symmetric columns, where the whole would be small, the right half. Straight panels
#' that are joined side by side, such as those of a seine, are drawn as one wall.
#'
#' Beside every panel stand its part, meshes deep, mesh size, twine and material; at its upper and
#' lower edges the meshes across (of the whole panel); and at its sides the cutting rate after ISO
#' 1532: points (N), meshes (T) and bars (B) in one cycle, such as 1N2B, or all of one kind (AN, AB,
#' AT). Where no cycle of few cuts gives the taper, the two nearest follow each other, each as often
#' as is written, until the edge is done: 9(1N2B)+1(1N3B). Meshes that seams take up are not
#' counted. Where a table beside the netting would not be clear, panels have numbers (P1) that are
#' explained below. Ropes have numbers and pieces have letters, which the lists explain; E is a
#' rope's hanging ratio. The rigging is not to scale; what is alike on both sides is drawn once.
#'
#' A panel that makes up most of the length of a net is drawn shortened, with a break; a wall much
#' longer than deep is drawn at two scales, and says so.
#'
#' @param x A gear ([read_gear()], [gear()]).
#' @param file `NULL` for the current graphics device, or a file to write, ending in `.png`, `.pdf`
#'   or `.svg`. It is written whole or not at all.
#' @param width,height Size of the file's page, inches; A4 on its side by default. On a smaller page
#'   all is drawn smaller.
#' @param ... Not used.
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @examples
#' plot(read_gear("midwater_trawl"))
#' @export
plot.codend_gear <- function(x, file = NULL, width = plan_page[1], height = plan_page[2],
                             ...) {
  check_inches("width", width)
  check_inches("height", height)
  if (!is.null(file)) check_file_path(file, picture_types)
  figure <- plan_figure(x)
  if (is.null(file)) {
    draw_plan(figure, grDevices::dev.size())
  } else {
    write_picture(file, c(width, height), figure$title, function(page) draw_plan(figure, page))
  }
  invisible(x)
}

# What the drawing shows, before any page is known: list(title, si, layout (NULL without netting),
# ropes, pieces (items, or NULL), rigging (NULL for none)).
plan_figure <- function(gear) {
  si <- gear_si(gear)
  # Struts that weigh nothing stand for stiff corners: nobody makes them.
  si$ropes <- Filter(function(rope) !(rope$strut && rope$mass_per_length == 0), si$ropes)
  ropes <- if (length(si$ropes)) rope_items(si)
  pieces <- piece_items(si)
  list(
    title = gear$plan$name, si = si,
    layout = if (length(si$panels)) flat_layout(si),
    ropes = ropes, pieces = pieces, rigging = plan_rigging(si, ropes, pieces)
  )
}

plan_margin <- 0.3
plan_title_height <- 0.42
# Shares of the page's width for the netting, and of the right column's height for the rigging.
netting_share <- 0.68
rigging_share <- 0.45
# Text: lists, labels and headings, as cex; ink.
plan_text <- c(list = 0.6, label = 0.56, heading = 0.68)
plan_ink <- "#202428"

# The page as laid out, inches; on a smaller one all is drawn smaller.
plan_page <- c(11.69, 8.27)

draw_plan <- function(figure, page) {
  if (page[1] < 5 || page[2] < 3.5) {
    size <- round(page, 1)
    abort_argument(
      "A page of {size[1]} by {size[2]} inches is too small for a plan; it takes 5 by 3.5."
    )
  }
  kept <- graphics::par(no.readonly = TRUE)
  on.exit(graphics::par(kept))
  small <- min(1, page / plan_page)
  page <- page / small
  graphics::par(family = "sans", bg = "white", mai = c(0, 0, 0, 0), cex = small, xaxs = "i",
    yaxs = "i", col = plan_ink, lend = "butt")
  graphics::plot.new()
  graphics::plot.window(c(0, page[1]), c(0, page[2]))
  top <- page[2] - plan_margin - plan_title_height
  left <- plan_margin
  right <- page[1] - plan_margin
  bottom <- plan_margin
  graphics::text(left, page[2] - plan_margin, figure$title, adj = c(0, 1), font = 2, cex = 1)
  graphics::segments(left, top + 0.08, right, top + 0.08, lwd = 0.8)
  has_netting <- !is.null(figure$layout)
  has_rigging <- !is.null(figure$rigging)
  split <- left + (right - left) * netting_share
  main <- c(left, bottom, split - 0.15, top)
  side <- c(split, bottom, right, top)
  if (has_netting) {
    draw_flat_netting(figure, main)
    if (has_rigging) {
      below <- top - (top - bottom) * rigging_share
      draw_rigging(figure$rigging, c(side[1], below, side[3], top))
      side[4] <- below - 0.1
    }
  } else if (has_rigging) {
    draw_rigging(figure$rigging, main)
  }
  draw_plan_lists(figure, side)
}

# ---- marks and text that keep clear of each other ------------------------------------------------

# A number or letter in a circle (ropes) or a square (pieces).
draw_balloon <- function(x, y, text, square = FALSE) {
  r <- 0.075
  if (square) {
    graphics::rect(x - r, y - r, x + r, y + r, col = "white", border = plan_ink, lwd = 0.8)
  } else {
    graphics::symbols(x, y, circles = r, inches = FALSE, add = TRUE, bg = "white", fg = plan_ink,
      lwd = 0.8)
  }
  graphics::text(x, y, text, cex = 0.5, font = 2)
}

# Boxes taken on the page: an environment with `boxes` (left, bottom, right, top in rows).
new_page_use <- function() {
  use <- new.env(parent = emptyenv())
  use$boxes <- matrix(0, 0L, 4L)
  use
}

is_free <- function(use, box) {
  b <- use$boxes
  !any(b[, 1] < box[3] & b[, 3] > box[1] & b[, 2] < box[4] & b[, 4] > box[2])
}

take_box <- function(use, box) use$boxes <- rbind(use$boxes, box)

# Places (n x 2) in order of liking: the first that a box of this size (width, height) around it
# leaves free, which is then taken; NULL where none is.
find_room <- function(use, places, size) {
  for (k in seq_len(nrow(places))) {
    box <- c(places[k, ] - size / 2, places[k, ] + size / 2)
    if (is_free(use, box)) {
      take_box(use, box)
      return(places[k, ])
    }
  }
  NULL
}

# Heights of labels that want to be at y (falling or not) and keep this distance: as near as may be.
spread_labels <- function(y, distance, bottom, top) {
  order <- order(-y)
  out <- y[order]
  n <- length(out)
  if (n > 1L) {
    for (pass in 1:200) {
      gap <- out[-n] - out[-1L]
      close <- which(gap < distance - 1e-9)
      if (!length(close)) break
      for (k in close) {
        push <- (distance - (out[k] - out[k + 1L])) / 2
        if (push > 0) {
          out[k] <- out[k] + push
          out[k + 1L] <- out[k + 1L] - push
        }
      }
      out <- out - max(0, out[1L] - top)
      out <- out + max(0, bottom - out[n])
    }
  }
  y[order] <- out
  y
}

# ---- lists ---------------------------------------------------------------------------------------

draw_plan_lists <- function(figure, frame) {
  ropes <- figure$ropes
  pieces <- figure$pieces
  lines <- 2 * (NROW(ropes) > 0) + NROW(ropes) + 2 * (NROW(pieces) > 0) + 2 * NROW(pieces)
  if (!lines) return(invisible())
  step <- min(0.17, (frame[4] - frame[2]) / lines)
  if (step < 0.1) {
    shown <- floor((frame[4] - frame[2]) / 0.1) - 5
    ropes <- utils::head(ropes, max(1, shown - 2 * NROW(pieces)))
    pieces <- utils::head(pieces, max(1, (shown - NROW(ropes)) %/% 2))
    step <- 0.1
  }
  cex <- min(plan_text[["list"]], plan_text[["list"]] * step / 0.14)
  y <- frame[4] - step / 2
  heading <- function(words) {
    graphics::text(frame[1], y, words, adj = c(0, 0.5), font = 2, cex = plan_text[["heading"]])
    y <<- y - 1.2 * step
  }
  if (NROW(ropes)) {
    heading("Ropes (length of each)")
    words <- vapply(seq_len(nrow(ropes)), function(k) rope_item_words(ropes[k, ]), character(4))
    width <- apply(words, 1L, function(w) max(graphics::strwidth(w, cex = cex)))
    room <- frame[3] - frame[1] - 0.2
    cex <- cex * min(1, (room - 0.3) / sum(width))
    width <- width * min(1, (room - 0.3) / sum(width))
    at <- frame[1] + 0.2 + c(0, cumsum(width[1:3] + 0.1))
    for (k in seq_len(nrow(ropes))) {
      draw_balloon(frame[1] + 0.08, y, ropes$item[k])
      graphics::text(at[1], y, words[1, k], adj = c(0, 0.5), cex = cex)
      graphics::text(at[2] + width[2], y, words[2, k], adj = c(1, 0.5), cex = cex)
      graphics::text(at[3:4], y, words[3:4, k], adj = c(0, 0.5), cex = cex)
      y <- y - step
    }
    if (nrow(ropes) < nrow(figure$ropes)) {
      graphics::text(at[1], y, sprintf("and %d more in the plan", nrow(figure$ropes) - nrow(ropes)),
        adj = c(0, 0.5), cex = cex, font = 3)
      y <- y - step
    }
    y <- y - 0.5 * step
  }
  if (NROW(pieces)) {
    heading("Boards, kites, weights, floats (of each)")
    for (k in seq_len(nrow(pieces))) {
      draw_balloon(frame[1] + 0.08, y, pieces$item[k], square = TRUE)
      name <- paste0(pieces$name[k], if (pieces$count[k] > 1) paste0(", ", pieces$count[k], " off"))
      graphics::text(frame[1] + 0.2, y, name, adj = c(0, 0.5), cex = cex)
      beside <- frame[1] + 0.2 + graphics::strwidth(name, cex = cex) + 0.12
      fits <- beside + graphics::strwidth(pieces$words[k], cex = cex) <= frame[3]
      if (!fits) {
        y <- y - 0.85 * step
        beside <- frame[1] + 0.3
      }
      small <- min(1, (frame[3] - beside) / graphics::strwidth(pieces$words[k], cex = cex))
      graphics::text(beside, y, pieces$words[k], adj = c(0, 0.5), cex = cex * small)
      y <- y - step
    }
  }
}
