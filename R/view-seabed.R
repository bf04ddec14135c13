# The sea bed in a view from the side or from astern: a line with the ground below it.

# axes: of the view; usr: its limits [m]; up: its height on the page [inch].
draw_bed <- function(bed, axes, usr, up) {
  if (is.null(bed) || axes[2] != 3L) return(invisible())
  ends <- matrix(bed$middle, 2L, 2L)
  ends[axes[1], ] <- usr[1:2]
  height <- bed_heights(bed, ends)
  if (min(height) > usr[4] || max(height) < usr[3]) return(invisible())
  # below the view, so that the lower edge is hidden
  deep <- min(height, usr[3]) - diff(usr[3:4])
  graphics::polygon(usr[c(1, 2, 2, 1)], c(height, deep, deep), col = bed_colours[["ground"]],
    border = NA)
  graphics::segments(usr[1], height[1], usr[2], height[2], col = bed_colours[["line"]])
  below <- height[1] - usr[3] > 0.16 * diff(usr[3:4]) / up
  graphics::text(usr[1], height[1], " sea bed", adj = c(0, if (below) 1.35 else -0.35),
    col = bed_colours[["line"]], cex = 0.75)
}
