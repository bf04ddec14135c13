#' Charts of trajectories, studies and tables
#'
#' `plot()` draws a chart with \pkg{ggplot2} on the current device, or writes it to a file.
#' `autoplot()` returns the chart as a ggplot object, to which themes, scales and labels can be
#' added.
#'
#' @section Charts:
#' - A trajectory ([tow()]): all measures and scheduled conditions against time. Bands are twice the
#'   standard error of [measures()] to both sides.
#' - A schedule ([tow_schedule()]): each input against time, with dashed lines where ropes break.
#' - Tensions along ropes ([as.data.frame()][as.data.frame.codend_state], `"rope_tensions"`):
#'   tension against the distance from the rope's start, a facet for each role. Every second rope is
#'   dashed, so that equal ropes are both visible.
#' - Meshes along a net (the same, `"mesh_openings"`): opening and angle against the distance aft. A
#'   line joins panels between the same two seams, such as the panels of the back.
#' - Variations ([vary()]): measures against the field that changes first, with a line for each
#'   combination of the other fields. A cross marks a gear that did not settle.
#' - Variations with drawn designs: each measure against each field, with a smooth curve (lowess).
#'   With `one_at_a_time`, only designs in which the other fields are as in the plan.
#' - [Effects][effects.codend_variations] of fields and of pairs: means of measures against a field.
#'   A pair has a line for each value of the other field, with the value at its end. Lines that are
#'   not parallel show an interaction.
#' - [Sobol' indices][effects.codend_variations]: first-order and total index of each field, with
#'   intervals.
#' - Sensitivities ([sensitivities()]): percent of the measure per percent of the field. Open bars
#'   are not smooth; ticks mark the secants to 1 % less and 1 % more.
#' - Uncertainties ([uncertainty()]): the standard uncertainty of each measure by origin or, with
#'   `sources`, the ten largest sources of one measure.
#' - A calibration ([calibrate()]): settled against measured values, and residuals against the
#'   column `by`. Open points are before, filled points after the calibration; dashed lines are at
#'   twice the error.
#' - An optimum ([optimise_gear()]): the objective, the margin of each condition and the fields at
#'   each step of the search. A negative margin is a violated condition. Filled points satisfy all
#'   conditions; dashed lines are the ends of a field's range.
#' - A trade-off ([trade_off()]): the second objective and all fields against the first objective.
#'   Open points are not shown to be optimal.
#' - Coefficients ([force_coefficients()]): computed values (lines) and published values (points)
#'   against the angle or the Reynolds number.
#'
#' @param x,object A result of a function above.
#' @param ... Arguments of `autoplot()`: `measures` and the arguments below.
#' @param measures Names of measures as in [measures()]. `NULL` (default) draws the main measures
#'   of the gear, at most nine.
#' @param most Largest number of pairs for each measure (default 6).
#' @param sources Name of a measure, or `NULL` (default).
#' @param by For a calibration: a column of the data, `"row"` for the row number, or `NULL`
#'   (default) for the first column that sets a field. For coefficients: `"angle"`, `"reynolds"`, or
#'   `NULL` (default) for the angle if available.
#' @param force Forces, any of `"twine"`, `"netting"`, `"otter_board"`, `"kite"`, `"sphere"` and
#'   `"wake"`, or `NULL` (default) for all.
#' @param until For a schedule: last time of the chart, s or string. `NULL` (default): the last time
#'   of its tables.
#' @param file `NULL` (default) for the current graphics device, or the path of a `.png`, `.pdf` or
#'   `.svg` file.
#' @param width,height Size of the file's page in inches. If `height` is `NULL` (default), it fits
#'   the chart.
#' @return `plot()` returns `x`, invisibly; `autoplot()` returns a ggplot. An invalid argument is an
#'   error of class `codend_error_argument`, a missing ggplot2 of class `codend_error_package`.
#' @seealso [plot.codend_state()] and [plot.codend_gear()] for drawings.
#' @name codend_charts
#' @examplesIf requireNamespace("ggplot2", quietly = TRUE)
#' found <- vary("towed_cable", towing.speed = paste(3:6, "knot"),
#'   ropes.cable.length = c("400 m", "700 m"))
#' plot(found, measures = c("total_drag_kN", "greatest_depth_m"))
NULL

