# Text that is the same for every reader: messages without a terminal's marks, text that stands in
# HTML or XML, and numbers whatever R's options are.

# The bullets that cli writes before the lines of a message, in Unicode and in ASCII.
message_bullets <- "\n(?:[\u2716\u2139\u2022\u2714\u2192!*>xiv]) "

# A condition's message on one line, without colours and bullets.
plain_message <- function(condition) {
  text <- gsub(message_bullets, " ", cli::ansi_strip(conditionMessage(condition)), perl = TRUE)
  trimws(gsub("[[:space:]]+", " ", text))
}

# Text as it may stand in HTML and XML, between tags and as the value of an attribute.
escape_markup <- function(text) htmltools::htmlEscape(text, attribute = TRUE)

# JSON without any `<`: within a page's script, `<!--` and `<script` of a name would hide all that
# follows, and `</script` would end it.
escape_json <- function(text) gsub("<", "\\u003c", text, fixed = TRUE)

capital <- function(text) paste0(toupper(substr(text, 1, 1)), substring(text, 2))

# The value of an expression in which numbers become text as they do without options(OutDec,
# scipen, digits): with a decimal point, in names such as "wall_2" with plain digits, and in places
# of a plan without rounding.
with_plain_numbers <- function(expression) {
  kept <- options(OutDec = ".", scipen = 0, digits = 7)
  on.exit(options(kept))
  force(expression)
}
