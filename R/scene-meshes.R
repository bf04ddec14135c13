# What the colours of netting stand for in a picture: the tension of its twine, or how its meshes
# stand.

netting_colours <- c("tension", "mesh_opening", "mesh_angle")

check_colour <- function(colour, known = netting_colours) {
  if (is_text(colour) && colour %in% known) return(invisible())
  abort_argument("{.arg colour} is {.val {colour}}; it must be one of {.val {known}}.")
}

# The drawing of a state with netting coloured by one of `netting_colours`: list(drawing (see
# state_drawing(), the netting's `tension` being what its colours show), scales of rope and
# netting).
coloured_drawing <- function(state, colour = "tension") {
  drawing <- state_drawing(state)
  by_tension <- colour == "tension"
  if (!by_tension) {
    drawing$netting$tension <- mesh_values(state, drawing$netting, colour)
  }
  list(
    drawing = drawing,
    scales = list(
      rope = tension_scale(drawing$ropes$tension, "rope"),
      netting = if (by_tension) {
        tension_scale(drawing$netting$tension, "netting")
      } else {
        mesh_scale(drawing$netting$tension, colour)
      }
    )
  )
}

# Of lines of netting (see new_lines()) the mean of both ends, as mesh_means() has it.
mesh_values <- function(state, lines, colour) {
  mesh_means(state, lines$part - length(state$si$ropes), lines$ends, colour)
}

# Of places of netting, each among some points of one panel (ends: their numbers, a column for each
# place; panel: its number), their mean opening over mesh size, of squares over a bar (%), or mesh
# angle (deg), from all (found). Never 0, which stands for slack.
mesh_means <- function(state, panel, ends, colour, found = mesh_places(state)) {
  if (!length(panel)) return(numeric())
  panels <- state$si$panels
  table <- panel_table(panels)
  value <- if (colour == "mesh_angle") {
    in_unit(found$angle, "deg")
  } else {
    100 * (found$opening / mesh_unit(table)[found$panel])
  }
  value[is.na(value)] <- 0
  first <- !duplicated(found$row)
  row <- match(found$row, found$row[first])
  rows <- list(panel = found$panel[first], t = found$t[first], row = row, s = found$s,
    x = matrix(value, 1L))
  places <- panel_places(table, state$lattice$division, state$lattice$panels)
  at_places <- as.vector(on_rows(places, rows))
  key <- function(panel, node) panel * 1e9 + node
  at <- match(key(rep(panel, each = nrow(ends)), ends), key(places$panel, places$node))
  mean <- colMeans(matrix(at_places[at], nrow(ends)), na.rm = TRUE)
  # among points that are tied to an edge
  mean[is.nan(mean)] <- stats::median(value)
  pmax(mean, 1e-6)
}

# As tension_scale(), of what mesh_values() gives.
mesh_scale <- function(value, colour) {
  if (!length(value)) return(NULL)
  ticks <- pretty(c(0, max(value)), 5)
  list(
    colours = tension_palette("netting"), log = FALSE, per_unit = 1,
    unit = if (colour == "mesh_angle") "deg" else "%",
    words = if (colour == "mesh_angle") "Mesh angle" else "Mesh opening over mesh size",
    ticks = ticks, limits = c(0, max(ticks))
  )
}
