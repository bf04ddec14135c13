# Type checks and defaults of values.

is_text <- function(value) is.character(value) && length(value) == 1 && !is.na(value)

# TRUE for a vector with a name for each element.
is_named <- function(value) {
  length(value) > 0L && !is.null(names(value)) && all(nzchar(names(value)))
}

is_map <- function(value) {
  is.list(value) && (!is.null(names(value)) || length(value) == 0)
}

first_of <- function(value, otherwise) if (is.null(value)) otherwise else value

# Returns at most `most` evenly spaced numbers from 1 to n.
evenly <- function(n, most) unique(round(seq(1, n, length.out = min(n, most))))

table_rows <- function(table, rows = seq_len(nrow(table))) {
  table <- table[rows, , drop = FALSE]
  row.names(table) <- NULL
  table
}

# Returns a function that caches its last result: the gears of a study share most of their parts.
# `make` must be a named function, which R compiles when the package is installed. R compiles an
# anonymous function at run time, which takes longer than settling a gear.
remembered <- function(make) {
  last <- result <- NULL
  function(...) {
    given <- list(...)
    if (is.null(last) || !identical(given, last)) {
      result <<- make(...)
      last <<- given
    }
    result
  }
}

# Present names of fields, values and elements of results by their names in version 0.1.0.
former_names <- list(
  head_line = "headline", head_line_extensions = "headline_extensions", share = "extent",
  place = "position", volume_share = "volume_fraction", twines = "morison",
  pushes = c("lift_direction", "carries_compression"),
  lattice = "mesh", aim = "objective", settles = "n_solves", narrow = "next_measurement"
)

# Returns the known name for a former name, else the known name that is most similar to `name`, or
# NULL if none is similar.
nearest <- function(name, known) {
  now <- intersect(former_names[[as.character(name)]], known)
  if (length(now)) return(now)
  if (length(known) == 0 || !nzchar(name) || nchar(name) > 100) return(NULL)
  distance <- utils::adist(name, known, ignore.case = TRUE)[1, ]
  best <- which.min(distance)
  if (distance[best] <= max(2, nchar(name) / 3)) known[best] else NULL
}

# Returns the chosen value of an argument, by default the first choice. choices: as listed in the
# argument's default.
chosen <- function(value, choices) {
  argument <- deparse(substitute(value))
  if (identical(value, choices)) return(choices[1])
  k <- if (is_text(value)) pmatch(value, choices) else NA
  if (is.na(k)) abort_unknown_word(argument, value, choices, "one of")
  choices[k]
}

# Returns the names in an argument, or all known names if it is NULL.
chosen_some <- function(values, known, argument = deparse(substitute(values))) {
  if (is.null(values)) return(known)
  if (!is.character(values) || !length(values) || !all(values %in% known)) {
    wrong <- if (is.character(values) && length(values)) setdiff(values, known)[1] else values
    abort_unknown_word(argument, wrong, known, "any of")
  }
  values
}

abort_unknown_word <- function(argument, value, known, must) {
  near <- if (is_text(value)) nearest(value, known)
  hint <- if (length(near)) " Did you mean {.val {near}}?"
  abort_argument(paste0(
    "{.arg {argument}} is {describe_value(value)}; it must be ", must, " {.or {.val {known}}}.",
      hint
  ))
}

# Formats a wrong value for a message: the value, or its class.
describe_value <- function(value) {
  if (!length(value)) return("empty")
  said <- if (is.atomic(value)) value else class(value)
  cli::format_inline("{.val {said}}")
}

# TRUE for one finite number without a class (FALSE for a units object or a date).
is_plain_number <- function(value) {
  is.numeric(value) && !is.object(value) && length(value) == 1L && is.finite(value)
}

check_truth <- function(value, name) {
  if (!isTRUE(value) && !isFALSE(value)) abort_argument("{.arg {name}} must be TRUE or FALSE.")
}

check_fraction <- function(value, name, below = Inf) {
  if (is_plain_number(value) && value > 0 && value < below) return(invisible())
  allowed <- if (is.finite(below)) paste("between 0 and", below) else "above 0"
  abort_argument("{.arg {name}} is {describe_value(value)}; it must be a fraction {allowed}.")
}

check_count <- function(name, value, least = 1) {
  good <- is_plain_number(value) && value == round(value) && value >= least && value < 2^31
  if (good) return(invisible())
  abort_argument("{.arg {name}} is {describe_value(value)}; it must be a whole number, {least} or
    more.")
}

# unit: text after "a number", such as " of inches".
check_between <- function(name, value, least, most, unit = "") {
  if (is_plain_number(value) && value >= least && value <= most) return(invisible())
  abort_argument("{.arg {name}} is {describe_value(value)}; it must be a number{unit} from {least}
    to {most}.")
}
