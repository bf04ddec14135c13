#' Plot a calibration
#'
#' Two figures for each thing matched: what the gear settles to against what was measured (open: as
#' it was, filled: calibrated), with the line on which they agree, and the residuals by a condition.
#'
#' @param x A calibration, from [calibrate()].
#' @param by A column of the data to draw residuals by; the first that sets a field when `NULL`, or
#'   the rows' numbers where there is none.
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examples
#' runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
#' plot(calibrate("towed_cable", runs,
#'   change = list(ropes.cable.diameter = c("10 mm", "30 mm")), match = Drag ~ total_drag_kN))
plot.codend_calibration <- function(x, by = NULL, file = NULL, width = 8, height = NULL, ...) {
  data <- x$task$data
  if (is.null(by)) by <- c(x$conditions, "row")[1L]
  known <- c(names(data), "row")
  by <- chosen(by, known)
  along <- if (by == "row") seq_len(nrow(data)) else data[[by]]
  if (!is.numeric(along)) along <- factor(along, unique(along))
  title <- paste0("Calibration of ", x$gear$plan$name)
  draw <- function() {
    graphics::par(mfrow = c(nrow(x$match), 2L))
    for (k in seq_len(nrow(x$match))) {
      rows <- x$matched[x$matched$match == x$match$text[k], ]
      draw_agreement(rows, x$match$text[k])
      draw_residuals(rows, along[rows$row], by, x$match$error[k])
    }
  }
  show_picture(x, function(page) draw_under(title, page, draw), file, width, height, title,
    min(100, series_title + key_row + 2.8 * nrow(x$match)))
}

draw_agreement <- function(rows, text) {
  ends <- range(rows$measured, rows$fitted, rows$begun, finite = TRUE)
  graphics::plot(ends, ends, type = "n", xlab = "measured", ylab = "")
  quiet_grid()
  graphics::abline(0, 1, col = "grey40")
  graphics::points(rows$measured, rows$begun, pch = 21, col = "grey55", bg = "white", cex = 0.8)
  graphics::points(rows$measured, rows$fitted, pch = 21, col = water_colour, bg = water_colour,
    cex = 0.8)
  figure_heading(paste0(text, ", settled (open: before, filled: now)"))
}

draw_residuals <- function(rows, along, by, error) {
  at <- if (is.factor(along)) as.integer(along) else along
  graphics::plot(at, rows$residual, type = "n", xlab = by, ylab = "",
    xaxt = if (is.factor(along)) "n" else "s",
    ylim = range(rows$residual, -2 * error, 2 * error))
  if (is.factor(along)) graphics::axis(1, seq_along(levels(along)), levels(along))
  graphics::abline(h = c(-2, 0, 2) * error, col = c("grey60", "grey40", "grey60"),
    lty = c(2, 1, 2))
  graphics::points(at, rows$residual, pch = 21, col = water_colour, bg = water_colour, cex = 0.8)
  figure_heading("Measured less settled; dashed: twice the error")
}
