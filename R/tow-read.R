# The `tow` section of a plan as the arguments of tow().

# Returns a list by argument; arguments that the plan leaves out are not in it.
tow_section <- function(gear) {
  # never a plan's section `towing`, which begins alike
  tow <- gear_fields(gear)[["tow"]]
  if (is.null(tow)) return(list())
  for (name in intersect(c("speed", "course", "catch"), names(tow))) {
    tow[[name]] <- schedule_table(tow[[name]])
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
    tow$current <- lapply(layers, lapply, schedule_table)
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

# A list of rows, of which some fields may be missing, as a data frame: 0 for what is.
rows_table <- function(rows) {
  names <- unique(unlist(lapply(rows, names)))
  list2DF(lapply(setNames(names, names), function(name) {
    vapply(rows, function(row) as.double(first_of(row[[name]], 0)), 0)
  }))
}

# A number, or a list of list(time, value), as tow() takes it.
schedule_table <- function(given) {
  if (!is.list(given)) return(given)
  data.frame(
    time = vapply(given, `[[`, 0, "time"), value = vapply(given, `[[`, 0, "value")
  )
}

# Height (m) of a regular swell by time (s), from its mean upwards.
swell <- function(amplitude, period) {
  force(amplitude)
  force(period)
  function(time) amplitude * sin(2 * pi * time / period)
}
