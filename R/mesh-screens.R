# Netting forces in addition to its twines: screen drag.

# Returns the panel of every cell, as an index in si$panels.
cell_panel <- function(si, mesh) mesh$cell_part - length(si$ropes)

# Returns the cells of panels whose `netting_drag` is in `drag`.
cells_with_drag <- function(si, mesh, drag) {
  which((vapply(si$panels, `[[`, "", "netting_drag") %in% drag)[cell_panel(si, mesh)])
}

# Returns the overlap coefficient of crossings without knots: area fraction counted twice, over the
# squared twine area fraction (see base/solidity.hpp). Bars of hexagons meet and do not cross.
crossing_overlap <- function(panel) {
  0.25 * (panel$knot_diameter == 0 && panel$straight_bar == 0)
}
