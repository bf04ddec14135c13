# Small figures beside one another on a page, each of a quantity against another: the pictures of
# trajectories, of variations and of tensions along ropes.
#
# A figure is list(words, unit (of what it shows), across (label below), lines = list of list(x, y,
# group, dashed, symbols), groups (labels of its own groups, or NULL: they are those of the page's
# key), colours (of its groups, or NULL: from dark to light), missing (places along the axis where
# there is nothing to show), ticks (labels of the places 1, 2, ... or NULL), beside (values of
# figures beside it that its axis reaches too, or NULL)). A line that is not `joined` is its symbols
# alone.

# Inches of the page: of one figure, of the title above them and of a row of the key.
least_series <- c(2.4, 1.3)
series_height <- 1.6
series_title <- 0.4
key_row <- 0.2
own_key_row <- 0.14

# As many columns as find room, as even in number as the figures allow.
series_columns <- function(n, width) {
  most <- min(4L, max(1L, floor(width / least_series[1L])))
  ceiling(n / ceiling(n / most))
}

fitting_rows <- function(figures, width, key) {
  n <- length(figures)
  own <- max(lengths(lapply(figures, `[[`, "groups")))
  each <- series_height + if (own > 1L) own_key_row * own else 0
  max(3, series_title + key_height(key, width) + each * ceiling(n / series_columns(n, width)))
}

# A page of figures of x on the current device or in a file; see plot.codend_trajectory() for both.
# key: list(title, labels (of groups), missing (what a cross stands for, or NULL)), or NULL.
plot_series <- function(x, figures, title, key, file, width, height) {
  show_picture(x, function(page) draw_series(figures, title, key, page), file, width, height, title,
    fitting_rows(figures, width, key))
}

# How much smaller than at their full size figures may be drawn on a page that is too small for
# them.
least_zoom <- 0.6

# Columns, rows, the inches above them and the zoom at which they find room on a page (inches), or
# NULL.
series_layout <- function(n, key, page) {
  for (zoom in seq(1, least_zoom, by = -0.05)) {
    columns <- series_columns(n, page[1L] / zoom)
    rows <- ceiling(n / columns)
    above <- series_title + key_height(key, page[1L] / zoom)
    if ((page[2L] / zoom - above) / rows >= least_series[2L]) {
      return(list(columns = columns, rows = rows, above = above, zoom = zoom))
    }
  }
}

draw_series <- function(figures, title, key, page) {
  n <- length(figures)
  layout <- series_layout(n, key, page)
  if (is.null(layout)) abort_small_page(page, n)
  zoom <- layout$zoom
  draw <- function() {
    for (figure in figures) {
      draw_one_series(figure, max(1L, length(key$labels), length(figure$groups)), zoom)
    }
  }
  draw_under(title, page / zoom, draw, layout$above, c(0.42, 0.6, 0.28, 0.12), key, zoom = zoom,
    mfrow = c(layout$rows, layout$columns))
}

