#' Plot sensitivities of measures
#'
#' Small figures next to one another, a tornado for each measure: how much it changes with every
#' field, in percent per percent, the fields that matter most on top. Bars are filled where the
#' sensitivity is smooth and open where it is not; there the two ticks show the secants to 1 % less
#' and 1 % more.
#'
#' @param x Sensitivities, from [sensitivities()].
#' @param measures Names of measures, as [measures()] has them; all that change at all when `NULL`.
#' @param file `NULL` for the current graphics device, or a file to write, ending in `.png`, `.pdf`
#'   or `.svg`. It is written whole or not at all.
#' @param width,height Size of the file's page, inches; a `height` of `NULL` fits the figures.
#' @param ... Not used.
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @export
#' @examples
#' found <- sensitivities(settle("towed_cable"), to = c("towing.speed", "ropes.cable.length"))
#' plot(found, measures = c("total_drag_kN", "body_depth_m"))
plot.codend_sensitivities <- function(x, measures = NULL, file = NULL, width = 10, height = NULL,
                                      ...) {
  known <- unique(x$measure[is.finite(x$elasticity) & x$elasticity != 0])
  measures <- chosen_some(measures, known)
  title <- paste0("What changes ", attr(x, "gear_name"), ", ", attr(x, "conditions"))
  # parts that change together stand for one another
  x$field <- sub(" [+] .*", " ...", x$field)
  said <- paste("Percent of the measure per percent of the field. Open bars: not smooth, ticks are",
    "secants to 1 % less and 1 % more.")
  plot_tornados(x, measures, title, said, draw_tornado, file, width, height)
}

# Height of a bar, and minimum width and height of a tornado with the names of its fields (inches).
bar_height <- 0.17
least_tornado <- c(4.5, 1.2)

tornado_columns <- function(n, width) min(n, max(1L, floor(width / least_tornado[1L])))

# A page of figures of bars, one for each measure. said: the line under the title; draw: a
# function(rows, name) of one figure.
plot_tornados <- function(x, measures, title, said, draw, file, width, height) {
  n <- length(measures)
  above <- series_title + key_row
  rows <- ceiling(n / tornado_columns(n, width))
  fields <- length(unique(x$field))
  show_picture(x, function(page) draw_tornados(x, measures, title, said, draw, page, above), file,
    width, height, title,
    max(3, min(100, above + rows * max(least_tornado[2L], 0.75 + bar_height * fields))))
}

draw_tornados <- function(x, measures, title, said, draw, page, above) {
  columns <- tornado_columns(length(measures), page[1L])
  rows <- ceiling(length(measures) / columns)
  if ((page[2L] - above) / rows < least_tornado[2L] - 1e-9) abort_small_page(page, length(measures))
  unit <- attr(x, "measure_unit")
  left <- min(2.6, 0.35 + 0.068 * max(nchar(x$field)))
  draw_all <- function() {
    for (name in measures) draw(structure(x[x$measure == name, ], measure_unit = unit), name)
  }
  draw_under(title, page, draw_all, above, c(0.42, left, 0.28, 0.12), said = said,
    mfrow = c(rows, columns))
}

# An empty figure of bars with a field's name beside each.
plot_bars_frame <- function(across, fields) {
  n <- length(fields)
  graphics::plot.new()
  graphics::plot.window(across, c(0.4, n + 0.6), yaxs = "i")
  quiet_ground(ny = NA)
  graphics::abline(v = 0, col = "grey40")
  quiet_axis(1)
  graphics::axis(2, at = seq_len(n), labels = fields, lwd = 0, cex.axis = 0.85)
  graphics::box(col = "grey40")
}

draw_tornado <- function(rows, name) {
  unit <- attr(rows, "measure_unit")[[name]]
  rows <- rows[order(abs(rows$elasticity)), ]
  per <- rows$elasticity / rows$slope
  ends <- cbind(rows$secant_below * per, rows$secant_above * per)
  ends[rows$smooth, ] <- NA
  # secants over a jump would leave no room for the rest
  most <- 1.5 * max(abs(rows$elasticity), na.rm = TRUE)
  ends[] <- pmin(pmax(ends, -most), most)
  at <- seq_len(nrow(rows))
  plot_bars_frame(range(0, rows$elasticity, ends, na.rm = TRUE), rows$field)
  graphics::rect(pmin(0, rows$elasticity), at - 0.36, pmax(0, rows$elasticity), at + 0.36,
    col = ifelse(rows$smooth, water_colour, NA), border = water_colour, lwd = 1.2)
  for (side in 1:2) {
    graphics::segments(ends[, side], at - 0.36, ends[, side], at + 0.36, col = "#202428", lwd = 1.6)
  }
  figure_heading(words_of(name, unit))
}
