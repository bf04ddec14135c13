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
  value <- if (colour == "mesh_angle") {
    in_unit(found$angle, "deg")
  } else {
    panels <- panel_table(state$si$panels)
    100 * (found$opening / (panels$mesh_size / (1 + is_square(panels)))[found$panel])
  }
  value[is.na(value)] <- 0
  of <- mesh_mean_terms(state, panel, ends)
  mean <- sum_by(of$weight * value[of$column], of$row, of$rows)
  # among points that are tied to an edge
  mean[!seq_along(mean) %in% of$row] <- stats::median(value)
  pmax(mean, 1e-6)
}

# How mesh_means() takes what places of netting show from all places of meshes: a sparse matrix of
# rows, as row, column and weight of what is in it.
mesh_mean_terms <- function(state, panel, ends) {
  meshes <- state$lattice$mesh$frame$meshes
  rows <- list(panel = meshes$row_panel, t = meshes$row_t, row = meshes$row + 1L, s = meshes$s)
  places <- panel_places(
    panel_table(state$si$panels), state$lattice$division, state$lattice$panels
  )
  on <- rows_at(places, rows)
  key <- function(panel, node) panel * 1e9 + node
  at <- match(key(rep(panel, each = nrow(ends)), ends), key(places$panel, places$node))
  place <- rep(seq_len(ncol(ends)), each = nrow(ends))[!is.na(at)]
  at <- at[!is.na(at)]
  share <- (1 / tabulate(place, ncol(ends)))[place]
  list(
    row = rep(place, 4L),
    column = c(on$before$low[at], on$before$high[at], on$after$low[at], on$after$high[at]),
    weight = share * c(
      (1 - on$share[at]) * (1 - on$before$share[at]), (1 - on$share[at]) * on$before$share[at],
      on$share[at] * (1 - on$after$share[at]), on$share[at] * on$after$share[at]
    ),
    rows = ncol(ends)
  )
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
