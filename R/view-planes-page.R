# The page of the plane views: its views and their frames, the title and the legends. Lengths are in
# inches.

plane_margins <- c(0.5, 0.7, 0.3, 0.12)
legend_height <- 0.85
title_height <- 0.4
# Limits of the fraction of the width for views along x, next to a view from astern.
left_shares <- c(0.4, 0.62)
# Smallest height of a readable view.
least_height <- 0.7
# Largest height of a single view, and of each of several views.
tallest_views <- c(9, 4.5)
# Views next to a tall view from astern are stretched up to this height.
shortest_column <- 4.5

# Returns the views for a drawing: list(plane, region ("whole" or "net"), enlarged (TRUE if the net
# is drawn again), across, up (ranges [m]), boxes (ranges drawn again)).
plane_views <- function(drawing, planes, enlarge) {
  whole <- drawn_ranges(list(drawing$ropes, drawing$netting), drawing$marks)
  net <- if (enlarge) net_to_enlarge(drawing, whole)
  enlarged <- !is.null(net)
  view <- function(plane, region, ranges, boxes = list()) {
    axes <- plane_axes[[plane]]
    list(plane = plane, region = region, enlarged = enlarged, across = ranges[, axes[1]],
      up = ranges[, axes[2]], boxes = boxes)
  }
  along <- setdiff(planes, "yz")
  strips <- lapply(along, function(plane) {
    axes <- plane_axes[[plane]]
    view(plane, "whole", whole, if (enlarged) list(c(net[, axes[1]], net[, axes[2]])))
  })
  close <- if (enlarged) lapply(along, view, region = "net", ranges = net)
  astern <- if ("yz" %in% planes) list(view("yz", "whole", whole))
  c(strips, close, astern)
}

fitting_height <- function(figure, width) {
  zoom <- page_zoom(width)
  zoom * natural_height(plane_views(figure$drawing, figure$planes, TRUE), width / zoom)
}

# A page that is much too low does not have the enlarged net.
views_for_page <- function(figure, page) {
  enlarge <- fitting_height(figure, page[1]) <= 1.25 * page[2]
  plane_views(figure$drawing, figure$planes, enlarge)
}

# Returns the ranges of a net that is much shorter than its gear, otherwise NULL.
net_to_enlarge <- function(drawing, whole) {
  if (!length(drawing$netting$tension)) return(NULL)
  net <- drawn_ranges(list(drawing$netting), NULL)
  if (net[2, 1] - net[1, 1] < 0.6 * (whole[2, 1] - whole[1, 1])) net
}

# Returns the ranges of x, y and z [2 x 3] with a margin.
drawn_ranges <- function(lines, marks) {
  all <- do.call(cbind, lapply(lines, function(l) cbind(l$from, l$to)))
  if (NROW(marks)) all <- cbind(all, t(as.matrix(marks[c("x", "y", "z")])))
  ranges <- apply(all, 1L, range)
  room <- pmax(0.04 * (ranges[2, ] - ranges[1, ]), 0.015 * max(ranges[2, ] - ranges[1, ]), 0.05)
  ranges + rbind(-room, room)
}

# Returns list(strips, left, right) of view numbers. Strips have the full width. Below them, the
# views along x are on the left and the view from astern on the right.
page_rows <- function(views) {
  astern <- vapply(views, function(v) v$plane == "yz", NA)
  whole <- vapply(views, function(v) v$region == "whole", NA)
  strips <- which(!astern & whole & vapply(views, function(v) v$enlarged, NA))
  list(strips = strips, left = setdiff(which(!astern), strips), right = which(astern))
}

space_across <- plane_margins[2] + plane_margins[4]
space_up <- plane_margins[1] + plane_margins[3]

# Returns the height for equal scales on both axes, margins included.
view_height <- function(view, width) {
  max(least_height, diff(view$up) / diff(view$across) * (width - space_across)) + space_up
}

# Returns the fraction of the width at which all three views have the same scale, within limits.
left_share <- function(views, rows) {
  if (!length(rows$right)) return(1)
  long <- diff(views[[rows$left[1]]]$across)
  wide <- diff(views[[rows$right]]$across)
  min(max(long / (long + wide), left_shares[1]), left_shares[2])
}

page_heights <- function(views, width) {
  rows <- page_rows(views)
  alone <- length(views) == 1L
  beside <- length(rows$left) && length(rows$right)
  share <- if (length(rows$left)) left_share(views, rows) else 0
  wanted <- function(k, w) {
    pmin(vapply(views[k], view_height, 0, width = w), tallest_views[if (alone) 1L else 2L])
  }
  left <- wanted(rows$left, width * share)
  right <- min(Inf, vapply(views[rows$right], view_height, 0,
    width = width * (if (beside) 1 - share else 0.6)))
  right <- if (length(rows$right)) min(right, tallest_views[1]) else 0
  lower <- if (beside) max(sum(left), min(right, shortest_column)) else max(sum(left), right)
  list(rows = rows, share = share, strips = wanted(rows$strips, width), left = left,
    right = min(right, lower), lower = lower)
}

