# The plan of a gear drawn flat, as net makers draw it.

#' Draw the plan of a gear
#'
#' The gear's netting laid flat, its ropes laid straight, its rigging and the lists of its ropes and
#' pieces on one sheet, as in the FAO Catalogue of Fishing Gear Designs (FAO, 1972 and 1978; drawing
#' after ISO 3169). Panels that follow each other are drawn in columns, front edge up, as deep as
#' their netting is stretched and half as wide as it is stretched, at one scale. What hangs between
#' two ropes of known hanging ratio is as wide as these; square netting has its own width. Of
#' symmetric columns that taper one half is drawn: the left half of the upper panel and the right
#' half of the lower one, at one centre line. Of columns that are alike one is drawn. Straight
#' panels that are joined side by side, such as those of a seine, are drawn as one wall.
#'
#' Next to every panel are its part, meshes deep, mesh size, and twine (Rtex after ISO 858,
#' material, what is special about its meshes); at its upper and lower edges the meshes across (of
#' the whole panel); and at
#' its sides the cutting rate after ISO 1532: points (N), meshes (T) and bars (B) in one cycle, such
#' as 1N2B, or all of one kind (AN, AB, AT). It is the plan's own where it has one, otherwise the
#' simplest that ends within half a mesh of the counts (a mesh, where the edge loses more than ten);
#' where no one cycle does, the two nearest follow each other: 9(1N2B)+1(1N3B). Meshes that seams
#' take up are not counted. Ropes have numbers and pieces have letters, which the lists explain; E
#' is a rope's hanging ratio. The rigging is not to scale; what is alike on both sides is drawn
#' once, and a rope from a place to its like, such as a tickler chain from shoe to shoe, ends in an
#' open circle.
#'
#' A panel that makes up most of the length of a net is drawn shortened, with a break; a wall much
#' longer than deep is drawn at two scales, and says so. A DXF has neither. Texts have the heights
#' of ISO 3098, 1.8 mm at least, larger on larger sheets; scales are round.
#'
#' @param x A gear ([read_gear()], [gear()]).
#' @param file `NULL` for the current graphics device, or a file to write, ending in `.svg`, `.pdf`,
#'   `.png` or `.dxf`. It is written whole or not at all. A DXF has the gear's true size in
#'   millimetres, and a layer for each kind of thing. In an SVG every group (`g`) that shows a part
#'   of the gear or a field of it has `data-component`, what it shows, and `data-path`, the path of
#'   its field in the plan, as [update()][update.codend_gear()] takes it.
#' @param page Size of the sheet: `"A4"`, `"A3"`, `"A2"` or `"A1"`.
#' @param ... Not used.
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @examples
#' plot(read_gear("midwater_trawl"))
#' @export
plot.codend_gear <- function(x, file = NULL, page = c("A4", "A3", "A2", "A1"), ...) {
  page <- chosen(page, names(sheet_sizes))
  true_size <- !is.null(file) && check_file_path(file, drawing_types) == ".dxf"
  with_plain_numbers({
    sheet <- gear_sheet(x, page, true_size)
    if (is.null(file)) paint_sheet(sheet) else write_sheet(sheet, x, file)
  })
  invisible(x)
}

drawing_types <- c(".svg", ".pdf", ".png", ".dxf")

write_sheet <- function(sheet, gear, file) {
  title <- gear$plan$name
  switch(check_file_path(file, drawing_types),
    .svg = write_text(sheet_svg(sheet, title, path_finder(gear)), file),
    .dxf = write_dxf(sheet, file),
    write_picture(file, sheet$page / 25.4, title, function(page) paint_sheet(sheet, page))
  )
}

# The drawing of a gear as the text of an SVG.
drawing_svg <- function(gear, page = "A4") {
  with_plain_numbers(
    paste(sheet_svg(gear_sheet(gear, page), gear$plan$name, path_finder(gear)), collapse = "\n")
  )
}

# What the drawing shows, before any page is known: list(title, si, layout (NULL without netting),
# ropes, pieces (items, or NULL), rigging (NULL for none), panels (checked fields)).
plan_figure <- function(gear) {
  si <- gear_si(gear)
  # Struts that weigh nothing are the edges of stiff pieces, no ropes.
  stiff <- vapply(si$ropes, function(rope) rope$strut && rope$mass_per_length == 0, NA)
  frames <- si$ropes[stiff]
  si$ropes <- si$ropes[!stiff]
  ropes <- if (length(si$ropes)) rope_items(si)
  pieces <- piece_items(si)
  list(
    title = gear$plan$name, si = si,
    layout = if (length(si$panels)) flat_layout(si),
    ropes = ropes, pieces = pieces, rigging = plan_rigging(si, ropes, pieces, frames),
    panels = gear_fields(gear)$panels, discs = plan_discs(gear$plan), source = plan_source(gear),
    reaches = new.env(parent = emptyenv())
  )
}

# Where the plan comes from: its sources in one text, or the name of its file.
plan_source <- function(gear) {
  sources <- gear$plan$sources
  if (length(sources)) {
    return(paste(names(sources), unlist(lapply(sources, toString)), sep = ": ", collapse = "; "))
  }
  if (is.null(gear$file)) "" else basename(gear$file)
}
