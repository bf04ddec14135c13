# The tables of the flume tank, as strings and numbers that the page lays out.

# Returns a table for the page. numbers: columns that are aligned as numbers; foot: last row; note:
# a sentence below the table.
page_table <- function(
  caption, head, rows, numbers = seq_along(head)[-1], foot = NULL, note = NULL
) {
  list(
    caption = caption, head = I(head), rows = lapply(rows, function(row) I(as.character(row))),
    numbers = I(seq_along(head) %in% numbers), foot = if (!is.null(foot)) I(as.character(foot)),
    note = note
  )
}

text_rows <- function(table) {
  lapply(seq_len(nrow(table)), function(k) unname(as.list(table[k, , drop = FALSE])))
}

# Compares the measures of two states. Returns a data frame: measure, unit, now, error (of now),
# kept, change, change_percent, definition. A value is NA if a state lacks the measure;
# change_percent also if the stored value is 0.
measure_changes <- function(now, kept) {
  names <- union(names(now), names(kept))
  unit <- unname(c(attr(now, "unit"), attr(kept, "unit"))[names])
  error <- unname(attr(now, "error")[names])
  definition <- c(
    setNames(definitions_of(now), names(now)), setNames(definitions_of(kept), names(kept))
  )[names]
  now <- unname(plain_measures(now)[names])
  kept <- unname(plain_measures(kept)[names])
  change <- now - kept
  data.frame(
    measure = label_of(names, unit), unit = unit,
    now = now, error = error, kept = kept, change = change,
    change_percent = ifelse(kept == 0, NA_real_, 100 * change / abs(kept)),
    definition = unname(definition)
  )
}

# Returns numbers with separated thousands, and "0" if all decimals are 0. (formatC() takes as long
# as settling.)
fixed_decimals <- function(x, decimals) {
  text <- sprintf("%.*f", as.integer(decimals), x)
  text[is.finite(x) & !grepl("[1-9]", text)] <- "0"
  long <- which(abs(x) >= 1e4)
  text[long] <- vapply(text[long], format_thousands, "")
  text[is.na(x)] <- ""
  text
}

format_thousands <- function(text) {
  parts <- strsplit(text, ".", fixed = TRUE)[[1]]
  parts[1] <- gsub("(?<=[0-9])(?=(?:[0-9]{3})+$)", "\u202f", parts[1], perl = TRUE)
  paste(parts, collapse = ".")
}

# Returns differences such as "+3.2", and "0" if all decimals are 0.
signed <- function(x, decimals) {
  text <- fixed_decimals(abs(x), decimals)
  text <- ifelse(text == "0", "0", paste0(ifelse(x < 0, "\u2212", "+"), text))
  text[is.na(x)] <- ""
  text
}

# Returns the decimals that give four digits of the largest value of a row, but at most four.
decimals_of <- function(largest) {
  shown <- signif(largest, 4)
  ifelse(is.na(shown) | shown == 0, 0, pmin(pmax(3 - floor(log10(pmax(shown, 1e-3))), 0), 4))
}

# Returns a list by measure of two states: name, words (translated, with unit), unit and factor (of
# the preferred unit), definition, and `key`, TRUE for key measures. preferred: from preferred_of();
# `say`: translator from make_translator(), here and below.
displayed_measures <- function(now, kept, preferred = list(), say = make_translator()) {
  table <- measure_changes(now, kept)
  names <- union(names(now), names(kept))
  units <- lapply(table$unit, function(unit) preferred_number(1, unit, preferred))
  unit <- vapply(units, `[[`, "", "unit")
  unname(Map(
    list, name = names, words = label_with_unit(say, table$measure, unit), unit = unit,
    factor = vapply(units, `[[`, 0, "value"), definition = table$definition,
    key = names %in% key_names(names)
  ))
}

# Returns the numbers of two states, in the order of `measures` from displayed_measures(): now,
# error (of now), kept, and the strings of intervals with their level, NULL without uncertainty.
displayed_numbers <- function(measures, now, kept, uncertainty = NULL, say = make_translator()) {
  names <- vapply(measures, `[[`, "", "name")
  numbers <- function(x) I(unname(as.double(x[names])))
  list(
    now = numbers(plain_measures(now)), error = numbers(attr(now, "error")),
    kept = numbers(plain_measures(kept)),
    intervals = if (!is.null(uncertainty)) {
      factor <- vapply(measures, `[[`, 0, "factor")
      I(interval_cells(uncertainty, names, factor, say))
    },
    level = if (!is.null(uncertainty)) 100 * uncertainty$level
  )
}

# Measures that users check first, for any gear, and the number of key measures of a gear.
key_measures <- c(
  "door_spread_m", "wing_end_spread_m", "net_mouth_height_m", "headline_height_m",
  "footrope_height_m", "total_drag_kN"
)
key_count <- 6L

# Returns the first `key_count` names: members of `key_measures`, then other names in their order.
key_names <- function(names) {
  utils::head(union(intersect(key_measures, names), names), key_count)
}