natural_height <- function(views, width) {
  heights <- page_heights(views, width)
  title_height + legend_height + sum(heights$strips) + heights$lower
}

# Returns frames (left, bottom, right, top) of the title, the legends and every view. On a page that
# is too low, the views are narrower and keep their proportions.
page_frames <- function(views, page) {
  widths <- page[1] * seq(1, 0.6, by = -0.02)
  fits <- vapply(widths, natural_height, 0, views = views) <= page[2] + 1e-6
  width <- if (any(fits)) widths[which(fits)[1]] else page[1]
  heights <- page_heights(views, width)
  rows <- heights$rows
  fit <- (page[2] - title_height - legend_height) / (sum(heights$strips) + heights$lower)
  frames <- vector("list", length(views))
  stack <- function(k, heights, top, right) {
    below <- top - cumsum(heights)
    for (n in seq_along(k)) frames[[k[n]]] <<- c(0, below[n], right, below[n] + heights[n])
    top - sum(heights)
  }
  top <- stack(rows$strips, fit * heights$strips, page[2] - title_height, width)
  alone <- !length(rows$left)
  split <- width * (if (alone) 0.2 else heights$share)
  if (!alone) stack(rows$left, fit * heights$lower * heights$left / sum(heights$left), top, split)
  if (length(rows$right)) {
    frames[[rows$right]] <- c(
      split, top - fit * heights$right, if (alone) width - split else width, top
    )
  }
  inset <- (page[1] - width) / 2
  list(
    title = c(0, page[2] - title_height, page[1], page[2]),
    legend = c(0, 0, page[1], legend_height),
    views = lapply(frames, function(f) f + c(inset, 0, inset, 0))
  )
}

draw_title <- function(figure, frame, page) {
  open_region(frame, page, c(0, plane_margins[2], 0, plane_margins[4]))
  graphics::plot.window(c(0, 1), c(0, 1))
  graphics::text(0, 0.4, figure$title, adj = c(0, 0.5), font = 2, cex = 1.25)
  graphics::text(1, 0.4, figure$conditions, adj = c(1, 0.5), cex = 1)
}

draw_legends <- function(figure, frame, page) {
  open_region(frame, page, c(0, 0, 0, 0))
  graphics::plot.window(c(0, page[1]), c(0, legend_height))
  left <- plane_margins[2]
  width <- min(2.6, 0.25 * page[1])
  for (kind in c("rope", "netting")) {
    scale <- figure$scales[[kind]]
    lines <- figure$drawing[[if (kind == "rope") "ropes" else "netting"]]
    if (!length(lines$tension)) next
    draw_colour_bar(scale, kind, left, width, slack_text(lines$tension))
    left <- left + width + min(0.55, 0.05 * page[1])
  }
  used <- view_symbols$role %in% symbol_of(figure$drawing$marks$role)$role
  draw_key(view_symbols[used, ], left, page[1] - 0.1)
}

# scale: NULL if all lines are slack.
draw_colour_bar <- function(scale, kind, left, width, slack) {
  graphics::text(left, 0.72, scale_heading(scale, kind), adj = c(0, 0.5), font = 2, cex = 0.8)
  from <- left
  if (length(slack)) {
    graphics::rect(left, 0.4, left + 0.25, 0.56, col = slack_colour, border = NA)
    graphics::text(left, 0.26, slack, cex = 0.72, adj = c(0, 0.5))
    from <- left + max(0.45, graphics::strwidth(slack, cex = 0.72) + 0.15)
  }
  if (is.null(scale)) return(invisible())
  edges <- seq(from, left + width, length.out = 129L)
  colours <- scale$colours[round(seq(1, length(scale$colours), length.out = 128L))]
  graphics::rect(edges[-129L], 0.4, edges[-1L], 0.56, col = colours, border = colours)
  at <- from + scale_share(scale, scale$ticks * scale$per_unit) * (left + width - from)
  graphics::segments(at, 0.4, at, 0.36, col = "grey30")
  graphics::text(at, 0.26, tick_labels(scale), cex = 0.72)
}

draw_key <- function(symbols, left, right) {
  n <- nrow(symbols)
  if (!n) return(invisible())
  per_column <- 3L
  column <- (seq_len(n) - 1L) %/% per_column
  row <- (seq_len(n) - 1L) %% per_column
  x <- left + column * min(1.15, (right - left) / (max(column) + 1))
  y <- 0.66 - row * 0.21
  graphics::points(x + 0.08, y, pch = symbols$symbol, bg = symbols$fill, col = "#202428",
    cex = symbols$size)
  graphics::text(x + 0.22, y, symbols$label, adj = c(0, 0.5), cex = 0.78)
}
