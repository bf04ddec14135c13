#' Turn a state around in three dimensions
#'
#' Makes a page with the gear in three dimensions, at one scale on all axes, to turn with the left
#' mouse button and to zoom with the wheel or the right one. Ropes and netting are coloured by
#' tension as in [plot.codend_state()], with legends in the page. Where the warps make the gear much
#' longer than its net, the page opens at the net; buttons look at the net or the whole gear. Pieces
#' are drawn large enough to be seen.
#'
#' The page of a trajectory plays it, as seen from the vessel, with a button and a slider of time;
#' the space bar plays and stops, the arrow keys step from kept time to kept time. All of it is in
#' the one file: some 12 bytes per node and time, and a third more for its text.
#'
#' @param state A state, from [settle()], or a trajectory, from [tow()].
#' @param file `NULL`, or an HTML file to write: one file that holds everything it needs and asks
#'   nothing of the network. It is written whole or not at all.
#' @param colour What the colours of netting show, as in [plot.codend_state()]; of a trajectory it
#' is
#'   always tension.
#' @return An HTML widget, which prints in the viewer or browser; invisibly where `file` is given.
#'   A wrong argument is an error of class `codend_error_argument`.
#' @examples
#' page <- view(settle("towed_cable"))
#' class(page)
#' @export
view <- function(state, file = NULL, colour = "tension") {
  moves <- inherits(state, "codend_trajectory")
  if (!moves) check_is_state(state)
  if (!is.null(file)) check_file_path(file, ".html")
  check_colour(colour)
  # In a file a fixed name, so that every new session writes the same page of the same state.
  element <- if (!is.null(file)) "gear"
  page <- with_plain_numbers(
    if (moves) motion_page(state, element) else gear_page(state, element, colour)
  )
  if (is.null(file)) return(page)
  write_file(file, function(path) {
    body <- with_plain_numbers(htmltools::as.tags(page, standalone = TRUE))
    write_single_page(path, state$gear$plan$name, body,
      style = "body { margin: 0; background: white; }")
  })
  invisible(page)
}

# The page of a state as a widget; element is its name in HTML or NULL for a random one.
gear_page <- function(state, element, colour = "tension") {
  coloured <- coloured_drawing(state, colour)
  drawing <- coloured$drawing
  scales <- coloured$scales
  whole <- page_ranges(drawing, state)
  net <- net_to_enlarge(drawing, whole)
  scene <- gear_scene(state, drawing, scales, whole, net)
  gear_widget(scene, page_legend(state, drawing, scales), whole, net, element)
}

# Ranges of what is drawn, with the water's surface.
page_ranges <- function(drawing, state) {
  whole <- drawn_ranges(list(drawing$ropes, drawing$netting), drawing$marks)
  if (state$si$water$density > 0) whole[2, 3] <- max(whole[2, 3], 0)
  whole
}

# The scene, drawn on a device of its own that needs no display. It turns around the middle of the
# net's ranges where they are given, else of the whole's. Returns the scene with the object numbers
# of its axes as `net_axes` and `whole_axes`, and as `drawn` those of what it shows, with the size
# (m) by which marks are enlarged. flow: m/s, an arrow beside the axes.
gear_scene <- function(state, drawing, scales, whole, net, flow = flow_past(state)) {
  kept <- options(rgl.useNULL = TRUE)
  on.exit(options(kept))
  before <- rgl::cur3d()
  device <- rgl::open3d(useNULL = TRUE, silent = TRUE)
  on.exit({
    rgl::close3d(device)
    if (before > 0) rgl::set3d(before, silent = TRUE)
  }, add = TRUE, after = FALSE)
  rgl::bg3d("#F7FAFC")
  focus <- if (is.null(net)) whole else net
  netting <- scene_lines(drawing$netting, scales$netting, 1)
  ropes <- scene_lines(drawing$ropes, scales$rope, 4)
  # To be seen from near and from far.
  size <- (longest_side(focus)^2 * longest_side(whole))^(1 / 3)
  marks <- scene_marks(drawing, size)
  if (state$si$water$density > 0) scene_surface(whole)
  scene_bed(drawn_bed(state), whole)
  # Axes lie around the box that the scene turns in.
  rgl::par3d(ignoreExtent = TRUE)
  whole_axes <- scene_axes(whole, flow)
  net_axes <- if (!is.null(net)) scene_axes(net, flow)
  rgl::par3d(ignoreExtent = FALSE)
  # A scene turns around the middle of its box: make the middle of the focus that of the box.
  middle <- colMeans(focus)
  reach <- reach_around(whole, focus)
  rgl::points3d(rbind(middle - reach, middle + reach), alpha = 0)
  rgl::aspect3d("iso")
  rgl::view3d(userMatrix = first_turn(), fov = 20, zoom = zoom_to(focus, reach))
  scene <- rgl::scene3d(minimal = FALSE)
  scene$whole_axes <- whole_axes
  scene$net_axes <- net_axes
  scene$drawn <- c(list(size = size, netting = netting, ropes = ropes), marks)
  scene
}

