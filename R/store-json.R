# States as JSON (inst/schema/state.schema.json), for languages without a NetCDF reader.

write_state_json <- function(state, file) {
  numbers <- state_numbers(state)
  numbers <- Filter(function(number) length(number$value) > 0L, numbers)
  numbers <- numbers[!startsWith(names(numbers), "saved_")]
  found <- measures(state)
  said <- measure_labels(found)
  error <- attr(found, "error")
  of_state <- list(
    codend = "state", version = format(utils::packageVersion("codend")),
    name = state$gear$plan$name, conditions = state_conditions(state),
    converged = isTRUE(state$report$converged), time = state$time,
    measures = lapply(setNames(seq_along(found), names(found)), function(k) {
      list(value = exact_json(found[[k]]), unit = cf_unit(said$unit[k]), long_name = said$words[k],
        error = exact_json(if (is.null(error)) NA else error[k]))
    }),
    variables = lapply(numbers, function(number) {
      list(long_name = number$words, unit = number$unit,
        across = I(rev(setdiff(number$across, "letter"))),
        values = json_values(number$value))
    })
  )
  text <- as.character(jsonlite::toJSON(of_state, auto_unbox = TRUE, null = "null",
    json_verbatim = TRUE))
  text <- paste0(substr(text, 1L, nchar(text) - 1L), ",\"plan\":", json_plan(state$gear), "}\n")
  write_file(file, function(path) writeBin(charToRaw(enc2utf8(text)), path))
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
