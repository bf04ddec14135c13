# A lattice filled again: where a gear differs from the one that a shape was settled of in its
# conditions alone, nothing but those is made anew.

# Fields of a gear's SI numbers that a lattice holds as they are.
condition_fields <- c("name", "water", "towing", "ground", "sticking", "measures")

# The lattice of `from` (see build_lattice()) with the conditions of a gear, or NULL where more than
# those has changed or nodes and netting are asked for otherwise.
fill_lattice <- function(si, nodes, netting, from) {
  old <- from$settled
  asked <- from$lattice$counts$asked
  if (is.null(old) || !is.null(si$shooting) || !identical(nodes, asked$nodes)) return(NULL)
  parts <- setdiff(union(names(si), names(old)), condition_fields)
  same <- identical(si[parts], old[parts]) &&
    identical(si$water[c("density", "free_surface")], old$water[c("density", "free_surface")]) &&
    is.null(si$ground) == is.null(old$ground) && identical(panels_of_bars(si, netting), asked$bars)
  if (!same) return(NULL)
  lattice <- from$lattice
  lattice$engine$water <- engine_water(si)
  lattice$engine["ground"] <- list(si$ground)
  lattice$start <- from$position[, seq_len(lattice$nodes), drop = FALSE]
  supports <- gear_supports(si, lattice)
  lattice$start[, which(supports$held)] <- supports$position[, supports$held]
  lattice
}

# The division that divide() made for the lattice of `from`, for a gear of which the same counts are
# asked for; NULL where it would be another, or may be.
division_again <- function(si, from) {
  old <- from$settled
  lattice <- from$lattice
  if (is.null(old) || !"runs" %in% names(lattice$division)) return(NULL)
  if (!identical(gear_structure(si), gear_structure(old))) return(NULL)
  c(
    lattice$division, lattice[c("points", "ropes", "held_edges")],
    list(places = lattice_places(lattice))
  )
}

# The engine's water: the current as the gear meets it, which is towed along -x.
engine_water <- function(si) {
  water <- list(
    density = si$water$density, viscosity = si$water$viscosity,
    free_surface = si$water$free_surface, depth = si$water$current$depth,
    x = si$water$current$x + si$towing$speed, y = si$water$current$y
  )
  water$waves <- engine_waves(si$water$waves)
  water
}
