#' Draw plane views of a state
#'
#' Draws the gear from above (XY), from the port side (XZ) and from astern (YZ), with the same scale
#' on both axes. Ropes (thick) are coloured by tension, netting (thin) by tension or by mesh opening
#' or angle. Each has a legend.
#'
#' @section Drawn lines:
#' - If the warps make the gear much longer than its net, the net is also drawn enlarged, unless the
#'   page is too low.
#' - Netting of cells is drawn as the two twine directions through its cells, which are larger than
#'   the meshes.
#' - If a net is too fine for the page, some twines are omitted, so that the drawn twines are about
#'   equally spaced. Several bars or cells in a row are one line with their mean tension.
#' - Seams between panels of bars have the mean tension of the twines that end on them.
#'
#' @param x A state from [settle()].
#' @param planes The planes to draw: any of `"xy"`, `"xz"` and `"yz"` (default: all).
#' @param file `NULL` (default) for the current graphics device, or a file to write, ending in
#'   `.png`, `.pdf` or `.svg`. It is written atomically.
#' @param width,height Size of the file's page in inches. If `height` is `NULL` (default), it fits
#'   the gear.
#' @param colour The quantity that colours of netting show: `"tension"` of one twine (default),
#'   `"mesh_opening"` (opening over mesh size) or `"mesh_angle"`, as in the table `"mesh_openings"`
#'   of [as.data.frame()][as.data.frame.codend_state].
#' @param ... Not used.
#' @return `x`, invisibly. An invalid argument is an error of class `codend_error_argument`.
#' @seealso [view_3d()] for three dimensions, [codend_charts] for charts, [plot.codend_gear()] for
#'   the net drawing.
#' @examples
#' state <- settle("small_midwater_trawl", nodes = 300)
#' plot(state, planes = "xz")
#' @export
plot.codend_state <- function(x, planes = c("xy", "xz", "yz"), file = NULL, width = 10,
                              height = NULL, colour = "tension", ...) {
  known <- c("xy", "xz", "yz")
  planes <- chosen_some(planes, known)
  colour <- chosen(colour, netting_colours)
  figure <- plane_figure(x, intersect(known, planes), colour)
  show_picture(x, function(page) draw_figure(figure, page), file, width, height, figure$title,
    fitting_height(figure, width))
}

# Returns the data of the views for any page: list(drawing, title, conditions, scales of rope and
# netting, flow [m/s, x and y], in_water, bed from drawn_bed(), planes).
plane_figure <- function(state, planes, colour = "tension") {
  coloured <- coloured_drawing(state, colour)
  list(
    drawing = coloured$drawing,
    title = state$gear$plan$name,
    conditions = state_conditions(state),
    scales = coloured$scales,
    flow = flow_past(state),
    in_water = state$si$water$density > 0,
    bed = drawn_bed(state),
    planes = planes
  )
}

# page: inches. A narrow page is a wide page that is drawn smaller, with its text and margins.
draw_figure <- function(figure, page) {
  given <- page
  page <- page / page_zoom(page[1])
  views <- views_for_page(figure, page)
  frames <- page_frames(views, page)
  check_space(frames$views, given)
  kept <- graphics::par(no.readonly = TRUE)
  on.exit(graphics::par(kept))
  # text size is set first, because margins are measured in lines of text
  graphics::par(family = "sans", bg = "white", cex = 0.8 * zoom_of(page))
  graphics::plot.new()
  for (k in seq_along(views)) draw_plane(figure, views[[k]], frames$views[[k]], page)
  draw_title(figure, frames$title, page)
  draw_legends(figure, frames$legend, page)
}

check_space <- function(frames, page) {
  across <- min(vapply(frames, function(f) f[3] - f[1], 0)) - space_across
  up <- min(vapply(frames, function(f) f[4] - f[2], 0)) - space_up
  if (across < 0.3 || up < 0.1) {
    size <- round(page, 1)
    abort_argument(
      "A page of {size[1]} by {size[2]} inches is too small for {length(frames)}
      panel{?s}; increase its size or draw fewer planes."
    )
  }
}

# Width of the narrowest page with text at its full size [inch].
full_width <- 7

page_zoom <- function(width) min(1, width / full_width)

# Returns the size of the open device relative to a page that is drawn on it.
zoom_of <- function(page) graphics::par("din")[1] / page[1]

# Opens a plotting region on part of the page. frame: left, bottom, right, top [inch]; margins:
# bottom, left, top, right [inch].
open_region <- function(frame, page, margins) {
  zoom <- zoom_of(page)
  graphics::par(
    fig = c(frame[1] / page[1], frame[3] / page[1], frame[2] / page[2], frame[4] / page[2]),
    mai = margins * zoom, new = TRUE, xaxs = "i", yaxs = "i", cex = 0.8 * zoom,
    mgp = c(2, 0.5, 0), tcl = -0.25
  )
  graphics::plot.new()
}

water_colour <- "#2C6E9B"

plane_axes <- list(xy = c(1L, 2L), xz = c(1L, 3L), yz = c(2L, 3L))
plane_labels <- c("x aft (m)", "y starboard (m)", "depth (m)")
plane_words <- c(xy = "from above", xz = "from the port side", yz = "from astern")

