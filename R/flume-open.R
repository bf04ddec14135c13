# The gears that a page opens: files, typed plans and new gears. A browser may send anything.

# Returns the gear of a file that the page has read: list(name, text). The page never sends a path,
# because a path could be any file of the server. The server does not write the text to a file.
read_opened <- function(given) {
  given <- as.list(given)
  name <- if (is_text(given$name)) substr(given$name, 1L, 100L) else "on this page"
  read_sent(given$text, name)
}

# `said`: list(kind, values), with values as strings by argument of new_plan().
read_new <- function(said) {
  said <- as.list(said)
  requests <- new_plan_kinds()[[if (is_text(said$kind)) said$kind else ""]]$requests
  values <- as.list(said$values)
  values <- values[names(values) %in% names(requests)]
  good <- vapply(values, function(value) is_text(value) && nchar(value) <= most_characters, NA)
  if (!all(good)) {
    abort_argument("The values of a new gear must be numbers with units, such as 25 m.")
  }
  # an empty field has its default
  values <- values[vapply(values, function(value) nzchar(trimws(value)), NA)]
  values <- Map(typed_quantity, values, requests[names(values)])
  do.call(new_plan, c(list(said$kind), values))
}

read_sent <- function(text, name) {
  if (!is_text(text)) abort_plan("The plan must be text.", NULL)
  gear_of_bytes(charToRaw(enc2utf8(text)), name)
}