longest_side <- function(ranges) max(ranges[2, ] - ranges[1, ])

# How far (m along x, y, z) the whole reaches from the middle of the focus.
reach_around <- function(whole, focus) {
  apply(abs(sweep(whole, 2L, colMeans(focus))), 2L, max)
}

# From the port bow, a little above.
first_turn <- function() {
  rgl::rotationMatrix(-0.38 * pi, 1, 0, 0) %*% rgl::rotationMatrix(-0.12 * pi, 0, 0, 1)
}

# The zoom at which ranges fill a window half as wide again as it is high, with room for legends. At
# zoom 1 the ball around the whole scene fills its height.
zoom_to <- function(ranges, reach) {
  half <- abs(first_turn()[1:2, 1:3]) %*% ((ranges[2, ] - ranges[1, ]) / 2)
  max(half[1] / (0.82 * 1.5), half[2] / 0.7) / sqrt(sum(reach^2))
}

# Returns the number of the object drawn, NULL for none.
scene_lines <- function(lines, scale, width) {
  n <- length(lines$tension)
  if (!n) return(NULL)
  ends <- matrix(rbind(lines$from, lines$to), 3L)
  colour <- rep(tension_colours(scale, lines$tension), each = 2L)
  as.integer(rgl::segments3d(t(ends), color = colour, lwd = width, lit = FALSE))
}

# Returns the numbers of the objects drawn with the rows of the marks that they show: a list of
# plates, and balls, which are one object or NULL.
scene_marks <- function(drawing, size) {
  marks <- drawing$marks
  flat <- symbol_of(marks$role)$plate
  plates <- lapply(which(flat), function(k) {
    corners <- plate_corners(marks[k, ], drawing$boards, size)
    colour <- symbol_of(marks$role[k])$fill
    list(id = as.integer(rgl::quads3d(t(corners), color = colour, lit = FALSE)), mark = k)
  })
  round <- marks[!flat, ]
  if (!NROW(round)) return(list(plates = plates))
  least <- 0.004 * size * symbol_of(round$role)$size
  radius <- pmax(least, ifelse(is.na(round$size), 0, round$size / sqrt(pi)))
  balls <- rgl::spheres3d(round$x, round$y, round$z, radius = radius,
    color = symbol_of(round$role)$fill, lit = TRUE, specular = "#303030")
  list(plates = plates, balls = list(id = as.integer(balls), mark = which(!flat)))
}

# Corners of a mark that is a plate, 3 x 4, m; boards: those of all free boards; size: of the scene,
# m, in which the plate must be seen.
plate_corners <- function(mark, boards, size) {
  if (mark$board > 0L) return(free_plate(boards, mark, size))
  half <- max(if (is.na(mark$size)) 0 else mark$size, least_plate * size) / 2
  held_plate(mark$direction) * half + c(mark$x, mark$y, mark$z)
}

# Side of the smallest plate, as a share of its scene.
least_plate <- 0.02

# A free board in its own attitude, enlarged about its middle where it would be too small.
free_plate <- function(boards, mark, size) {
  corners <- boards[, 4L * (mark$board - 1L) + 1:4]
  middle <- rowMeans(corners)
  middle + (corners - middle) * max(1, least_plate * size / mark$size)
}

# A piece that lifts is a point of the state without an attitude, so that its plate is a symbol:
# upright and at 30 degrees to the flow where it lifts sideways, else across it and leaning 45
# degrees to lift. Corners of a plate of 2 by 2 around the origin, 3 x 4.
held_plate <- function(direction) {
  if (is.na(direction)) direction <- "up"
  # Two directions in the plate; the water is turned away from the lift.
  first <- switch(direction,
    port = c(cos(pi / 6), sin(pi / 6), 0), starboard = c(cos(pi / 6), -sin(pi / 6), 0), c(0, 1, 0)
  )
  second <- switch(direction, up = c(-1, 0, 1) / sqrt(2), down = c(1, 0, 1) / sqrt(2), c(0, 0, 1))
  cbind(-first - second, first - second, first + second, -first + second)
}

