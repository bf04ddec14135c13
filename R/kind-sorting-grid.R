# Rigid sorting grids and excluders (Nordmore grids, TEDs): an oval frame with bars, laced to the
# ring of meshes behind a section.
#
# The netting ahead is longer on the side at which the grid leans aft, and shorter on the other. The
# netting behind has the reverse difference, so the frame inclines without a change of total length.

# Model bars of a grid. Each one replaces the bars of a fifth of its width.
grid_bars <- 5

# Elastic modulus (Pa) of frames and bars, typical of polyamide. The loads of a net hardly deform
# such rods; with the modulus of steel the same shape takes more iterations.
grid_modulus <- 2e9

#' Rigid grids in trawls
#'
#' The plan field `grids` of a trawl defines sorting grids and turtle excluders: an oval frame with
#' parallel bars, laced to the meshes behind the section `behind`.
#'
#' `angle` is the angle between the grid and the axis of the net. The sections ahead and behind get
#' the difference in depth between back and belly that inclines the grid by this angle. Both are
#' divided into three strips for this purpose. The measure `<name>_angle` of a state is the angle of
#' the middle bar below the horizontal. Loaded meshes close and lengthen the short sides of the
#' netting, so grids settle steeper and may roll: 48 degrees became 59 in `sorting_grid.yaml`,
#' with a roll of 13 degrees.
#'
#' The frame and five model bars have the mass of the grid, and are as stiff as polyamide rods of
#' their diameters.
#' Netting ahead of the outlet is not cut away. Use `separators` for a guiding panel.
#'
#' @section Drag and loss of flow:
#' The loss coefficient of clean, round bars is (O. Kirschmer, Mitteilungen des Hydraulischen
#' Instituts der Technischen Hochschule Muenchen 1, 1926):
#'
#' k = 1.79 (diameter / spacing)^(4/3) sin(angle)
#'
#' Water that can flow around a porous plate passes it at a fraction of the speed V (G. I. Taylor,
#' ARC Reports and Memoranda 2236, 1944):
#'
#' fraction = 1 / (1 + k / 4)
#'
#' The force on the grid is normal to its plane. On the area A of the oval it is
#'
#' F = 1/2 rho V^2 A k fraction^2
#'
#' Limits:
#'
#' - Kirschmer tested racks across a whole channel. Fish, weed and skewed flow increase the loss.
#' - If the computed angle differs from `angle`, the force changes with the square of its sine.
#' - The netting around the grid hinders the flow around it: the force is between F and F without
#'   the fraction. The netting behind the grid is not slowed.
#'
#' @seealso [gear()] for trawls in R, [settle()] for the measures.
#' @examples
#' file <- system.file("examples", "sorting_grid.yaml", package = "codend")
#' trawl <- read_gear(file)
#' measures(settle(trawl, nodes = 600))[["nordmore_angle_deg"]]
#' @name sorting_grids
NULL

# Returns the force coefficient of a rack of round bars, normal to its plane, on its area.
# `sine`: of the angle between the rack and the flow.
rack_coefficient <- function(diameter, spacing, sine) {
  loss <- 1.79 * (diameter / spacing)^(4 / 3) * sine
  loss / (1 + loss / 4)^2
}

# Returns list(length (m), area (m2), bars, top) of the oval of a grid: its circumference, and for
# each model bar its length (m) and the fraction of the circumference from the top of the oval to
# the top of the bar, in the order of the netting.
grid_oval <- function(grid) {
  height <- grid$height
  width <- first_of(grid$width, height)
  angle <- seq(-pi / 2, pi / 2, length.out = 721)
  arc <- c(0, cumsum(sqrt(diff(width * sin(angle))^2 + diff(height * cos(angle))^2) / 2))
  across <- (seq_len(grid_bars) - 0.5) / grid_bars * 2 - 1
  top <- stats::approx(angle, arc, asin(across))$y
  around <- 2 * arc[length(arc)]
  list(length = around, area = pi / 4 * height * width, bars = height * sqrt(1 - across^2),
    top = top / around - 0.25)
}

# Returns the cells ahead of a sorting grid and their fractions of the stretched circumference:
# list(ring, size (m), end), by panel. The frame starts at the starboard edge of the back.
grid_ring <- function(grid, device) {
  last <- unlist(lapply(grid$columns, rear_row, device$behind))
  ring <- stats::setNames(paste(names(last), last, sep = "_"), names(last))
  size <- vapply(grid$cells[ring], function(cell) cell$mesh_size * cell$counts$lower, 0)
  list(ring = ring, size = size, end = stats::setNames(cumsum(size) / sum(size), names(ring)))
}

