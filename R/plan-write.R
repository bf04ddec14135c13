json_plan <- function(gear) {
  enc2utf8(as.character(jsonlite::toJSON(gear$plan, auto_unbox = TRUE, digits = NA)))
}

# remarks: TRUE keeps the original text where it is still valid.
#' @export
format.codend_gear <- function(x, ..., remarks = FALSE) edited_text(if (remarks) x$source, x$plan)

#' @export
as.character.codend_gear <- function(x, ...) format(x)

# Readable YAML: a list or map of numbers and strings takes one line if it fits, otherwise one line
# per field or item. Other YAML writers for R cannot do this.
yaml_width <- 96

yaml_lines <- function(value, indent) {
  items <- as.list(value)
  heads <- if (is.null(names(items))) rep("-", length(items)) else {
    paste0(vapply(names(items), yaml_text, ""), ":")
  }
  heads <- paste0(strrep(" ", indent), heads)
  unlist(lapply(seq_along(items), function(i) {
    item <- items[[i]]
    line <- yaml_flow(item)
    if (!is.na(line) && nchar(line) + nchar(heads[i]) < yaml_width) {
      return(paste(heads[i], line))
    }
    if (!is.list(item) && length(item) == 1) return(paste(heads[i], yaml_scalar(item)))
    c(heads[i], yaml_lines(item, indent + 2))
  }))
}

# Returns a value on one line, or NA if it contains maps or lists.
yaml_flow <- function(value) {
  named <- !is.null(names(value))
  if (length(value) == 0) return(if (named) "{}" else "[]")
  items <- as.list(value)
  if (any(vapply(items, is.list, NA)) || any(lengths(items) != 1)) return(NA_character_)
  shown <- vapply(items, yaml_scalar, "")
  if (named) {
    return(paste0("{", paste0(vapply(names(items), yaml_text, ""), ": ", shown, collapse = ", "),
      "}"))
  }
  if (!is.list(value) && length(value) == 1) return(shown)
  # Long lists of prose have one item per line.
  if (is.character(value) && sum(nchar(value)) > 60) return(NA_character_)
  paste0("[", paste(shown, collapse = ", "), "]")
}

yaml_scalar <- function(value) {
  if (is.character(value)) return(yaml_text(value))
  if (is.logical(value)) return(if (value) "yes" else "no")
  shortest_decimal(value)
}

# Returns words and quantities without quotes. Any ambiguous string is quoted as JSON.
yaml_text <- function(text) {
  word <- "^[\\p{L}](?:[\\p{L}\\p{N} _./%()=+;-]*[\\p{L}\\p{N}_./%()=+-])?\\z"
  quantity <- "^-?[0-9]+[.]?[0-9]* [\\p{L}%][\\p{L}0-9/]*\\z"
  other <- "^(?i:null|yes|no|true|false|on|off|y|n)$"
  bare <- (grepl(word, text, perl = TRUE) && !grepl(other, text, perl = TRUE)) ||
    grepl(quantity, text, perl = TRUE)
  if (bare) text else yaml_quoted(text)
}

yaml_quoted <- function(text) {
  quoted <- as.character(jsonlite::toJSON(text, auto_unbox = TRUE))
  # JSON keeps these characters; YAML forbids them or reads them as line ends.
  codes <- utf8ToInt(quoted)
  control <- (codes >= 0x7f & codes <= 0x9f) | codes %in% c(0x2028, 0x2029, 0xfeff, 0xfffe)
  if (!any(control)) return(quoted)
  characters <- strsplit(quoted, "")[[1]]
  characters[control] <- sprintf("\\u%04x", codes[control])
  paste(characters, collapse = "")
}
