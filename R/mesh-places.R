# Positions on panels, as fractions across and deep, and interpolation between rows of positions.

# Returns the positions of nodes on panels: list(node, panel, s, t = fractions across, deep).
panel_places <- function(panels, division, drawn) {
  bars <- vapply(drawn, function(panel) panel$netting == "bars", NA)
  on_grids <- grid_places(division)
  if (!any(bars)) return(on_grids)

  edge <- rep.int(seq_along(division$count), division$count)
  panel <- (edge - 1L) %/% 4L + 1L
  of_bars <- bars[panel]
  side <- ((edge - 1L) %% 4L + 1L)[of_bars]
  f <- division$fraction[of_bars]
  on_edges <- list(
    node = division$edge_node[of_bars], panel = panel[of_bars],
    s = ifelse(side <= 2L, f, side - 3), t = ifelse(side <= 2L, side - 1, f)
  )

  inside <- bar_places(panels, which(bars), drawn)
  own <- inside$node > division$nodes
  mapply(c, on_grids, on_edges, lapply(inside[names(on_grids)], `[`, own), SIMPLIFY = FALSE)
}

# Returns the positions of the nodes of grids (panels of cells), in the same form.
grid_places <- function(division) {
  size <- lengths(division$grids)
  panel <- rep.int(seq_along(size), size)
  columns <- division$count[4L * panel - 3L]
  k <- sequence(size) - 1L
  list(
    node = as.integer(unlist(division$grids)), panel = panel,
    s = division$fraction[division$before[4L * panel - 3L] + k %% columns + 1L],
    t = division$fraction[division$before[4L * panel - 1L] + k %/% columns + 1L]
  )
}

# Returns the positions of all knots and bar nodes of panels, with their mesh coordinates i and j.
bar_places <- function(panels, numbers, drawn) {
  field <- function(name) unlist(lapply(drawn[numbers], `[[`, name), use.names = FALSE)
  panel <- rep.int(numbers, lengths(lapply(drawn[numbers], `[[`, "node")))
  j <- field("j")
  shape <- lapply(panels[side_fields], `[`, panel)
  left <- panel_left(shape, j)
  width <- panel_right(shape, j) - left
  width[width < 1e-9] <- 1e-9
  s <- (field("i") - left) / width
  list(
    node = field("node"), panel = panel, s = pmin(pmax(s, 0), 1), t = j / shape$deep,
    i = field("i"), j = j
  )
}

# Returns the interpolation of positions between rows. `before`, `after`: neighbours and weight
# along the row before and after; `share`: weight between the two rows.
rows_at <- function(places, rows) {
  row <- between_values(places$panel, places$t, rows$panel, rows$t)
  along <- function(row) between_values(row, places$s, rows$row, rows$s)
  list(before = along(row$low), after = along(row$high), share = row$share)
}

# Returns the two neighbours of x (0 to 1) within its group: list(low, high = indices, share =
# weight of `high`). `groups` (integers) and `values` must be sorted, and must contain every
# requested group.
between_values <- function(group, x, groups, values) {
  low <- findInterval(2 * group + x, 2 * groups + values)
  low <- pmax(low, match(group, groups))
  high <- pmin(low + 1L, length(groups))
  beyond <- groups[high] != group
  high[beyond] <- low[beyond]
  width <- values[high] - values[low]
  share <- pmin(pmax((x - values[low]) / pmax(width, 1e-12), 0), 1)
  list(low = low, high = high, share = share)
}
