# Readers of exported files that follow the formats' specifications, not the writers.

# A .vtu file with raw appended data: list(points, cells, types, point, cell, field data by name).
read_raw_vtu <- function(file) {
  bytes <- readBin(file, "raw", file.size(file))
  start <- grepRaw("<AppendedData encoding=\"raw\">", bytes)
  data <- grepRaw("_", bytes, offset = start) + 1L
  head <- strsplit(rawToChar(bytes[seq_len(start - 1L)]), "\n")[[1]]
  field <- function(line, name) {
    found <- regmatches(line, regexec(sprintf(" %s=\"([^\"]*)\"", name), line))[[1]]
    if (length(found)) found[2] else NA_character_
  }
  group <- NA
  arrays <- list()
  for (line in head) {
    opens <- grepl("^<(FieldData|PointData|CellData|Points|Cells)>$", line)
    if (opens) group <- gsub("[<>]", "", line)
    if (!startsWith(line, "<DataArray")) next
    at <- data + as.numeric(field(line, "offset"))
    length <- readBin(bytes[at + 0:7], "integer", 2L, endian = "little")
    stopifnot(length[2] == 0L)
    held <- bytes[at + 7 + seq_len(length[1])]
    value <- switch(field(line, "type"),
      Float64 = readBin(held, "double", length[1] / 8, endian = "little"),
      Int32 = readBin(held, "integer", length[1] / 4, endian = "little"),
      UInt8 = as.integer(held)
    )
    width <- field(line, "NumberOfComponents")
    if (!is.na(width)) value <- matrix(value, as.integer(width))
    arrays[[group]][[field(line, "Name")]] <- value
  }
  piece <- grep("<Piece ", head, value = TRUE)
  c(arrays, list(
    n_points = as.integer(field(piece, "NumberOfPoints")),
    n_cells = as.integer(field(piece, "NumberOfCells"))
  ))
}

# A .glb or .gltf file: list(tree, get = function(accessor number) that returns its numbers by
# column).
read_gltf_file <- function(file) {
  if (endsWith(file, ".gltf")) {
    tree <- jsonlite::fromJSON(file, simplifyVector = FALSE)
    buffer <- jsonlite::base64_dec(sub("^data:application/octet-stream;base64,", "",
      tree$buffers[[1]]$uri))
  } else {
    bytes <- readBin(file, "raw", file.size(file))
    words <- function(at, n = 1L) readBin(bytes[at - 1 + seq_len(4 * n)], "integer", n)
    stopifnot(rawToChar(bytes[1:4]) == "glTF", words(5) == 2L, words(9) == length(bytes))
    json <- words(13)
    stopifnot(rawToChar(bytes[17:20]) == "JSON", json %% 4 == 0)
    tree <- jsonlite::fromJSON(rawToChar(bytes[20 + seq_len(json)]), simplifyVector = FALSE)
    at <- 20 + json
    stopifnot(identical(bytes[at + 5:8], c(charToRaw("BIN"), as.raw(0))),
      words(at + 1) == length(bytes) - at - 8, words(at + 1) %% 4 == 0)
    buffer <- bytes[-seq_len(at + 8)]
  }
  stopifnot(length(buffer) == tree$buffers[[1]]$byteLength)
  list(tree = tree, get = function(number) {
    accessor <- tree$accessors[[number + 1]]
    view <- tree$bufferViews[[accessor$bufferView + 1]]
    rows <- c(SCALAR = 1, VEC3 = 3, VEC4 = 4)[[accessor$type]]
    n <- rows * accessor$count
    held <- buffer[view$byteOffset + seq_len(view$byteLength)]
    matrix(switch(as.character(accessor$componentType),
      "5126" = readBin(held, "double", n, 4L, endian = "little"),
      "5123" = readBin(held, "integer", n, 2L, signed = FALSE, endian = "little") / 65535
    ), rows)
  })
}

# Names of all parts in the field data of a grid.
part_names_of <- function(field) {
  text <- rawToChar(as.raw(field$part_names))
  Encoding(text) <- "UTF-8"
  strsplit(text, "\n", fixed = TRUE)[[1]]
}

# The system's Python, for readers that are independent of codend.
python <- "/usr/bin/python3"

has_python <- function(module) {
  file.exists(python) && system2(python, c("-c", shQuote(paste("import", module))),
    stdout = FALSE, stderr = FALSE) == 0L
}

# Returns the JSON that a Python script, given as its lines, prints for a file.
read_with_python <- function(file, ...) {
  script <- tempfile(fileext = ".py")
  on.exit(unlink(script))
  writeLines(c(...), script)
  jsonlite::fromJSON(system2(python, shQuote(c(script, file)), stdout = TRUE))
}
