#' Plot coefficients of forces
#'
#' Lines: what the engine computes, by angle or by Reynolds number; points: what is published. One
#' row of figures for each force (netting: for each solidity), with its laws next to them.
#'
#' @param x Coefficients, from [force_coefficients()].
#' @param force Which forces: any of `"twine"`, `"netting"`, `"otter_board"`, `"kite"`, `"sphere"`
#'   and `"wake"`; all when `NULL`.
#' @inherit plot.codend_sensitivities params return
#' @examples
#' plot(force_coefficients(), force = "wake")
#' @export
plot.codend_coefficients <- function(x, force = NULL, file = NULL, width = 9, height = NULL, ...) {
  force <- chosen_some(force, unique(x$force))
  table <- as.data.frame(x)
  class(table) <- "data.frame"
  rows <- coefficient_figures(table[table$force %in% force, ])
  show_picture(x, function(page) draw_coefficients(rows), file, width, height, "Coefficients",
    coefficient_row_height * length(rows))
}

coefficient_row_height <- 2.6

# What is drawn: a list of rows, each list(title, figures = list of list(table, label, log), laws).
coefficient_figures <- function(table) {
  words <- c(
    twine = "Twines and ropes", netting = "Netting", otter_board = "Otter boards and plates",
    kite = "Kites", sphere = "Knots and floats", wake = "Speed behind netting"
  )
  rows <- list()
  add <- function(title, some, labels) {
    figures <- lapply(names(labels), function(name) {
      list(table = some[some$figure == name, ], label = labels[[name]])
    })
    rows[[length(rows) + 1L]] <<- list(
      title = title, figures = Filter(function(f) nrow(f$table) > 0, figures),
      laws = unique(some$law)
    )
  }
  both <- c(drag = "drag coefficient", lift = "lift coefficient")
  for (force in intersect(names(words), table$force)) {
    of <- table[table$force == force, ]
    angle <- of[of$by == "angle", ]
    angle$figure <- angle$coefficient
    if (force == "twine") {
      add(paste0(words[[force]], ", by their angle to the flow"), angle, both)
      reynolds <- of[of$by == "reynolds", ]
      reynolds$figure <- "across"
      add(paste0(words[[force]], ", by Reynolds number"), reynolds,
        c(across = "drag coefficient across the flow"))
    } else if (force == "sphere") {
      of$figure <- "drag"
      add(words[[force]], of, both["drag"])
    } else if (force %in% c("netting", "wake")) {
      for (solidity in unique(angle$solidity)) {
        add(sprintf("%s of solidity %s, by the angle of its normal to the flow", words[[force]],
          format(solidity)), angle[angle$solidity == solidity, ],
          c(both, speed = "speed over that of the free flow"))
      }
    } else {
      add(paste0(words[[force]], ", by angle of attack"), angle, both)
    }
  }
  rows
}

# Okabe and Ito's, which most colour-blind readers tell apart, darkest first; lines differ in type
# too.
law_colours <- c(
  "#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7F7F7F"
)

draw_coefficients <- function(rows) {
  kept <- graphics::par(no.readonly = TRUE)
  on.exit(graphics::par(kept))
  # A row of one figure gives it the room of two.
  cells <- matrix(0, length(rows), 3L)
  number <- 0
  for (k in seq_along(rows)) {
    n <- length(rows[[k]]$figures)
    cells[k, ] <- number + if (n == 1L) c(1, 1, 2) else 1:3
    number <- max(cells)
  }
  graphics::layout(cells, widths = c(1, 1, 0.62))
  graphics::par(cex = 0.75, mgp = c(1.6, 0.4, 0), tcl = -0.25, las = 1, family = "sans",
    bg = "white")
  for (row in rows) {
    style <- data.frame(
      law = row$laws, colour = rep_len(law_colours, length(row$laws)),
      type = rep_len(c(1, 2, 4, 5, 6, 3), length(row$laws)),
      point = rep_len(c(1, 2, 0, 5, 6, 4), length(row$laws))
    )
    for (figure in row$figures) draw_coefficient(figure, style)
    draw_laws(style, row)
  }
}

draw_coefficient <- function(figure, style) {
  table <- figure$table
  by_reynolds <- table$by[1] == "reynolds"
  across <- if (by_reynolds) table$reynolds else table$angle_deg
  shown <- !by_reynolds | table$value > 1e-3
  graphics::par(mar = c(2.6, 3.4, 1.8, 0.6))
  graphics::plot.new()
  graphics::plot.window(range(across[shown]), range(if (by_reynolds) NULL else 0,
    table$value[shown]), log = if (by_reynolds) "xy" else "")
  quiet_grid()
  for (k in seq_len(nrow(style))) {
    of <- shown & table$law == style$law[k]
    line <- of & is.na(table$source)
    order <- order(across[line])
    graphics::lines(across[line][order], table$value[line][order], col = style$colour[k],
      lty = style$type[k], lwd = 1.6)
    point <- of & !is.na(table$source)
    graphics::points(across[point], table$value[point], col = style$colour[k],
      pch = style$point[k], cex = 0.9)
  }
  if (by_reynolds) {
    quiet_axis(1, 10^(-2:7), c("0.01", "0.1", "1", "10", "100", "1000", paste0("1e", 4:7)))
  } else {
    quiet_axis(1, seq(0, 90, 15))
  }
  quiet_axis(2)
  graphics::box(col = "grey40")
  graphics::title(xlab = if (by_reynolds) "Reynolds number" else "angle (deg)")
  figure_heading(figure$label)
}

draw_laws <- function(style, row) {
  graphics::par(mar = c(2.6, 0.4, 1.8, 0.2))
  graphics::plot.new()
  tables <- do.call(rbind, lapply(row$figures, `[[`, "table"))
  has <- function(published) style$law %in% tables$law[is.na(tables$source) != published]
  graphics::text(0, 1, paste(strwrap(row$title, 30), collapse = "\n"), adj = c(0, 1), font = 2,
    xpd = NA)
  graphics::legend(0, 0.86 - 0.06 * length(strwrap(row$title, 30)), gsub("_", " ", style$law),
    col = style$colour, lty = ifelse(has(FALSE), style$type, NA),
    pch = ifelse(has(TRUE), style$point, NA), lwd = 1.6, bty = "n", xjust = 0, seg.len = 2.6,
    xpd = NA)
}
