# The designs that a page stores for comparison.

most_stored_designs <- 24L

# found: list(gear, drawing, measures). `seen` is TRUE if the picture contains the design.
stored_design <- function(id, name, found) {
  list(
    id = id, name = name, design = design_of(found$gear), gear = found$gear,
    drawing = found$drawing, measures = found$measures, seen = TRUE
  )
}

# Returns a cleaned and shortened name, or `otherwise` if a page did not send a name.
design_name <- function(name, otherwise) {
  if (!is_text(name)) return(otherwise)
  name <- trimws(gsub("[[:cntrl:][:space:]]+", " ", substr(name, 1L, 4L * most_name)))
  if (nzchar(name)) substr(name, 1L, most_name) else otherwise
}

# designs: list of list(name, measures); the first design is the reference. Returns list(measure,
# unit, values, changes), with one vector of values and of changes per design.
design_table <- function(designs) {
  every <- lapply(designs, `[[`, "measures")
  names <- unique(unlist(lapply(every, names)))
  units <- unlist(unname(lapply(every, attr, "unit")))
  unit <- unname(units[match(names, names(units))])
  values <- lapply(every, function(one) unname(plain_measures(one)[names]))
  list(
    measure = label_of(names, unit), unit = unit, values = values,
    changes = lapply(values, function(value) value - values[[1L]])
  )
}

# Returns the table of stored designs and of the measures on screen, with a column per design.
designs_tables <- function(kept, measures, preferred, say = make_translator()) {
  designs <- c(kept, list(list(name = say("on_screen"), measures = measures)))
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
    list(label_with_unit(say, table$measure, table$unit)), unname(cells), stringsAsFactors = FALSE
  ))
  list(page_table(say("designs_caption"), head, text_rows(rows)))
}

# Returns the table as a data frame, for a file.
designs_frame <- function(designs) {
  table <- design_table(designs)
  values <- stats::setNames(table$values, vapply(designs, `[[`, "", "name"))
  data.frame(
    measure = table$measure, unit = table$unit, values, check.names = FALSE
  )
}
