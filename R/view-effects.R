#' Plot main effects of fields
#'
#' Small figures beside one another, of every measure against every field: its mean over designs
#' with that value of the field, or in a group of values about it. All figures of a measure have one
#' scale, so that a field that matters little is flat. Depths grow downwards.
#'
#' @param x Effects, from [main_effects()].
#' @param file `NULL` for the current graphics device, or a file to write, ending in `.png`, `.pdf`
#'   or `.svg`. It is written whole or not at all.
#' @param width,height Size of the file's page, inches; a `height` of `NULL` fits the figures.
#' @param ... Not used.
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @export
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:5, "knot"),
#'   ropes.cable.length = c("400 m", "700 m"))
#' plot(main_effects(found, c("total_drag_kN", "greatest_depth_m")))
plot.codend_effects <- function(x, file = NULL, width = 10, height = NULL, ...) {
  pairs <- unique(as.data.frame(unclass(x)[c("measure", "field")]))
  figures <- lapply(seq_len(nrow(pairs)), function(k) {
    effects_figure(x, x$measure == pairs$measure[k] & x$field == pairs$field[k])
  })
  name <- attr(x, "gear_name")
  title <- paste0("Main effects", if (!is.null(name)) paste(" of", name))
  plot_series(figures, title, NULL, file, width, height)
  invisible(x)
}

effects_figure <- function(x, rows) {
  unit <- x$unit[rows][1L]
  value <- x$value[rows]
  number <- suppressWarnings(as.double(value))
  text <- anyNA(number)
  list(
    words = words_of(x$measure[rows][1L], unit), unit = unit,
    across = field_words(x, x$field[rows][1L]),
    lines = list(list(x = if (text) seq_along(value) else number, y = x$mean[rows], group = 1L,
      dashed = FALSE, symbols = TRUE)),
    ticks = if (text) value, beside = x$mean[x$measure == x$measure[rows][1L]]
  )
}
