# What a value is, and what to take where there is none.

is_text <- function(value) is.character(value) && length(value) == 1 && !is.na(value)

is_map <- function(value) {
  is.list(value) && (!is.null(names(value)) || length(value) == 0)
}

first_of <- function(value, otherwise) if (is.null(value)) otherwise else value
