# What netting carries besides its twines: drag as a screen, and stiffness of its meshes.

# The laws of netting whose drag is a screen's.
screen_laws <- function() c("loland", "aarsnes", "kristiansen_faltinsen")

# The panel of every cell, by its number in si$panels.
cell_panel <- function(si, lattice) lattice$cell_part - length(si$ropes)

# Which of elements of these parts are of panels whose `netting_drag` is one of these.
parts_with_drag <- function(si, part, drag) {
  which((vapply(si$panels, `[[`, "", "netting_drag") %in% drag)[part - length(si$ropes)])
}
cells_with_drag <- function(si, lattice, drag) parts_with_drag(si, lattice$cell_part, drag)

# Cells, and sheets between bars, whose drag is a whole's: list(panel, node, twine, height,
# multiplicity, bars = of one family).
whole_drag_elements <- function(si, lattice, kind) {
  cells <- lattice$engine$cells
  some <- lattice$on_cell[[kind]]
  sheets <- lattice$sheets
  other <- lattice$on_sheet[[kind]]
  at <- cell_twine_places(list(twine = sheets$twine), other)
  list(
    panel = c(lattice$cell_part[some], sheets$part[other]) - length(si$ropes),
    node = c(cells$node[corners_of(some)], sheets$node[corners_of(other)]),
    twine = c(cells$twine[twine_of(some)], sheets$twine[twine_of(other)]),
    height = c(cells$height[some], sheets$height[other]),
    multiplicity = c(cells$multiplicity[some], rep(1, length(other))),
    bars = c(cell_bars(cells, some), cell_area(at$u, at$v))
  )
}

# As NettingScreens.
screen_elements <- function(si, lattice) {
  all <- whole_drag_elements(si, lattice, "screens")
  panels <- if (length(all$panel)) si$panels
  number <- function(field) vapply(panels, `[[`, 0, field, USE.NAMES = FALSE)[all$panel]
  width <- vapply(panels, twine_width, 0, USE.NAMES = FALSE)[all$panel]
  twine <- all$bars * (number("mesh_size") - number("straight_bar")) * width
  knots <- all$bars * (1 + (number("straight_bar") > 0))
  list(
    node = all$node, twine = all$twine,
    twine_area = twine + knots * pi / 4 * number("knot_diameter")^2,
    # of hexagonal netting bars meet and do not cross
    overlap = crossing_overlap(panels)[all$panel],
    # The law's Reynolds number is of one cylinder, also where two run side by side.
    diameter = number("twine_diameter"), height = all$height, multiplicity = all$multiplicity,
    law = vapply(panels, `[[`, "", "netting_drag", USE.NAMES = FALSE)[all$panel]
  )
}

# How much of its twine's share of the area each of some panels (a list) loses where its twines
# cross without a knot, over that share squared (see netting_screen.hpp). Bars of hexagons meet and
# do not cross.
crossing_overlap <- function(panels) {
  0.25 * vapply(panels, function(p) p$knot_diameter == 0 && p$straight_bar == 0, NA,
    USE.NAMES = FALSE)
}

# As BlendedNetting.
blended_elements <- function(si, lattice) {
  all <- whole_drag_elements(si, lattice, "blended")
  panels <- if (length(all$panel)) si$panels
  list(
    node = all$node, twine = all$twine,
    rest = vapply(panels, function(panel) panel$mesh_size / 2 - panel$straight_bar, 0,
      USE.NAMES = FALSE)[all$panel],
    multiplicity = all$multiplicity, height = all$height,
    overlap = crossing_overlap(panels)[all$panel],
    material = as.integer(all$panel), materials = twine_materials(panels, alone = FALSE)
  )
}

# list(node, twine, couple, angle, multiplicity), as MeshOpenings: twine coordinates in m.
opening_elements <- function(si, lattice) {
  cells <- lattice$engine$cells
  sheets <- lattice$sheets
  stiffness <- lapply(si$panels, `[[`, "opening_stiffness")
  stiff <- !vapply(stiffness, is.null, NA)
  some <- which(stiff[cell_panel(si, lattice)])
  # netting of bars has the couples of its knots on the sheets between them
  other <- which(stiff[sheets$part - length(si$ropes)])
  panel <- c(lattice$cell_part[some], sheets$part[other]) - length(si$ropes)
  number <- function(field) {
    of <- numeric(length(stiff))
    of[stiff] <- vapply(stiffness[stiff], `[[`, 0, field, USE.NAMES = FALSE)
    of[panel]
  }
  turned <- vapply(si$panels, `[[`, "", "orientation")[panel] == "turned"
  angle <- number("angle")
  angle[turned] <- pi - angle[turned]
  rest <- c(cells$rest[some], bar_lengths(si)[panel[length(some) + seq_along(other)]])
  list(
    node = c(cells$node[corners_of(some)], sheets$node[corners_of(other)]),
    twine = c(cells$twine[twine_of(some)], sheets$twine[twine_of(other)]) * rep(rest, each = 8L),
    couple = number("couple"), angle = angle,
    multiplicity = c(cells$multiplicity[some], rep(1, length(other))) / rest^2
  )
}

# Of every panel, from knot to knot but for straight bars.
bar_lengths <- function(si) {
  vapply(si$panels, function(p) p$mesh_size / 2 - p$straight_bar, 0, USE.NAMES = FALSE)
}

# Places of cells' numbers in arrays of four corners and of eight twine coordinates each.
corners_of <- function(cell) rep(4L * (cell - 1L), each = 4L) + seq_len(4L)
twine_of <- function(cell) rep(8L * (cell - 1L), each = 8L) + seq_len(8L)

# The start with the inner nodes of hexagonal triangles where their bars would lie if all were
# stretched alike: from the triangle's middle along the mean of its two base vectors.
place_inner_nodes <- function(lattice) {
  start <- lattice$start
  cells <- lattice$engine$cells
  some <- which(cells$inner > 0L)
  if (!length(some)) return(start)
  at <- 8L * (some - 1L)
  twine <- function(k) cells$twine[at + k]
  corner <- function(k) start[, cells$node[4L * (some - 1L) + k], drop = FALSE]
  u2 <- twine(3L) - twine(1L)
  v2 <- twine(4L) - twine(2L)
  u3 <- twine(5L) - twine(1L)
  v3 <- twine(6L) - twine(2L)
  d <- u2 * v3 - u3 * v2
  second <- corner(2L) - corner(1L)
  third <- corner(3L) - corner(1L)
  # e_u + e_v
  both <- second * rep((v3 - u3) / d, each = 3L) + third * rep((u2 - v2) / d, each = 3L)
  share <- cells$straight[some] / (cells$straight + cells$rest)[some] / 2
  middle <- (corner(1L) + corner(2L) + corner(3L)) / 3
  start[, cells$inner[some]] <- middle + both * rep(share, each = 3L)
  start
}
