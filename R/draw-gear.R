# The plan of a gear drawn flat, as net makers draw it.

#' Draw the plan of a gear
#'
#' The gear's netting laid flat, its rigging and the list of its ropes and pieces, on one page, as
#' in the FAO Catalogue of Fishing Gear Designs (FAO, 1972 and 1978; drawing after ISO 3169): panels
#' that follow each other stand in columns, front edge up, as deep as their netting is stretched and
#' half as wide as it is stretched, at one scale. What hangs between two ropes of known hanging
#' ratio is as wide as these; square netting has its own width. Of columns that are alike one is
#' drawn, and of symmetric columns, where the whole would be small, the right half. Straight panels
#' that are joined side by side, such as those of a seine, are drawn as one wall.
#'
#' Beside every panel stand its part, meshes deep, mesh size, twine and material; at its upper and
#' lower edges the meshes across (of the whole panel); and at its sides the cutting rate after ISO
#' 1532: points (N), meshes (T) and bars (B) in one cycle, such as 1N2B, or all of one kind (AN, AB,
#' AT). Where no cycle of few cuts gives the taper, the two nearest follow each other, each as often
#' as is written, until the edge is done: 9(1N2B)+1(1N3B). Meshes that seams take up are not
#' counted. Where a table beside the netting would not be clear, panels have numbers (P1) that are
#' explained below. Ropes have numbers and pieces have letters, which the lists explain; E is a
#' rope's hanging ratio. The rigging is not to scale; what is alike on both sides is drawn once.
#'
#' A panel that makes up most of the length of a net is drawn shortened, with a break; a wall much
#' longer than deep is drawn at two scales, and says so.
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
  if (!is.null(file)) check_file_path(file, drawing_types)
  sheet <- gear_sheet(x, page)
  if (is.null(file)) paint_sheet(sheet) else write_sheet(sheet, x, file)
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
  paste(sheet_svg(gear_sheet(gear, page), gear$plan$name, path_finder(gear)), collapse = "\n")
}

# A function that gives the path in a gear's plan of a field of its assembly, "" where no field of
# the plan is that one.
path_finder <- function(gear) {
  plan <- gear$plan
  tree <- first_of(gear_checked(gear)$tree, plan)
  leaves <- plan_leaves(plan)
  known <- new.env(parent = emptyenv())
  function(ref) {
    if (is.null(known[[ref]])) known[[ref]] <- drawn_path(ref, plan, tree, leaves)
    known[[ref]]
  }
}

# Fields that a wing's panel has by other names in its short form.
wing_fields <- c(upper = "tip", lower = "base")

drawn_path <- function(ref, plan, tree, leaves) {
  steps <- path_steps(ref)
  has <- function(path) !is.null(path) && !is.null(plan_field(plan, path))
  if (has(ref)) return(ref)
  value <- tryCatch(tree[[steps]], error = function(e) NULL)
  # of a part as a whole, what the first of its fields belongs to
  if (is.list(value) || is.null(value) && length(steps) == 2L) {
    for (name in intersect(part_marks, names(value))) {
      path <- drawn_path(paste(ref, name, sep = "."), plan, tree, leaves)
      if (nzchar(path) && grepl(".", path, fixed = TRUE)) return(sub("[.][^.]*$", "", path))
    }
    return("")
  }
  if (is.null(value)) return("")
  path <- written_path(plan, ref, value, leaves)
  if (has(path)) return(path)
  last <- steps[length(steps)]
  if (last %in% names(wing_fields)) {
    steps[length(steps)] <- wing_fields[[last]]
    path <- written_path(plan, paste(steps, collapse = "."), value, leaves)
    if (has(path)) return(path)
  }
  ""
}

# The fields by which a part is found in a short form, those that tell it best first.
part_marks <- c("mesh_size", "diameter", "mass", "area", "buoyancy", "length", "material",
  "mass_per_length", "drag_area", "volume")

# A gear's drawing on a sheet of a size ("A4").
gear_sheet <- function(gear, page) {
  sheet <- new_sheet(rev(sheet_sizes[[page]]))
  pen$sheet <- sheet
  draw_plan(plan_figure(gear), plan_page)
  sheet
}

