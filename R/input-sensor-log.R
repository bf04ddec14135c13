#' Read the log of door and net sensors
#'
#' Reads a CSV file as vessels' systems write it, by a small file that says which column is what,
#' takes out what cannot be and what jumps, and gives a table in SI. [haul_means()] takes the tow's
#' part of it.
#'
#' Echoes are lost and doubled, so that single readings are far off. A reading is taken for a spike
#' where it differs from the running median of `window` readings by more than `spikes` times their
#' spread: 1.4826 times the running median of such differences (Hampel's identifier; the factor
#' makes it a standard deviation where readings are normal). What stays for more than half a window
#' is no spike.
#'
#' @param file A CSV file, with commas or semicolons.
#' @param columns A YAML file, or a list, that names the columns of interest: each a name to give
#'   it, with `column` (its name in the CSV), and for readings `unit` (of the plan's) and, where
#'   wanted, `least` and `most`, which a real reading lies between, in that unit. `time` has a
#'   `format` of [strptime()], or none where it is in seconds; the example has such a list.
#' @param window Readings in the running median, an odd number.
#' @param spikes How many standard deviations make a spike.
#' @return A data frame with `time` (s from the first reading; times of a day alone go on after
#'   midnight) and a column per reading in SI, `NA` where there is none or it was taken out. The
#'   attribute `removed` counts what was. A file that cannot be read, a column that is not there and
#'   a unit that is not known are errors of class `codend_error_file` or `codend_error_argument`.
#' @export
#' @examples
#' log <- tempfile(fileext = ".csv")
#' writeLines(c("Time;Door spread", paste0("10:00:", 10:29, ";", c(80:94, 800, 96:109))), log)
#' read_sensor_log(log, list(
#'   time = list(column = "Time", format = "%H:%M:%S"),
#'   door_spread = list(column = "Door spread", unit = "m", least = 10, most = 900)
#' ))
read_sensor_log <- function(file, columns, window = 11, spikes = 4) {
  check_given("file", "columns")
  check_count("window", window)
  if (window %% 2 == 0 || window < 3) {
    abort_argument("{.arg window} is {.val {window}}; it must be an odd number, 3 or more.")
  }
  if (!(is.numeric(spikes) && length(spikes) == 1L && is.finite(spikes) && spikes > 0)) {
    abort_argument("{.arg spikes} is {.val {spikes}}; it must be a number above 0.")
  }
  columns <- log_columns(columns)
  table <- read_log_table(file)
  lost <- setdiff(vapply(columns, `[[`, "", "column"), names(table))
  if (length(lost)) {
    abort_file(file, "has no column \"{lost}\"; it has {has}.", lost = lost[1L],
      has = paste(names(table), collapse = ", "))
  }
  time <- log_times(table[[columns$time$column]], columns$time$format, file)
  order <- order(time)
  found <- data.frame(time = time[order] - min(time))
  removed <- integer()
  for (name in setdiff(names(columns), "time")) {
    one <- columns[[name]]
    values <- suppressWarnings(as.double(sub(",", ".", table[[one$column]], fixed = TRUE)))[order]
    given <- !is.na(values)
    values[!is.na(values) & (values < one$least | values > one$most)] <- NA
    values[is_spike(values, window, spikes)] <- NA
    removed[name] <- sum(given & is.na(values))
    found[[name]] <- from_unit(values, one$unit)
  }
  attr(found, "removed") <- removed
  found
}

