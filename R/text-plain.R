# Text as other programs show it: messages without a terminal's marks, and text that stands in HTML
# or XML.

# The bullets that cli writes before the lines of a message, in Unicode and in ASCII.
message_bullets <- "\n(?:[\u2716\u2139\u2022\u2714\u2192!*>xiv]) "

# A condition's message on one line, without colours and bullets.
plain_message <- function(condition) {
  text <- gsub(message_bullets, " ", cli::ansi_strip(conditionMessage(condition)), perl = TRUE)
  trimws(gsub("[[:space:]]+", " ", text))
}

# Text as it may stand in HTML and XML, between tags and as the value of an attribute.
escape_markup <- function(text) htmltools::htmlEscape(text, attribute = TRUE)
