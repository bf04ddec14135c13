# Quantities of each snapshot besides positions and velocities. Arrays, engine output and files use
# this table.
#
# `name`: array of the trajectory. `field`, `within`: field of the snapshot and its list ("" for
# none). `variable`, `across`, `unit`, `words`: name, dimension, unit and description in the file.
frame_fields <- data.frame(
  name = c("bar_tension", "u_tension", "v_tension", "straight_tension", "wake", "catch_front",
    "winch_length", "broken", "energy"),
  within = c("", "", "", "", "", "", "done", "done", ""),
  field = c("bar_tension", "u_tension", "v_tension", "straight_tension", "wake", "catch_front",
    "length", "broken", "energy"),
  variable = c("bar_tension_N", "u_tension_N", "v_tension_N", "straight_tension_N", "wake",
    "catch_front", "winch_length_m", "broken", "energy_J"),
  across = c("bar", "cell", "cell", "hexagonal_cell", "point", "catch", "growing_part",
    "rupture", "energy_part"),
  unit = c("N", "N", "N", "N", "1", "1", "m", "1", "J"),
  words = c(
    "tension of one line", "tension of one twine along u", "tension of one twine along v",
    "tension of one straight bar", "speed of the flow at a point, relative to the free flow",
    "catch in netting: meshes behind its front, and the volume there (m3)",
    "length paid out by a winch", "bar that has broken, 0 for none",
    "energy since the start, by parts: see the attribute energy_parts"
  )
)

# Combines snapshots into arrays by name: one column per snapshot.
frame_arrays <- function(frames) {
  arrays <- lapply(seq_len(nrow(frame_fields)), function(row) {
    of <- frame_fields[row, ]
    values <- lapply(frames, function(frame) {
      (if (nzchar(of$within)) frame[[of$within]] else frame)[[of$field]]
    })
    matrix(as.double(unlist(values)), ncol = length(frames))
  })
  setNames(arrays, frame_fields$name)
}

# Extracts the fields of snapshot k from these arrays.
frame_of_arrays <- function(arrays, k) {
  frame <- list()
  for (row in seq_len(nrow(frame_fields))) {
    of <- frame_fields[row, ]
    value <- arrays[[of$name]][, k]
    if (nzchar(of$within)) frame[[of$within]][[of$field]] <- value else frame[[of$field]] <- value
  }
  frame
}

# Returns the energy [J] that the time scheme has created (positive) or removed, by saved time.
# `energy`: one row for each entry in engine_energy_parts().
energy_imbalance <- function(energy) {
  of <- function(parts) colSums(energy[match(parts, engine_energy_parts()), , drop = FALSE])
  of(c("kinetic", "elastic", "potential")) - of(c("supports", "winches", "water", "damping"))
}

# Returns the dissipation [J] until each saved time: c(scheme, physical, exchanged) by column.
# `exchanged`: largest change of kinetic, elastic and potential energy; without it, rounding errors
# of a gear at rest would count.
energy_lost <- function(energy) {
  part <- setNames(asplit(energy, 1), engine_energy_parts())
  span <- function(x) cummax(x) - cummin(x)
  path <- function(x) cumsum(c(0, abs(diff(x))))
  rbind(scheme = -energy_imbalance(energy), physical = path(part$water) + path(part$damping),
    exchanged = pmax(span(part$kinetic), span(part$elastic), span(part$potential)))
}