# Returns a net's grid of pieces in which the pieces next to sorting grids are divided into strips,
# with the depths that incline the grids.
with_inclined_rows <- function(grid, fields) {
  for (name in names(fields$grids)) {
    device <- fields$grids[[name]]
    path <- paste0("grids.", name)
    around <- grid_ring(grid, device)
    open <- grid_oval(device)$length / sum(around$size)
    if (open >= 1) {
      abort_field(path, NULL, sprintf("a frame with a circumference of less than %s",
        format_si(sum(around$size), "length")), "is wider than the netting")
    }
    ends <- c(0, around$end)
    for (k in seq_along(around$ring)) {
      panel <- names(around$ring)[k]
      rows <- grid$columns[[panel]]
      at <- match(rear_row(rows, device$behind), rows)
      if (at == length(rows)) {
        abort_field(paste0(path, ".behind"), device$behind, "a section ahead of another section")
      }
      # Mean distance of each strip's edge forward or aft of the centre of the grid, as a fraction
      # of half the grid's height.
      arc <- 2 * pi * (seq(ends[k], ends[k + 1L], length.out = 4L) - around$end[[1L]] / 2)
      lean <- diff(sin(arc)) / diff(arc)
      if (device$outlet == "bottom") lean <- -lean
      for (shift in 0:1) {
        cell <- paste(panel, rows[at + shift], sep = "_")
        half <- device$height * cos(device$angle) / 2 / sqrt(1 - open^2)
        grid$cells[[cell]] <- strips_of(grid$cells[[cell]], half * lean * (1 - 2 * shift),
          paste0(path, ".behind"), device$behind)
      }
    }
  }
  grid
}

# Returns a cell divided into three strips, which are `longer` (stretched, m) than the cell. `path`,
# `row`: for errors.
strips_of <- function(cell, longer, path, row) {
  own <- cell$pieces[[1L]]
  plain <- length(cell$pieces) == 1L && !length(cell$covers) &&
    cell$counts$upper == cell$counts$lower && first_of(own$orientation, "diamond") == "diamond"
  if (!plain) {
    abort_field(path, row, paste(
      "a section with straight sides, diamond meshes and no covers, ahead of another such section"
    ))
  }
  deep <- cell$counts$deep + longer / cell$mesh_size
  if (min(deep) < 1) {
    abort_field(path, row, sprintf(
      "a section of more than %s meshes in depth, so that the grid leans",
      displayed_count(ceiling(cell$counts$deep - min(deep) + 1))
    ))
  }
  across <- rep(cell$counts$upper / 3, 3L)
  own$lost <- own$cutting <- NULL
  pieces <- lapply(1:3, function(k) {
    own$meshes <- list(upper = across[k], lower = across[k], deep = deep[k])
    own
  })
  names(pieces) <- paste0(cell$name, c("_left", "", "_right"))
  new_cell(pieces, cell$counts, cell$mesh_size, across = list(upper = across, lower = across))
}

# Returns list(ropes, pieces) of the sorting grids of a net's grid of pieces.
sorting_grids <- function(grid, fields) {
  ropes <- pieces <- list()
  for (name in names(fields$grids)) {
    device <- fields$grids[[name]]
    top <- grid_ring(grid, device)$end[[1L]] / 2
    oval <- grid_oval(device)
    bar <- device$bars
    # Length of all bars, and bars for each model bar.
    long <- oval$area / (bar$diameter + bar$spacing)
    each <- long / sum(oval$bars)
    volume <- c(device$frame_diameter, bar$diameter)^2
    mass <- device$mass * volume / sum(volume * c(oval$length, long))
    # A rod that replaces `number` rods has their total mass, stiffness and width.
    rod <- function(diameter, mass, number) {
      list(diameter = diameter * number, mass_per_length = mass * number,
        volume_per_length = mass * number / device$density,
        axial_stiffness = grid_modulus * pi / 4 * diameter^2 * number, role = "grid")
    }
    frame <- rod(device$frame_diameter, mass[1L], 1)
    frame$bending_stiffness <- frame$axial_stiffness * device$frame_diameter^2 / 16
    ropes[[name]] <- c(list(along = rear_edges(grid, device$behind), length = oval$length),
      frame)
    sine <- sin(device$angle)
    normal <- rack_coefficient(bar$diameter, bar$spacing, sine) * oval$area /
      (bar$diameter * long * sine^2)
    place <- function(fraction) sprintf("%s[%.9g]", name, fraction %% 1)
    for (k in seq_len(grid_bars)) {
      ropes[[paste0(name, "_bar_", k)]] <- c(
        list(from = place(top + oval$top[k]), to = place(top + 0.5 - oval$top[k]),
          length = oval$bars[k], segments = 1, carries_compression = TRUE,
          coefficients = list(normal = normal)),
        rod(bar$diameter, mass[2L], each)
      )
    }
    pieces[[paste0(name, "_floats")]] <- part_with_role(device$floats, "float", along = name,
      extent = top + c(-0.1, 0.1))
  }
  list(ropes = ropes, pieces = pieces)
}

# Returns the measures of sorting grids: the angle of the middle bar below the horizontal.
grid_measures <- function(fields) {
  middle <- (grid_bars + 1) / 2
  measures <- lapply(names(fields$grids), function(name) {
    list(angle = stats::setNames(list("declination"), sprintf("%s_bar_%d.start", name, middle)))
  })
  stats::setNames(measures, paste0(names(fields$grids), "_angle", recycle0 = TRUE))
}
