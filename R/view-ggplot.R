#' Pictures as ggplot objects
#'
#' The pictures of `plot()` for those who use \pkg{ggplot2}: add themes, scales and labels, or take
#' the data out of them. Colours are those of `plot()`.
#'
#' @details
#' Of a state: one plane. Ropes are coloured by tension; netting by twine tension, on the scale of
#' `fill`; slack or pushing lines are grey. Of a trajectory: measures against time. Of variations
#' ([vary()]): measures against the field that changes first, with a line for each combination of
#' the others, or response curves as in [`plot()`][plot.codend_variations()]; what did not settle is
#' left out. Of [main_effects()], [pair_effects()] and [sobol_indices()] what `plot()` shows. Of
#' [tensions_along()]: a facet for every role.
#' Facets have free scales; unlike in `plot()`, depths in facets grow upwards.
#'
#' @param object What `plot()` takes.
#' @param plane `"xy"` (from above), `"xz"` (from the port side) or `"yz"` (from astern).
#' @param colour What the colours of netting show: `"tension"`, `"mesh_opening"` or `"mesh_angle"`.
#' @param measures Names of measures, as [measures()] has them; all when `NULL`.
#' @param ... Not used.
#' @return A ggplot.
#' @name codend_autoplot
#' @examplesIf requireNamespace("ggplot2", quietly = TRUE)
#' ggplot2::autoplot(settle("towed_cable"), plane = "xz")
NULL

#' @rdname codend_autoplot
#' @exportS3Method ggplot2::autoplot
autoplot.codend_state <- function(object, plane = c("xy", "xz", "yz"), colour = "tension", ...) {
  plane <- chosen(plane, c("xy", "xz", "yz"))
  check_colour(colour)
  figure <- plane_figure(object, plane, colour)
  axes <- plane_axes[[plane]]
  flat <- function(lines, scale) {
    up <- if (axes[2L] == 3L) -1 else 1
    data.frame(
      x = lines$from[axes[1L], ], y = up * lines$from[axes[2L], ], xend = lines$to[axes[1L], ],
      yend = up * lines$to[axes[2L], ],
      tension = if (is.null(scale)) lines$tension else lines$tension / scale$per_unit,
      slack = lines$tension <= 0
    )
  }
  scales <- figure$scales
  ropes <- flat(figure$drawing$ropes, scales$rope)
  netting <- flat(figure$drawing$netting, scales$netting)
  taut <- netting[!netting$slack, ]
  segments <- function(data, ..., mapping = gg_line()) {
    ggplot2::geom_segment(mapping, data, ..., lineend = "round")
  }
  layers <- list(
    segments(netting[netting$slack, ], colour = slack_colour, linewidth = 0.25),
    # one scale of colours serves ropes: netting has its own colours, and `fill` to tell them
    if (nrow(taut)) {
      list(
        segments(taut, linewidth = 0.25,
          colour = tension_colours(scales$netting, taut$tension * scales$netting$per_unit)),
        ggplot2::geom_point(
          ggplot2::aes(.data[["x"]], .data[["y"]], fill = .data[["tension"]]), taut, shape = 21,
          alpha = 0, stroke = 0
        ),
        gg_tension(ggplot2::scale_fill_gradientn, scales$netting, "netting")
      )
    },
    segments(ropes[ropes$slack, ], colour = slack_colour, linewidth = 0.8),
    if (any(!ropes$slack)) {
      list(
        segments(ropes[!ropes$slack, ], mapping = gg_line(tension = TRUE), linewidth = 0.8),
        gg_tension(ggplot2::scale_colour_gradientn, scales$rope, "rope")
      )
    }
  )
  ggplot2::ggplot() + layers + ggplot2::coord_fixed() +
    (if (axes[2L] == 3L) ggplot2::scale_y_reverse()) +
    ggplot2::labs(
      title = figure$title, x = plane_labels[axes[1L]], y = plane_labels[axes[2L]],
      subtitle = paste0(plane_words[[plane]], ", ", figure$conditions)
    ) + gg_theme()
}

