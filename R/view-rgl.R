# A state on a device of rgl, for those who go on with rgl's own functions.

# Draws the gear and leaves the device current. Returns its number.
rgl_view <- function(state, colour = "tension") {
  coloured <- coloured_drawing(state, colour)
  drawing <- coloured$drawing
  ranges <- drawn_ranges(list(drawing$ropes, drawing$netting), drawing$marks)
  if (state$si$water$density > 0) ranges[2, 3] <- max(ranges[2, 3], 0)
  net <- net_to_enlarge(drawing, ranges)
  device <- rgl::open3d(silent = TRUE)
  rgl::bg3d("#F7FAFC")
  focus <- if (is.null(net)) ranges else net
  rgl_lines(drawing$netting, coloured$scales$netting, 1)
  rgl_lines(drawing$ropes, coloured$scales$rope, 4)
  # To be seen from near and from far.
  rgl_marks(drawing, (longest_side(focus)^2 * longest_side(ranges))^(1 / 3))
  if (state$si$water$density > 0) rgl_surface(ranges)
  rgl_bed(drawn_bed(state), ranges)
  rgl_axes(focus, flow_past(state))
  # A scene turns around the middle of its box: make the middle of the focus that of the box.
  middle <- colMeans(focus)
  reach <- reach_around(ranges, focus)
  rgl::points3d(rbind(middle - reach, middle + reach), alpha = 0)
  rgl::aspect3d("iso")
  rgl::view3d(userMatrix = first_turn(), fov = 20, zoom = zoom_to(focus, reach))
  as.integer(device)
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

rgl_lines <- function(lines, scale, width) {
  if (!length(lines$tension)) return(invisible())
  ends <- matrix(rbind(lines$from, lines$to), 3L)
  colour <- rep(tension_colours(scale, lines$tension), each = 2L)
  rgl::segments3d(t(ends), color = colour, lwd = width, lit = FALSE)
}

# Plates as they stand, all else as balls.
rgl_marks <- function(drawing, size) {
  marks <- drawing$marks
  flat <- symbol_of(marks$role)$plate
  for (k in which(flat)) {
    corners <- plate_corners(marks[k, ], drawing$boards, size)
    rgl::quads3d(t(corners), color = symbol_of(marks$role[k])$fill, lit = FALSE)
  }
  round <- marks[!flat, ]
  if (!NROW(round)) return(invisible())
  least <- 0.004 * size * symbol_of(round$role)$size
  radius <- pmax(least, ifelse(is.na(round$size), 0, round$size / sqrt(pi)))
  rgl::spheres3d(round$x, round$y, round$z, radius = radius, color = symbol_of(round$role)$fill,
    lit = TRUE, specular = "#303030")
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

rgl_surface <- function(ranges) {
  x <- ranges[c(1, 2, 2, 1), 1]
  y <- ranges[c(1, 1, 2, 2), 2]
  rgl::quads3d(x, y, 0, color = "#4A90C2", alpha = 0.15, lit = FALSE, depth_mask = FALSE)
  rgl::lines3d(x[c(1:4, 1)], y[c(1:4, 1)], 0, color = water_colour, lwd = 1, lit = FALSE)
  rgl::texts3d(ranges[2, 1], ranges[1, 2], 0, "water surface", adj = c(1, -0.5),
    color = water_colour, cex = 0.9)
}

# Axes along three edges of the ranges, with about as many metres between ticks on each, and the
# flow beside them.
rgl_axes <- function(ranges, flow) {
  size <- longest_side(ranges)
  low <- ranges[1, ]
  high <- ranges[2, ]
  # Where each axis starts, and the way out of the box from it.
  from <- rbind(low, low, c(high[1], low[2], low[3]))
  out <- rbind(c(0, -1, 0), c(-1, 0, 0), c(0.7, -0.7, 0))
  colour <- "#404448"
  for (axis in 1:3) {
    at <- ticks_between(ranges[, axis], max(2, 8 * (high - low)[axis] / size))
    on_axis <- matrix(from[axis, ], length(at), 3L, byrow = TRUE)
    on_axis[, axis] <- at
    away <- function(share) sweep(on_axis, 2L, share * size * out[axis, ], "+")
    end <- from[axis, ]
    end[axis] <- high[axis]
    title <- if (axis == 3L) end + c(0, 0, 0.03 * size) else {
      (from[axis, ] + end) / 2 + 0.11 * size * out[axis, ]
    }
    rgl::segments3d(
      rbind(from[axis, ], end, matrix(t(cbind(on_axis, away(0.012))), ncol = 3L, byrow = TRUE)),
      color = colour, lwd = 1, lit = FALSE
    )
    rgl::texts3d(away(0.035), texts = as.character(if (axis == 3L) 0 - at else at),
      color = colour, cex = 0.75)
    rgl::texts3d(matrix(title, 1L), texts = plane_labels[axis], color = colour, cex = 0.85)
  }
  rgl_flow(flow, ranges, size)
}

# An arrow beside the port side of the ranges, at mid depth.
rgl_flow <- function(flow, ranges, size) {
  speed <- sqrt(sum(flow^2))
  if (speed == 0) return(NULL)
  long <- 0.1 * size
  along <- c(flow, 0) / speed
  side <- c(-along[2], along[1], 0)
  start <- c(ranges[1, 1], ranges[1, 2] - 0.05 * size, mean(ranges[, 3]))
  tip <- start + long * along
  barbs <- tip - 0.25 * long * along
  ends <- rbind(start, tip, tip, barbs + 0.12 * long * side, tip, barbs - 0.12 * long * side)
  rgl::segments3d(ends, color = water_colour, lwd = 3, lit = FALSE)
  rgl::texts3d(matrix(start + 0.5 * long * along, 1), texts = sprintf("flow %.2f m/s", speed),
    adj = c(0.5, -0.6), color = water_colour, cex = 0.9)
}

# The bed in a scene, over the ranges of what is drawn; none far below them.
rgl_bed <- function(bed, ranges) {
  if (is.null(bed)) return(invisible())
  x <- ranges[c(1, 2, 2, 1), 1]
  y <- ranges[c(1, 1, 2, 2), 2]
  z <- bed_heights(bed, rbind(x, y))
  if (max(z) < ranges[1, 3] - 0.1 * longest_side(ranges)) return(invisible())
  rgl::quads3d(x, y, z, color = bed_colours[["line"]], alpha = 0.2, lit = FALSE,
    depth_mask = FALSE)
  rgl::lines3d(x[c(1:4, 1)], y[c(1:4, 1)], z[c(1:4, 1)], color = bed_colours[["line"]], lwd = 1,
    lit = FALSE)
  rgl::texts3d(x[3], y[3], z[3], "sea bed", adj = c(1, -0.5), color = bed_colours[["line"]],
    cex = 0.9)
}
