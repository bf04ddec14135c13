# Returns a list per free field: name, paths, value (of the gear), unit, whole, dimension, lower,
# upper, prior. Values are in the plan's unit. `prior`: c(mean, standard deviation) of a
# `normal_value()`, or NULL. `change`: ranges or distributions by path; " + " joins paths that
# change together. `what`: argument name for errors.
free_fields <- function(gear, change, what = "change") {
  if (!is.list(change) || !is_named(change)) {
    abort_argument("{.arg {what}} must be a list of ranges by the paths of fields, such as
      {.code list(warps.length = c(\"300 m\", \"600 m\"))}.")
  }
  paths <- lapply(names(change), paths_of)
  if (anyDuplicated(unlist(paths))) {
    twice <- unlist(paths)[duplicated(unlist(paths))][1L]
    abort_argument("{.arg {what}} has {.field {twice}} twice.")
  }
  Map(function(path, range) free_field(gear, path, range, what), paths, unname(change))
}

free_field <- function(gear, paths, range, what) {
  name <- paste(paths, collapse = " + ")
  found <- lapply(paths, function(path) field_number(gear$plan, path))
  wrong <- Filter(is.character, found)
  if (length(wrong)) abort_argument("{.arg {what}} has {.field {name}}, which {wrong[[1]]}.")
  if (any(!vapply(found, identical, NA, found[[1L]]))) {
    abort_argument("{.arg {what}} has {.field {name}}; fields that change together must have the
      same value.")
  }
  field <- c(list(name = name, paths = paths), found[[1L]])
  field$dimension <- first_of(field_dimension(gear, paths[1L]), NA_character_)
  field$prior <- NULL
  if (is_distribution(range)) {
    if (range$kind == "normal") {
      prior <- numbers_in_units(range$numbers, range)
      field$prior <- vapply(prior, range_end, 0, field = field)
    }
    wide <- range$numbers[1L] + c(-1, 1) * normal_reach * range$numbers[2L]
    range <- numbers_in_units(ifelse(is.finite(range$ends), range$ends, wide), range)
  }
  range <- given_value(range, name)
  note_bare_numbers(gear$plan, setNames(list(unlist(range)), paths[1L]))
  ends <- vapply(as.list(range), range_end, 0, field = field)
  if (length(ends) != 2L || !(ends[1L] < ends[2L])) {
    said <- paste(unlist(range), collapse = ", ")
    abort_argument("{.arg {what}} has the range {.val {said}} for {.field {name}}; it must be two
      values, the smaller first.")
  }
  if (field$whole) ends <- c(ceiling(ends[1L]), floor(ends[2L]))
  field$lower <- ends[1L]
  field$upper <- ends[2L]
  if (field$value < field$lower || field$value > field$upper) {
    has <- with_field_unit(field$value, field)
    said <- paste(unlist(range), collapse = " to ")
    abort_argument("{.arg {what}} has the range {.val {said}} for {.field {name}}, which does not
      contain the current value, {.val {has}}.")
  }
  # Invalid ends must fail before any gear is settled.
  for (end in ends) {
    tryCatch(set_free(gear, list(field), end), codend_error_plan = function(e) {
      said <- plain_message(e)
      at <- with_field_unit(end, field)
      abort_argument("{.arg {what}} allows {.val {at}} for {.field {name}}: {said}")
    })
  }
  field
}

# Half-range of an unbounded normal distribution, in standard deviations.
normal_reach <- 4

# Returns an end of a range in the unit of its field.
range_end <- function(end, field) {
  dimension <- if (field$whole || is.na(field$dimension)) "number" else field$dimension
  value <- quantity_number(end, dimension, field$name)
  if (field$whole || !nzchar(field$unit)) value else in_unit(value, plain_unit(field$unit))
}

# Returns a number as the plan value of a field.
field_text <- function(value, field) {
  if (field$whole) return(as.integer(round(value)))
  if (!nzchar(field$unit)) return(value)
  paste(with_plain_numbers(format(value, digits = 17)), field$unit)
}

with_field_unit <- function(value, field) {
  trimws(paste(with_plain_numbers(format(signif(value, 5), digits = 6)), field$unit))
}

# `values`: in the units of the fields.
set_free <- function(gear, fields, values) {
  changes <- unlist(Map(function(field, value) {
    setNames(rep(list(field_text(value, field)), length(field$paths)), field$paths)
  }, fields, values), recursive = FALSE)
  with_fields(gear, changes)
}

# A condition or field is active within this fraction of its limit or range.
active_share <- 1e-3

# Returns "lower", "upper" or "" for scaled fields.
range_ends <- function(scaled) {
  ifelse(scaled <= active_share, "lower", ifelse(scaled >= 1 - active_share, "upper", ""))
}

# Returns the ends of ranges as text. at: from `range_ends()`.
end_text <- function(at) ifelse(at == "", "", paste("at the", at, "end of its range"))

lower_ends <- function(fields) vapply(fields, `[[`, 0, "lower")
upper_ends <- function(fields) vapply(fields, `[[`, 0, "upper")
own_values <- function(fields) vapply(fields, `[[`, 0, "value")
field_names <- function(fields) vapply(fields, `[[`, "", "name")
whole_fields <- function(fields) vapply(fields, `[[`, NA, "whole")
