# Readers of the files that codend writes; they do not use its code. Each reader stops if the file
# is damaged or shows a value that is not a number.

stop_check <- function(...) stop(sprintf(...), call. = FALSE)

file_bytes <- function(file) {
  if (!file.exists(file)) stop_check("%s is not written", basename(file))
  if (file.size(file) == 0) stop_check("%s is empty", basename(file))
  readBin(file, "raw", file.size(file))
}

file_text <- function(file, encoding = "UTF-8") {
  text <- iconv(rawToChar(file_bytes(file)), encoding, "UTF-8")
  if (is.na(text)) stop_check("%s is not encoded in %s", basename(file), encoding)
  text
}

# A text must not contain the words NaN, Inf and NULL.
check_words <- function(text, what) {
  shown <- regmatches(text, regexpr("[^\n]{0,40}\\b(NaN|Inf|NULL|character\\(0\\))[^\n]{0,40}",
    text, perl = TRUE))
  if (length(shown)) stop_check("%s shows `%s`", what, trimws(shown))
}

# All numbers of a tree must be finite; missing values are NULL.
check_finite <- function(tree, what) {
  numbers <- rapply(list(tree), as.double, classes = c("numeric", "integer"), how = "unlist")
  if (!all(is.finite(numbers))) stop_check("%s has numbers that are not finite", what)
}

# The columns of a table must be complete and finite, except the optional columns.
check_table <- function(table, rows, what, optional = character()) {
  if (!identical(nrow(table), as.integer(rows))) {
    stop_check("%s has %d rows, not %d", what, nrow(table), as.integer(rows))
  }
  for (name in setdiff(names(table), optional)) {
    values <- table[[name]]
    complete <- if (is.numeric(values)) all(is.finite(values)) else !anyNA(values)
    if (!complete) stop_check("%s: the column %s is not finite or not complete", what, name)
  }
}

# A blank page compresses to 200 times fewer bytes than these pictures.
read_png <- function(file) {
  bytes <- file_bytes(file)
  number <- function(at) sum(as.integer(bytes[at + 0:3]) * 256^(3:0))
  if (!identical(bytes[1:8], as.raw(c(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a)))) {
    stop_check("%s is not a PNG", basename(file))
  }
  if (rawToChar(utils::tail(bytes, 8L)[1:4]) != "IEND") stop_check("%s is cut off", basename(file))
  if (length(bytes) < number(17L) * number(21L) / 400) stop_check("%s is blank", basename(file))
}

read_pdf <- function(file) {
  bytes <- file_bytes(file)
  whole <- rawToChar(bytes[1:5]) == "%PDF-" && length(grepRaw("%%EOF", utils::tail(bytes, 32L)))
  if (!whole) stop_check("%s is not a PDF", basename(file))
}

read_svg <- function(file) {
  svg <- xml2::xml_ns_strip(xml2::read_xml(file_text(file)))
  marks <- xml2::xml_find_all(svg, "//path | //polyline | //polygon | //line | //circle | //use")
  if (length(marks) < 5L) stop_check("%s has %d marks", basename(file), length(marks))
  check_words(file_text(file), basename(file))
}

# Lines come in pairs of a code and a value; the codes 10 to 39 are coordinates.
read_dxf <- function(file) {
  pairs <- matrix(strsplit(file_text(file, "CP1252"), "\r?\n")[[1L]], 2L)
  if (trimws(pairs[2L, ncol(pairs)]) != "EOF") stop_check("%s is cut off", basename(file))
  coordinates <- as.double(pairs[2L, as.integer(pairs[1L, ]) %in% 10:39])
  if (length(coordinates) < 100L) stop_check("%s has few coordinates", basename(file))
  check_finite(coordinates, basename(file))
}

# The body of a page must be well-formed without its scripts; its data must be JSON.
read_page <- function(file) {
  html <- file_text(file)
  script <- "(?s)<script([^>]*)>(.*?)</script>"
  scripts <- regmatches(html, gregexpr(script, html, perl = TRUE))[[1L]]
  data <- scripts[grepl("^<script[^>]*application/json", scripts)]
  if (!length(data)) stop_check("%s has no data", basename(file))
  for (text in sub(script, "\\2", data, perl = TRUE)) jsonlite::fromJSON(text)
  body <- sub("(?s)^.*<body[^>]*>", "<body>", html, perl = TRUE)
  body <- sub("(?s)</body>.*$", "</body>", body, perl = TRUE)
  body <- xml2::read_xml(gsub(script, "", body, perl = TRUE))
  check_words(xml2::xml_text(body), basename(file))
  body
}

read_vtu <- function(file) {
  grid <- read_raw_vtu(file)
  check_finite(grid$Points, "the points of the grid")
  check_finite(grid$PointData, "the grid's data by point")
  grid
}

read_gltf <- function(file) {
  scene <- read_gltf_file(file)
  for (number in seq_along(scene$tree$accessors) - 1) check_finite(scene$get(number), "the scene")
  scene
}

# The reader of each format, by the end of the file's name.
file_readers <- list(png = read_png, pdf = read_pdf, svg = read_svg, dxf = read_dxf,
  html = read_page, vtu = read_vtu, glb = read_gltf, gltf = read_gltf)

# Writes a file and reads it with the reader of its format.
written <- function(file, write) {
  write(file)
  file_readers[[tools::file_ext(file)]](file)
}