scene_surface <- function(ranges) {
  x <- ranges[c(1, 2, 2, 1), 1]
  y <- ranges[c(1, 1, 2, 2), 2]
  rgl::quads3d(x, y, 0, color = "#4A90C2", alpha = 0.15, lit = FALSE, depth_mask = FALSE)
  rgl::lines3d(x[c(1:4, 1)], y[c(1:4, 1)], 0, color = water_colour, lwd = 1, lit = FALSE)
  rgl::texts3d(ranges[2, 1], ranges[1, 2], 0, "water surface", adj = c(1, -0.5),
    color = water_colour, cex = 0.9)
}

# Axes along three edges of the ranges, with about as many metres between ticks on each, and the
# flow beside them. Returns the numbers of the objects drawn.
scene_axes <- function(ranges, flow) {
  size <- longest_side(ranges)
  low <- ranges[1, ]
  high <- ranges[2, ]
  # Where each axis starts, and the way out of the box from it.
  from <- rbind(low, low, c(high[1], low[2], low[3]))
  out <- rbind(c(0, -1, 0), c(-1, 0, 0), c(0.7, -0.7, 0))
  colour <- "#404448"
  drawn <- lapply(1:3, function(axis) {
    at <- ticks_between(ranges[, axis], max(2, 8 * (high - low)[axis] / size))
    on_axis <- matrix(from[axis, ], length(at), 3L, byrow = TRUE)
    on_axis[, axis] <- at
    away <- function(share) sweep(on_axis, 2L, share * size * out[axis, ], "+")
    end <- from[axis, ]
    end[axis] <- high[axis]
    title <- if (axis == 3L) end + c(0, 0, 0.03 * size) else {
      (from[axis, ] + end) / 2 + 0.11 * size * out[axis, ]
    }
    c(
      rgl::segments3d(
        rbind(from[axis, ], end, matrix(t(cbind(on_axis, away(0.012))), ncol = 3L, byrow = TRUE)),
        color = colour, lwd = 1, lit = FALSE
      ),
      rgl::texts3d(away(0.035), texts = as.character(if (axis == 3L) 0 - at else at),
        color = colour, cex = 0.75),
      rgl::texts3d(matrix(title, 1L), texts = plane_labels[axis], color = colour, cex = 0.85)
    )
  })
  unname(c(unlist(drawn), scene_flow(flow, ranges, size)))
}

# An arrow beside the port side of the ranges, at mid depth.
scene_flow <- function(flow, ranges, size) {
  speed <- sqrt(sum(flow^2))
  if (speed == 0) return(NULL)
  long <- 0.1 * size
  along <- c(flow, 0) / speed
  side <- c(-along[2], along[1], 0)
  start <- c(ranges[1, 1], ranges[1, 2] - 0.05 * size, mean(ranges[, 3]))
  tip <- start + long * along
  barbs <- tip - 0.25 * long * along
  ends <- rbind(start, tip, tip, barbs + 0.12 * long * side, tip, barbs - 0.12 * long * side)
  c(
    rgl::segments3d(ends, color = water_colour, lwd = 3, lit = FALSE),
    rgl::texts3d(matrix(start + 0.5 * long * along, 1), texts = sprintf("flow %.2f m/s", speed),
      adj = c(0.5, -0.6), color = water_colour, cex = 0.9)
  )
}

# The scene as a widget that fills its window, with the legends laid over it and, where the net is
# small in its gear, buttons to look at either.
gear_widget <- function(scene, legend, whole, net, element) {
  widget <- rgl::rglwidget(scene, width = 960, height = 640, elementId = element)
  widget$width <- widget$height <- NULL
  widget$sizingPolicy <- htmlwidgets::sizingPolicy(
    defaultWidth = "100%", defaultHeight = 640, padding = 0, browser.fill = TRUE,
    viewer.fill = TRUE, knitr.figure = FALSE
  )
  data <- list(html = legend)
  if (!is.null(net)) {
    data$move <- unname(colMeans(net) - colMeans(whole))
    data$zoom <- zoom_to(whole, reach_around(whole, net))
    data$whole_axes <- scene$whole_axes
    data$net_axes <- scene$net_axes
  }
  run_script(widget, "page.js", data)
}

# Runs one of the package's scripts once the page is there.
run_script <- function(widget, name, data) {
  htmlwidgets::onRender(widget, view_file(name), data = data)
}