# What the drawing shows, before any page is known: list(title, si, layout (NULL without netting),
# ropes, pieces (items, or NULL), rigging (NULL for none)).
plan_figure <- function(gear) {
  si <- gear_si(gear)
  # Struts that weigh nothing stand for stiff corners: nobody makes them.
  si$ropes <- Filter(function(rope) !(rope$strut && rope$mass_per_length == 0), si$ropes)
  ropes <- if (length(si$ropes)) rope_items(si)
  pieces <- piece_items(si)
  list(
    title = gear$plan$name, si = si,
    layout = if (length(si$panels)) flat_layout(si),
    ropes = ropes, pieces = pieces, rigging = plan_rigging(si, ropes, pieces)
  )
}

plan_margin <- 0.3
plan_title_height <- 0.42
# Shares of the page's width for the netting, and of the right column's height for the rigging.
netting_share <- 0.68
rigging_share <- 0.45
# Text: lists, labels and headings, as cex; ink.
plan_text <- c(list = 0.6, label = 0.56, heading = 0.68)
plan_ink <- "#202428"

# The page as laid out, inches; on a smaller one all is drawn smaller.
plan_page <- c(11.69, 8.27)

draw_plan <- function(figure, page) {
  top <- page[2] - plan_margin - plan_title_height
  left <- plan_margin
  right <- page[1] - plan_margin
  bottom <- plan_margin
  on_sheet(pen$sheet, component = "name", ref = "name",
    draw = pen_text(left, page[2] - plan_margin, figure$title, adj = c(0, 1), font = 2, cex = 1))
  pen_segments(left, top + 0.08, right, top + 0.08, lwd = 0.8)
  has_netting <- !is.null(figure$layout)
  has_rigging <- !is.null(figure$rigging)
  split <- left + (right - left) * netting_share
  main <- c(left, bottom, split - 0.15, top)
  side <- c(split, bottom, right, top)
  if (has_netting) {
    draw_flat_netting(figure, main)
    if (has_rigging) {
      below <- top - (top - bottom) * rigging_share
      draw_rigging(figure$rigging, c(side[1], below, side[3], top))
      side[4] <- below - 0.1
    }
  } else if (has_rigging) {
    draw_rigging(figure$rigging, main)
  }
  draw_plan_lists(figure, side)
}

# ---- marks and text that keep clear of each other ------------------------------------------------

# A number or letter in a circle (ropes) or a square (pieces).
draw_balloon <- function(x, y, text, square = FALSE) {
  r <- 0.075
  if (square) {
    pen_rect(x - r, y - r, x + r, y + r, col = "white", border = plan_ink, lwd = 0.8)
  } else {
    sheet_circle(pen$sheet, x * 25.4, y * 25.4, r * 25.4)
  }
  pen_text(x, y, text, cex = 0.5, font = 2)
}

# Boxes taken on the page: an environment with `boxes` (left, bottom, right, top in rows).
new_page_use <- function() {
  use <- new.env(parent = emptyenv())
  use$boxes <- matrix(0, 0L, 4L)
  use
}

is_free <- function(use, box) {
  b <- use$boxes
  !any(b[, 1] < box[3] & b[, 3] > box[1] & b[, 2] < box[4] & b[, 4] > box[2])
}

take_box <- function(use, box) use$boxes <- rbind(use$boxes, box)

# Places (n x 2) in order of liking: the first that a box of this size (width, height) around it
# leaves free, which is then taken; NULL where none is.
find_room <- function(use, places, size) {
  for (k in seq_len(nrow(places))) {
    box <- c(places[k, ] - size / 2, places[k, ] + size / 2)
    if (is_free(use, box)) {
      take_box(use, box)
      return(places[k, ])
    }
  }
  NULL
}

