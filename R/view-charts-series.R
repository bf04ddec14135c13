# Charts of quantities against time, length or fields.

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_trajectory <- function(object, measures = NULL, ...) {
  table <- as.data.frame(object, what = "measures")
  attr(table, "main") <- printed_names(state_values(state_at(object, max(object$time))))
  shown <- drawn_measures(table, measures, unique(table$measure))
  table <- table[order(match(table$measure, shown), na.last = NA), ]
  data <- with_time_axis(rbind(
    if (is.null(measures)) schedule_series(object),
    data.frame(panel = measure_label(table$measure, table$unit), time = table$time_s,
      value = table$value, error = table$error)
  ))
  error <- ifelse(is.na(data$error), 0, data$error)
  data$low <- data$value - 2 * error
  data$high <- data$value + 2 * error
  series_chart(data, paste("Tow of", object$gear$plan$name))
}

# Longest time axis in seconds (s); longer ones are in minutes.
longest_in_seconds <- 180

with_time_axis <- function(data) {
  minutes <- max(data$time) > longest_in_seconds
  data$at <- data$time / if (minutes) 60 else 1
  data$across <- if (minutes) "time (min)" else "time (s)"
  data
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_schedule <- function(object, until = NULL, ...) {
  until <- schedule_end(object, schedule_changes(object), until)
  table <- as.data.frame(object, until = until)
  if (!nrow(table)) abort_argument("{.arg x} has no input over time to draw.")
  # inputs are constant before their first and after their last time
  series <- lapply(split(table, in_order(table$input)), function(input) {
    n <- nrow(input)
    data.frame(
      panel = label_and_unit(gsub("[._]+", " ", input$input[1L]), input$unit[1L]),
      time = c(min(0, input$time_s), input$time_s, max(until, input$time_s)),
      value = input$value[c(1L, seq_len(n), n)]
    )
  })
  breaks <- break_times(object)
  data <- with_time_axis(do.call(rbind, series))
  scale <- if (any(data$at != data$time)) 60 else 1
  chart <- series_chart(data, "Schedule of a tow")
  if (!length(breaks)) return(chart)
  chart + ggplot2::geom_vline(xintercept = breaks / scale, linetype = "dashed") +
    ggplot2::labs(caption = paste("Breaks at the dashed lines:",
      paste(names(breaks), collapse = ", ")))
}

# Returns the conditions of a trajectory that change, without the position of the vessel: data
# frame(panel, time [s], value, error).
schedule_series <- function(trajectory) {
  table <- condition_units(trajectory$conditions)
  known <- c(
    speed_m_per_s = "vessel speed (m/s)", course_deg = "vessel course (deg)", heave_m = "heave (m)",
    elevation_m = "elevation of the water (m)"
  )
  others <- c("time_s", "x_m", "y_m", "energy_imbalance_J", "energy_put_through_J")
  changed <- Filter(function(name) any(table[[name]] != table[[name]][1L]),
    setdiff(names(table), others))
  do.call(rbind, lapply(changed, function(name) {
    unit <- if (is.null(trajectory$si$ropes[[name]])) "fraction" else "m"
    label <- sprintf("%s out (%s)", gsub("_", " ", name), unit)
    if (name %in% names(known)) label <- known[[name]]
    data.frame(panel = label, time = table$time_s, value = table[[name]], error = NA_real_)
  }))
}

# ---- ropes and meshes ----------------------------------------------------------------------------

# Adjacent colours differ most, because a dashed line often covers a solid line.
rope_colours <- series_palette[c(1L, 5L, 2L, 4L, 3L)]

# More lines than these in one facet cannot be distinguished.
most_lines <- 8L

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_rope_tensions <- function(object, ...) {
  data <- rope_series(object)
  small <- max(data$tension_kN) < 0.1
  data$value <- data$tension_kN * if (small) 1000 else 1
  data$panel <- sprintf("%s tension (%s)", data$heading, if (small) "N" else "kN")
  data$at <- data$along_m
  data$across <- "distance along the rope (m)"
  data <- data[order(match(data$heading, unique(data$heading)), data$group), ]
  title <- along_title("Tension along ropes", object)
  data$number <- data$group
  data$group <- gsub("_", " ", data$line)
  named_lines_chart(data, title)
}

along_title <- function(what, x) toString(c(what, attr(x, "gear_name"), attr(x, "conditions")))

# A group of `data` has one line and a `number` in its facet.
named_lines_chart <- function(data, title) {
  number <- data$number[match(unique(data$group), data$group)]
  chart <- series_chart(data, title, colours = rep_len(rope_colours, max(number))[number],
    dashes = ifelse(number %% 2L == 0L, "33", "solid"))
  if (max(number) > most_lines) chart <- chart + ggplot2::theme(legend.position = "none")
  chart
}

# Extends the tensions to both ends of each line. `heading` is the facet, `group` the number of the
# line in it.
rope_series <- function(x) {
  lines <- split(x, factor(x$line, unique(x$line)))
  drawn <- do.call(rbind, lapply(lines, function(line) {
    n <- nrow(line)
    data.frame(
      line = line$line[1L], heading = stats::na.omit(c(line$role[1L], line$line[1L]))[1L],
      along_m = c(0, line$along_m, line$along_m[n] + line$length_m[n] / 2),
      tension_kN = line$tension_kN[c(1L, seq_len(n), n)]
    )
  }))
  # both sides of a pair follow each other
  line <- unique(drawn$line)
  pair <- sub("_(port|starboard)(?=_|$)", "", line, perl = TRUE)
  order <- match(drawn$line, line[order(match(pair, pair))])
  drawn$group <- as.integer(stats::ave(order, drawn$heading,
    FUN = function(order) match(order, sort(unique(order)))))
  drawn$heading <- gsub("_", " ", drawn$heading)
  table_rows(drawn)
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_mesh_openings <- function(object, ...) {
  x <- object[object$meshes_across > 0, ]
  side <- mesh_sides(x)
  part <- function(panel, field) {
    data.frame(panel = panel, at = x$x_m, value = x[[field]], group = gsub("_", " ", side),
      number = match(side, unique(side)), piece = x$panel)[!is.na(x[[field]]), ]
  }
  data <- rbind(part("mesh opening over mesh size (%)", "opening_percent"),
    part("mesh angle (deg)", "mesh_angle_deg"))
  data$across <- "distance aft (m)"
  title <- along_title("Meshes along the net", object)
  # panels of one side, one after the other, are separate lines
  named_lines_chart(data, title) + ggplot2::aes(group = .data[["piece"]])
}

# Returns the line to which each row belongs: the name of its panel without the part. A wing belongs
# to the line of the panel that it is joined to.
mesh_sides <- function(x) {
  out <- mapply(function(panel, part) {
    if (nzchar(part)) sub(paste0("_?", part, "$"), "", panel) else panel
  }, x$panel, x$part, USE.NAMES = FALSE)
  sub("_(wing|jib)(_(left|right))?$", "", ifelse(nzchar(out), out, x$panel))
}

# ---- variations ----------------------------------------------------------------------------------

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_variations <- function(object, measures = NULL, ...) {
  shown <- drawn_measures(object, measures, variations_measures(object))
  title <- study_title(object, "Variations")
  if (has_response_curves(object)) return(response_chart(object, shown, title))
  fields <- variations_fields(object)
  field <- fields[1L]
  # a field that has one value for each value of the first adds no lines
  apart <- Filter(function(other) {
    nrow(unique(object[c(field, other)])) > length(unique(object[[field]]))
  }, fields[-1L])
  values <- lapply(unclass(object)[apart], axis_strings)
  group <- if (length(apart)) do.call(paste, c(values, sep = ", ")) else rep("", nrow(object))
  at <- object[[field]]
  rows <- order(match(group, unique(group)), axis_places(at))
  data <- do.call(rbind, lapply(shown, function(name) {
    data.frame(panel = measure_label(name, variations_unit(object, name)),
      across = field_words(object, field), at = at[rows], value = object[[name]][rows],
      group = group[rows], marked = TRUE, settled = object$settled[rows])
  }))
  series_chart(data, title,
    key = paste(vapply(apart, function(other) field_words(object, other), ""), collapse = ", "))
}

study_title <- function(x, what) paste(c(what, attr(x, "gear_name")), collapse = " of ")

# Returns positions along an axis: numbers as they are, strings in order of appearance.
axis_places <- function(values) if (is.numeric(values)) values else match(values, unique(values))

axis_strings <- function(values) {
  if (!is.numeric(values)) return(as.character(values))
  vapply(values, function(v) format(signif(v, 6)), "")
}

# Returns "towing speed (knot)" for "towing.speed_knot".
field_words <- function(x, column) {
  unit <- variations_unit(x, column)
  label_and_unit(gsub(".", " ", label_of(column, unit), fixed = TRUE), unit)
}

# Returns "" if a subset of the table has lost the units.
variations_unit <- function(x, column) {
  unit <- attr(x, "unit")[column]
  if (is.null(unit) || is.na(unit)) "" else unname(unit)
}

drawn_ways <- c("random", "latin", "sobol", "indices")

variations_fields <- function(x) intersect(attr(x, "fields"), names(x))
variations_measures <- function(x) {
  setdiff(names(x), c(attr(x, "fields"), "settled", "problem", "warning"))
}

has_response_curves <- function(x) {
  isTRUE(attr(x, "study")$how %in% c(drawn_ways, "one_at_a_time")) &&
    length(variations_fields(x)) > 1L
}

# Smallest number of points for a smooth curve.
least_smooth <- 8L

response_chart <- function(x, measures, title) {
  fields <- variations_fields(x)
  single <- attr(x, "study")$how == "one_at_a_time"
  own <- which(attr(x, "study")$design == 1L)
  text <- !all(vapply(unclass(x)[fields], is.numeric, NA))
  pairs <- expand.grid(field = fields, measure = measures, stringsAsFactors = FALSE)
  parts <- Map(function(field, measure) {
    others <- setdiff(fields, field)
    rows <- rep(TRUE, nrow(x))
    if (single && length(own)) {
      rows <- Reduce(`&`, lapply(others, function(other) x[[other]] %in% x[[other]][own]))
    }
    rows <- which(rows)
    rows <- rows[order(x[[field]][rows])]
    part <- data.frame(
      panel = measure_label(measure, variations_unit(x, measure)), across = field_words(x, field),
      at = if (text) axis_strings(x[[field]][rows]) else x[[field]][rows],
        value = x[[measure]][rows],
      joined = single, marked = TRUE, settled = x$settled[rows]
    )
    seen <- !is.na(part$value)
    if (single || text || sum(seen) < least_smooth) return(part)
    curve <- stats::lowess(part$at[seen], part$value[seen])
    rbind(part, data.frame(panel = part$panel[1L], across = part$across[1L], at = curve$x,
      value = curve$y, joined = TRUE, marked = FALSE, settled = TRUE))
  }, pairs$field, pairs$measure)
  series_chart(do.call(rbind, parts), title, grid = TRUE)
}

# ---- effects -------------------------------------------------------------------------------------

# Converts strings to numbers if all are numbers.
numbers_or_strings <- function(values) {
  number <- suppressWarnings(as.double(values))
  if (anyNA(number)) values else number
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_effects <- function(object, measures = NULL, ...) {
  shown <- object$measure %in% drawn_measures(object, measures, unique(object$measure))
  data <- data.frame(
    panel = measure_label(object$measure, object$unit), at = numbers_or_strings(object$level),
    across = vapply(object$field, function(field) field_words(object, field), ""),
    value = object$value, marked = TRUE
  )
  series_chart(data[shown, ], study_title(object, "Main effects"), grid = TRUE)
}

#' @rdname codend_charts
#' @exportS3Method ggplot2::autoplot
autoplot.codend_pair_effects <- function(object, measures = NULL, most = 6, ...) {
  rows <- chosen_pairs(object, measures, most)
  data <- do.call(rbind, lapply(rows, function(row) pair_points(object, row)))
  data$at <- numbers_or_strings(data$at)
  number <- data$number[match(unique(data$group), data$group)]
  series_chart(data, study_title(object, "Effects of pairs"),
    colours = rep_len(rope_colours, max(number))[number]) +
    # the value of the other field is printed at the end of each line
    ggplot2::geom_text(ggplot2::aes(label = .data[["label"]]), function(drawn) drawn[drawn$last, ],
      hjust = -0.2, size = 3, show.legend = FALSE) +
    (if (is.numeric(data$at)) ggplot2::scale_x_continuous(expand = c(0.05, 0, 0.2, 0))) +
    ggplot2::theme(legend.position = "none")
}

# Returns the rows of the pairs to draw.
chosen_pairs <- function(x, measures, most) {
  measures <- drawn_measures(x, measures, unique(x$measure))
  check_count("most", most)
  if (is.null(attr(x, "means"))) {
    abort_argument("{.arg x} has no means; use the unchanged result of {.fn effects}.")
  }
  unlist(lapply(measures, function(name) utils::head(which(x$measure == name), most)))
}

# Returns the means of a pair for series_chart().
pair_points <- function(x, row) {
  means <- attr(x, "means")
  drawn <- means[means$measure == x$measure[row] & means$field == x$field[row] &
    means$other == x$other[row], ]
  drawn <- drawn[order(match(drawn$other_value, unique(drawn$other_value)),
    axis_places(numbers_or_strings(drawn$value))), ]
  other <- field_words(x, x$other[row])
  data.frame(
    panel = measure_label(x$measure[row], x$unit[row]),
    across = paste0(field_words(x, x$field[row]), "\na line for each ", other),
    at = drawn$value, value = drawn$mean, marked = TRUE,
    group = paste(other, "=", group_labels(drawn$other_value)),
    label = group_labels(drawn$other_value, 3L),
    number = match(drawn$other_value, unique(drawn$other_value)),
    last = !duplicated(drawn$other_value, fromLast = TRUE)
  )
}

# Returns numbers with few digits if that distinguishes them.
group_labels <- function(values, figures = 4L) {
  number <- numbers_or_strings(values)
  if (!is.numeric(number)) return(values)
  short <- axis_strings(signif(number, figures))
  if (length(unique(short)) < length(unique(number))) axis_strings(number) else short
}
