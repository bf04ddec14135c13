#' Plot tensions along ropes
#'
#' A figure for every role of ropes, or for every rope without one: tension against the distance from
#' the rope's start. Every second rope of a figure is dashed, so that equal ones, such as those to port
#' and to starboard, show both.
#'
#' @param x Tensions, from [tensions_along()].
#' @param file `NULL` for the current graphics device, or a file to write, ending in `.png`, `.pdf`
#'   or `.svg`. It is written whole or not at all.
#' @param width,height Size of the file's page, inches; a `height` of `NULL` fits the figures.
#' @param ... Not used.
#' @return `x`, invisibly. A wrong argument is an error of class `codend_error_argument`.
#' @export
#' @examples
#' plot(tensions_along(settle("towed_cable")))
plot.codend_rope_tensions <- function(x, file = NULL, width = 10, height = NULL, ...) {
  drawn <- rope_series(x)
  figures <- lapply(split(drawn, factor(drawn$heading, unique(drawn$heading))), function(mine) {
    list(
      words = paste(mine$heading[1L], "tension"), unit = "kN", across = "distance along the rope (m)",
      colours = rep_len(rope_colours, max(mine$group)),
      groups = mine$label[match(sort(unique(mine$group)), mine$group)],
      lines = lapply(split(mine, mine$group), function(line) {
        group <- line$group[1L]
        list(
          x = line$along_m, y = line$tension_kN, group = group, dashed = group %% 2L == 0L,
          symbols = FALSE
        )
      })
    )
  })
  plot_series(figures, rope_title(x), NULL, file, width, height)
  invisible(x)
}

# Neighbours, one solid and one dashed over it, differ most.
rope_colours <- series_palette[c(1L, 5L, 2L, 4L, 3L)]

rope_title <- function(x) {
  paste(c("Tension along ropes", attr(x, "gear_name"), attr(x, "conditions")), collapse = ", ")
}

# Tensions as lines that reach both ends of their rope, with the figure (heading) of each, and its
# number (group) and name (label) there.
rope_series <- function(x) {
  lines <- split(x, factor(x$rope, unique(x$rope)))
  drawn <- do.call(rbind, lapply(lines, function(line) {
    n <- nrow(line)
    data.frame(
      rope = line$rope[1L], heading = first_given(line$role[1L], line$rope[1L]),
      along_m = c(0, line$along_m, line$along_m[n] + line$length_m[n] / 2),
      tension_kN = line$tension_kN[c(1L, seq_len(n), n)]
    )
  }))
  # both sides of a pair follow each other
  rope <- unique(drawn$rope)
  pair <- sub("_(port|starboard)(?=_|$)", "", rope, perl = TRUE)
  order <- match(drawn$rope, rope[order(match(pair, pair))])
  drawn$group <- as.integer(stats::ave(order, drawn$heading,
    FUN = function(order) match(order, sort(unique(order)))))
  # what the heading says already
  said <- startsWith(drawn$rope, paste0(drawn$heading, "_"))
  short <- ifelse(said, substring(drawn$rope, nchar(drawn$heading) + 2L), drawn$rope)
  drawn$label <- gsub("_", " ", short)
  drawn$heading <- gsub("_", " ", drawn$heading)
  rownames(drawn) <- NULL
  drawn
}

first_given <- function(value, otherwise) if (is.na(value)) otherwise else value
