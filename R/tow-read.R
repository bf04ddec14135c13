# The section `tow` of a plan: as arguments of tow(), as a schedule, and from a schedule.

# Returns the section of the gear's assembly with its quantities as in the plan; lists of times
# become data frames. A purse seine has a section from its phases.
tow_section <- function(gear) {
  # no partial match with the section `towing`
  section <- first_of(gear_checked(gear)$tree, gear$plan)[["tow"]]
  if (is.null(section)) return(list())
  section <- map_changes(section, function(value, path, dimension) rows_table(value))
  for (name in intersect(c("response", "record"), names(section$vessel_motion))) {
    section$vessel_motion[[name]] <- rows_table(section$vessel_motion[[name]])
  }
  section
}

# Returns the section `tow` for a tow by a schedule. The schedule replaces the inputs that the plan
# gives, and sets the end time. Hauling that follows from other fields of the plan remains.
unscheduled_section <- function(gear, schedule) {
  section <- tow_section(gear)
  if (!any(lengths(schedule))) return(section)
  replaced <- intersect(names(gear$plan[["tow"]]), schedule_inputs())
  section <- section[setdiff(names(section), replaced)]
  last <- last_time(with_planned(schedule, section))
  if (last > 0) section$until <- last
  section
}

# Converts a list of rows to a data frame; missing fields become 0. Other values stay.
rows_table <- function(rows) {
  if (!is.list(rows) || !is.null(names(rows))) return(rows)
  names <- unique(unlist(lapply(rows, names)))
  list2DF(lapply(setNames(nm = names), function(name) {
    plain_values(lapply(rows, function(row) first_of(row[[name]], 0)))
  }))
}

# Converts a data frame to a list of rows. Other values stay.
table_rows_list <- function(table) {
  if (!is.data.frame(table)) return(table)
  lapply(seq_len(nrow(table)), function(k) lapply(as.list(table), `[[`, k))
}

# Returns the section `tow` with the inputs of a schedule instead of its own.
#' @export
planned_value.codend_schedule <- function(value, present) { # nolint: object_name_linter.
  given <- Filter(Negate(is.null), unclass(value))
  for (name in intersect(c("control", "control_every"), names(given))) abort_unplanned(name)
  given <- map_changes(given, function(value, path, dimension) {
    if (is.function(value)) abort_unplanned(path)
    table_rows_list(value)
  })
  for (name in intersect(c("response", "record"), names(given$vessel_motion))) {
    table <- given$vessel_motion[[name]]
    if (is_text(table)) table <- utils::read.csv(table, comment.char = "#")
    given$vessel_motion[[name]] <- table_rows_list(table)
  }
  section <- c(present[setdiff(names(present), names(value))], given)
  if (length(section)) section
}

abort_unplanned <- function(path) {
  abort_argument(c(
    "{.arg {path}} is a function, which a plan cannot hold.",
    i = "Give a table of {.field time} and {.field value}, or pass the schedule to {.fn tow}."
  ))
}

# Returns a function of time (s): height (m) of a regular swell, rising from 0.
swell <- function(given) {
  amplitude <- quantity_number(given$amplitude, "length", "heave$amplitude")
  period <- quantity_number(given$period, "time", "heave$period", positive = TRUE)
  function(time) amplitude * sin(2 * pi * time / period)
}
