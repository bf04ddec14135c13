#' Plot measures of many variations
#'
#' Small figures next to one another: every measure against the field that changes first. Where
#' other fields change too there is a line for each of their combinations, distinguished by colour,
#' symbol and the key above. A cross at the foot of a figure is where a gear did not settle. Depths
#' grow downwards.
#'
#' Of designs that are drawn (`random`, `latin`, `sobol`, `indices`) or change `one_at_a_time` there
#' is a response curve instead, of every measure against every field: of drawn designs all points
#' with a smooth curve through them (Cleveland's lowess), of single fields the line of the designs
#' in which the others are as in the plan.
#'
#' @param x Variations, from [vary()].
#' @param measures Names of measures, as [measures()] has them; all when `NULL`.
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:6, "knot"),
#'   ropes.cable.length = c("400 m", "700 m"))
#' plot(found, measures = c("total_drag_kN", "greatest_depth_m"))
plot.codend_variations <- function(x, measures = NULL, file = NULL, width = 10, height = NULL,
                                   ...) {
  drawn <- variations_drawn(x, measures)
  plot_series(x, drawn$figures, variations_title(x), drawn$key, file, width, height)
}

# list(figures, key) as plot_series() takes them.
variations_drawn <- function(x, measures) {
  missing <- if (!all(x$settled)) "did not settle"
  if (has_response_curves(x)) {
    return(list(figures = response_figures(x, measures), key = list(missing = missing)))
  }
  study <- variations_study(x, measures)
  list(
    figures = lapply(study$measures, function(name) variations_figure(x, study, name)),
    key = list(title = study$groups_title, labels = study$group_labels, missing = missing)
  )
}

variations_title <- function(x) {
  name <- attr(x, "gear_name")
  if (is.null(name)) "Variations" else paste("Variations of", name)
}

# What is drawn of variations: list(field (column of the axis), ticks (labels, where its values are
# texts), at = its places, measures, group of every row, group_labels, groups_title).
variations_study <- function(x, wanted) {
  fields <- variations_fields(x)
  shown_measures <- chosen_some(wanted, variations_measures(x), "measures")
  field <- fields[1L]
  text <- !is.numeric(x[[field]])
  ticks <- if (text) unique(x[[field]])
  # Fields that follow the first, value by value, make no lines of their own.
  apart <- Filter(function(other) {
    pairs <- unique(x[c(field, other)])
    nrow(pairs) > length(unique(x[[field]]))
  }, fields[-1L])
  shown <- lapply(apart, function(other) as_shown(x[[other]]))
  label <- if (length(apart)) do.call(paste, c(shown, sep = ", ")) else rep("", nrow(x))
  labels <- unique(label)
  list(
    field = field, ticks = ticks, at = if (text) match(x[[field]], ticks) else x[[field]],
    measures = shown_measures,
    group = match(label, labels), group_labels = labels,
    groups_title = if (length(apart)) {
      paste(vapply(apart, function(other) field_words(x, other), ""), collapse = ", ")
    } else {
      ""
    }
  )
}

as_shown <- function(values) {
  if (!is.numeric(values)) return(as.character(values))
  vapply(values, function(v) format(signif(v, 6)), "")
}

# A field as an axis says it: "towing speed (knot)" of "towing.speed_knot".
field_words <- function(x, column) {
  unit <- variations_unit(x, column)
  words_and_unit(gsub(".", " ", words_of(column, unit), fixed = TRUE), unit)
}

# The unit of a column of variations, "" where a part of the table is drawn that lost it.
variations_unit <- function(x, column) {
  unit <- attr(x, "unit")[column]
  if (is.null(unit) || is.na(unit)) "" else unname(unit)
}

variations_figure <- function(x, study, name) {
  unit <- variations_unit(x, name)
  rows <- split(seq_len(nrow(x)), study$group)
  lines <- lapply(rows, function(row) {
    row <- row[order(study$at[row])]
    row <- row[!is.na(x[[name]][row])]
    list(
      x = study$at[row], y = x[[name]][row], group = study$group[row][1L], dashed = FALSE,
      symbols = TRUE
    )
  })
  list(
    words = words_of(name, unit), unit = unit,
    across = field_words(x, study$field),
    lines = Filter(function(line) length(line$x), lines),
    missing = unique(study$at[!x$settled]), ticks = study$ticks
  )
}

# ---- response curves -----------------------------------------------------------------------------

drawn_ways <- c("random", "latin", "sobol", "indices")

variations_fields <- function(x) names(x)[seq_len(match("settled", names(x)) - 1L)]
variations_measures <- function(x) names(x)[-seq_len(match("warning", names(x)))]

has_response_curves <- function(x) {
  isTRUE(attr(x, "study")$how %in% c(drawn_ways, "one_at_a_time")) &&
    length(variations_fields(x)) > 1L
}

# Every measure against every field: a data frame of measure, field, at (places along the axis),
# value and settled; a field's texts are the list `ticks`.
response_points <- function(x, wanted) {
  fields <- variations_fields(x)
  measures <- chosen_some(wanted, variations_measures(x), "measures")
  ticks <- lapply(x[fields], function(values) if (!is.numeric(values)) unique(values))
  single <- attr(x, "study")$how == "one_at_a_time"
  rows <- lapply(setNames(nm = fields), function(field) {
    if (!single) return(seq_len(nrow(x)))
    others <- setdiff(fields, field)
    own <- which(attr(x, "study")$design == 1L)
    if (!length(own)) return(seq_len(nrow(x)))
    same <- lapply(others, function(other) x[[other]] %in% x[[other]][own])
    which(Reduce(`&`, same))
  })
  points <- do.call(rbind, lapply(measures, function(name) {
    do.call(rbind, lapply(fields, function(field) {
      at <- if (is.null(ticks[[field]])) x[[field]] else match(x[[field]], ticks[[field]])
      row <- rows[[field]][order(at[rows[[field]]])]
      data.frame(measure = name, field = field, at = at[row], value = x[[name]][row],
        settled = x$settled[row])
    }))
  }))
  list(points = points, ticks = ticks, single = single)
}

response_figures <- function(x, measures) {
  found <- response_points(x, measures)
  points <- found$points
  pairs <- unique(points[c("measure", "field")])
  lapply(seq_len(nrow(pairs)), function(k) {
    rows <- points[points$measure == pairs$measure[k] & points$field == pairs$field[k], ]
    name <- rows$measure[1L]
    field <- rows$field[1L]
    unit <- variations_unit(x, name)
    ticks <- found$ticks[[field]]
    seen <- rows[!is.na(rows$value), ]
    list(
      words = words_of(name, unit), unit = unit, across = field_words(x, field),
      lines = response_lines(seen, found$single, is.null(ticks)),
      missing = unique(rows$at[!rows$settled]), ticks = ticks,
      beside = points$value[points$measure == name & !is.na(points$value)]
    )
  })
}

# Fewer points than these have no smooth curve.
least_smooth <- 8L

response_lines <- function(seen, single, numbers) {
  if (!nrow(seen)) return(list())
  line <- function(x, y, symbols, joined) {
    list(x = x, y = y, group = 1L, dashed = FALSE, symbols = symbols, joined = joined)
  }
  if (single) return(list(line(seen$at, seen$value, TRUE, TRUE)))
  curve <- if (numbers && nrow(seen) >= least_smooth) stats::lowess(seen$at, seen$value)
  c(
    list(line(seen$at, seen$value, TRUE, FALSE)),
    if (!is.null(curve)) list(line(curve$x, curve$y, FALSE, TRUE))
  )
}
