# An unstructured grid in VTK's XML format (.vtu): a header that describes the layout, then the raw
# arrays, low byte first. Arrays are converted one at a time to save memory.

vtk_cell_types <- c(vertex = 1L, line = 3L, triangle = 5L, quad = 9L)

# Writes the grid to `path`. `points`: 3 x n, m. `cells`: list(corners (points from 1, cell after
# cell), size (corners of each cell), type (names of `vtk_cell_types`)). `point_data`, `cell_data`,
# `field_data`: named lists of vectors, or of matrices with a column per point or cell.
write_vtu <- function(path, points, cells, point_data, cell_data, field_data) {
  groups <- list(
    FieldData = field_data, PointData = point_data, CellData = cell_data,
    Points = list(points = points),
    Cells = list(
      connectivity = cells$corners - 1L, offsets = cumsum(cells$size),
      types = as.raw(vtk_cell_types[cells$type])
    )
  )
  placed <- 0
  head <- lapply(names(groups), function(group) {
    arrays <- groups[[group]]
    lines <- vapply(names(arrays), function(name) {
      line <- vtk_array_head(name, arrays[[name]], placed, group == "FieldData")
      placed <<- placed + 8 + vtk_bytes(arrays[[name]])
      line
    }, "")
    c(sprintf("<%s>", group), lines, sprintf("</%s>", group))
  })
  head <- setNames(head, names(groups))
  connection <- base::file(path, "wb")
  on.exit(close(connection))
  text <- function(...) {
    writeBin(charToRaw(enc2utf8(paste0(c(...), collapse = "\n"))), connection)
  }
  text(
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
    paste0("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" ",
      "header_type=\"UInt64\">"),
    "<UnstructuredGrid>", head$FieldData,
    sprintf("<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">", ncol(points),
      length(cells$size)),
    unlist(head[-1L]), "</Piece>", "</UnstructuredGrid>", "<AppendedData encoding=\"raw\">", "_"
  )
  for (arrays in groups) for (array in arrays) put_vtk_array(connection, array)
  text("", "</AppendedData>", "</VTKFile>", "")
}

vtk_array_head <- function(name, value, offset, in_field) {
  type <- switch(typeof(value),
    double = "Float64", integer = "Int32", logical = , raw = "UInt8"
  )
  components <- if (is.matrix(value)) nrow(value) else 1L
  sprintf(
    "<DataArray type=\"%s\" Name=\"%s\"%s%s format=\"appended\" offset=\"%.0f\"/>", type,
    escape_markup(name),
    if (components > 1L) sprintf(" NumberOfComponents=\"%d\"", components) else "",
    if (in_field) sprintf(" NumberOfTuples=\"%d\"", length(value) / components) else "", offset
  )
}

vtk_bytes <- function(value) {
  switch(typeof(value), double = 8, integer = 4, logical = , raw = 1) * length(value)
}

put_vtk_array <- function(connection, value) {
  writeBin(low_word_first(vtk_bytes(value)), connection, endian = "little")
  writeBin(if (is.logical(value)) as.raw(value) else as.vector(value), connection,
    endian = "little")
}

# Converts a whole number up to 2^53 to the two integers of its 64 bits, low word first.
low_word_first <- function(number) {
  words <- c(number %% 2^32, number %/% 2^32)
  as.integer(words - 2^32 * (words >= 2^31))
}