# Returns "90 %: 4.5 to 6.6" or "" for each measure. factor: to preferred units.
interval_cells <- function(uncertainty, names, factor, say) {
  table <- uncertainty$measures[match(names, uncertainty$measures$measure), ]
  known <- which(table$error > 0)
  text <- rep("", length(names))
  ends <- lapply(table[known, c("lower", "upper")], function(end) {
    interval_ends(end * factor[known], table$error[known] * factor[known])
  })
  text[known] <- mapply(function(low, high) {
    say("interval", level = 100 * uncertainty$level, low = low, high = high)
  }, ends$lower, ends$upper)
  text
}

# Returns the largest tension of each role of ropes or netting, highest first, per rope or twine
# [kN].
ranked_tensions <- function(state) {
  table <- tension_table(state)
  groups <- by_role(table)
  rows <- do.call(rbind, lapply(names(groups), function(name) {
    group <- groups[[name]]
    rope <- group$kind[1] == "rope"
    height <- if (rope) group$max_kN else group$most_loaded_kN
    at <- which.max(height)
    data.frame(
      part = name, kind = group$kind[1], highest_kN = height[at], mean_kN = max(group$mean_kN),
      strength_kN = group$strength_kN[at], at = group$part[at]
    )
  }))
  rows <- rows[order(-rows$highest_kN), ]
  rows$margin <- rows$strength_kN / rows$highest_kN
  row.names(rows) <- NULL
  rows
}

tension_tables <- function(state, say = make_translator()) {
  ranked <- ranked_tensions(state)
  margin <- ifelse(
    is.finite(ranked$margin),
    paste0("\u00d7 ", formatC(ranked$margin, format = "f", digits = 1)), ""
  )
  table <- function(kind, caption, unit, highest, with_strength) {
    shown <- function(force) trimws(column_figures(in_unit(from_unit(force, "kN"), unit)))
    rows <- ranked[ranked$kind == kind, ]
    if (!nrow(rows)) return(NULL)
    cells <- data.frame(rows$part, shown(rows$highest_kN), shown(rows$mean_kN))
    head <- c(say("part"), highest)
    if (with_strength) {
      cells <- cbind(cells, ifelse(is.na(rows$strength_kN), say("not_known"),
        trimws(column_figures(rows$strength_kN))), margin[ranked$kind == kind])
      head <- c(head, say("breaking_load_kn"), say("margin"))
    }
    page_table(caption, head, text_rows(cells), note = if (with_strength) say("margin_note"))
  }
  Filter(Negate(is.null), list(
    table("rope", say("ropes_by_tension"), "kN", c(say("largest_kn"), say("mean_kn")), TRUE),
    table("netting", say("netting_by_tension"), "N", c(say("tenth_n"), say("mean_n")), FALSE)
  ))
}

drag_tables <- function(state, say = make_translator()) {
  drag <- drag_table(state)
  totals <- drag_totals(drag)
  total <- totals$drag_kN[nrow(totals)]
  cells <- function(name, drag, side, lift) {
    data.frame(name, trimws(column_figures(drag)), share_text(drag, total),
      trimws(column_figures(side)), trimws(column_figures(lift)))
  }
  last <- nrow(totals)
  of_groups <- text_rows(cells(totals$group, totals$drag_kN, totals$side_kN, totals$lift_kN))
  groups <- by_role(drag)
  sums <- function(column) vapply(groups, function(group) sum(group[[column]]), 0)
  order <- order(-sums("drag_kN"))
  of_parts <- text_rows(cells(names(groups), sums("drag_kN"), sums("side_kN"),
    sums("lift_kN"))[order, ])
  head <- c(say("drag_kn"), say("share"), say("to_starboard_kn"), say("lift_kn"))
  list(
    page_table(say("drag_by_group"), c(say("group"), head), of_groups[-last],
      foot = of_groups[[last]]),
    page_table(say("drag_by_part"), c(say("part"), head), of_parts)
  )
}

difference_tables <- function(kept, now, say = make_translator()) {
  found <- plan_changes(kept$plan, now$plan)
  shown <- function(value) if (is.null(value)) say("none") else show_value(value)
  listed <- utils::head(found, 60L)
  note <- if (!length(found)) {
    say("no_difference")
  } else if (length(found) > length(listed)) {
    say("and_more", n = length(found) - length(listed))
  }
  list(page_table(
    say("fields_differ"), c(say("field"), say("kept"), say("now")),
    lapply(listed, function(d) list(d$path, shown(d$was), shown(d$value))), numbers = integer(),
    note = note
  ))
}

# Functions of tank and translator that return the tables of a tab, by name.
tank_tables <- list(
  tensions = function(tank, say) tension_tables(tank$state, say),
  drag = function(tank, say) drag_tables(tank$state, say),
  differences = function(tank, say) difference_tables(tank$kept[[1L]]$gear, tank$gear, say),
  designs = function(tank, say) designs_tables(tank$kept, tank$measures, tank$preferred, say),
  slopes = function(tank, say) sensitivity_tables(tank$slopes, say)
)
