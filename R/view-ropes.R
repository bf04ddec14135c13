#' Plot tensions along ropes
#'
#' A figure for every role of ropes, or for every rope without one: tension against the distance
#' from the rope's start. Every second rope of a figure is dashed, so that equal ones, such as those
#' to port and to starboard, show both.
#'
#' @param x Tensions, from [tensions_along()].
#' @inherit plot.codend_sensitivities params return
#' @export
#' @examples
#' plot(tensions_along(settle("towed_cable")))
plot.codend_rope_tensions <- function(x, file = NULL, width = 10, height = NULL, ...) {
  drawn <- rope_series(x)
  figures <- lapply(split(drawn, factor(drawn$heading, unique(drawn$heading))), rope_figure)
  title <- c("Tension along ropes", attr(x, "gear_name"), attr(x, "conditions"))
  plot_series(x, figures, paste(title, collapse = ", "), NULL, file, width, height)
}

# Neighbours, one solid and one dashed over it, differ most.
rope_colours <- series_palette[c(1L, 5L, 2L, 4L, 3L)]

# More ropes than these in one figure are not told apart.
most_ropes <- 8L

rope_figure <- function(mine) {
  n <- max(mine$group)
  apart <- n <= most_ropes
  unit <- if (max(mine$tension_kN) < 0.1) "N" else "kN"
  list(
    words = paste0(mine$heading[1L], " tension", if (!apart) sprintf(", %d ropes", n)),
    unit = unit,
    across = "distance along the rope (m)", colours = rep_len(rope_colours, n),
    groups = if (apart) mine$label[match(seq_len(n), mine$group)],
    lines = lapply(split(mine, mine$group), function(line) {
      group <- line$group[1L]
      list(
        x = line$along_m, y = in_unit(from_unit(line$tension_kN, "kN"), unit),
        group = if (apart) group else 1L,
        dashed = apart && group %% 2L == 0L, symbols = FALSE
      )
    })
  )
}

# Tensions of lines that reach both ends, with the figure (heading) of each, and its number (group)
# and name (label) there.
rope_series <- function(x) {
  lines <- split(x, factor(x$line, unique(x$line)))
  drawn <- do.call(rbind, lapply(lines, function(line) {
    n <- nrow(line)
    data.frame(
      line = line$line[1L], heading = stats::na.omit(c(line$role[1L], line$line[1L]))[1L],
      along_m = c(0, line$along_m, line$along_m[n] + line$length_m[n] / 2),
      tension_kN = line$tension_kN[c(1L, seq_len(n), n)]
    )
  }))
  # both sides of a pair follow each other
  line <- unique(drawn$line)
  pair <- sub("_(port|starboard)(?=_|$)", "", line, perl = TRUE)
  order <- match(drawn$line, line[order(match(pair, pair))])
  drawn$group <- as.integer(stats::ave(order, drawn$heading,
    FUN = function(order) match(order, sort(unique(order)))))
  # what the heading says already
  said <- startsWith(drawn$line, paste0(drawn$heading, "_"))
  short <- ifelse(said, substring(drawn$line, nchar(drawn$heading) + 2L), drawn$line)
  drawn$label <- gsub("_", " ", short)
  drawn$heading <- gsub("_", " ", drawn$heading)
  table_rows(drawn)
}
