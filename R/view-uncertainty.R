#' Plot where uncertainty comes from
#'
#' A bar for each measure: its combined standard uncertainty in percent of the measure, divided by
#' how much of the variance comes from coefficients, plan, conditions, discretisation and model.
#' With `sources` a bar for each of the largest sources of one measure instead.
#'
#' @param x Uncertainties, from [uncertainty()].
#' @param measures Names of measures; all with a value when `NULL`.
#' @param sources The name of a measure whose ten largest sources are drawn, or `NULL`.
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examples
#' found <- uncertainty(settle("towed_cable"))
#' plot(found)
#' plot(found, sources = "body_depth_m")
plot.codend_uncertainty <- function(x, measures = NULL, sources = NULL, file = NULL, width = 9,
                                    height = NULL, ...) {
  table <- x$measures[x$measures$value != 0 & x$measures$uncertainty > 0, ]
  known <- table$measure
  measures <- chosen_some(measures, known)
  if (!is.null(sources) && !(is_text(sources) && sources %in% known)) {
    abort_argument("{.arg sources} is {.val {sources}}; it must be one of {.val {known}}.")
  }
  title <- paste0("Uncertainty of ", x$gear_name, ", ", x$conditions)
  table <- table[match(measures, known), ]
  rows <- if (is.null(sources)) nrow(table) else 10L
  draw <- function() if (is.null(sources)) draw_budget(table) else draw_sources(x, sources)
  above <- series_title + key_row
  show_picture(x, function(page) draw_under(title, page, draw, above), file, width, height, title,
    min(100, above + 1 + 1.6 * bar_height * rows))
}

budget_colours <- c(
  coefficients = "#2a6f97", plan = "#61a5c2", conditions = "#a9d6e5", lattice = "#e9c46a",
  model = "#9a8c98"
)

uncertainty_frame <- function(across, names, xlab) {
  left <- min(3.2, 0.35 + 0.075 * max(nchar(names)))
  graphics::par(mai = c(0.6, left, 0.1, 0.2), cex = 0.85, mgp = c(1.8, 0.5, 0))
  plot_bars_frame(across, names)
  graphics::title(xlab = xlab)
  ends <- graphics::par("usr")
  graphics::legend(ends[1L], ends[4L], group_words[names(budget_colours)],
    fill = budget_colours, border = NA, horiz = TRUE, yjust = 0, bty = "n", cex = 0.9, xpd = NA)
}

draw_budget <- function(table) {
  at <- rev(seq_len(nrow(table)))
  percent <- 100 * table$uncertainty / abs(table$value)
  # a measure near 0 would leave no room for the rest
  most <- max(pmin(percent, 4 * stats::median(percent)))
  parts <- as.matrix(table[names(budget_colours)])^2
  parts <- parts / rowSums(parts)
  uncertainty_frame(c(0, 1.05 * most), rev(words_of(table$measure, table$unit)),
    "standard uncertainty (one standard deviation), % of the measure")
  for (m in seq_len(nrow(table))) {
    ends <- pmin(c(0, cumsum(parts[m, ])) * percent[m], most)
    graphics::rect(ends[-length(ends)], at[m] - 0.36, ends[-1L], at[m] + 0.36,
      col = budget_colours, border = NA)
    if (percent[m] > most) {
      graphics::text(most, at[m], sprintf("to %.0f %%", percent[m]), pos = 2L, font = 2L)
    }
  }
}

draw_sources <- function(x, name) {
  rows <- utils::head(x$sources[x$sources$measure == name, ], 10L)
  unit <- x$measures$unit[x$measures$measure == name]
  rows <- rows[rev(seq_len(nrow(rows))), ]
  uncertainty_frame(range(0, rows$contribution), rows$source,
    paste0("change of the ", words_of(name, unit), " for one standard uncertainty, ", unit))
  at <- seq_len(nrow(rows))
  graphics::rect(pmin(0, rows$contribution), at - 0.36, pmax(0, rows$contribution), at + 0.36,
    col = budget_colours[rows$group], border = NA)
}
