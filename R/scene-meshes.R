netting_colours <- c("tension", "mesh_opening", "mesh_angle")

# Returns the drawing of a state with its netting coloured by an element of `netting_colours`:
# list(drawing, scales). In `drawing` (see `state_drawing()`) the netting's `tension` is the
# coloured quantity.
coloured_drawing <- function(state, colour = "tension") {
  drawing <- state_drawing(state)
  by_tension <- colour == "tension"
  if (!by_tension) {
    netting <- drawing$netting
    drawing$netting$tension <- mesh_means(state, netting$part - length(state$si$ropes),
      netting$ends, colour)
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

# Returns the mean opening or angle of meshes at locations in netting. The opening is relative to
# the mesh size, for square meshes to the bar (%); the angle is in deg. The result is never 0, which
# means slack. `panel`: number of the panel of each location. `ends`: points of each location, a
# column each. `found`: result of `mesh_places()`.
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
  # Locations with only points tied to an edge have no mean.
  mean[!seq_along(mean) %in% of$row] <- stats::median(value)
  pmax(mean, 1e-6)
}

# Returns the weights with which `mesh_means()` averages meshes at locations in netting: a sparse
# matrix as row, column and weight.
mesh_mean_terms <- function(state, panel, ends) {
  meshes <- state$mesh$model$frame$meshes
  rows <- list(panel = meshes$row_panel, t = meshes$row_t, row = meshes$row + 1L, s = meshes$s)
  places <- panel_places(
    panel_table(state$si$panels), state$mesh$division, state$mesh$panels
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