draw_plane <- function(figure, view, frame, page) {
  open_region(frame, page, plane_margins)
  zoom <- zoom_of(page)
  pin <- graphics::par("pin") / zoom
  axes <- plane_axes[[view$plane]]
  graphics::plot.window(view$across, view$up, asp = 1)
  usr <- graphics::par("usr")
  graphics::rect(usr[1], usr[3], usr[2], usr[4], col = "#F6F9FB", border = NA)
  graphics::clip(usr[1], usr[2], usr[3], usr[4])
  if (axes[2] == 3L && figure$in_water && usr[4] > 0) {
    graphics::rect(usr[1], 0, usr[2], usr[4], col = "white", border = NA)
    graphics::segments(usr[1], 0, usr[2], 0, col = water_colour, lwd = 1)
    above <- usr[4] > 0.16 * diff(usr[3:4]) / pin[2]
    graphics::text(usr[2], 0, "water surface ", adj = c(1, if (above) -0.35 else 1.35),
      col = water_colour, cex = 0.75)
  }
  draw_bed(figure$bed, axes, usr, pin[2])
  thin <- zoom * if (view$region == "whole" && view$enlarged) 0.35 else 0.6
  draw_lines(figure$drawing$netting, figure$scales$netting, axes, thin)
  draw_lines(figure$drawing$ropes, figure$scales$rope, axes,
    zoom * if (view$region == "net") 2.6 else 2)
  for (box in view$boxes) {
    graphics::rect(box[1], box[3], box[2], box[4], border = "grey30", lty = 3)
  }
  draw_marks(figure$drawing$marks, axes)
  do.call(graphics::clip, as.list(usr + c(-1, 1, -1, 1) * 10 * max(diff(usr))))
  graphics::box(col = "grey40")
  up <- ticks_between(usr[3:4], max(3, pin[2] / 0.4))
  across <- ticks_between(usr[1:2], max(3, pin[1] / 0.7))
  graphics::axis(1, at = across, col = "grey40")
  graphics::axis(2, at = up, labels = if (axes[2] == 3L) 0 - up else up, las = 1, col = "grey40")
  graphics::title(xlab = plane_labels[axes[1]])
  graphics::title(ylab = plane_labels[axes[2]], line = 2.6)
  heading <- paste0(if (view$region == "net") "Net " else "Gear ", plane_words[[view$plane]], " (",
    toupper(view$plane), ")")
  graphics::mtext(heading, side = 3, line = 0.3, adj = 0, cex = 0.85 * zoom, font = 2)
  draw_flow(figure$flow, axes, usr, pin)
}

ticks_between <- function(range, wanted) {
  at <- pretty(range, min(10, wanted))
  at[at >= range[1] & at <= range[2]]
}

# Lines near the viewer are drawn over distant lines.
draw_lines <- function(lines, scale, axes, width) {
  if (!length(lines$tension)) return(invisible())
  away <- setdiff(1:3, axes)
  near <- (lines$from[away, ] + lines$to[away, ]) * (if (away == 2L) -1 else 1)
  order <- order(near)
  graphics::segments(
    lines$from[axes[1], order], lines$from[axes[2], order],
    lines$to[axes[1], order], lines$to[axes[2], order],
    col = tension_colours(scale, lines$tension)[order], lwd = width, lend = "round"
  )
}

draw_marks <- function(marks, axes) {
  if (!NROW(marks)) return(invisible())
  symbol <- symbol_of(marks$role)
  at <- as.matrix(marks[c("x", "y", "z")])
  graphics::points(at[, axes[1]], at[, axes[2]], pch = symbol$symbol, bg = symbol$fill,
    col = "#202428", cex = symbol$size, lwd = 0.8)
}

# Draws the flow next to the heading: an arrow in its plane, or the tip or tail of an arrow across
# it. `pin`: size of the view on the page [inch].
draw_flow <- function(flow, axes, usr, pin) {
  speed <- sqrt(sum(flow^2))
  if (speed == 0) return(invisible())
  inch <- diff(usr[1:2]) / pin[1]
  along <- c(flow, 0)[axes] / speed
  centre <- c(usr[2] - 0.25 * inch, usr[4] + 0.13 * inch)
  kept <- graphics::par(xpd = NA)
  on.exit(graphics::par(kept))
  if (sqrt(sum(along^2)) > 0.2) {
    half <- min(0.2, 0.12 / max(abs(along[2]), 1e-9)) * inch * along
    graphics::arrows(centre[1] - half[1], centre[2] - half[2], centre[1] + half[1],
      centre[2] + half[2], length = 0.07, col = water_colour, lwd = 1.8)
  } else {
    across <- c(flow, 0)[setdiff(1:3, axes)] * (if (identical(axes, plane_axes$xz)) -1 else 1)
    graphics::points(centre[1], centre[2], pch = 1, cex = 1.6, col = water_colour, lwd = 1.5)
    graphics::points(centre[1], centre[2], pch = if (across > 0) 20 else 4, cex = 0.8,
      col = water_colour)
  }
  # a narrow view only has space for the arrow
  if (pin[1] < 2.8) return(invisible())
  graphics::text(usr[2] - 0.5 * inch, centre[2], sprintf("flow %.2f m/s", speed), adj = c(1, 0.5),
    col = water_colour, cex = 0.8)
}
