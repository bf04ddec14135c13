#' Plot main effects of fields
#'
#' Small figures next to one another, of every measure against every field: its mean over designs
#' with that value of the field, or in a group of values about it. All figures of a measure have one
#' scale, so that a field that matters little is flat. Depths grow downwards.
#'
#' @param x Effects, from [main_effects()].
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:5, "knot"),
#'   ropes.cable.length = c("400 m", "700 m"))
#' plot(main_effects(found, c("total_drag_kN", "greatest_depth_m")))
plot.codend_effects <- function(x, file = NULL, width = 10, height = NULL, ...) {
  plot_series(x, effects_figures(x), effects_title(x, "Main effects"), NULL, file, width, height)
}

effects_figures <- function(x, measures = NULL) {
  pairs <- unique(as.data.frame(unclass(x)[c("measure", "field")]))
  pairs <- pairs[pairs$measure %in% chosen_some(measures, unique(x$measure)), ]
  lapply(seq_len(nrow(pairs)), function(k) {
    effects_figure(x, x$measure == pairs$measure[k] & x$field == pairs$field[k])
  })
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

#' Plot effects of two fields together
#'
#' Small figures next to one another: the means of a measure against one field, with a line for each
#' value, or group of values, of the other. Lines that run side by side say that both fields add up;
#' lines that fan out or cross, that one changes what the other does. All figures of a measure have
#' one scale; the pairs that matter most come first. Depths grow downwards.
#'
#' @param x Effects, from [pair_effects()].
#' @param measures Names of measures, as [measures()] has them; all when `NULL`.
#' @param most How many pairs of each measure are drawn at most.
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:5, "knot"),
#'   ropes.cable.length = c("400 m", "700 m"))
#' plot(pair_effects(found, c("total_drag_kN", "greatest_depth_m")))
plot.codend_pair_effects <- function(x, measures = NULL, most = 6, file = NULL, width = 10,
                                     height = NULL, ...) {
  rows <- chosen_pairs(x, measures, most)
  figures <- lapply(rows, function(row) pair_figure(x, row))
  plot_series(x, figures, effects_title(x, "Effects of pairs"), NULL, file, width, height)
}

# Rows of the pairs that are drawn.
chosen_pairs <- function(x, measures, most) {
  measures <- chosen_some(measures, unique(x$measure))
  check_count("most", most)
  if (is.null(attr(x, "means"))) {
    abort_argument("{.arg x} has lost the means that {.fn pair_effects} gave it.")
  }
  unlist(lapply(measures, function(name) utils::head(which(x$measure == name), most)))
}

effects_title <- function(x, what) {
  name <- attr(x, "gear_name")
  paste0(what, if (!is.null(name)) paste(" of", name))
}

pair_figure <- function(x, row) {
  means <- attr(x, "means")
  measure <- x$measure[row]
  drawn <- means[means$measure == measure & means$field == x$field[row] &
    means$other == x$other[row], ]
  number <- suppressWarnings(as.double(drawn$value))
  text <- anyNA(number)
  values <- unique(drawn$value)
  at <- if (text) match(drawn$value, values) else number
  groups <- unique(drawn$other_value)
  list(
    words = words_of(measure, x$unit[row]), unit = x$unit[row],
    across = field_words(x, x$field[row]),
    lines = lapply(seq_along(groups), function(group) {
      mine <- which(drawn$other_value == groups[group])
      mine <- mine[order(at[mine])]
      list(x = at[mine], y = drawn$mean[mine], group = group, dashed = FALSE, symbols = TRUE)
    }),
    groups = paste0(c(paste0(field_words(x, x$other[row]), ": "), rep("", length(groups) - 1L)),
      group_labels(groups)),
    ticks = if (text) values, beside = means$mean[means$measure == measure]
  )
}

group_labels <- function(values) {
  number <- suppressWarnings(as.double(values))
  if (anyNA(number)) return(values)
  # means of groups have more figures than say anything
  short <- as_shown(signif(number, 4))
  if (anyDuplicated(short)) as_shown(number) else short
}

#' Plot Sobol' indices
#'
#' A figure for each measure: the share of its variance that each field explains alone (filled) and
#' has a part in (open), with their intervals, the fields that matter most on top.
#'
#' @param x Indices, from [sobol_indices()].
#' @param measures Names of measures, as [measures()] has them; all when `NULL`.
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examplesIf requireNamespace("spacefillr", quietly = TRUE)
#' sample <- designs(towing.speed = value_range("3 knot", "5 knot"),
#'   ropes.cable.length = value_range("400 m", "700 m"), how = "indices", number = 16)
#' plot(sobol_indices(vary("towed_cable", sample), c("total_drag_kN", "greatest_depth_m")))
plot.codend_sobol_indices <- function(x, measures = NULL, file = NULL, width = 10, height = NULL,
                                      ...) {
  measures <- chosen_some(measures, unique(x$measure))
  x$field <- plain_field(x$field)
  said <- sprintf("Share of the variance: alone (filled) and in all (open), intervals of %s %%.",
    format(100 * first_of(attr(x, "confidence"), 0.9)))
  plot_tornados(x, measures, effects_title(x, "Sobol' indices"), said, draw_indices, file, width,
    height)
}

# Fields that change together, by the first of them.
plain_field <- function(field) sub(",.*", ", ...", field)

draw_indices <- function(rows, name) {
  unit <- attr(rows, "measure_unit")[[name]]
  rows <- rows[order(rows$total), ]
  at <- seq_len(nrow(rows))
  ends <- c(0, 1, rows$first_low, rows$first_high, rows$total_low, rows$total_high)
  plot_bars_frame(range(ends[is.finite(ends)]), rows$field)
  for (kind in c("first", "total")) {
    y <- at + if (kind == "first") 0.16 else -0.16
    low <- rows[[paste0(kind, "_low")]]
    high <- rows[[paste0(kind, "_high")]]
    graphics::segments(low, y, high, y, col = water_colour, lwd = 1.6)
    graphics::points(rows[[kind]], y, pch = if (kind == "first") 16L else 21L, col = water_colour,
      bg = "white")
  }
  figure_heading(words_of(name, unit))
}
