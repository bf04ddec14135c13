# Charts of sensitivities, uncertainties, calibrations, optima and coefficients.

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_sensitivities <- function(object, measures = NULL, ...) {
  known <- unique(object$measure[is.finite(object$elasticity) & object$elasticity != 0])
  data <- object[object$measure %in% drawn_measures(object, measures, known), ]
  unit <- attr(object, "measure_unit")
  per <- data$elasticity / data$derivative
  data <- data.frame(
    panel = measure_label(data$measure, unit[data$measure]), size = abs(data$elasticity),
    # fields that change together are named by the first
    name = sub(" [+] .*", " ...", data$field), elasticity = data$elasticity, smooth = data$smooth,
    below = data$secant_below * per, above = data$secant_above * per
  )
  # a secant over a jump would leave no space for the other bars
  most <- 1.5 * stats::ave(data$size, data$panel, FUN = max)
  secants <- rbind(cbind(data, secant = data$below, most), cbind(data, secant = data$above, most))
  # a sensitivity of 0 has no elasticity that could scale its secants
  secants <- secants[!secants$smooth & is.finite(secants$secant), ]
  secants$secant <- pmin(pmax(secants$secant, -secants$most), secants$most)
  secants$row <- bar_row(secants$name, secants$panel)
  bar_chart(data, paste0("Sensitivities of ", attr(object, "gear_name"), ", ",
    attr(object, "conditions")), "percent of the measure per percent of the field",
    ggplot2::geom_col(
      ggplot2::aes(.data[["elasticity"]], fill = .data[["smooth"]]), colour = water_colour,
      orientation = "y"
    ),
    ggplot2::geom_point(ggplot2::aes(.data[["secant"]], .data[["row"]]), secants, shape = "|",
      size = 4),
    ggplot2::scale_fill_manual(values = c(`TRUE` = water_colour, `FALSE` = "white"),
      guide = "none"),
    subtitle = "Open bars: not smooth; ticks: secants to 1 % less and 1 % more"
  )
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_sobol_indices <- function(object, measures = NULL, ...) {
  known <- unique(object$measure)
  object <- object[object$measure %in% drawn_measures(object, measures, known), ]
  unit <- attr(object, "measure_unit")
  data <- data.frame(
    panel = measure_label(object$measure, unit[object$measure]),
    size = stats::ave(object$value, object$measure, object$field, FUN = max),
    name = sub(",.*", ", ...", object$field), index = object$index, value = object$value,
    low = object$lower, high = object$upper
  )
  bar_chart(data, study_title(object, "Sobol' indices"),
    "fraction of the variance",
    ggplot2::geom_pointrange(
      ggplot2::aes(.data[["value"]], xmin = .data[["low"]], xmax = .data[["high"]],
        shape = .data[["index"]]),
      colour = water_colour, fill = "white", position = ggplot2::position_dodge(width = 0.5)
    ),
    ggplot2::scale_shape_manual("index", values = c(first = 16L, total = 21L)),
    subtitle = sprintf("Intervals of %s %%",
      format(100 * first_of(attr(object, "confidence"), 0.9)))
  )
}

origin_colours <- c(
  coefficients = "#2a6f97", plan = "#61a5c2", conditions = "#a9d6e5", mesh = "#e9c46a",
  model = "#9a8c98"
)

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_uncertainty <- function(object, measures = NULL, sources = NULL, ...) {
  table <- object$measures[object$measures$value != 0 & object$measures$error > 0, ]
  measures <- chosen_some(measures, table$measure)
  if (!is.null(sources) && !(is_text(sources) && sources %in% table$measure)) {
    abort_argument("{.arg sources} is {.val {sources}}; it must be one of {.val {table$measure}}.")
  }
  title <- paste0("Uncertainty of ", object$gear_name, ", ", object$conditions)
  draw <- function(data, across, ...) {
    data$panel <- ""
    data$origin <- factor(group_words[data$origin], group_words[names(origin_colours)])
    bar_chart(data, title, across,
      ggplot2::geom_col(ggplot2::aes(.data[["value"]], fill = .data[["origin"]]),
        orientation = "y", position = ggplot2::position_stack(reverse = TRUE)),
      ggplot2::scale_fill_manual(NULL, values = unname(origin_colours), drop = FALSE),
      ggplot2::theme(strip.text = ggplot2::element_blank()), ...)
  }
  if (!is.null(sources)) {
    rows <- utils::head(object$sources[object$sources$measure == sources, ], 10L)
    unit <- table$unit[table$measure == sources]
    data <- data.frame(name = rows$source, value = rows$contribution, origin = rows$group,
      size = abs(rows$contribution))
    return(draw(data, sprintf("change of the %s for one standard uncertainty (%s)",
      label_of(sources, unit), unit)))
  }
  table <- table[match(measures, table$measure), ]
  percent <- 100 * table$error / abs(table$value)
  # a measure near 0 would leave no space for the other bars
  most <- max(pmin(percent, 4 * stats::median(percent)))
  parts <- as.matrix(table[names(origin_colours)])^2
  parts <- parts / rowSums(parts) * pmin(percent, most)
  names <- label_of(table$measure, table$unit)
  data <- data.frame(name = names[row(parts)], value = as.vector(parts),
    origin = names(origin_colours)[col(parts)], size = -as.vector(row(parts)))
  long <- data.frame(row = bar_row(names, ""), text = sprintf("to %.0f %%", percent), panel = "")
  draw(data, "standard uncertainty, % of the measure",
    ggplot2::geom_text(ggplot2::aes(most, label = .data[["text"]]), long[percent > most, ],
      hjust = 1.1, fontface = "bold"))
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_calibration <- function(object, by = NULL, ...) {
  data <- object$task$data
  if (is.null(by)) by <- c(object$conditions, "row")[1L]
  known <- c(names(data), "row")
  by <- chosen(by, known)
  along <- if (by == "row") seq_len(nrow(data)) else data[[by]]
  words <- by
  if (!is.numeric(along)) {
    levels <- unique(along)
    words <- paste0(by, ": ", paste0(seq_along(levels), " = ", levels, collapse = ", "))
    along <- match(along, levels)
  }
  rows <- object$matched
  agreement <- paste0(rows$match, ": settled against measured")
  residuals <- paste0(rows$match, ": residual against ", words)
  points <- rbind(
    data.frame(panel = agreement, at = rows$measured, value = rows$begun, when = "before"),
    data.frame(panel = agreement, at = rows$measured, value = rows$fitted, when = "calibrated"),
    data.frame(panel = residuals, at = along[rows$row], value = rows$residual, when = "calibrated")
  )
  panel <- function(labels) factor(labels, rbind(unique(agreement), unique(residuals)))
  error <- object$match$error[match(rows$match, object$match$text)]
  bands <- unique(data.frame(panel = rep(panel(residuals), 3L),
    value = c(-2 * error, 0 * error, 2 * error)))
  # both axes of an agreement reach the values of the other
  equal <- data.frame(panel = panel(agreement), at = c(rows$begun, rows$fitted),
    value = rows$measured)
  points$panel <- panel(points$panel)
  ggplot2::ggplot(points, ggplot2::aes(.data[["at"]], .data[["value"]])) +
    ggplot2::geom_blank(data = equal) +
    ggplot2::geom_abline(ggplot2::aes(slope = 1, intercept = 0), equal, colour = "grey40") +
    ggplot2::geom_hline(ggplot2::aes(yintercept = .data[["value"]]), bands, colour = "grey40",
      linetype = "33") +
    ggplot2::geom_point(ggplot2::aes(fill = .data[["when"]]), shape = 21L, colour = water_colour) +
    ggplot2::scale_fill_manual(NULL, values = c(before = "white", calibrated = water_colour)) +
    ggplot2::facet_wrap("panel", scales = "free", ncol = 2L) +
    ggplot2::scale_y_continuous(labels = axis_labels) +
    ggplot2::labs(title = paste("Calibration of", object$gear$plan$name), x = NULL, y = NULL) +
    chart_theme()
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_optimum <- function(object, ...) {
  rows <- object$history
  fields <- object$fields
  labels <- label_and_unit(fields$field, fields$unit)
  margins <- sprintf("margin of %s (%%)", object$keep$text)
  quantity <- function(panel, value) {
    data.frame(panel = panel, at = seq_len(nrow(rows)), value = value, open = !rows$kept)
  }
  data <- rbind(
    quantity(object$objective$text, rows$objective),
    do.call(rbind, lapply(seq_len(nrow(object$keep)), function(k) {
      quantity(margins[k], -100 * attr(rows, "gaps")[, k])
    })),
    do.call(rbind, Map(quantity, labels, unclass(rows)[seq_along(labels)]))
  )
  data$across <- "step of the search"
  data$marked <- TRUE
  ends <- data.frame(panel = factor(c(rep(labels, 2L), margins), unique(data$panel)),
    value = c(fields$lower, fields$upper, 0 * seq_along(margins)))
  series_chart(data, paste("Optimum of", object$gear$plan$name)) +
    ggplot2::geom_hline(ggplot2::aes(yintercept = .data[["value"]]), ends, colour = "grey40",
      linetype = "33")
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_trade_off <- function(object, ...) {
  objectives <- unname(attr(object, "objectives"))
  shown <- setdiff(names(object)[-1L], c("kept", "optimal"))
  data <- do.call(rbind, lapply(shown, function(name) {
    data.frame(panel = name, at = object[[1L]], value = object[[name]], marked = TRUE,
      open = !unname(object$kept & object$optimal), across = objectives[1L])
  }))
  data$panel[data$panel == names(object)[2L]] <- objectives[2L]
  series_chart(data[order(match(data$panel, unique(data$panel)), data$at), ],
    paste("Trade-off of", attr(object, "gear_name")))
}

# Colours of Okabe and Ito, the darkest first. Most colour-blind readers can distinguish them.
model_colours <- c(
  "#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7F7F7F"
)

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_coefficients <- function(object, force = NULL, by = NULL, ...) {
  words <- c(
    twine = "twine and rope", netting = "netting", otter_board = "otter board", kite = "kite",
    sphere = "sphere", wake = "behind netting"
  )
  table <- as.data.frame(unclass(object))
  table <- table[table$force %in% chosen_some(force, unique(object$force)), ]
  by <- chosen(first_of(by, sort(unique(table$by))[1L]), c("angle", "reynolds"))
  table <- table[table$by == by & (by == "angle" | table$value > 1e-3), ]
  by_solidity <- table$force %in% c("netting", "wake")
  solidity <- ifelse(by_solidity, paste(", solidity", format(table$solidity)), "")
  table$panel <- in_order(paste0(words[table$force], solidity, ": ", table$coefficient))
  table$at <- if (by == "angle") table$angle_deg else table$reynolds
  table$model <- in_order(gsub("_", " ", table$law))
  n <- nlevels(table$model)
  computed <- is.na(table$source)
  ggplot2::ggplot(table, ggplot2::aes(.data[["at"]], .data[["value"]], colour = .data[["model"]])) +
    ggplot2::geom_line(ggplot2::aes(linetype = .data[["model"]]), table[computed, ]) +
    ggplot2::geom_point(ggplot2::aes(shape = .data[["model"]]), table[!computed, ]) +
    ggplot2::facet_wrap("panel", scales = "free_y", ncol = 3L) +
    ggplot2::scale_colour_manual(NULL, values = rep_len(model_colours, n), drop = FALSE) +
    ggplot2::scale_linetype_manual(NULL, values = rep_len(c(1, 2, 4, 5, 6, 3), n), drop = FALSE) +
    ggplot2::scale_shape_manual(NULL, values = rep_len(c(1, 2, 0, 5, 6, 4), n), drop = FALSE) +
    ggplot2::guides(colour = ggplot2::guide_legend(ncol = 5L)) +
    (if (by == "reynolds") list(ggplot2::scale_x_log10(), ggplot2::scale_y_log10())) +
    ggplot2::labs(
      title = "Coefficients: computed (lines) and published (points)", y = NULL,
      x = if (by == "angle") "angle (deg)" else "Reynolds number"
    ) + chart_theme()
}