#' @rdname codend_charts
#' @export
#' @rawNamespace
#'   S3method(plot, codend_schedule, plot.codend_trajectory)
#'   S3method(plot, codend_variations, plot.codend_trajectory)
#'   S3method(plot, codend_rope_tensions, plot.codend_trajectory)
#'   S3method(plot, codend_mesh_openings, plot.codend_trajectory)
#'   S3method(plot, codend_effects, plot.codend_trajectory)
#'   S3method(plot, codend_pair_effects, plot.codend_trajectory)
#'   S3method(plot, codend_sobol_indices, plot.codend_trajectory)
#'   S3method(plot, codend_sensitivities, plot.codend_trajectory)
#'   S3method(plot, codend_uncertainty, plot.codend_trajectory)
#'   S3method(plot, codend_calibration, plot.codend_trajectory)
#'   S3method(plot, codend_optimum, plot.codend_trajectory)
#'   S3method(plot, codend_trade_off, plot.codend_trajectory)
#'   S3method(plot, codend_coefficients, plot.codend_trajectory)
plot.codend_trajectory <- function(x, ..., file = NULL, width = 10, height = NULL) {
  check_package("ggplot2", "A chart")
  chart <- ggplot2::autoplot(x, ...)
  show_picture(x, function(page) print(chart), file, width, height, chart$labels$title,
    chart_height(chart))
}

# Returns the height of a page that fits the facets and bars of a chart [inch].
chart_height <- function(chart) {
  rows <- max(ggplot2::summarise_layout(ggplot2::ggplot_build(chart))$row)
  bars <- first_of(attr(chart, "bars"), 0)
  min(100, max(3, 1 + rows * max(1.8, 0.6 + 0.2 * bars)))
}

# ggplot2's name for the data in aes().
utils::globalVariables(".data")

chart_theme <- function() {
  ggplot2::theme_minimal() +
    ggplot2::theme(
      panel.background = ggplot2::element_rect(fill = "#F6F9FB", colour = "grey40"),
      panel.grid.minor = ggplot2::element_blank(),
      plot.background = ggplot2::element_rect(fill = "white", colour = NA),
      plot.title = ggplot2::element_text(size = 12, face = "bold"),
      plot.title.position = "plot",
      legend.position = "bottom", legend.margin = ggplot2::margin()
    )
}

label_and_unit <- function(words, unit) {
  ifelse(is.na(unit) | !nzchar(unit), words, sprintf("%s (%s)", words, unit))
}

# Returns "door spread (m)" for "door_spread_m".
measure_label <- function(measure, unit) label_and_unit(label_of(measure, unit), unit)

axis_labels <- function(values) {
  with_plain_numbers(format(values, scientific = FALSE, big.mark = ",", trim = TRUE))
}

series_symbols <- c(16L, 17L, 15L, 18L, 1L)

