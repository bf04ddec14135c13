#' Plot the meshes along a net
#'
#' Two figures against distance aft: the mean opening of the meshes as a share of their size, and
#' the mean angle between their bars. Each line is what lies between two seams along the net, such
#' as the back or the belly, through all parts.
#'
#' @param x Meshes, from [mesh_openings()].
#' @inheritParams plot.codend_rope_tensions
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @export
#' @examples
#' plot(mesh_openings(settle("t90_codend")))
plot.codend_mesh_openings <- function(x, file = NULL, width = 10, height = NULL, ...) {
  side <- mesh_sides(x)
  labels <- unique(side)
  apart <- length(labels) <= most_ropes
  figure <- function(words, unit, field) {
    known <- which(!is.na(x[[field]]) & x$meshes_across > 0)
    lines <- lapply(split(known, factor(x$panel[known], unique(x$panel[known]))), function(k) {
      group <- if (apart) match(side[k[1L]], labels) else 1L
      list(
        x = x$x_m[k], y = x[[field]][k], group = group, dashed = apart && group %% 2L == 0L,
        symbols = FALSE
      )
    })
    list(
      words = words, unit = unit, across = "distance aft (m)",
      colours = rep_len(rope_colours, if (apart) length(labels) else 1L),
      groups = if (apart) gsub("_", " ", labels), lines = unname(lines)
    )
  }
  figures <- list(
    figure("mesh opening over mesh size", "%", "opening_percent"),
    figure("mesh angle", "deg", "mesh_angle_deg")
  )
  title <- paste(c("Meshes along the net", attr(x, "gear_name"), attr(x, "conditions")),
    collapse = ", ")
  plot_series(x, figures, title, NULL, file, width, height)
}

# Which line along the net every row belongs to: its panel's name without that of its part, a wing
# with the panel that it is joined to.
mesh_sides <- function(x) {
  out <- mapply(function(panel, part) {
    if (nzchar(part)) sub(paste0("_?", part, "$"), "", panel) else panel
  }, x$panel, x$part, USE.NAMES = FALSE)
  sub("_(wing|jib)(_(left|right))?$", "", ifelse(nzchar(out), out, x$panel))
}
