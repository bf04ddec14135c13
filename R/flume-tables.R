# The tables of the flume tank, as strings and numbers that the page lays out.

# Returns a table for the page. numbers: columns that are aligned as numbers; foot: last row; note:
# a sentence below the table; parts: names of the gear's parts in each row.
page_table <- function(
  caption, head, rows, numbers = seq_along(head)[-1], foot = NULL, note = NULL, parts = NULL
) {
  list(
    caption = caption, head = I(head), rows = lapply(rows, function(row) I(as.character(row))),
    numbers = I(seq_along(head) %in% numbers), foot = if (!is.null(foot)) I(as.character(foot)),
    note = note, parts = lapply(unname(parts), I)
  )
}

text_rows <- function(table) {
  lapply(seq_len(nrow(table)), function(k) unname(as.list(table[k, , drop = FALSE])))
}

# Returns a list by measure: name, words (translated), label (in English), unit, definition, and
# `key`, TRUE for key measures. `say`: translator from make_translator(), here and below.
measures_about <- function(measures, say = make_translator()) {
  unit <- unname(attr(measures, "unit"))
  label <- label_of(names(measures), unit)
  unname(Map(
    list, name = names(measures), words = label_of_measure(say, label), label = label, unit = unit,
    definition = definitions_of(measures), key = names(measures) %in% key_names(names(measures))
  ))
}

# Returns the numbers of measures: now, error, and with an uncertainty its level and the lower and
# upper end of each interval, NA without one.
measures_numbers <- function(measures, uncertainty = NULL) {
  numbers <- list(
    now = I(unname(plain_measures(measures))), error = I(unname(attr(measures, "error")))
  )
  if (is.null(uncertainty)) return(numbers)
  table <- uncertainty$measures[match(names(measures), uncertainty$measures$measure), ]
  known <- table$error > 0
  c(numbers, list(
    level = 100 * uncertainty$level, spread = I(ifelse(known, table$error, NA)),
    lower = I(ifelse(known, table$lower, NA)), upper = I(ifelse(known, table$upper, NA))
  ))
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
      strength_kN = group$strength_kN[at], at = group$part[at], parts = I(list(group$part))
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
    page_table(caption, head, text_rows(cells), note = if (with_strength) say("margin_note"),
      parts = rows$parts)
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
    page_table(say("drag_by_part"), c(say("part"), head), of_parts,
      parts = lapply(groups[order], `[[`, "part"))
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

# Functions of tank, translator and a stored design that return the tables of a tab, by name.
tank_tables <- list(
  tensions = function(tank, say, kept) tension_tables(tank$state, say),
  drag = function(tank, say, kept) drag_tables(tank$state, say),
  differences = function(tank, say, kept) difference_tables(gear_of_words(kept), tank$gear, say)
)