# Draws lines and points, with a facet for each quantity.
#
# `data` is a data frame with `value`, `panel` (label of the quantity), `across` (label of the
# horizontal axis) and `at` (position on it). Optional columns are `group`, `low` and `high` (ends
# of a band), `joined` (FALSE: a point without a line), `marked` (TRUE: visible points) and `open`
# (TRUE: open points). `settled` is FALSE for a gear without values. `grid`: facets by `panel` and
# `across`. `colours` and `dashes` belong to the groups in order of appearance.
series_chart <- function(data, title, key = NULL, grid = FALSE, colours = NULL, dashes = NULL) {
  given <- names(data)
  data$group <- in_order(if ("group" %in% given) data$group else "")
  for (name in setdiff(c("joined", "marked", "open", "settled"), given)) {
    data[[name]] <- name %in% c("joined", "settled")
  }
  if (!is.numeric(data$at)) data$at <- in_order(data$at)
  alone <- length(unique(data$across)) == 1L
  if (!grid && !alone) data$panel <- paste0(data$panel, "\nagainst ", data$across)
  data[c("panel", "across")] <- lapply(data[c("panel", "across")], in_order)
  unsettled <- unique(data[!data$settled, c("panel", "across", "at")])
  data <- data[!is.na(data$value), ]
  n <- nlevels(data$group)
  marked <- data[data$marked, ]
  faint <- marked[!marked$joined, ]
  ggplot2::ggplot(data, ggplot2::aes(.data[["at"]], .data[["value"]], colour = .data[["group"]],
    group = .data[["group"]])) +
    ggplot2::geom_blank(data = least_range(data)) +
    (if ("low" %in% given) {
      ggplot2::geom_ribbon(ggplot2::aes(ymin = .data[["low"]], ymax = .data[["high"]]),
        fill = water_colour, alpha = 0.25, colour = NA)
    }) +
    ggplot2::geom_line(ggplot2::aes(linetype = .data[["group"]]), data[data$joined, ]) +
    ggplot2::geom_point(ggplot2::aes(shape = .data[["group"]]), marked[marked$joined, ],
      fill = "white") +
    ggplot2::geom_point(data = faint, alpha = 0.35) +
    (if (any(marked$open)) {
      ggplot2::geom_point(data = marked[marked$open, ], shape = 21L, fill = "white")
    }) +
    (if (nrow(unsettled)) {
      ggplot2::geom_text(ggplot2::aes(.data[["at"]], -Inf), unsettled, label = "\u00d7", vjust = 0,
        size = 6, inherit.aes = FALSE)
    }) +
    (if (grid) {
      ggplot2::facet_grid(panel ~ across, scales = "free")
    } else {
      ggplot2::facet_wrap("panel", scales = if (alone) "free_y" else "free")
    }) +
    ggplot2::scale_y_continuous(labels = axis_labels) +
    ggplot2::scale_colour_manual(values = first_of(colours,
      if (n > 1L) series_colours(n) else water_colour)) +
    # Colours repeat after five groups, with another line type.
    ggplot2::scale_linetype_manual(values = first_of(dashes,
      rep(c("solid", "33", "12"), each = length(series_palette), length.out = n))) +
    ggplot2::scale_shape_manual(values = rep_len(series_symbols, n)) +
    ggplot2::labs(
      title = title, y = NULL, x = if (alone && !grid) levels(data$across), colour = key,
      linetype = key, shape = key,
      caption = if (nrow(unsettled)) "A cross marks a gear that did not settle."
    ) +
    chart_theme() + (if (n == 1L) ggplot2::theme(legend.position = "none"))
}

# Returns at most nine of the measures `known` for prints and charts: the main measures of the gear,
# else the first.
some_measures <- function(x, known) {
  main <- intersect(attr(x, "main"), known)
  utils::head(if (length(main)) main else known, most_measures)
}

drawn_measures <- function(x, measures, known) {
  if (is.null(measures)) some_measures(x, known) else chosen_some(measures, known)
}

in_order <- function(values) factor(values, unique(values))

# Returns points that widen each vertical axis to a thousandth of its values. A constant is then
# drawn as a straight line, not as its rounding errors.
least_range <- function(data) {
  data <- data[is.finite(data$value), ]
  panels <- split(data, data$panel, drop = TRUE)
  do.call(rbind, lapply(panels, function(panel) {
    ends <- range(panel$value)
    least <- if (any(ends != 0)) 1e-3 * max(abs(ends)) else 1
    if (diff(ends) >= least) return(panel[0L, ])
    two <- panel[c(1L, 1L), ]
    two$value <- mean(ends) + c(-0.5, 0.5) * least
    two
  }))
}

# Distinguishes equal names in different panels.
bar_row <- function(name, panel) paste(name, panel, sep = "\r")

# Draws horizontal bars or points, with a facet for each panel and the largest on top.
#
# data: data frame with `panel`, `name` and `size`, which sorts the names. Layers in `...` have the
# vertical position `.data[["row"]]`.
bar_chart <- function(data, title, across, ..., subtitle = NULL) {
  data$panel <- in_order(data$panel)
  data <- data[order(data$size), ]
  data$row <- in_order(bar_row(data$name, data$panel))
  chart <- ggplot2::ggplot(data, ggplot2::aes(y = .data[["row"]])) + list(...) +
    ggplot2::facet_wrap("panel", scales = "free", ncol = min(2L, nlevels(data$panel))) +
    ggplot2::scale_y_discrete(labels = function(row) sub("\r.*", "", row)) +
    ggplot2::labs(title = title, subtitle = subtitle, x = across, y = NULL) + chart_theme()
  structure(chart, bars = max(tapply(data$name, data$panel, function(x) length(unique(x)))))
}
