#' Plot a trajectory against time
#'
#' Small figures beside one another: what the schedule changes (speed, course, warps), then the
#' measures of the gear, each against time with its unit. Tensions and forces have the colour of
#' taut ropes; depths grow downwards.
#'
#' @param x A trajectory, from [tow()].
#' @param measures Names of measures, as [measures()] has them; all, and what the schedule changes,
#'   when `NULL`.
#' @param file `NULL` for the current graphics device, or a file to write, ending in `.png`, `.pdf`
#'   or `.svg`. It is written whole or not at all.
#' @param width,height Size of the file's page, inches; a `height` of `NULL` fits the figures.
#' @param ... Not used.
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @examples
#' plot(tow("towed_cable", until = 30, every = 1, speed = data.frame(
#'   time = c(0, 10), value = c("4 knot", "5 knot")
#' )))
#' @export
plot.codend_trajectory <- function(x, measures = NULL, file = NULL, width = 10, height = NULL,
                                   ...) {
  check_inches("width", width)
  if (!is.null(height)) check_inches("height", height)
  if (!is.null(file)) picture_extension(file, picture_types)
  series <- trajectory_series(x, measures)
  title <- paste("Tow of", x$gear$plan$name)
  draw <- function(page) draw_series(series, title, page)
  if (is.null(file)) {
    draw(grDevices::dev.size())
  } else {
    if (is.null(height)) height <- fitting_rows(length(series), width)
    write_picture(file, c(width, height), title, draw)
  }
  invisible(x)
}

# What is drawn against time: a list of list(words, unit, time (s), value).
trajectory_series <- function(trajectory, wanted) {
  table <- as.data.frame(trajectory, what = "measures")
  known <- unique(table$measure)
  if (!is.null(wanted) && !(is.character(wanted) && length(wanted) && all(wanted %in% known))) {
    abort_view("{.arg measures} is {.val {wanted}}; it must be any of {.val {known}}.",
      list(wanted = wanted, known = known))
  }
  shown <- if (is.null(wanted)) known else wanted
  of_measures <- lapply(shown, function(measure) {
    of <- table[table$measure == measure, ]
    list(
      words = measure_words(measure)$words, unit = of$unit[1L], time = of$time_s, value = of$value
    )
  })
  c(if (is.null(wanted)) condition_series(trajectory), of_measures)
}

# What of the schedule changes, the vessel's place apart.
condition_series <- function(trajectory) {
  table <- condition_units(trajectory$conditions)
  table <- table[setdiff(names(table), c("x_m", "y_m"))]
  known <- c(speed_m_per_s = "vessel speed", course_deg = "vessel course", heave_m = "heave")
  unit <- c(speed_m_per_s = "m/s", course_deg = "deg", heave_m = "m")
  changed <- names(table)[-1L][vapply(table[-1L], function(v) any(v != v[1L]), NA)]
  lapply(changed, function(name) {
    own <- name %in% names(known)
    list(
      words = if (own) known[[name]] else paste(gsub("_", " ", name), "out"),
      unit = if (own) {
        unit[[name]]
      } else if (is.null(trajectory$si$ropes[[name]])) {
        "share"
      } else {
        "m"
      },
      time = table$time_s, value = table[[name]]
    )
  })
}

# Inches of the page: of one figure, and of the title above them.
least_series <- c(2.4, 1.3)
series_height <- 1.6
series_title <- 0.4

series_columns <- function(n, width) min(n, 4L, max(1L, floor(width / least_series[1L])))

fitting_rows <- function(n, width) {
  rows <- ceiling(n / series_columns(n, width))
  max(3, series_title + series_height * rows)
}

draw_series <- function(series, title, page) {
  n <- length(series)
  columns <- series_columns(n, page[1L])
  rows <- ceiling(n / columns)
  if ((page[2L] - series_title) / rows < least_series[2L]) {
    abort_view(
      "A page of {page[1]} by {page[2]} inches is too small for {n} figure{?s}; make it larger or
      choose some {.arg measures}.",
      list(page = round(page, 1), n = n)
    )
  }
  kept <- graphics::par(no.readonly = TRUE)
  on.exit(graphics::par(kept))
  graphics::par(
    mfrow = c(rows, columns), omi = c(0, 0, series_title, 0), mai = c(0.42, 0.6, 0.28, 0.12),
    cex = 0.75, mgp = c(1.5, 0.4, 0), tcl = -0.25, las = 1, family = "sans", bg = "white"
  )
  minutes <- max(series[[1L]]$time) > 180
  for (one in series) draw_one_series(one, minutes)
  graphics::mtext(title, side = 3, outer = TRUE, line = 0.4, adj = 0.01, font = 2, cex = 1)
}

draw_one_series <- function(one, minutes) {
  time <- one$time / if (minutes) 60 else 1
  graphics::plot.new()
  graphics::plot.window(range(time), series_range(one))
  usr <- graphics::par("usr")
  graphics::rect(usr[1L], usr[3L], usr[2L], usr[4L], col = "#F6F9FB", border = NA)
  graphics::grid(col = "#DDE3E8", lty = 1, lwd = 0.6)
  of_force <- one$unit %in% c("N", "kN")
  colour <- if (of_force) tension_palette("rope")[100L] else water_colour
  graphics::lines(time, one$value, col = colour, lwd = 1.6)
  graphics::axis(1, col = "grey40", lwd = 0, lwd.ticks = 1)
  graphics::axis(2, col = "grey40", lwd = 0, lwd.ticks = 1)
  graphics::box(col = "grey40")
  graphics::title(xlab = if (minutes) "time (min)" else "time (s)", line = 1.3)
  graphics::mtext(sprintf("%s (%s)", one$words, one$unit), side = 3, line = 0.3, adj = 0,
    cex = 0.72, font = 2)
}

# Ends of a figure's axis, no narrower than a thousandth of the values: what does not change is a
# straight line, not its rounding. Depths grow downwards.
series_range <- function(one) {
  ends <- range(one$value)
  least <- if (any(ends != 0)) 1e-3 * max(abs(ends)) else 1
  if (diff(ends) < least) ends <- mean(ends) + c(-0.5, 0.5) * least
  if (grepl("depth", one$words)) rev(ends) else ends
}
