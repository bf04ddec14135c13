#' Plot a trade-off
#'
#' The curve of two objectives, and next to it how each field goes along it, as a share of what it
#' changes by.
#'
#' @param x A trade-off, from [trade_off()].
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examplesIf requireNamespace("nloptr", quietly = TRUE)
#' plot(trade_off("towed_cable",
#'   minimise = list(drag = ~ total_drag_kN, depth = ~ -body_depth_m),
#'   change = list(ropes.cable.length = c("600 m", "1200 m")), points = 4
#' ))
plot.codend_trade_off <- function(x, file = NULL, width = 9, height = NULL, ...) {
  title <- paste0("Trade-off of ", attr(x, "gear_name"))
  show_picture(x, function(page) draw_under(title, page, function() draw_trade_off(x)), file, width,
    height, title, 4.5)
}

draw_trade_off <- function(x) {
  graphics::par(mfrow = c(1L, 2L))
  good <- x$kept & x$optimal
  graphics::plot(x[[1L]], x[[2L]], type = "n", xlab = attr(x, "aims")[1L], ylab = "")
  quiet_grid()
  graphics::lines(x[[1L]], x[[2L]], col = "grey60")
  graphics::points(x[[1L]], x[[2L]], pch = 21, col = water_colour,
    bg = ifelse(good, water_colour, "white"))
  figure_heading(paste0(attr(x, "aims")[2L],
    if (!all(good)) " (open: not shown to be optimal)"))
  fields <- seq(3L, ncol(x) - 2L)
  shares <- vapply(x[fields], function(values) {
    width <- diff(range(values))
    # what an optimiser leaves of a value at the end of its range is no change
    if (width <= 1e-6 * max(abs(values))) 0 * values else (values - min(values)) / width
  }, numeric(nrow(x)))
  colours <- grDevices::hcl.colors(max(2L, length(fields)), "Dark 3")
  graphics::plot(range(x[[1L]]), c(0, 1 + 0.13 * length(fields)), type = "n", yaxt = "n",
    xlab = attr(x, "aims")[1L], ylab = "")
  graphics::axis(2, at = c(0, 1), labels = c("least", "most"))
  for (k in seq_along(fields)) graphics::lines(x[[1L]], shares[, k], col = colours[k], lwd = 1.8)
  ends <- vapply(x[fields], function(values) {
    paste(four_figures(range(values)), collapse = " to ")
  }, "")
  graphics::legend("top", paste0(names(x)[fields], ", ", ends), col = colours, lwd = 1.8, bty = "n",
    cex = 0.8)
  figure_heading("Fields along it")
}
