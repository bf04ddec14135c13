# The panels of a gear as one table, so that the lattice of all netting is made at once.

# Returns a list of columns with an element per panel: the fields of `gear_si()`'s panels that every
# plan gives.
panel_table <- remembered(new_panel_table)

new_panel_table <- function(panels) {
  numbers <- c(
    "mesh_size", "upper", "lower", "deep", "taper_left", "taper_right", "mass_per_length",
    "volume_per_length", "twine_diameter", "twine_count", "knot_diameter", "knot_twine",
    "straight_bar"
  )
  field <- function(name, of) vapply(panels, `[[`, of, name, USE.NAMES = FALSE)
  c(lapply(setNames(nm = numbers), field, 0), list(orientation = field("orientation", "")))
}

# Width of a panel's twine across the flow, m: of all that run side by side.
twine_width <- function(panel) panel$twine_diameter * panel$twine_count

is_square <- function(panel) panel$orientation == "square"

# Bars of one family in a panel (as many of the other), and knots, in the plan.
panel_bars <- function(panel) {
  (panel$upper + panel$lower) / 2 * panel$deep * (2 - is_square(panel))
}

# Twine of a panel for each of these bars, m: that of one cell of its netting.
cell_twine <- function(panel) panel$mesh_size - panel$straight_bar

# The same with what its knots take, m: a diamond or square cell has one knot. Three bars meet in
# each of the two joins of a hexagonal cell, which are taken as half a knot.
cell_twine_with_knots <- function(panel) cell_twine(panel) + panel$knot_twine

# Fields that place a panel's sides.
side_fields <- c("upper", "lower", "deep", "taper_left", "taper_right")

# Where the left and the right side of a panel lie at a depth of j meshes, in meshes across.
panel_left <- function(panel, j) {
  panel$taper_left * (panel$upper - panel$lower) * j / panel$deep
}

panel_right <- function(panel, j) {
  panel$upper - panel$taper_right * (panel$upper - panel$lower) * j / panel$deep
}
