# States as JSON (inst/schema/state.schema.json), for languages without a NetCDF reader.

# Returns the JSON text of a state. `uncertainty`: NULL, or the result of uncertainty().
state_json <- function(state, uncertainty = NULL) {
  numbers <- Filter(function(number) length(number$value) > 0L, state_numbers(state))
  record <- list(
    codend = "state", version = format(utils::packageVersion("codend")),
    name = state$gear$plan$name, conditions = state_conditions(state),
    converged = isTRUE(state$report$converged), time_s = state$time,
    report = state$report[c("iterations", "residual")],
    measures = lapply(measure_numbers(state), function(number) {
      list(value = exact_json(number$value), unit = number$unit, error = exact_json(number$error),
        long_name = number$words)
    }),
    variables = lapply(numbers, function(number) {
      list(long_name = number$words, unit = number$unit,
        across = I(rev(setdiff(number$across, "letter"))), values = json_values(number$value))
    }),
    findings = row_records(findings(state))
  )
  if (!is.null(uncertainty)) {
    table <- uncertainty$measures
    table$freedom[!is.finite(table$freedom)] <- NA
    record$uncertainty <- setNames(row_records(table[-1L]), table$measure)
  }
  text <- as.character(jsonlite::toJSON(record, auto_unbox = TRUE, digits = NA, null = "null",
    na = "null", json_verbatim = TRUE))
  paste0(substr(text, 1L, nchar(text) - 1L), ",\"plan\":", json_plan(state$gear), "}")
}

# Returns a number with 17 digits, because jsonlite writes fewer.
exact_json <- function(x) {
  structure(if (is.finite(x)) sprintf("%.17g", x) else "null", class = "json")
}

# Returns values as a JSON array; matrices become an array of columns.
json_values <- function(x) {
  if (is.matrix(x)) return(t(x))
  if (!is.double(x)) return(I(x))
  text <- ifelse(is.finite(x), sprintf("%.17g", x), "null")
  structure(paste0("[", paste(text, collapse = ","), "]"), class = "json")
}

# Returns a list for each row, for a JSON array of objects.
row_records <- function(table) lapply(seq_len(nrow(table)), function(k) as.list(table[k, ]))