#' @rdname codend_autoplot
#' @exportS3Method ggplot2::autoplot
autoplot.codend_trajectory <- function(object, measures = NULL, ...) {
  gg_series(lapply(trajectory_series(object, measures), time_figure), tow_title(object))
}

#' @rdname codend_autoplot
#' @exportS3Method ggplot2::autoplot
autoplot.codend_variations <- function(object, measures = NULL, ...) {
  drawn <- variations_drawn(object, measures)
  gg_series(drawn$figures, variations_title(object), drawn$key, has_response_curves(object))
}

#' @rdname codend_autoplot
#' @exportS3Method ggplot2::autoplot
autoplot.codend_rope_tensions <- function(object, ...) {
  drawn <- rope_series(object)
  drawn$heading <- factor(drawn$heading, unique(drawn$heading))
  n <- length(unique(drawn$line))
  drawn$name <- gsub("_", " ", drawn$line)
  drawn$name <- factor(drawn$name, unique(drawn$name[order(drawn$heading, drawn$group)]))
  # the colours and dashes that each rope has in its own figure
  first <- match(levels(drawn$name), drawn$name)
  alone <- stats::ave(drawn$group, drawn$heading, FUN = max)[first] == 1L
  colours <- rep_len(rope_colours, max(drawn$group))[drawn$group[first]]
  colours[alone] <- tension_palette("rope")[100L]
  mapping <- ggplot2::aes(
    .data[["along_m"]], .data[["tension_kN"]], colour = .data[["name"]],
    linetype = .data[["name"]]
  )
  ggplot2::ggplot(drawn, mapping) + ggplot2::geom_line() +
    ggplot2::facet_wrap("heading", scales = "free") +
    ggplot2::scale_colour_manual(values = colours) +
    ggplot2::scale_linetype_manual(
      values = ifelse(drawn$group[first] %% 2L == 0L, "33", "solid")) +
    ggplot2::labs(
      title = "Tension along ropes", x = "distance along the rope (m)", y = "tension (kN)",
      colour = NULL, linetype = NULL,
      subtitle = paste(c(attr(object, "gear_name"), attr(object, "conditions")), collapse = ", ")
    ) +
    gg_theme() + (if (n == 1L) ggplot2::theme(legend.position = "none"))
}

#' @rdname codend_autoplot
#' @exportS3Method ggplot2::autoplot
autoplot.codend_effects <- function(object, measures = NULL, ...) {
  gg_series(effects_figures(object, measures), effects_title(object, "Main effects"), grid = TRUE)
}

#' @rdname codend_autoplot
#' @exportS3Method ggplot2::autoplot
autoplot.codend_pair_effects <- function(object, measures = NULL, ...) {
  figures <- lapply(chosen_pairs(object, measures, 6), function(row) pair_figure(object, row))
  gg_series(figures, effects_title(object, "Effects of pairs"))
}

#' @rdname codend_autoplot
#' @exportS3Method ggplot2::autoplot
autoplot.codend_sobol_indices <- function(object, measures = NULL, ...) {
  rows <- object$measure %in% chosen_some(measures, unique(object$measure))
  unit <- attr(object, "measure_unit")
  part <- function(kind) {
    data.frame(
      measure = words_of(object$measure, unit[object$measure]), field = plain_field(object$field),
      index = kind, value = object[[kind]], low = object[[paste0(kind, "_low")]],
      high = object[[paste0(kind, "_high")]]
    )[rows, ]
  }
  data <- rbind(part("first"), part("total"))
  data$measure <- factor(data$measure, unique(data$measure))
  mapping <- ggplot2::aes(.data[["value"]], .data[["field"]], xmin = .data[["low"]],
    xmax = .data[["high"]], shape = .data[["index"]])
  ggplot2::ggplot(data, mapping) +
    ggplot2::geom_pointrange(colour = water_colour, fill = "white",
      position = ggplot2::position_dodge(width = 0.5)) +
    ggplot2::scale_shape_manual(values = c(first = 16, total = 21)) +
    ggplot2::facet_wrap("measure") +
    ggplot2::labs(title = effects_title(object, "Sobol' indices"), x = "share of the variance",
      y = NULL, shape = NULL) + gg_theme()
}

