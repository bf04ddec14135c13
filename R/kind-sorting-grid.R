# Rigid sorting grids and excluders (Nordmore grids, TEDs): an oval frame with bars, laced along a
# slanted cut through the netting between two sections.

# Model bars of a grid. Each one replaces the bars of a fifth of its width.
grid_bars <- 5

# Elastic modulus (Pa) of frames and bars: aluminium. The loads of a net hardly deform such rods.
grid_modulus <- 7e10

#' Rigid grids in trawls
#'
#' The plan field `grids` of a trawl defines sorting grids and turtle excluders: an oval frame with
#' parallel bars, laced to the meshes behind the section `behind`.
#'
#' `angle` is the angle between the grid and the axis of the net. The grid is laced in a slanted cut
#' through the netting, which leaves the total depth of both sections unchanged. The cut is straight
#' across the middle third of the back and of the belly. Its depth gives the grid this angle in taut
#' netting. The measure `<name>_angle` of a state is the angle of the middle bar below the
#' horizontal.
#'
#' Floats at the top of a grid that leans aft make it steeper. The flow presses a grid with
#' `outlet: top` down. If its floats do not carry this force and its weight, the grid stands on the
#' seabed and rolls. A grid with `outlet: bottom` needs fewer floats.
#'
#' The frame and five model bars have the mass of the grid, and are as stiff as aluminium rods of
#' their diameters. Netting ahead of the outlet is not cut away. Use `separators` for a guiding
#' panel.
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

# Returns list(length (m), area (m2), bars, top) of the oval of a grid. `length`: its circumference.
# `bars`: length (m) of each model bar. `top`: fraction of the circumference from the top of the
# oval to the top of each bar, in the order of the netting.
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

# Fraction of each panel's width across which the cut is straight. A plane cuts a round net along a
# sine curve. The straight cut in the middle and the slanted cuts at the sides follow this curve
# within 9 % of its height.
grid_straight <- 1 / 3

# Distance of the straight cut from the side seams (stretched), as a fraction of the distance of
# the top or bottom of the grid from its middle along the net. Taut netting pulls the frame inward
# and flattens the grid. The inverse was 1.07 to 1.18 in settled grids. They had heights of 0.9 m to
# 1.8 m, angles of 20 to 65 degrees and hanging ratios of 0.3 to 0.67 at the frame.
grid_depth <- 1 / 1.15

# Returns the net's grid of pieces with two rows for each sorting grid. With `outlet: top` they are
# at the rear of the belly of the section ahead and at the front of the back of the section behind.
# The slanted cuts between the netting ahead and behind divide a row into three pieces.
with_grid_rows <- function(grid, fields) {
  for (name in names(fields$grids)) {
    device <- fields$grids[[name]]
    path <- paste0("grids.", name)
    cells <- grid_cells(grid, device, path)
    around <- sum(vapply(cells$ahead, cell_width, 0))
    if (grid_oval(device)$length >= around) {
      abort_field(path, NULL, sprintf("a frame with a circumference of less than %s",
        format_si(around, "length")), "is wider than the netting")
    }
    depth <- grid_depth * device$height * cos(device$angle) / 2
    for (panel in names(cells$ahead)) {
      own <- lapply(cells, `[[`, panel)
      aft <- (panel == "back") == (device$outlet == "top")
      short <- if (aft) "behind" else "ahead"
      if (own[[short]]$counts$deep * own[[short]]$mesh_size <= depth) {
        abort_field(paste0(path, ".behind"), device$behind, sprintf(
          "a section of more than %s meshes in depth, ahead of another such section",
          displayed_count(ceiling(depth / own[[short]]$mesh_size))
        ))
      }
      row <- paste(cells$rows[[short]], name, sep = "_")
      cell <- paste(panel, c(cells$rows[[short]], row), sep = "_")
      grid$cells[[cell[2L]]] <- grid_row(own$ahead, own$behind, cell[2L], depth, aft)
      own[[short]]$counts$deep <- own[[short]]$counts$deep - depth / own[[short]]$mesh_size
      own[[short]]$pieces[[1L]]$meshes$deep <- own[[short]]$counts$deep
      grid$cells[[cell[1L]]] <- own[[short]]
      rows <- grid$columns[[panel]]
      names(rows) <- whole_rows(rows)
      at <- match(cells$rows[[short]], rows)
      grid$columns[[panel]] <- append(rows, stats::setNames(row, names(rows)[at]), at - aft)
    }
  }
  grid
}

cell_width <- function(cell) cell$mesh_size * cell$counts$upper