# Heights of labels that want to be at y (falling or not) and keep this distance: as near as may be.
spread_labels <- function(y, distance, bottom, top) {
  order <- order(-y)
  out <- y[order]
  n <- length(out)
  if (n > 1L) {
    for (pass in 1:200) {
      gap <- out[-n] - out[-1L]
      close <- which(gap < distance - 1e-9)
      if (!length(close)) break
      for (k in close) {
        push <- (distance - (out[k] - out[k + 1L])) / 2
        if (push > 0) {
          out[k] <- out[k] + push
          out[k + 1L] <- out[k + 1L] - push
        }
      }
      out <- out - max(0, out[1L] - top)
      out <- out + max(0, bottom - out[n])
    }
  }
  y[order] <- out
  y
}

# ---- lists ---------------------------------------------------------------------------------------

draw_plan_lists <- function(figure, frame) {
  ropes <- figure$ropes
  pieces <- figure$pieces
  lines <- 2 * (NROW(ropes) > 0) + NROW(ropes) + 2 * (NROW(pieces) > 0) + 2 * NROW(pieces)
  if (!lines) return(invisible())
  step <- min(0.17, (frame[4] - frame[2]) / lines)
  if (step < 0.1) {
    shown <- floor((frame[4] - frame[2]) / 0.1) - 5
    ropes <- utils::head(ropes, max(1, shown - 2 * NROW(pieces)))
    pieces <- utils::head(pieces, max(1, (shown - NROW(ropes)) %/% 2))
    step <- 0.1
  }
  cex <- min(plan_text[["list"]], plan_text[["list"]] * step / 0.14)
  y <- frame[4] - step / 2
  heading <- function(words) {
    pen_text(frame[1], y, words, adj = c(0, 0.5), font = 2, cex = plan_text[["heading"]])
    y <<- y - 1.2 * step
  }
  if (NROW(ropes)) {
    heading("Ropes (length of each)")
    words <- vapply(seq_len(nrow(ropes)), function(k) rope_item_words(ropes[k, ]), character(4))
    width <- apply(words, 1L, function(w) max(pen_width(w, cex = cex)))
    room <- frame[3] - frame[1] - 0.2
    cex <- cex * min(1, (room - 0.3) / sum(width))
    width <- width * min(1, (room - 0.3) / sum(width))
    at <- frame[1] + 0.2 + c(0, cumsum(width[1:3] + 0.1))
    for (k in seq_len(nrow(ropes))) {
      draw_balloon(frame[1] + 0.08, y, ropes$item[k])
      put <- function(component, field, c, x, across) {
        ref <- paste0("ropes.", ropes$first[k], if (nzchar(field)) ".", field)
        on_sheet(pen$sheet, component = component, ref = ref,
          draw = pen_text(x, y, words[c, k], adj = c(across, 0.5), cex = cex))
      }
      put("rope", "", 1, at[1], 0)
      put("length", "length", 2, at[2] + width[2], 1)
      put("diameter", "diameter", 3, at[3], 0)
      put("hanging_ratio", "hanging_ratio", 4, at[4], 0)
      y <- y - step
    }
    if (nrow(ropes) < nrow(figure$ropes)) {
      pen_text(at[1], y, sprintf("and %d more in the plan", nrow(figure$ropes) - nrow(ropes)),
        adj = c(0, 0.5), cex = cex, font = 3)
      y <- y - step
    }
    y <- y - 0.5 * step
  }
  if (NROW(pieces)) {
    heading("Boards, kites, weights, floats (of each)")
    for (k in seq_len(nrow(pieces))) {
      draw_balloon(frame[1] + 0.08, y, pieces$item[k], square = TRUE)
      name <- paste0(pieces$name[k], if (pieces$count[k] > 1) paste0(", ", pieces$count[k], " off"))
      on_sheet(pen$sheet, component = "piece", ref = pieces$ref[k],
        draw = pen_text(frame[1] + 0.2, y, name, adj = c(0, 0.5), cex = cex))
      beside <- frame[1] + 0.2 + pen_width(name, cex = cex) + 0.12
      fits <- beside + pen_width(pieces$words[k], cex = cex) <= frame[3]
      if (!fits) {
        y <- y - 0.85 * step
        beside <- frame[1] + 0.3
      }
      small <- min(1, (frame[3] - beside) / pen_width(pieces$words[k], cex = cex))
      pen_text(beside, y, pieces$words[k], adj = c(0, 0.5), cex = cex * small)
      y <- y - step
    }
  }
}
