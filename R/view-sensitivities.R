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
  show_picture(function(page) draw_tornados(x, measures, title, said, page, draw_tornado), file,
    width, height, title, tornado_height(x, measures, width))
  invisible(x)
}

# Inches of a bar, and of a tornado with its fields' names.
bar_height <- 0.17
least_tornado <- 4.5

tornado_columns <- function(n, width) min(n, max(1L, floor(width / least_tornado)))

# Inches of a page of `bars` a figure.
tornado_height <- function(x, measures, width) {
  rows <- ceiling(length(measures) / tornado_columns(length(measures), width))
  bars <- length(unique(x$field))
  max(3, min(100, series_title + key_row + rows * (0.75 + bar_height * bars)))
}

# said: the line under the title; draw: a function(rows, name) of one figure.
draw_tornados <- function(x, measures, title, said, page, draw) {
  columns <- tornado_columns(length(measures), page[1L])
  rows <- ceiling(length(measures) / columns)
  above <- series_title + key_row
  if ((page[2L] - above) / rows < 1.2) {
    page <- round(page, 1)
    n <- length(measures)
    abort_argument("A page of {page[1]} by {page[2]} inches is too small for {n} figure{?s}; make it
      larger or choose fewer.")
  }
  kept <- graphics::par(no.readonly = TRUE)
  on.exit(graphics::par(kept))
  left <- min(2.6, 0.35 + 0.068 * max(nchar(x$field)))
  graphics::par(
    mfrow = c(rows, columns), omi = c(0, 0, above, 0), mai = c(0.42, left, 0.28, 0.12),
    cex = 0.75, mgp = c(1.5, 0.4, 0), tcl = -0.25, las = 1, family = "sans", bg = "white"
  )
  unit <- attr(x, "measure_unit")
  for (name in measures) draw(structure(x[x$measure == name, ], measure_unit = unit), name)
  draw_head(title, list(missing = NULL), page)
  graphics::text(0.12, page[2L] - series_title - 0.05, said, adj = c(0, 0.5), cex = 0.95)
}

# An empty figure of bars with a field's name beside each.
plot_bars_frame <- function(across, fields) {
  n <- length(fields)
  graphics::plot.new()
  graphics::plot.window(across, c(0.4, n + 0.6), yaxs = "i")
  usr <- graphics::par("usr")
  graphics::rect(usr[1L], usr[3L], usr[2L], usr[4L], col = "#F6F9FB", border = NA)
  graphics::grid(ny = NA, col = "#DDE3E8", lty = 1, lwd = 0.6)
  graphics::abline(v = 0, col = "grey40")
  graphics::axis(1, col = "grey40", lwd = 0, lwd.ticks = 1)
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
  graphics::mtext(words_of(name, unit), side = 3, line = 0.3, adj = 0, cex = 0.72, font = 2)
}