# Returns list(rows, ahead, behind): the rows ahead of and behind a sorting grid, and their cells by
# panel. Throws an error if a grid cannot be laced between them.
grid_cells <- function(grid, device, path) {
  panels <- names(Filter(function(rows) device$behind %in% whole_rows(rows), grid$columns))
  rows <- grid$columns$back
  at <- match(device$behind, rows)
  plain <- function(cell) {
    length(cell$pieces) == 1L && !length(cell$covers) && cell$counts$upper == cell$counts$lower &&
      first_of(cell$pieces[[1L]]$orientation, "diamond") == "diamond"
  }
  rows <- list(ahead = rows[at], behind = rows[at + 1L])
  cells <- lapply(rows, function(row) {
    stats::setNames(grid$cells[paste(panels, row, sep = "_")], panels)
  })
  if (!setequal(panels, c("back", "belly")) || anyNA(unlist(rows)) ||
    !all(vapply(unlist(cells, FALSE), plain, NA))) {
    abort_field(paste0(path, ".behind"), device$behind, paste(
      "a section of two panels with straight sides, diamond meshes and no covers, ahead of another",
      "such section"
    ))
  }
  c(list(rows = rows), cells)
}

# Returns the row of a panel that the slanted cuts of a sorting grid divide. `ahead`, `behind`: the
# cells of its netting. `depth`: its depth (stretched, m). `aft`: TRUE if the netting ahead is in
# the middle of the row, and the frame is aft of the seams.
grid_row <- function(ahead, behind, name, depth, aft) {
  # `left`, `right`: slants of the edges, as fractions of the cut at one side.
  part <- function(cell, left, upper, right) {
    piece <- cell$pieces[[1L]]
    across <- cell$counts$upper
    piece$cutting <- NULL
    piece$lost <- list(left = left * side * across, right = right * side * across)
    piece$meshes <- list(upper = upper * across, lower = (upper - (left + right) * side) * across,
      deep = depth / cell$mesh_size)
    # The sides of the frame have as many elements.
    piece$rows <- 3L
    piece
  }
  side <- (1 - grid_straight) / 2
  pieces <- if (aft) {
    list(part(behind, 0, 0, -1), part(ahead, 1, 1, 1), part(behind, -1, 0, 0))
  } else {
    list(part(ahead, 0, side, 1), part(behind, -1, grid_straight, -1), part(ahead, 1, side, 0))
  }
  names(pieces) <- paste0(name, c("_left", "", "_right"))
  parts <- list(c(0, 1, 0), c(side, grid_straight, side))
  own <- if (aft) behind else ahead
  counts <- pieces[[1L]]$meshes
  counts[c("upper", "lower")] <- own$counts$upper
  new_cell(pieces, counts, own$mesh_size,
    across = stats::setNames(parts, if (aft) c("upper", "lower") else c("lower", "upper")))
}

# Returns list(edges, fractions (of the frame), top) of the ring of meshes at a sorting grid, from
# the port end of the back. `top`: fraction of the frame at the top of the oval.
grid_ring <- function(grid, name, device) {
  edges <- lapply(c(back = "back", belly = "belly"), function(panel) {
    rows <- grid$columns[[panel]]
    piece <- paste(panel, rows[endsWith(rows, paste0("_", name))], sep = "_")
    aft <- (panel == "back") == (device$outlet == "top")
    middle <- paste0(piece, if (aft) ".lower" else ".upper")
    way <- if (aft) c("", "-") else c("-", "")
    side <- paste0(way, piece, c("_left.right", "_right.left"))
    c(side[1L], middle, side[2L])
  })
  width <- vapply(names(edges), function(panel) {
    cell_width(grid$cells[[paste(panel, device$behind, sep = "_")]])
  }, 0)
  side <- (1 - grid_straight) / 2
  fractions <- unlist(lapply(unname(width / sum(width)), `*`, c(side, grid_straight, side)))
  list(edges = unlist(edges, use.names = FALSE), fractions = fractions,
    top = sum(fractions[1:3]) / 2)
}

# Returns list(ropes, pieces) of the sorting grids of a net's grid of pieces.
sorting_grids <- function(grid, fields) {
  ropes <- pieces <- list()
  for (name in names(fields$grids)) {
    device <- fields$grids[[name]]
    ring <- grid_ring(grid, name, device)
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
    ropes[[name]] <- c(list(along = ring$edges, lengths = oval$length * ring$fractions), frame)
    sine <- sin(device$angle)
    normal <- rack_coefficient(bar$diameter, bar$spacing, sine) * oval$area /
      (bar$diameter * long * sine^2)
    place <- function(fraction) sprintf("%s[%.9g]", name, fraction %% 1)
    for (k in seq_len(grid_bars)) {
      ropes[[paste0(name, "_bar_", k)]] <- c(
        list(from = place(ring$top + oval$top[k]), to = place(ring$top + 0.5 - oval$top[k]),
          length = oval$bars[k], segments = 1, carries_compression = TRUE,
          coefficients = list(normal = normal)),
        rod(bar$diameter, mass[2L], each)
      )
    }
    pieces[[paste0(name, "_floats")]] <- part_with_role(device$floats, "float", along = name,
      extent = ring$top + c(-0.1, 0.1))
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
