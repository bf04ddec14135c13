# Text that does not depend on the reader's settings: messages without terminal codes, text for HTML
# or XML, and numbers for any options of R.

# Bullets of cli messages, in Unicode and in ASCII.
message_bullets <- "\n(?:[\u2716\u2139\u2022\u2714\u2192!*>xiv]) "

# Returns a condition's message on one line, without colours and bullets.
plain_message <- function(condition) {
  text <- gsub(message_bullets, " ", cli::ansi_strip(conditionMessage(condition)), perl = TRUE)
  trimws(gsub("[[:space:]]+", " ", text))
}

# Escapes text for HTML and XML, also for values of attributes.
escape_markup <- function(text) htmltools::htmlEscape(text, attribute = TRUE)

# Removes each `<` from JSON. In a script of a page, `<!--` and `<script` would hide all that
# follows, and `</script` would end the script.
escape_json <- function(text) gsub("<", "\\u003c", text, fixed = TRUE)

capital <- function(text) paste0(toupper(substr(text, 1, 1)), substring(text, 2))

# Evaluates an expression with default values of options(OutDec, scipen, digits). Otherwise, numbers
# in text, in names such as "wall_2" and in positions of a plan would depend on these options.
with_plain_numbers <- function(expression) {
  kept <- options(OutDec = ".", scipen = 0, digits = 7)
  on.exit(options(kept))
  force(expression)
}

# Returns the shortest decimal that reads back as the same number, independent of R's options.
shortest_decimal <- function(x) {
  for (digits in c(6L, 15L, 16L, 17L)) {
    shown <- sprintf("%.*g", digits, x)
    if (as.double(shown) == x) break
  }
  # YAML 1.1 accepts an exponent only after a decimal point.
  if (grepl("^-?[0-9]+e", shown)) sub("e", ".0e", shown) else shown
}

# Formats each number with four digits.
four_figures <- function(x) {
  with_plain_numbers(vapply(x, function(one) format(signif(one, 4), digits = 6), ""))
}

# Returns a count of meshes as a string.
displayed_count <- function(x) shortest_decimal(round(x, 2))
