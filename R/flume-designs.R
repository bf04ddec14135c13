# The designs that a page keeps beside each other.

# Designs that a page may keep.
most_kept <- 24L

# One design that is kept: found = list(gear, drawing, measures). `seen` says whether it is in the
# picture.
kept_design <- function(id, name, found) {
  list(
    id = id, name = name, design = design_of(found$gear), gear = found$gear,
    drawing = found$drawing, measures = found$measures, seen = TRUE
  )
}

# A name of a page's, as a name.
design_name <- function(name, otherwise) {
  if (!is_text(name)) return(otherwise)
  name <- trimws(gsub("[[:cntrl:][:space:]]+", " ", substr(name, 1L, 4L * most_name)))
  if (nzchar(name)) substr(name, 1L, most_name) else otherwise
}

# Measures of designs beside each other, a column each: data frame with measure, unit, definition,
# and for each design its value and, from the second on, its difference to the first.
# designs: list of list(name, measures), the first the one that others are compared with.
design_table <- function(designs) {
  every <- lapply(designs, `[[`, "measures")
  names <- unique(unlist(lapply(every, names)))
  units <- unlist(unname(lapply(every, attr, "unit")))
  unit <- unname(units[match(names, names(units))])
  values <- lapply(every, function(one) unname(plain_measures(one)[names]))
  list(
    measure = words_of(names, unit), unit = unit, values = values,
    changes = lapply(values, function(value) value - values[[1L]])
  )
}

# As HTML: columns by id, each of designs_table().
designs_html <- function(designs, preferred, say = new_say()) {
  table <- in_preferred(design_table(designs), preferred)
  figures <- decimals_of(do.call(pmax, c(lapply(table$values, abs), list(na.rm = TRUE))))
  head <- c(say("measure"), vapply(designs, `[[`, "", "name"))
  cells <- Map(function(value, change, k) {
    shown <- fixed_decimals(value, figures)
    if (k == 1L) return(shown)
    moved <- signed(change, figures)
    paste0(shown, ifelse(nzchar(moved) & moved != "0", paste0("\n", moved), ""))
  }, table$values, table$changes, seq_along(designs))
  rows <- do.call(data.frame, c(
    list(said_measure_unit(say, table$measure, table$unit)), unname(cells), stringsAsFactors = FALSE
  ))
  html_table(say("designs_caption"), head, text_rows(rows))
}

# As a table for a file.
designs_frame <- function(designs) {
  table <- design_table(designs)
  values <- stats::setNames(table$values, vapply(designs, `[[`, "", "name"))
  data.frame(
    measure = table$measure, unit = table$unit, values, check.names = FALSE
  )
}
