# Sources of uncertainty of a gear. Uncertainties in the plan come first, then a table by kind of
# number (inst/extdata/uncertainty.csv).

uncertainty_table <- package_table("uncertainty.csv")

# Returns a standard uncertainty of the table as a fraction of a value (SI).
table_share <- function(text, value = 1) {
  parts <- split_quantity(text)
  if (identical(parts[2L], "%")) return(as.double(parts[1L]) / 100)
  dimension <- quantity_dimension(text)
  quantity_si(text, if (is.na(dimension)) "number" else dimension) / abs(value)
}

# Returns a list per source:
#   name, group, paths; multiplier: name of the force component
#   share: standard uncertainty as a fraction of the value, or of 1 if the value is 0
#   off: mean minus value, as such a fraction
#   uniform: TRUE for a uniform distribution
#   given: TRUE if the plan states the uncertainty
#   upward: TRUE for a value of 0, which can only increase
uncertainty_sources <- function(gear) {
  c(multiplier_sources(gear), field_sources(gear))
}

multiplier_sources <- function(gear) {
  table <- uncertainty_table
  own <- uncertain_numbers(gear$plan)
  lapply(names(force_multipliers), function(name) {
    path <- paste0("multipliers.", name)
    row <- table[table$group == "coefficients" & table$field == name, ]
    value <- field_number(gear$plan, path)$value
    source <- list(
      name = force_multipliers[[name]], group = "coefficients", multiplier = name, paths = path,
      share = table_share(row$uncertainty, whole_of(value)), off = 0, upward = value == 0
    )
    if (path %in% rownames(own)) source[names(stated(own, path))] <- stated(own, path)
    source
  })
}

# Removes the side from a path, because both sides of a gear have one error.
without_side <- function(path) gsub("_?(port|starboard|left|right)", "", path)

field_sources <- function(gear) {
  plan <- gear$plan
  own <- uncertain_numbers(plan)
  own <- own[!startsWith(rownames(own), "multipliers."), , drop = FALSE]
  table <- uncertainty_table
  table <- table[table$group %in% c("conditions", "plan"), ]
  paths <- setdiff(given_paths(plan), rownames(own))
  numbers <- lapply(setNames(paths, paths), function(path) field_number(plan, path))
  numbers <- Filter(function(one) is.list(one) && !one$whole && one$value != 0, numbers)
  row <- vapply(names(numbers), function(path) {
    fits <- vapply(table$field, grepl, NA, x = path, perl = TRUE)
    # The first matching row applies. Multipliers cover the coefficients.
    if (any(fits) && !grepl("coefficient", path)) which(fits)[1L] else NA_integer_
  }, 0L)
  numbers <- numbers[!is.na(row)]
  row <- row[!is.na(row)]
  together <- table$together[row] == "yes"
  value <- vapply(numbers, function(one) paste(one$value, one$unit), "")
  key <- ifelse(together, table$words[row], paste(without_side(names(numbers)), value))
  given <- lapply(unique(key), function(one) {
    at <- which(key == one)
    si <- table[row[at[1L]], ]
    list(
      name = if (together[at[1L]]) si$words else path_labels(names(numbers)[at]),
      group = si$group, paths = names(numbers)[at],
      share = table_share(si$uncertainty, abs(numbers[[at[1L]]]$value)), off = 0
    )
  })
  # Numbers of one kind, value and uncertainty have one error if the table marks the kind as
  # `together`.
  first_row <- function(path) which(vapply(table$field, grepl, NA, x = path, perl = TRUE))[1L]
  alike <- vapply(rownames(own), function(path) {
    row <- first_row(path)
    if (is.na(row) || table$together[row] != "yes") return(without_side(path))
    numbers <- c(format(field_number(plan, path)$value), unlist(own[path, ]))
    paste(c(table$words[row], numbers), collapse = " ")
  }, "")
  said <- lapply(split(rownames(own), factor(alike, unique(alike))), function(paths) {
    fits <- first_row(paths[1L])
    largest <- paths[which.max(own[paths, "share"])]
    c(
      list(name = path_labels(paths), paths = paths,
        group = if (is.na(fits)) "plan" else table$group[fits],
        upward = field_number(plan, paths[1L])$value == 0),
      stated(own, largest)
    )
  })
  c(unname(said), given)
}

# Returns the elements of a source with the distribution that the plan states for a path.
stated <- function(own, path) {
  list(share = own[[path, "share"]], off = own[[path, "off"]],
    uniform = own[[path, "uniform"]] == 1, given = TRUE)
}

path_labels <- function(paths) {
  gsub("[._]", " ", without_side(paths[1L]))
}

# Returns a field for `field_sensitivities()` whose paths change by the same fraction.
common_field <- function(plan, paths) {
  list(
    name = paste(paths, collapse = " + "), paths = paths, value = 1, unit = "", whole = FALSE,
    parts = lapply(paths, function(path) field_number(plan, path))
  )
}
