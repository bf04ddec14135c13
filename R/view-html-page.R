# HTML pages as one file that uses no network. Scripts and styles of widgets are written into it.

# body: tags, with widgets; style, script: strings for this page.
write_single_page <- function(file, title, body, style = NULL, script = NULL) {
  rendered <- with_plain_numbers(htmltools::renderTags(body))
  parts <- htmltools::resolveDependencies(rendered$dependencies)
  head <- c(
    vapply(parts, inline_dependency, ""), inline_style(style), inline_script(script),
    as.character(rendered$head)
  )
  write_html(file, title, head, as.character(rendered$html))
}

# head, body: strings; policy: tag with a content security policy, or NULL.
write_html <- function(file, title, head, body, policy = NULL) {
  html <- c(
    "<!DOCTYPE html>", "<html lang=\"en\">", "<head>", "<meta charset=\"utf-8\"/>",
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>", policy,
    # browsers request an icon from a server unless the page has one
    "<link rel=\"icon\" href=\"data:,\"/>",
    paste0("<title>", escape_markup(title), "</title>"), head, "</head>", "<body>", body,
    "</body>", "</html>", ""
  )
  connection <- base::file(file, "wb")
  on.exit(close(connection))
  writeBin(charToRaw(enc2utf8(paste(html, collapse = "\n"))), connection)
}

# Returns the scripts and styles of a dependency as text.
inline_dependency <- function(part) {
  read <- function(files) {
    vapply(files, function(name) {
      path <- file.path(part$src$file, name)
      text <- readChar(path, file.size(path), useBytes = TRUE)
      Encoding(text) <- "UTF-8"
      text
    }, "", USE.NAMES = FALSE)
  }
  names_of <- function(field) as.character(unlist(part[[field]]))
  head <- gsub("<!--/?html_preserve-->", "", paste(part$head, collapse = "\n"))
  paste(c(
    vapply(read(names_of("stylesheet")), inline_style, ""),
    vapply(read(names_of("script")), inline_script, ""), head
  ), collapse = "\n")
}

inline_style <- function(text) {
  if (is.null(text)) return("")
  paste0("<style>\n", paste(text, collapse = "\n"), "\n</style>")
}

# The mark that ends a script is escaped.
inline_script <- function(text) {
  if (is.null(text)) return("")
  text <- gsub("</script", "<\\/script", paste(text, collapse = "\n"), fixed = TRUE)
  paste0("<script>\n", text, "\n</script>")
}

# Returns a file in the folder `of` of the package as text.
view_file <- function(name, of = "view") {
  path <- system.file(of, name, package = "codend", mustWork = TRUE)
  paste(readLines(path, encoding = "UTF-8", warn = FALSE), collapse = "\n")
}
