# A sheet as DXF (release 12 in ASCII, which every CAD program reads). It has the gear's true size
# in millimetres, so that netting can be measured in it. Group codes: Autodesk, DXF reference.

dxf_layers <- c(
  NETTING = 7, CENTRE_LINES = 1, ROPES = 5, PIECES = 3, RIGGING = 5, COUNTS = 7, CUTTING = 7,
  NAMES = 7, TABLES = 7, TITLE = 7, SHEET = 8
)

sheet_dxf <- function(sheet) {
  scale <- if (is.na(sheet$scale)) 1 else sheet$scale
  size <- sheet$page * scale
  c(
    dxf_section("HEADER", c(
      dxf_codes(9, "$ACADVER", 1, "AC1009"), dxf_codes(9, "$DWGCODEPAGE", 3, "ANSI_1252"),
      dxf_codes(9, "$EXTMIN", 10, 0, 20, 0, 30, 0),
      dxf_codes(9, "$EXTMAX", 10, size[1], 20, size[2], 30, 0),
      dxf_codes(9, "$LIMMIN", 10, 0, 20, 0), dxf_codes(9, "$LIMMAX", 10, size[1], 20, size[2]),
      dxf_codes(9, "$LTSCALE", 40, scale),
      dxf_codes(9, "$MEASUREMENT", 70, 1)
    )),
    dxf_section("TABLES", c(
      dxf_table("LTYPE", list(
        c("CONTINUOUS", 70, 0, 3, "Solid", 72, 65, 73, 0, 40, 0),
        c("CENTER", 70, 0, 3, "Chain", 72, 65, 73, 4, 40, 10, 49, 6, 49, -1.5, 49, 1, 49, -1.5),
        c("DASHED", 70, 0, 3, "Dashed", 72, 65, 73, 2, 40, 3, 49, 2, 49, -1)
      )),
      dxf_table("LAYER", Map(function(name, colour) {
        c(name, 70, 0, 62, colour, 6, if (name == "CENTRE_LINES") "CENTER" else "CONTINUOUS")
      }, names(dxf_layers), dxf_layers)),
      dxf_table("STYLE", list(
        c("TEXT", 70, 0, 40, 0, 41, 1, 50, 0, 71, 0, 42, 2.5, 3, "arial.ttf", 4, ""),
        c("TEXT_BOLD", 70, 0, 40, 0, 41, 1, 50, 0, 71, 0, 42, 2.5, 3, "arialbd.ttf", 4, "")
      ))
    )),
    dxf_section("ENTITIES", unlist(lapply(sheet$items, dxf_item, scale = scale))),
    dxf_codes(0, "EOF"), ""
  )
}

dxf_codes <- function(...) {
  vapply(list(...), function(value) {
    if (is.character(value)) value else sheet_number(value, 4L)
  }, "")
}

dxf_section <- function(name, lines) {
  c(dxf_codes(0, "SECTION", 2, name), lines, dxf_codes(0, "ENDSEC"))
}

# entries: the codes after the name of each entry.
dxf_table <- function(name, entries) {
  c(
    dxf_codes(0, "TABLE", 2, name, 70, length(entries)),
    unlist(lapply(entries, function(entry) c("0", name, "2", as.character(entry))),
      use.names = FALSE),
    dxf_codes(0, "ENDTAB")
  )
}

dxf_item <- function(item, scale) {
  x <- item$x * scale
  y <- item$y * scale
  layer <- if (item$layer %in% names(dxf_layers)) item$layer else "SHEET"
  head <- function(type) dxf_codes(0, type, 8, layer)
  if (item$kind == "text") return(dxf_text(item, head, scale))
  if (!length(item$ink) || is.na(item$ink)) return(NULL)
  if (item$kind == "circle") {
    return(c(head("CIRCLE"), dxf_codes(10, x, 20, y, 30, 0, 40, item$radius * scale)))
  }
  type <- if (is.null(item$dash)) NULL else {
    dxf_codes(6, if (length(item$dash) > 2L) "CENTER" else "DASHED")
  }
  closed <- item$kind == "polygon"
  if (length(x) == 2L) {
    return(c(head("LINE"), type, dxf_codes(10, x[1], 20, y[1], 30, 0, 11, x[2], 21, y[2], 31, 0)))
  }
  c(
    head("POLYLINE"), type, dxf_codes(66, 1, 10, 0, 20, 0, 30, 0, 70, as.integer(closed)),
    unlist(Map(function(x, y) c(head("VERTEX"), dxf_codes(10, x, 20, y, 30, 0)), x, y),
      use.names = FALSE),
    head("SEQEND")
  )
}

dxf_text <- function(item, head, scale) {
  at <- scale * c(item$x, item$y - item$size / 2)
  c(
    head("TEXT"), dxf_codes(10, at[1], 20, at[2], 30, 0, 40, item$size * scale, 1,
      dxf_string(item$text), 50, 0, 7, if (item$bold) "TEXT_BOLD" else "TEXT"),
    if (item$italic) dxf_codes(51, 12),
    if (item$across > 0) {
      dxf_codes(72, if (item$across == 1) 2 else 1, 11, at[1], 21, at[2], 31, 0)
    }
  )
}

# Escapes characters beyond ISO 8859-1 by their number, and `%%`, which CAD programs interpret.
dxf_string <- function(text) {
  code <- utf8ToInt(enc2utf8(text))
  each <- intToUtf8(code, multiple = TRUE)
  each[code > 255L] <- sprintf("\\U+%04X", code[code > 255L])
  gsub("%%", "% %", paste(each, collapse = ""), fixed = TRUE)
}

write_dxf <- function(sheet, file) {
  text <- paste(sheet_dxf(sheet), collapse = "\n")
  bytes <- iconv(enc2utf8(text), "UTF-8", "latin1", toRaw = TRUE)[[1]]
  write_file(file, function(path) writeBin(bytes, path))
}
