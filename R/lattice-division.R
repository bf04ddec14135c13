# What is known of a lattice's division by edges and places alone.

# Which panels are of bars. netting: "bars" or "cells" for all, or NULL.
panels_of_bars <- function(si, netting) {
  vapply(si$panels, function(panel) {
    identical(first_of(netting, panel$netting), "bars") && panel$straight_bar == 0
  }, NA)
}

# A function(text) that tells the node of a parsed place.
place_finder <- function(places) {
  # Unforced it would keep everything that the lattice was built from.
  force(places)
  function(text) places[[text]]
}

# The nodes of all places of a lattice, by their texts.
lattice_places <- function(lattice) environment(lattice$place)$places