# What the columns file says, checked: lists of column, and format or unit, least and most.
log_columns <- function(columns) {
  if (is_text(columns)) {
    if (!file.exists(columns)) abort_file(columns, "does not exist.")
    columns <- tryCatch(yaml::read_yaml(columns), error = function(e) {
      abort_file(columns, "is no YAML file: {why}", why = conditionMessage(e))
    })
  }
  if (!is_map(columns) || !"time" %in% names(columns) || length(columns) < 2L) {
    abort_argument("{.arg columns} must name the columns {.field time} and at least one reading.")
  }
  for (name in names(columns)) {
    one <- columns[[name]]
    if (!is_map(one) || !is_text(one$column)) {
      abort_argument("{.arg columns} has {.field {name}} without the name of its {.field column}.")
    }
    if (name == "time") next
    known <- unlist(lapply(plan_units, names))
    if (!is_text(one$unit) || !plain_unit(one$unit) %in% known) {
      abort_argument("{.arg columns} gives {.field {name}} the unit {.val {one$unit}}; it must be a
        unit of plans, such as {.val m} or {.val kN}.")
    }
    one$unit <- plain_unit(one$unit)
    for (end in c("least", "most")) {
      value <- first_of(one[[end]], if (end == "least") -Inf else Inf)
      if (!is.numeric(value) || length(value) != 1L || is.na(value)) {
        abort_argument("{.arg columns} gives {.field {name}} the {end} {.val {value}}; it must be a
          number.")
      }
      one[[end]] <- value
    }
    columns[[name]] <- one
  }
  columns
}

read_log_table <- function(file) {
  check_file_exists(file)
  first <- readLines(file, n = 1L, warn = FALSE, encoding = "UTF-8")
  count <- function(mark) lengths(regmatches(first, gregexpr(mark, first, fixed = TRUE)))
  mark <- if (length(first) && count(";") > count(",")) ";" else ","
  tryCatch(
    utils::read.table(file, header = TRUE, sep = mark, quote = "\"", check.names = FALSE,
      colClasses = "character", na.strings = c("", "NA"), strip.white = TRUE, fill = TRUE,
      comment.char = "", encoding = "UTF-8"),
    error = function(e) {
      abort_file(file, "could not be read as CSV: {why}", why = conditionMessage(e))
    }
  )
}

log_times <- function(text, format, file) {
  if (is.null(format)) {
    time <- suppressWarnings(as.double(text))
  } else {
    time <- as.double(as.POSIXct(strptime(text, format, tz = "UTC")))
    # times of a day alone: past midnight when the clock goes back by more than half a day
    if (!grepl("%[dDFjxcs]", format)) {
      time <- time + 86400 * cumsum(c(0, diff(time) < -43200 & !is.na(diff(time))))
    }
  }
  if (anyNA(time)) {
    row <- which(is.na(time))[1L]
    abort_file(file, "has \"{value}\" for a time in row {row}.", value = text[row], row = row)
  }
  time
}

is_spike <- function(values, window, spikes) {
  good <- which(!is.na(values))
  spike <- logical(length(values))
  if (length(good) < window) return(spike)
  off <- abs(values[good] - stats::runmed(values[good], window, endrule = "median"))
  spread <- 1.4826 * stats::runmed(off, window, endrule = "median")
  # a steady reading has no spread of its own: that of all
  least <- 1.4826 * stats::median(off)
  if (least == 0) least <- 1e-3 * abs(stats::median(values[good]))
  spike[good] <- off > spikes * pmax(spread, least)
  spike
}

#' What sensors said during hauls
#'
#' @param log A table with `time` (s) and readings, from [read_sensor_log()].
#' @param from,to Begin and end of each haul on the clock of `log`, s.
#' @return A data frame with a row per haul: `haul`, `readings` (the fewest good ones of any sensor)
#'   and the median of every reading, `NA` where a sensor has fewer than three. Wrong arguments are
#'   an error of class `codend_error_argument`.
#' @export
#' @examples
#' log <- data.frame(time = 0:100, door_spread = 80 + sin(0:100))
#' haul_means(log, from = c(0, 60), to = c(40, 100))
haul_means <- function(log, from, to) {
  check_given("log", "from", "to")
  if (!is.data.frame(log) || !is.numeric(log$time)) {
    abort_argument("{.arg log} must be a data frame with a column {.field time}, in s.")
  }
  good <- is.numeric(from) && is.numeric(to) && length(from) == length(to) && length(from) > 0L &&
    !anyNA(c(from, to)) && all(from < to)
  if (!good) {
    abort_argument("{.arg from} and {.arg to} must be as many numbers, each haul's begin before its
      end.")
  }
  sensors <- setdiff(names(log)[vapply(log, is.numeric, NA)], "time")
  rows <- lapply(seq_along(from), function(k) {
    part <- log[log$time >= from[k] & log$time <= to[k], sensors, drop = FALSE]
    count <- vapply(part, function(values) sum(!is.na(values)), 0L)
    middle <- vapply(part, function(values) {
      if (sum(!is.na(values)) < 3L) NA_real_ else stats::median(values, na.rm = TRUE)
    }, 0)
    data.frame(haul = k, readings = min(c(count, Inf)), as.list(middle))
  })
  do.call(rbind, rows)
}
