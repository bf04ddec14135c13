# A sheet independent of any device: lines, circles and texts in millimetres from the lower left
# corner, y up. Devices, SVG and DXF draw the same items, and overlaps can be checked without
# drawing.

# Trimmed sheets of ISO 216 (mm), the short side first.
sheet_sizes <- list(
  A4 = c(210, 297), A3 = c(297, 420), A2 = c(420, 594), A1 = c(594, 841)
)

sheet_ink <- "#202428"
sheet_fill <- "#F2F4F6"
# Line widths (mm) from the series of ISO 128-2.
sheet_width <- c(thin = 0.18, middle = 0.25, thick = 0.5)

# page: width and height, mm. scale: mm of gear per mm of sheet, NA until it is set.
new_sheet <- function(page) {
  sheet <- new.env(parent = emptyenv())
  sheet$page <- page
  sheet$items <- list()
  sheet$about <- list(component = "", ref = "", layer = "SHEET")
  sheet$scale <- NA_real_
  sheet
}

# Evaluates `draw`, which draws a component of the gear. `component`: its kind ("panel", "rope",
# "mesh_size"). `ref`: the field of the assembly that it shows, or "". `layer`: its layer in a DXF.
on_sheet <- function(sheet, draw, component, ref = "", layer = sheet$about$layer) {
  before <- sheet$about
  on.exit(sheet$about <- before)
  sheet$about <- list(component = component, ref = ref, layer = layer)
  force(draw)
  invisible(sheet)
}

add_item <- function(sheet, ...) {
  sheet$items[[length(sheet$items) + 1L]] <- c(list(...), sheet$about)
  invisible(sheet)
}

# dash: lengths of strokes and gaps, mm.
sheet_line <- function(sheet, x, y, width = sheet_width[["thin"]], dash = NULL) {
  # As on a device, unknown points are skipped: an SVG must not contain NA.
  known <- is.finite(x) & is.finite(y)
  if (sum(known) < 2L) return(invisible())
  add_item(sheet, kind = "line", x = x[known], y = y[known], width = width, dash = dash,
    ink = sheet_ink, fill = NA)
}

sheet_polygon <- function(sheet, x, y, fill = NA, border = sheet_ink,
                          width = sheet_width[["thin"]]) {
  add_item(sheet, kind = "polygon", x = x, y = y, width = width, dash = NULL, ink = border,
    fill = fill)
}

sheet_circle <- function(sheet, x, y, radius, fill = "white") {
  add_item(sheet, kind = "circle", x = x, y = y, radius = radius, width = sheet_width[["thin"]],
    dash = NULL, ink = sheet_ink, fill = fill)
}

# Adds text on one line. size: height of capitals, mm (ISO 3098); across: position of x in the text,
# 0 left to 1 right; y: middle of the capitals.
sheet_text <- function(sheet, x, y, text, size, across = 0, bold = FALSE, italic = FALSE) {
  text <- as.character(text)
  if (is.na(text) || !nzchar(text)) return(invisible(sheet))
  add_item(sheet, kind = "text", x = x, y = y, text = text, size = size, across = across,
    bold = bold, italic = italic, ink = sheet_ink, fill = NA, wide = text_width(text, size, bold))
}

sheet_lines <- function(sheet, x, y, lines, look, italic = FALSE) {
  for (l in seq_along(lines)) {
    sheet_text(sheet, x, y - (l - 1) * look$line, lines[l], look$t, italic = italic)
  }
}

# ---- metrics -------------------------------------------------------------------------------------

# Height of capitals divided by font size; equal for Helvetica, Arial and Liberation Sans.
capital_height <- 0.718

# Widths of Helvetica's characters in ISO 8859-1 (1/1000 of the font size), from the font metrics
# that R includes. Arial and Liberation Sans have the same widths.
character_widths <- remembered(function() {
  lapply(c(plain = "Helvetica", bold = "Helvetica-Bold"), face_widths)
})

face_widths <- function(face) {
  file <- function(...) system.file(..., package = "grDevices", mustWork = TRUE)
  read <- function(path) {
    from <- gzfile(path)
    on.exit(close(from))
    readLines(from, encoding = "latin1", warn = FALSE)
  }
  metrics <- grep("^C ", read(file("afm", paste0(face, ".afm.gz"))), value = TRUE)
  width <- as.double(sub(".* WX ([0-9]+) .*", "\\1", metrics))
  names(width) <- sub(".* N ([A-Za-z0-9.]+) .*", "\\1", metrics)
  text <- paste(sub("%.*", "", read(file("enc", "ISOLatin1.enc"))), collapse = " ")
  glyphs <- regmatches(text, gregexpr("/[A-Za-z0-9.]+", text))[[1]]
  glyphs <- sub("/", "", utils::tail(glyphs, 256L))
  unname(width[glyphs])
}

