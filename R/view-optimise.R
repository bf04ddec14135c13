#' Plot an optimum
#'
#' Three figures: the objective at each settled gear of the search (filled where all conditions are
#' kept, open where not), where each field began and ended in its range, and how far each condition
#' is from its limit.
#'
#' @param x An optimum, from [optimise_gear()].
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examplesIf requireNamespace("nloptr", quietly = TRUE)
#' plot(optimise_gear("towed_cable", ~ -body_depth, ~ total_drag <= "9 kN",
#'   list(ropes.cable.length = c("600 m", "1200 m"), towing.speed = c("3 knot", "5 knot"))
#' ))
plot.codend_optimum <- function(x, file = NULL, width = 10, height = NULL, ...) {
  title <- paste0("Optimum of ", x$gear$plan$name)
  fitting <- min(100, max(4, series_title + 1.6 + 0.3 * (nrow(x$fields) + nrow(x$keep))))
  show_picture(x, function(page) draw_under(title, page, function() draw_optimum(x)), file, width,
    height, title, fitting)
}

draw_optimum <- function(x) {
  bars <- c(nrow(x$fields), max(1, nrow(x$keep)))
  if (nrow(x$keep)) {
    graphics::layout(matrix(c(1, 1, 2, 3), 2L), widths = c(1, 1.35), heights = bars + 2)
  } else {
    graphics::layout(matrix(1:2, 1L), widths = c(1, 1.35))
  }
  draw_search(x)
  fields <- x$fields
  width <- fields$upper - fields$lower
  draw_arrows(
    fields$field, (fields$begun - fields$lower) / width, (fields$value - fields$lower) / width,
    trimws(paste(four_figures(fields$value), fields$unit)), "Fields in their ranges"
  )
  if (nrow(x$keep)) draw_kept(x$keep)
}

draw_search <- function(x) {
  rows <- x$history
  good <- rows$kept
  graphics::plot(
    seq_len(nrow(rows)), rows$aim, type = "n", xlab = "Step of the search", ylab = "", main = ""
  )
  quiet_grid()
  graphics::abline(h = x$aim$value, col = "grey40", lty = 3)
  graphics::lines(seq_len(nrow(rows)), rows$aim, col = "grey60")
  graphics::points(seq_len(nrow(rows)), rows$aim, pch = 21, col = water_colour,
    bg = ifelse(good, water_colour, "white"))
  figure_heading(x$aim$text)
}

# Arrows from shares to shares of ranges, with names at the left and values at the right.
draw_arrows <- function(names, from, to, values, title) {
  n <- length(names)
  at <- rev(seq_len(n))
  # inches of names and values at the size that they are drawn in
  wide <- function(text) max(graphics::strwidth(text, "inches", cex = 0.85))
  kept <- graphics::par("mai")
  graphics::par(mai = replace(kept, c(2, 4), c(wide(names), wide(values)) + 0.2))
  graphics::plot.new()
  graphics::plot.window(c(0, 1), c(0.4, n + 0.6), yaxs = "i")
  graphics::segments(0, at, 1, at, col = "#C6D0D8", lwd = 5, lend = 1)
  graphics::points(from, at, pch = 21, bg = "white", col = water_colour)
  graphics::segments(from, at, to, at, col = water_colour, lwd = 1.6)
  graphics::points(to, at, pch = 21, bg = water_colour, col = water_colour)
  graphics::axis(2, at = at, labels = names, lwd = 0, cex.axis = 0.85)
  graphics::axis(4, at = at, labels = values, lwd = 0, cex.axis = 0.85)
  graphics::axis(1, at = c(0, 1), labels = c("lower end", "upper end"), lwd = 0, cex.axis = 0.85)
  figure_heading(paste0(title, " (open: before, filled: now)"))
  graphics::par(mai = kept)
}

draw_kept <- function(keep) {
  n <- nrow(keep)
  at <- rev(seq_len(n))
  off <- 100 * (keep$left - keep$right) / ifelse(keep$right == 0, 1, abs(keep$right))
  wide <- max(graphics::strwidth(keep$text, "inches", cex = 0.85))
  kept <- graphics::par("mai")
  graphics::par(mai = replace(kept, 2, wide + 0.2))
  graphics::plot.new()
  graphics::plot.window(range(0, off, 1, -1), c(0.4, n + 0.6), yaxs = "i")
  graphics::rect(pmin(0, off), at - 0.3, pmax(0, off), at + 0.3,
    col = ifelse(keep$holds, water_colour, "#B03A2E"), border = NA)
  graphics::abline(v = 0, col = "grey40")
  # what is at its limit has no bar
  graphics::points(off, at, pch = 16, col = ifelse(keep$holds, water_colour, "#B03A2E"))
  quiet_axis(1)
  graphics::axis(2, at = at, labels = keep$text, lwd = 0, cex.axis = 0.85)
  graphics::box(col = "grey40")
  figure_heading("Conditions: percent from their limit")
  graphics::par(mai = kept)
}

# Numbers to four figures, each by itself.
four_figures <- function(x) {
  with_plain_numbers(vapply(x, function(one) format(signif(one, 4), digits = 6), ""))
}
