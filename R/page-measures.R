# Measures as numbers that the page writes as tables.

# Returns a list by measure: name, label (in English), unit, definition, and `key`, TRUE for key
# measures.
measures_about <- function(measures) {
  unit <- unname(attr(measures, "unit"))
  names <- names(measures)
  unname(Map(list, name = names, label = label_of(names, unit), unit = unit,
    definition = definitions_of(measures), key = names %in% key_names(names)))
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
    level = 100 * uncertainty$level,
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
