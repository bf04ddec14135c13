# An HTML page as one file that asks nothing of the network: scripts and styles of widgets are
# written into it.

# file: where to write it; body: tags, with widgets; style, script: of the page's own (text).
write_single_page <- function(file, title, body, style = NULL, script = NULL) {
  rendered <- with_plain_numbers(htmltools::renderTags(body))
  parts <- htmltools::resolveDependencies(rendered$dependencies)
  head <- c(
    vapply(parts, inline_dependency, ""), inline_style(style), inline_script(script),
    as.character(rendered$head)
  )
  write_html(file, title, head, as.character(rendered$html))
}

# head, body: texts; policy: what the page may ask of whom, or NULL.
write_html <- function(file, title, head, body, policy = NULL) {
  html <- c(
    "<!DOCTYPE html>", "<html lang=\"en\">", "<head>", "<meta charset=\"utf-8\"/>",
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>", policy,
    # Browsers ask a server for an icon unless the page has one.
    "<link rel=\"icon\" href=\"data:,\"/>",
    paste0("<title>", escape_markup(title), "</title>"), head, "</head>", "<body>", body,
    "</body>", "</html>", ""
  )
  connection <- base::file(file, "wb")
  on.exit(close(connection))
  writeBin(charToRaw(enc2utf8(paste(html, collapse = "\n"))), connection)
}

# The scripts and styles of a part of a widget, written out.
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

# A script must not hold the mark that ends it.
inline_script <- function(text) {
  if (is.null(text)) return("")
  text <- gsub("</script", "<\\/script", paste(text, collapse = "\n"), fixed = TRUE)
  paste0("<script>\n", text, "\n</script>")
}

# One of the package's own files for pages, as text; of: its folder.
view_file <- function(name, of = "view") {
  path <- system.file(of, name, package = "codend", mustWork = TRUE)
  paste(readLines(path, encoding = "UTF-8", warn = FALSE), collapse = "\n")
}

# The viewer's scripts in the order in which they are read, as inst/htmlwidgets/codend.yaml has
# them.
viewer_scripts <- c(
  "three.js", "element.js", "materials.js", "gear.js", "graph.js", "motion.js", "save.js",
  "viewer.js"
)