# Returns the width (mm) of texts. size: height of capitals (mm).
text_width <- function(text, size, bold = FALSE) {
  widths <- character_widths()[[if (bold) "bold" else "plain"]]
  thousandths <- vapply(as.character(text), function(one) {
    code <- utf8ToInt(enc2utf8(one))
    each <- widths[pmin(code, 255L) + 1L]
    # Characters without a known width get the width of a wide capital.
    each[code > 255L | is.na(each)] <- 833
    sum(each)
  }, 0, USE.NAMES = FALSE)
  thousandths / 1000 * size / capital_height
}

# Returns the box of an item: left, bottom, right, top. For text it includes descenders.
item_box <- function(item) {
  if (item$kind == "text") {
    along <- item$wide * c(-item$across, 1 - item$across)
    across <- item$size * c(-0.5, 0.5)
    # Helvetica's descenders are 0.207 of the font size.
    if (grepl("[gjpqy,;()Q]", item$text)) across[1] <- across[1] - 0.207 / 0.718 * item$size
    return(c(item$x + along[1], item$y + across[1], item$x + along[2], item$y + across[2]))
  }
  if (item$kind == "circle") return(c(item$x - item$radius, item$y - item$radius,
    item$x + item$radius, item$y + item$radius))
  c(min(item$x), min(item$y), max(item$x), max(item$y))
}

# ---- on a device ---------------------------------------------------------------------------------

# Draws a sheet on the open device, as large as its page (inches) allows. Text is never wider than
# its metrics, whichever font the device has.
paint_sheet <- function(sheet, page = grDevices::dev.size()) {
  kept <- graphics::par(no.readonly = TRUE)
  on.exit(graphics::par(kept))
  graphics::par(bg = "white", mai = c(0, 0, 0, 0), cex = 1, xaxs = "i", yaxs = "i", lend = "butt")
  graphics::plot.new()
  small <- min(page * 25.4 / sheet$page)
  graphics::plot.window(c(0, page[1] * 25.4 / small), c(0, page[2] * 25.4 / small))
  # A line width of 1 is 1/96 inch.
  line_width <- function(mm) pmax(mm * small * 96 / 25.4, 0.1)
  for (item in sheet$items) paint_item(item, small, line_width)
}

paint_item <- function(item, small, line_width) {
  if (item$kind == "text") {
    font <- 1L + item$bold + 2L * item$italic
    cex <- item$size / capital_height * small / 25.4 * 72 / graphics::par("ps")
    drawn <- graphics::strwidth(item$text, cex = cex, font = font)
    cex <- cex * min(1, item$wide / drawn)
    # `text()` measures height from the baseline.
    graphics::text(item$x, item$y - item$size / 2, item$text, adj = c(item$across, 0), cex = cex,
      font = font, col = item$ink)
    return(invisible())
  }
  lwd <- line_width(item$width)
  if (item$kind == "circle") {
    turn <- seq(0, 2 * pi, length.out = 41L)[-41L]
    graphics::polygon(item$x + item$radius * cos(turn), item$y + item$radius * sin(turn),
      col = item$fill, border = item$ink, lwd = lwd)
  } else if (item$kind == "polygon") {
    graphics::polygon(item$x, item$y, col = item$fill, border = item$ink, lwd = lwd)
  } else {
    dash <- if (is.null(item$dash)) "solid" else {
      # Multiples of the line width, 1 to 15, in hexadecimal.
      steps <- pmin(15L, pmax(1L, as.integer(round(line_width(item$dash) / max(lwd, 1)))))
      paste(as.hexmode(steps), collapse = "")
    }
    graphics::lines(item$x, item$y, lwd = lwd, col = item$ink, lty = dash)
  }
}

# Returns numbers as text without exponents, with at most `digits` decimals.
sheet_number <- function(x, digits) {
  format(round(x, digits), trim = TRUE, scientific = FALSE, drop0trailing = TRUE, digits = 15)
}
