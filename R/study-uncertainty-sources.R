# Sources of uncertainty of a gear. Uncertainties in the plan come first, then a table by kind of
# number (inst/extdata/uncertainty.csv). Force components use the results of the validation
# (uncertainty_multipliers.csv).

package_table <- function(name) {
  file <- system.file("extdata", name, package = "codend")
  if (!nzchar(file)) return(NULL)
  utils::read.csv(file, comment.char = "#")
}

uncertainty_table <- function() package_table("uncertainty.csv")

# Returns a standard uncertainty of the table as a fraction of a value (SI).
table_share <- function(text, value = 1) {
  parts <- split_quantity(text)
  if (identical(parts[2L], "%")) return(as.double(parts[1L]) / 100)
  dimension <- quantity_dimension(text)
  quantity_si(text, if (is.na(dimension)) "number" else dimension) / abs(value)
}

# Returns a list per source: name, group, share, paths, off, multiplier (of force components).
# `share`: standard uncertainty as a fraction of the value, or of 1 if the value is 0. `off`: known
# bias of the mean, as a fraction.
uncertainty_sources <- function(gear) {
  c(multiplier_sources(gear), field_sources(gear))
}

multiplier_sources <- function(gear) {
  table <- uncertainty_table()
  known <- multiplier_knowledge()
  own <- uncertain_shares(gear$plan)
  lapply(names(force_multipliers), function(name) {
    path <- paste0("multipliers.", name)
    row <- table[table$group == "coefficients" & table$field == name, ]
    value <- whole_of(field_number(gear$plan, path)$value)
    source <- list(
      name = force_multipliers[[name]], group = "coefficients", multiplier = name, paths = path,
      share = table_share(row$uncertainty, value), off = 0, correlated = FALSE
    )
    if (path %in% names(own)) {
      source$share <- own[[path]]
    } else if (name %in% rownames(known$covariance)) {
      source$share <- sqrt(known$covariance[name, name])
      source$off <- known$mean[[name]] - 1
      source$correlated <- TRUE
    }
    source
  })
}

# Returns list(mean, covariance) of multipliers in the validation; empty without the file.
multiplier_knowledge <- function() {
  table <- package_table("uncertainty_multipliers.csv")
  if (is.null(table)) return(list(mean = numeric(), covariance = matrix(0, 0L, 0L)))
  correlation <- as.matrix(table[table$multiplier])
  list(
    mean = setNames(table$mean, table$multiplier),
    covariance = structure(correlation * outer(table$sd, table$sd),
      dimnames = list(table$multiplier, table$multiplier))
  )
}

# Removes the side from a path, because both sides of a gear have one error.
without_side <- function(path) gsub("_?(port|starboard|left|right)", "", path)

field_sources <- function(gear) {
  plan <- gear$plan
  own <- uncertain_shares(plan)
  own <- own[!startsWith(names(own), "multipliers.")]
  table <- uncertainty_table()
  table <- table[table$group %in% c("conditions", "plan"), ]
  paths <- setdiff(given_paths(plan), names(own))
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
  alike <- vapply(names(own), function(path) {
    row <- first_row(path)
    if (is.na(row) || table$together[row] != "yes") return(without_side(path))
    paste(table$words[row], format(field_number(plan, path)$value), own[[path]])
  }, "")
  said <- lapply(split(names(own), factor(alike, unique(alike))), function(paths) {
      fits <- first_row(paths[1L])
      list(
        name = path_labels(paths), paths = paths,
        group = if (is.na(fits)) "plan" else table$group[fits],
        share = max(own[paths]), off = 0
      )
    })
  c(unname(said), given)
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