# ---- small figures -------------------------------------------------------------------------------

# The figures of plot_series() as facets, a measure a row and a field a column where they are a
# grid.
gg_series <- function(figures, title, key = NULL, grid = FALSE) {
  lines <- unlist(lapply(figures, `[[`, "lines"), recursive = FALSE)
  # curves need numbers
  text <- !all(lengths(lapply(figures, `[[`, "ticks")) == 0L) &&
    all(vapply(lines, `[[`, NA, "symbols"))
  data <- do.call(rbind, lapply(figures, gg_figure, key, text))
  ordered <- c("at"[text], "measure", "across", "group")
  data[ordered] <- lapply(data[ordered], function(value) factor(value, unique(value)))
  alone <- nlevels(data$across) == 1L
  if (!grid && !alone) {
    figure <- paste0(data$measure, "\nby ", data$across)
    data$measure <- factor(figure, unique(figure))
  }
  n <- nlevels(data$group)
  mapping <- ggplot2::aes(.data[["at"]], .data[["value"]], colour = .data[["group"]],
    shape = .data[["group"]], group = .data[["group"]])
  marked <- data[data$symbols, ]
  layers <- list(
    if (any(data$joined)) ggplot2::geom_line(data = data[data$joined, ]),
    if (nrow(marked)) ggplot2::geom_point(data = marked, alpha = ifelse(marked$joined, 1, 0.35))
  )
  ggplot2::ggplot(data, mapping) + layers +
    (if (grid) {
      ggplot2::facet_grid(measure ~ across, scales = "free")
    } else {
      ggplot2::facet_wrap("measure", scales = if (alone) "free_y" else "free")
    }) +
    ggplot2::scale_colour_manual(values = if (n > 1L) series_colours(n) else water_colour) +
    ggplot2::scale_shape_manual(values = rep_len(series_symbols, n)) +
    ggplot2::labs(
      title = title, y = NULL, colour = key$title, shape = key$title,
      x = if (alone && !grid) levels(data$across)
    ) + gg_theme() + (if (n == 1L) ggplot2::theme(legend.position = "none"))
}

# The points of a figure's lines, a row each.
gg_figure <- function(figure, key, text) {
  labels <- first_of(key$labels, "")
  if (!is.null(figure$groups)) {
    labels <- paste(sub(": .*", "", figure$groups[1L]), sub(".*: ", "", figure$groups), sep = " = ")
  }
  do.call(rbind, lapply(figure$lines, function(line) {
    at <- line$x
    if (text) at <- if (is.null(figure$ticks)) as_shown(at) else figure$ticks[at]
    data.frame(
      at = at, value = line$y, measure = words_and_unit(figure$words, figure$unit),
      across = figure$across, group = labels[line$group], symbols = line$symbols,
      joined = !isFALSE(line$joined)
    )
  }))
}

# ---- what they share ----------------------------------------------------------------------------

# ggplot2's word for the data in aes().
utils::globalVariables(".data")

gg_line <- function(tension = FALSE) {
  ends <- ggplot2::aes(.data[["x"]], .data[["y"]], xend = .data[["xend"]], yend = .data[["yend"]])
  if (tension) ends$colour <- ggplot2::aes(colour = .data[["tension"]])$colour
  ends
}

# A scale of tension as the other pictures have it.
gg_tension <- function(make, scale, kind) {
  make(
    scale_heading(scale, kind), colours = scale$colours, limits = scale$limits / scale$per_unit,
    trans = if (scale$log) "log10" else "identity", breaks = scale$ticks,
    labels = tick_labels(scale),
    # values outside get the colour of the end
    oob = function(x, range = c(0, 1), ...) pmin(pmax(x, range[1L]), range[2L]),
    guide = if (kind == "rope") ggplot2::guide_colourbar(order = 1) else "colourbar"
  )
}

gg_theme <- function() {
  ggplot2::theme_minimal() +
    ggplot2::theme(
      panel.background = ggplot2::element_rect(fill = "#F6F9FB", colour = "grey40"),
      panel.grid.minor = ggplot2::element_blank(),
      plot.background = ggplot2::element_rect(fill = "white", colour = NA)
    )
}
