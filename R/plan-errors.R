# Throws a "codend_error_plan" with path, value and `said` (the message). `...`: further fields.
# draft_gear() continues after it, to collect all problems.
abort_plan <- function(message, path, value = NULL, ...) {
  withRestarts(
    abort_as("plan", "{message}", path = path, value = value, said = message, ...,
      envir = environment()),
    codend_go_on = function() NULL
  )
}

# Adds the line and column of the field in the plan file to an error, if they are known.
with_places <- function(expression, text) {
  tryCatch(expression, codend_error_plan = function(e) {
    place <- if (is.null(e$line)) field_place(text, e$path)
    if (is.null(place)) stop(e)
    abort_plan(
      sprintf("%s (line %d, column %d)", e$said, place$line, place$column), e$path, e$value,
      line = place$line, column = place$column
    )
  })
}

# Throws "Plan field `path` is VALUE; it must be MUST."
abort_field <- function(path, value, must, is = paste("is", show_value(value)), hint = NULL) {
  message <- sprintf("Plan field `%s` %s", path, is)
  message <- paste0(message, if (!is.null(must)) paste0("; it must be ", must), ".")
  if (length(hint)) message <- paste0(message, " Did you mean `", hint, "`?")
  abort_plan(message, path, value)
}

# Throws an error about a part with two fields that contradict each other.
abort_both <- function(part, one, other, value, path = part) {
  abort_plan(sprintf("Plan field `%s` has both `%s` and `%s`; remove one.", part, one, other), path,
    value)
}

abort_unknown <- function(path, name, known, value = NULL) {
  near <- nearest(name, known)
  where <- join(path, name)
  advice <- if (!length(near)) advice_on(name)
  abort_plan(
    paste0(
      "Plan field `", where, "` is not known",
      if (length(near)) paste0("; did you mean `", near, "`?"),
      if (length(advice)) paste0(": ", advice) else if (!length(near)) ".",
      known_text(known)
    ),
    where, value
  )
}

show_value <- function(value) {
  if (is.null(value)) return("empty")
  if (!is.atomic(value) && !is.list(value)) return(paste("of class", class(value)[1L]))
  if (identical(value, "given")) return("given")
  if (is.list(value)) {
    return(if (length(names(value))) "a map" else paste("a list of", length(value)))
  }
  if (length(value) != 1) {
    shown <- paste(vapply(utils::head(value, 4), show_value, ""), collapse = ", ")
    return(paste0("[", shown, if (length(value) > 4) ", ...", "]"))
  }
  if (is.logical(value) && !is.na(value)) return(if (value) "yes" else "no")
  if (!is.character(value) || is.na(value)) {
    return(with_plain_numbers(format(value, digits = 15, trim = TRUE)))
  }
  dimension <- quantity_dimension(value)
  if (!is.na(dimension)) return(value)
  if (nchar(value) > 60) value <- paste0(substr(value, 1, 57), "...")
  paste0("\"", value, "\"")
}

# Describes the allowed values of a schema node, with bounds in the unit of the given value.
describe <- function(node, value = NULL) {
  if (!is.null(node$enum)) return(paste("one of", word_list(node$enum)))
  if (is.character(node$const)) return(paste0("\"", node$const, "\""))
  if (!is.null(node$const)) return(format(node$const))
  switch(node$shape,
    quantity = {
      dimension <- node[["x-dimension"]]
      paste0(
        noun(gsub("_", " ", dimension)),
        bounds_text(node, function(bound) format_like(bound, dimension, value)),
        if (dimension != "number") paste0(" (units: ", unit_examples(dimension), ")")
      )
    },
    number = paste0("a number", bounds_text(node, format)),
    integer = paste0("a whole number", bounds_text(node, format)),
    boolean = "yes or no",
    string = if (is.null(node$pattern)) "text" else sentence_part(first_of(
      schema_description(first_of(node$meaning, node$description)), first_of(node$title, "text")
    )),
    array = paste0("a list", count_text(node)),
    object = paste0("a map", if (length(node$properties)) {
      paste(" with fields such as", paste0("`", utils::head(names(node$properties), 4), "`",
        collapse = ", "))
    }),
    any = paste(unique(vapply(node$choices, describe, "", value = value)), collapse = "; or ")
  )
}

sentence_part <- function(sentence) {
  sub("[.]$", "", paste0(tolower(substr(sentence, 1, 1)), substring(sentence, 2)))
}

noun <- function(word) paste(if (grepl("^[aeiou]", word)) "an" else "a", word)

word_list <- function(words) paste(words, collapse = ", ")

bounds_text <- function(node, show) {
  low <- if (!is.null(node$exclusiveMinimum)) {
    paste("greater than", show(node$exclusiveMinimum))
  } else if (!is.null(node$minimum)) {
    paste("of at least", show(node$minimum))
  }
  high <- if (!is.null(node$maximum)) paste("of at most", show(node$maximum))
  both <- paste(c(low, high), collapse = " and ")
  if (nzchar(both)) paste0(" ", both) else ""
}

count_text <- function(node) {
  item <- if (is.null(node$items$title)) "" else paste0(" (each ", noun(node$items$title), ")")
  count <- if (identical(node$minItems, node$maxItems) && !is.null(node$minItems)) {
    paste(" of", node$minItems)
  } else if (!is.null(node$minItems)) {
    paste(" of at least", node$minItems)
  }
  paste0(count, item)
}

unit_examples <- function(dimension) {
  factors <- plan_units[[dimension]]
  word_list(names(factors)[!duplicated(factors)])
}

abort_reference <- function(text, name, names, kind, path) {
  near <- nearest(name, names)
  abort_plan(
    paste0(
      "Plan field `", path, "` is ", show_value(text), ", but there is no ", kind, " `", name, "`",
      if (length(near)) paste0("; did you mean `", near, "`?") else ".", known_text(names)
    ),
    path, text
  )
}

known_text <- function(names) if (length(names)) paste0(" Known here: ", word_list(names), ".")
