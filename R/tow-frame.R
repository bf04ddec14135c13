# What a trajectory holds of every kept time beside places and velocities. Its arrays, the frames
# that the engine hands over and their file are made from this table.
#
# name: of the trajectory's array; field: of the frame, and within which of its lists, "" for none;
# across: the file's dimension; unit, words: as the file says them.
frame_fields <- data.frame(
  name = c("bar_tension", "u_tension", "v_tension", "straight_tension", "wake", "catch_front",
    "winch_length", "broken", "energy"),
  within = c("", "", "", "", "", "", "done", "done", ""),
  field = c("bar_tension", "u_tension", "v_tension", "straight_tension", "wake", "catch_front",
    "length", "broken", "energy"),
  across = c("bar", "cell", "cell", "hexagonal_cell", "point", "catch", "growing_part",
    "rupture", "energy_part"),
  unit = c("N", "N", "N", "N", "1", "1", "m", "1", "J"),
  words = c(
    "tension of one line", "tension of one twine along u", "tension of one twine along v",
    "tension of one straight bar", "speed of the flow at a point, as a share of the free flow's",
    "catch in netting: meshes behind its front, and the volume there (m3)",
    "length that a winch has paid out", "bar that has broken, 0 for none",
    "energy since the start, by parts: see the attribute energy_parts"
  )
)

# The arrays of a list of frames, by name: a column per frame.
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

# The fields of the k-th frame of such arrays.
frame_of_arrays <- function(arrays, k) {
  frame <- list()
  for (row in seq_len(nrow(frame_fields))) {
    of <- frame_fields[row, ]
    value <- arrays[[of$name]][, k]
    if (nzchar(of$within)) frame[[of$within]][[of$field]] <- value else frame[[of$field]] <- value
  }
  frame
}

# Energy (J) by kept time that was made (positive) or removed by the scheme: what the gear has
# gained beyond the work done on it. energy: a trajectory's, a row for each of
# engine_energy_parts().
energy_imbalance <- function(energy) {
  of <- function(parts) colSums(energy[match(parts, engine_energy_parts()), , drop = FALSE])
  of(c("kinetic", "elastic", "potential")) - of(c("supports", "winches", "water", "damping"))
}
