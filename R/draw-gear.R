#' Draw the plan of a gear
#'
#' Draws the gear's flat netting, its ropes, its rigging and lists of ropes and pieces on a single
#' sheet. The form follows the FAO Catalogue of Fishing Gear Designs (FAO, 1972 and 1978) and ISO
#' 3169.
#'
#' @section Netting:
#' - Panels that follow each other are drawn in columns, front edge up, at a single scale.
#' - A panel is drawn at its stretched depth and half its stretched width. Netting between two ropes
#'   of known hanging ratio has its hung width. Square netting has its own width. A window has the
#'   size of its hole.
#' - A symmetric column with taper is drawn as one half: the left half of the upper panel and the
#'   right half of the lower panel share a centre line.
#' - Identical columns are drawn once.
#' - Straight panels joined side by side, such as a seine's, are drawn as a wall.
#' - Sorting grids are in the list of pieces. The netting around them is drawn without their cut.
#' - A panel that makes up most of the length of a net is shortened, with a break. A wall much
#'   longer than deep has two scales, which the title strip states. A DXF has neither.
#'
#' @section Labels:
#' - Next to every panel are its part, meshes deep, mesh size and twine (Rtex after ISO 858,
#'   material, special meshes).
#' - Its upper and lower edges show the meshes across the whole panel, without meshes that seams
#'   take up.
#' - Its sides show the cutting rate after ISO 1532: points (N), meshes (T) and bars (B) in one
#'   cycle, such as 1N2B, or a single kind (AN, AB, AT).
#' - A rate that the plan omits is the simplest cycle that ends within half a mesh of the counts
#'   (one mesh if the edge loses more than ten). If no cycle does, two cycles follow each other:
#'   9(1N2B)+1(1N3B).
#' - Ropes have numbers and pieces have letters, which the lists explain. E is a rope's hanging
#'   ratio.
#' - Headline, footrope and ground gear are also drawn straight, with all sections. Their floats
#'   and discs have one scale, larger than the rope's.
#' - The rigging is not to scale. Both sides are drawn once. A rope to its mirror image, such as a
#'   tickler chain from shoe to shoe, ends in an open circle.
#' - A rig of several nets has a schematic of the ropes between its nets, and one of the ropes of
#'   each kind of net ("2 off").
#' - Text heights follow ISO 3098, with at least 1.8 mm and more on larger sheets.
#'
#' @section Files:
#' - Files are written atomically.
#' - A DXF has the gear's true size in millimetres and a layer for each kind of object.
#' - In an SVG every group (`g`) for a part or field has `data-component`, its kind. If the plan has
#'   that field, `data-path` is its path, as used by [update()][update.codend_gear()].
#'
#' @param x A gear ([read_gear()], [gear()]).
#' @param file Path of a file that ends in `.svg`, `.pdf`, `.png` or `.dxf`, or `NULL` (default) for
#'   the current graphics device.
#' @param page Size of the sheet: `"A4"` (default), `"A3"`, `"A2"` or `"A1"`.
#' @param ... Not used.
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @seealso [plot.codend_state()] for the settled shape, [netting]; the guide
#'   `vignette("from-drawing-to-plan", "codend")`.
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

drawing_svg <- function(gear, page = "A4") {
  with_plain_numbers(
    paste(sheet_svg(gear_sheet(gear, page), gear$plan$name, path_finder(gear)), collapse = "\n")
  )
}

# Returns the content of the drawing, independent of the page. Elements: title, si, layout (NULL
# without netting), ropes and pieces (items, or NULL), riggings, panels (checked fields),
# source, reaches (cache).
plan_figure <- function(gear) {
  grids <- gear$checked$fields$grids
  # The cut around a sorting grid would divide the pieces of the net, so grids are only listed.
  if (length(grids)) {
    drawn <- setdiff(names(gear$plan), c("grids", "measures", "uncertain"))
    gear <- as_gear(gear$plan[drawn], gear$file, like = gear)
  }
  si <- gear_si(gear)
  si$names_in_gears <- do.call(c, unname(Map(function(one, name) {
    parts <- unlist(one$parts[c("panels", drawn_groups)], use.names = FALSE)
    stats::setNames(substring(parts, nchar(name) + 2L), parts)
  }, gear$checked$gears, names(gear$checked$gears))))
  # Struts without mass are edges of stiff pieces, not ropes.
  stiff <- vapply(si$ropes, function(rope) rope$strut && rope$mass_per_length == 0, NA)
  frames <- si$ropes[stiff]
  si$ropes <- si$ropes[!stiff]
  ropes <- if (length(si$ropes)) rope_items(si)
  pieces <- piece_items(si, grids)
  list(
    title = gear$plan$name, si = si,
    layout = if (length(si$panels)) flat_layout(si),
    ropes = ropes, pieces = pieces,
    riggings = plan_riggings(gear$checked$gears, si, ropes, pieces, frames),
    panels = gear_fields(gear)$panels, source = plan_source(gear),
    reaches = new.env(parent = emptyenv())
  )
}

plan_source <- function(gear) {
  sources <- gear$plan$sources
  if (length(sources)) {
    return(paste(names(sources), unlist(lapply(sources, toString)), sep = ": ", collapse = "; "))
  }
  if (is.null(gear$file)) "" else basename(gear$file)
}
