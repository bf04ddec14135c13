# The panels of a gear as one table, so that the mesh of all netting is built at once.

# Returns columns with one element per panel: the fields that every panel of `gear_si()` has.
panel_table <- remembered(new_panel_table)

new_panel_table <- function(panels) {
  numbers <- c(
    "mesh_size", "upper", "lower", "deep", "lost_left", "lost_right", "mass_per_length",
    "volume_per_length", "twine_diameter", "twine_count", "knot_diameter", "knot_twine",
    "straight_bar"
  )
  field <- function(name, of) vapply(panels, `[[`, of, name, USE.NAMES = FALSE)
  c(lapply(setNames(nm = numbers), field, 0), list(orientation = field("orientation", "")))
}

# Returns the width of a panel's twine across the flow, m: the sum over parallel twines.
twine_width <- function(panel) panel$twine_diameter * panel$twine_count

is_square <- function(panel) panel$orientation == "square"

# Returns the planned number of bars per family in a panel, which equals the number of knots.
panel_bars <- function(panel) {
  (panel$upper + panel$lower) / 2 * panel$deep * (2 - is_square(panel))
}

# Returns the length of twine (m) for each such bar, which is the twine of one netting cell.
cell_twine <- function(panel) panel$mesh_size - panel$straight_bar

# Returns the same length with the twine in knots, m. A diamond or square cell has one knot. A
# hexagonal cell has two joins of three bars, each counted as half a knot.
cell_twine_with_knots <- function(panel) cell_twine(panel) + panel$knot_twine

side_fields <- c("upper", "lower", "deep", "lost_left", "lost_right")

# Returns the position of the left or right side of a panel at depth j (meshes), in meshes across.
panel_left <- function(panel, j) {
  panel$lost_left * j / panel$deep
}

panel_right <- function(panel, j) {
  panel$upper - panel$lost_right * j / panel$deep
}
