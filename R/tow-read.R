# Section `tow` of a plan as arguments of tow().

tow_section <- function(gear) {
  # no partial match with the section `towing`
  tow <- gear_fields(gear)[["tow"]]
  if (is.null(tow)) return(list())
  for (name in intersect(c("speed", "course", "catch"), names(tow))) {
    tow[[name]] <- schedule_table(tow[[name]], name)
  }
  if (!is.null(tow$warp_out)) {
    by_rope <- !is.null(names(tow$warp_out))
    tow$warp_out <- if (by_rope) {
      lapply(tow$warp_out, schedule_table)
    } else {
      schedule_table(tow$warp_out)
    }
  }
  if (!is.null(tow$current)) {
    one <- !is.null(names(tow$current))
    layers <- if (one) list(tow$current) else tow$current
    tow$current <- lapply(layers, function(layer) Map(schedule_table, layer, names(layer)))
  }
  tow$heave <- if (!is.null(names(tow$heave))) {
    swell(tow$heave$amplitude, tow$heave$period)
  } else if (!is.null(tow$heave)) {
    schedule_table(tow$heave)
  }
  for (table in intersect(c("response", "record"), names(tow$vessel_motion))) {
    tow$vessel_motion[[table]] <- rows_table(tow$vessel_motion[[table]])
  }
  tow
}

# Converts a list of rows to a data frame; missing fields become 0.
rows_table <- function(rows) {
  names <- unique(unlist(lapply(rows, names)))
  list2DF(lapply(setNames(names, names), function(name) {
    vapply(rows, function(row) as.double(first_of(row[[name]], 0)), 0)
  }))
}

# Converts a list of list(time, value) in SI to a data frame. Angles get a unit, because they may
# exceed a turn. `name`: of the argument.
schedule_table <- function(given, name = "") {
  unit <- if (name %in% c("course", "toward")) "rad" else ""
  if (!is.list(given)) return(if (nzchar(unit)) with_bare_unit(given, unit) else given)
  table <- data.frame(
    time = vapply(given, `[[`, 0, "time"), value = vapply(given, `[[`, 0, "value")
  )
  setNames(table, with_unit(names(table), c("", unit)))
}

# Returns a function of time (s): height (m) of a regular swell, rising from 0.
swell <- function(amplitude, period) {
  force(amplitude)
  force(period)
  function(time) amplitude * sin(2 * pi * time / period)
}
