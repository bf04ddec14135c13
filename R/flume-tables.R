# The data of the tables of the flume tank, which the page writes.

# columns: list of strings and numbers; parts: names of the gear's parts in each row.
page_table <- function(columns, parts = NULL) {
  list(columns = lapply(unname(as.list(columns)), I), parts = lapply(unname(parts), I))
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

# Functions of tank and a stored design that return the tables of a tab, by name.
tank_tables <- list(
  tensions = function(tank, kept) tension_tables(tank$state),
  drag = function(tank, kept) drag_tables(tank$state),
  differences = function(tank, kept) difference_tables(gear_of_words(kept), tank$gear)
)

# Ropes [kN] with the margin to the breaking load, and netting [N].
tension_tables <- function(state) {
  ranked <- ranked_tensions(state)
  rope <- ranked[ranked$kind == "rope", ]
  net <- ranked[ranked$kind == "netting", ]
  list(
    page_table(rope[c("part", "highest_kN", "mean_kN", "strength_kN", "margin")], rope$parts),
    page_table(list(net$part, 1000 * net$highest_kN, 1000 * net$mean_kN), net$parts)
  )
}

# Drag by group and by part, with its percentage of the total.
drag_tables <- function(state) {
  drag <- drag_table(state)
  totals <- drag_totals(drag)
  table <- function(names, sums, parts = NULL) {
    share <- 100 * sums$drag_kN / totals$drag_kN[nrow(totals)]
    page_table(list(names, sums$drag_kN, share, sums$side_kN, sums$lift_kN), parts)
  }
  groups <- by_role(drag)
  forces <- c("drag_kN", "side_kN", "lift_kN")
  sums <- as.data.frame(t(vapply(groups, function(group) colSums(group[forces]), numeric(3))))
  order <- order(-sums$drag_kN)
  list(
    table(totals$group, totals),
    table(names(groups)[order], sums[order, ], lapply(groups[order], `[[`, "part"))
  )
}

# Values of fields as strings, NA without one.
difference_tables <- function(kept, now) {
  found <- plan_changes(kept$plan, now$plan)
  column <- function(name) {
    vapply(found, function(one) {
      if (is.null(one[[name]])) NA_character_ else show_value(one[[name]])
    }, "")
  }
  list(page_table(list(vapply(found, `[[`, "", "path"), column("was"), column("value"))))
}
