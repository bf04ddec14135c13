#' Read the log of door and net sensors
#'
#' Returns the readings of a CSV log in SI, without impossible values and spikes. A small file
#' defines the columns. Use [haul_means()] to average a tow.
#'
#' Acoustic readings contain lost and double echoes, so single values can be far off. A reading is a
#' spike if it differs from the running median of `window` readings by more than `spikes` standard
#' deviations. The standard deviation is 1.4826 times the running median of the differences
#' (Hampel's identifier; the factor holds for normal readings). A change that lasts more than half a
#' window is not a spike.
#'
#' @param file Character: path of a CSV file, with commas or semicolons.
#' @param columns A list, or the path of a YAML file: one entry per column, named as in the result.
#'   The section Columns describes the entries.
#' @param window Number of readings in the running median, odd. Default 11.
#' @param spikes Number of standard deviations that make a spike. Default 4.
#'
#' @section Columns: Each entry has `column`, the name in the CSV file, and further fields:
#'
#' - Readings: `unit`, a unit of plans, and optionally `least` and `most`, the limits of a real
#'   reading in this unit.
#' - `time`: `format`, as in [strptime()]. Without `format`, times are in seconds.
#'
#' @return A data frame with `time` (s from the first reading) and one column per reading in SI.
#'   Missing and removed readings are `NA`. Times of day continue after midnight. The attribute
#'   `removed` counts the removed readings. An unreadable file or a missing column is an error of
#'   class `codend_error_file`; an unknown unit has class `codend_error_argument`.
#' @seealso [haul_means()] for haul averages, [track_schedule()] for positions, [calibrate()] to fit
#'   a gear to readings.
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
    abort_argument("{.arg spikes} is {describe_value(spikes)}; it must be a number above 0.")
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

# Returns the checked column definitions: lists of column, and format or unit, least and most.
log_columns <- function(columns) {
  if (is_text(columns)) {
    if (!file.exists(columns)) abort_file(columns, "does not exist.", argument = "columns")
    columns <- tryCatch(yaml::read_yaml(columns), error = function(e) {
      abort_file(columns, "is not a YAML file: {why}", why = conditionMessage(e),
        argument = "columns")
    })
  }
  if (!is_map(columns) || !"time" %in% names(columns) || length(columns) < 2L) {
    abort_argument("{.arg columns} must name the columns {.field time} and at least one reading.")
  }
  for (name in names(columns)) {
    one <- columns[[name]]
    if (!is_map(one) || !is_text(one$column)) {
      abort_argument("{.arg columns} has {.field {name}} without {.field column}, the name of its
        column.")
    }
    if (name == "time") next
    known <- unlist(lapply(plan_units, names))
    if (!is_text(one$unit) || !plain_unit(one$unit) %in% known) {
      abort_argument("{.arg columns} has the unit {.val {one$unit}} for {.field {name}}; it must be
        a unit of plans, such as {.val m} or {.val kN}.")
    }
    one$unit <- plain_unit(one$unit)
    for (end in c("least", "most")) {
      value <- first_of(one[[end]], if (end == "least") -Inf else Inf)
      if (!is.numeric(value) || length(value) != 1L || is.na(value)) {
        abort_argument("{.arg columns} has the {end} {.val {value}} for {.field {name}}; it must be
          a number.")
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
    # Times of day: the date changes if the clock jumps back by more than half a day.
    if (!grepl("%[dDFjxcs]", format)) {
      time <- time + 86400 * cumsum(c(0, diff(time) < -43200 & !is.na(diff(time))))
    }
  }
  if (anyNA(time)) {
    row <- which(is.na(time))[1L]
    abort_file(file, "has \"{value}\" as the time in row {row}.", value = text[row], row = row)
  }
  time
}

is_spike <- function(values, window, spikes) {
  good <- which(!is.na(values))
  spike <- logical(length(values))
  if (length(good) < window) return(spike)
  off <- abs(values[good] - stats::runmed(values[good], window, endrule = "median"))
  spread <- 1.4826 * stats::runmed(off, window, endrule = "median")
  # A constant reading has zero local spread: use the spread of all readings as the minimum.
  least <- 1.4826 * stats::median(off)
  if (least == 0) least <- 1e-3 * abs(stats::median(values[good]))
  spike[good] <- off > spikes * pmax(spread, least)
  spike
}

#' Average sensor readings over hauls
#'
#' Returns the median of each reading in each haul.
#'
#' @param log A data frame with `time` (s) and readings, from [read_sensor_log()].
#' @param from,to Start and end of each haul on the clock of `log`, s.
#' @return A data frame with one row per haul. Columns: `haul` (number), `readings` (smallest number
#'   of valid readings of any sensor) and the median of every reading, in its unit. A median is `NA`
#'   for fewer than three readings. Wrong arguments are an error of class `codend_error_argument`.
#' @seealso [read_sensor_log()] for the log, [explain_misfit()] and [calibrate()] to compare it with
#'   a gear.
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
    abort_argument("{.arg from} and {.arg to} must have the same number of times (s), and each start
      must be before its end.")
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
