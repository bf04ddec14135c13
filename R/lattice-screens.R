# What netting carries besides its twines: drag as a screen.

# The panel of every cell, by its number in si$panels.
cell_panel <- function(si, lattice) lattice$cell_part - length(si$ropes)

# Which cells are of panels whose `netting_drag` is one of these.
cells_with_drag <- function(si, lattice, drag) {
  which((vapply(si$panels, `[[`, "", "netting_drag") %in% drag)[cell_panel(si, lattice)])
}

# How much of its twine's share of the area a panel loses where its twines cross without a knot,
# over that share squared (see base/solidity.hpp). Bars of hexagons meet and do not cross.
crossing_overlap <- function(panel) {
  0.25 * (panel$knot_diameter == 0 && panel$straight_bar == 0)
}
