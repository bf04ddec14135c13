# A sheet as SVG: one unit is a millimetre, and each component of the gear is a group.

# Returns the lines of the SVG. find_path: a function that maps a field of the assembly to its path
# in the plan, or "".
#
# Each group is <g data-path="..." data-component="...">. The component is a kind of object
# ("panel", "rope", "piece", "mesh_size", "twine", "meshes", "cutting", "length", "diameter",
# "material", "name"). The path is the plan's field for update(), omitted if the plan has no such
# field.
sheet_svg <- function(sheet, title, find_path = function(ref) ref) {
  high <- sheet$page[2]
  key <- vapply(sheet$items, function(item) paste(item$component, item$ref, item$layer), "")
  runs <- rle(key)
  last <- cumsum(runs$lengths)
  first <- last - runs$lengths + 1L
  groups <- vapply(seq_along(first), function(k) {
    items <- sheet$items[seq(first[k], last[k])]
    about <- items[[1]]
    path <- if (nzchar(about$ref)) find_path(about$ref) else ""
    drawn <- paste(vapply(items, svg_item, "", high = high), collapse = "")
    if (!nzchar(about$component)) return(drawn)
    paste0(
      "<g", if (nzchar(path)) paste0(" data-path=\"", escape_markup(path), "\""),
      " data-component=\"", escape_markup(about$component), "\">", drawn, "</g>"
    )
  }, "")
  size <- sheet_number(sheet$page, 3L)
  c(
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
    sprintf(paste0(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%smm\" height=\"%smm\" ",
      "viewBox=\"0 0 %s %s\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" ",
      "fill=\"none\">"
    ), size[1], size[2], size[1], size[2]),
    paste0("<title>", escape_markup(title), "</title>"),
    sprintf("<rect width=\"%s\" height=\"%s\" fill=\"white\"/>", size[1], size[2]),
    groups, "</svg>", ""
  )
}

svg_item <- function(item, high) {
  n <- function(x) sheet_number(x, 3L)
  if (item$kind == "text") {
    # Every viewer must use the laid out width, in any font.
    return(paste0(
      "<text x=\"", n(item$x), "\" y=\"", n(high - item$y + item$size / 2), "\" font-size=\"",
      n(item$size / capital_height), "\" textLength=\"", n(item$wide),
      "\" lengthAdjust=\"spacingAndGlyphs\" fill=\"", item$ink,
      "\"",
      if (item$across > 0) {
        paste0(" text-anchor=\"", if (item$across == 1) "end" else "middle", "\"")
      },
      if (item$bold) " font-weight=\"bold\"", if (item$italic) " font-style=\"italic\"",
      ">", escape_markup(item$text), "</text>"
    ))
  }
  paint <- paste0(
    if (!is.na(item$ink)) sprintf(" stroke=\"%s\" stroke-width=\"%s\"", item$ink, n(item$width)),
    if (!is.na(item$fill)) sprintf(" fill=\"%s\"", item$fill),
    if (length(item$dash)) sprintf(" stroke-dasharray=\"%s\"", paste(n(item$dash), collapse = " "))
  )
  if (item$kind == "circle") {
    return(sprintf("<circle cx=\"%s\" cy=\"%s\" r=\"%s\"%s/>", n(item$x), n(high - item$y),
      n(item$radius), paint))
  }
  points <- paste(n(item$x), n(high - item$y), sep = ",", collapse = " ")
  element <- if (item$kind == "polygon") "polygon" else "polyline"
  sprintf("<%s points=\"%s\"%s/>", element, points, paint)
}