abort_small_page <- function(page, n) {
  size <- round(page, 1)
  abort_argument("A page of {size[1]} by {size[2]} inches is too small for {n} figure{?s}; make it
    larger or choose fewer.")
}

# Figures under a title, which draw() draws. page: inches before they are made smaller by zoom;
# above: inches over the figures; mai: a figure's own margins; said: a line under the title; mfrow:
# of figures of one size.
draw_under <- function(title, page, draw, above = series_title + 0.05,
                       mai = c(0.52, 0.7, 0.3, 0.12), key = NULL, said = NULL, zoom = 1,
                       mfrow = c(1L, 1L)) {
  kept <- graphics::par(no.readonly = TRUE)
  on.exit({
    graphics::layout(1)
    graphics::par(kept)
  })
  graphics::par(
    mfrow = mfrow, omi = c(0, 0, above, 0) * zoom, mai = mai * zoom, cex = 0.75 * zoom,
    mgp = c(1.5, 0.4, 0), tcl = -0.25, las = 1, family = "sans", bg = "white"
  )
  draw()
  draw_head(title, key, page)
  if (is.null(said)) return(invisible())
  graphics::text(0.12, page[2L] - series_title - 0.05, said, adj = c(0, 0.5), cex = 0.95)
}

# What all figures have: a grid, its ground, axes without a line and a heading.
quiet_grid <- function(...) graphics::grid(..., col = "#DDE3E8", lty = 1, lwd = 0.6)

quiet_ground <- function(...) {
  usr <- graphics::par("usr")
  graphics::rect(usr[1L], usr[3L], usr[2L], usr[4L], col = "#F6F9FB", border = NA)
  quiet_grid(...)
}

quiet_axis <- function(...) graphics::axis(..., col = "grey40", lwd = 0, lwd.ticks = 1)

figure_heading <- function(text, zoom = 1) {
  graphics::mtext(text, side = 3, line = 0.3, adj = 0, cex = 0.72 * zoom, font = 2)
}

series_symbols <- c(16L, 17L, 15L, 18L, 1L)

# How a group's line looks. One group alone has the colour of its quantity.
group_style <- function(group, groups, unit = "", colours = NULL) {
  colour <- if (groups > 1L) {
    if (is.null(colours)) series_colours(groups)[group] else colours[group]
  } else if (unit %in% c("N", "kN")) {
    tension_palette("rope")[100L]
  } else {
    water_colour
  }
  round <- (group - 1L) %/% length(series_palette)
  list(
    colour = colour, symbol = series_symbols[(group - 1L) %% length(series_symbols) + 1L],
    # beyond five groups colours come again, with other dashes
    dash = c("solid", "33", "12")[round %% 3L + 1L]
  )
}

draw_one_series <- function(figure, groups, zoom) {
  figure <- in_millions(figure)
  graphics::plot.new()
  x <- unlist(lapply(figure$lines, `[[`, "x"))
  y <- unlist(lapply(figure$lines, function(line) c(line$y, line$low, line$high)))
  across <- range(c(x, figure$missing))
  if (!is.null(figure$ticks)) across <- c(0.6, length(figure$ticks) + 0.4)
  up <- series_range(c(y, figure$beside), figure$words)
  if (length(figure$groups) > 1L) {
    wanted <- zoom * own_key_row * (length(figure$groups) + 0.5)
    key <- min(0.6, wanted / graphics::par("pin")[2L])
    up[2L] <- up[1L] + diff(up) / (1 - key)
  }
  graphics::plot.window(across, up)
  quiet_ground(nx = if (is.null(figure$ticks)) NULL else NA)
  # dashed lines over others that they equal
  dashed <- vapply(figure$lines, `[[`, NA, "dashed")
  for (line in figure$lines[order(dashed)]) {
    style <- group_style(line$group, groups, figure$unit, figure$colours)
    joined <- !isFALSE(line$joined)
    draw_band(line, style$colour)
    if (joined) {
      graphics::lines(line$x, line$y, col = style$colour, lwd = 1.6 * zoom,
        lty = if (line$dashed) "33" else style$dash)
    }
    if (line$symbols) {
      colour <- if (joined) style$colour else grDevices::adjustcolor(style$colour, 0.35)
      graphics::points(line$x, line$y, col = colour, pch = style$symbol, cex = 0.8)
    }
  }
  if (length(figure$missing)) {
    usr <- graphics::par("usr")
    graphics::points(figure$missing, rep(usr[3L] + 0.04 * (usr[4L] - usr[3L]),
      length(figure$missing)), pch = 4L, col = "#202428", cex = 0.9, lwd = 1.5)
  }
  if (is.null(figure$ticks)) quiet_axis(1) else {
    quiet_axis(1, at = seq_along(figure$ticks), labels = figure$ticks)
  }
  quiet_axis(2)
  graphics::box(col = "grey40")
  graphics::title(xlab = figure$across, line = 1.3)
  figure_heading(words_and_unit(figure$words, figure$unit), zoom)
  if (length(figure$groups) > 1L) draw_own_key(figure, zoom)
}

# What a line may be off, where that is known all along: between its `low` and `high`.
draw_band <- function(line, colour) {
  if (!length(line$low) || !all(is.finite(line$low))) return(invisible())
  graphics::polygon(c(line$x, rev(line$x)), c(line$low, rev(line$high)),
    col = grDevices::adjustcolor(colour, 0.25), border = NA)
}

# A figure's own key, in the room above its lines.
draw_own_key <- function(figure, zoom) {
  usr <- graphics::par("usr")
  inch <- zoom * c(usr[2L] - usr[1L], usr[4L] - usr[3L]) / graphics::par("pin")
  n <- length(figure$groups)
  # a group may have several lines, such as the panels of one side of a net
  first <- match(seq_len(n), vapply(figure$lines, `[[`, 0, "group"))
  for (group in seq_len(n)) {
    style <- group_style(group, n, colours = figure$colours)
    y <- usr[4L] - own_key_row * (group - 0.3) * inch[2L]
    graphics::segments(usr[1L] + 0.08 * inch[1L], y, usr[1L] + 0.42 * inch[1L], y,
      col = style$colour, lwd = 1.6 * zoom,
      lty = if (figure$lines[[first[group]]]$dashed) "33" else style$dash)
    graphics::text(usr[1L] + 0.48 * inch[1L], y, figure$groups[group], adj = c(0, 0.5), cex = 0.85)
  }
}

words_and_unit <- function(words, unit) {
  ifelse(is.na(unit) | !nzchar(unit), words, sprintf("%s (%s)", words, unit))
}

# Numbers of seven digits and more have no room beside an axis.
in_millions <- function(figure) {
  shown <- c(unlist(lapply(figure$lines, `[[`, "y")), figure$beside)
  largest <- max(0, abs(shown), na.rm = TRUE)
  if (largest < 1e6) return(figure)
  figure$unit <- paste("million", figure$unit)
  if (!is.null(figure$beside)) figure$beside <- figure$beside / 1e6
  figure$lines <- lapply(figure$lines, function(line) {
    some <- intersect(c("y", "low", "high"), names(line))
    line[some] <- lapply(line[some], `/`, 1e6)
    line
  })
  figure
}

# Ends of a figure's axis, no narrower than a thousandth of the values: what does not change is a
# straight line, not its rounding. Depths grow downwards.
series_range <- function(y, words) {
  y <- y[is.finite(y)]
  if (!length(y)) return(c(0, 1))
  ends <- range(y)
  least <- if (any(ends != 0)) 1e-3 * max(abs(ends)) else 1
  if (diff(ends) < least) ends <- mean(ends) + c(-0.5, 0.5) * least
  if (grepl("depth", words)) rev(ends) else ends
}

# ---- title and key ------------------------------------------------------------------------------

# Entries of the key: its title, its groups where there are several, and what a cross stands for.
key_entries <- function(key) {
  n <- length(key$labels)
  groups <- lapply(seq_len(n), function(group) {
    c(list(label = key$labels[group], line = TRUE, mark = TRUE), group_style(group, n))
  })
  cross <- list(label = key$missing, line = FALSE, mark = TRUE, colour = "#202428", symbol = 4L)
  title <- list(label = key$title, line = FALSE, mark = FALSE)
  c(if (n > 1L) c(list(title), groups), if (!is.null(key$missing)) list(cross))
}

# Where entries go: list(row, left), by the inches that each takes.
key_places <- function(entries, width) {
  takes <- vapply(entries, function(entry) {
    0.2 + 0.07 * nchar(entry$label, "width") + if (entry$mark) 0.46 else 0
  }, 0)
  row <- left <- takes
  x <- 0
  at <- 1
  for (k in seq_along(takes)) {
    if (x > 0 && x + takes[k] > width - 0.24) {
      x <- 0
      at <- at + 1
    }
    row[k] <- at
    left[k] <- 0.12 + x
    x <- x + takes[k]
  }
  list(row = row, left = left)
}

key_height <- function(key, width) {
  entries <- key_entries(key)
  if (length(entries)) key_row * max(key_places(entries, width)$row) + 0.04 else 0
}

# page: inches before they are made smaller.
draw_head <- function(title, key, page) {
  zoom <- zoom_of(page)
  graphics::par(
    fig = c(0, 1, 0, 1), omi = rep(0, 4), mai = rep(0, 4), new = TRUE, cex = 0.75 * zoom
  )
  graphics::plot.new()
  graphics::plot.window(c(0, page[1L]), c(0, page[2L]), xaxs = "i", yaxs = "i")
  # a long title shrinks to the page
  cex <- min(1.33, 1.33 * (page[1L] - 0.24) / graphics::strwidth(title, cex = 1.33, font = 2))
  graphics::text(0.12, page[2L] - 0.2, title, adj = c(0, 0.5), font = 2, cex = cex)
  entries <- key_entries(key)
  if (!length(entries)) return(invisible())
  place <- key_places(entries, page[1L])
  for (k in seq_along(entries)) {
    entry <- entries[[k]]
    x <- place$left[k]
    y <- page[2L] - series_title - key_row * (place$row[k] - 0.5)
    if (entry$line) {
      graphics::segments(x, y, x + 0.38, y, col = entry$colour, lwd = 1.6 * zoom, lty = entry$dash)
    }
    if (entry$mark) {
      graphics::points(
        x + 0.19, y, pch = entry$symbol, col = entry$colour, lwd = 1.5 * zoom, cex = 0.9
      )
    }
    graphics::text(x + if (entry$mark) 0.46 else 0, y, entry$label, adj = c(0, 0.5))
  }
}
