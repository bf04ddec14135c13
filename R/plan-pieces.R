# m/s2
gear_gravity <- 9.81

# Returns mass in air (kg) and displaced volume (m3) of one piece.
piece_body <- function(piece, path, fields) {
  ways <- intersect(c("volume", "density", "material"), names(piece))
  if (length(ways) > 1) {
    abort_both(path, ways[1], ways[2], piece)
  }
  if (length(ways) && ways != "volume" && is.null(piece$mass)) {
    abort_field(paste0(path, ".mass"), NULL, sprintf("given with `%s`", ways), "is missing")
  }
  sphere <- if (!is.null(piece$diameter)) pi / 6 * piece$diameter^3
  if (is.null(piece$buoyancy)) {
    mass <- first_of(piece$mass, 0)
    volume <- if (!is.null(piece$density)) {
      mass / piece$density
    } else if (!is.null(piece$material)) {
      mass / find_material(piece$material, fields$materials, paste0(path, ".material"))[["density"]]
    } else {
      first_of(piece$volume, first_of(sphere, 0))
    }
    return(list(mass = mass, volume = volume))
  }
  excess <- c(ways, if (!is.null(piece$mass)) "mass")
  if (length(excess)) {
    abort_both(path, "buoyancy", excess[1], piece)
  }
  water <- fields$water$density
  if (water == 0) {
    abort_field(paste0(path, ".buoyancy"), piece$buoyancy, NULL,
      "needs water, but `water.density` is 0")
  }
  lifted <- piece$buoyancy / gear_gravity
  volume <- first_of(sphere, lifted / water)
  # For a float without mass, buoyancy and displacement are exactly equal.
  mass <- if (is.null(sphere)) 0 else water * volume - lifted
  if (mass < 0) {
    abort_field(
      paste0(path, ".buoyancy"), piece$buoyancy,
      sprintf(
        "at most %s, the buoyancy of a weightless sphere of this diameter (%s)",
        format_si(water * volume * gear_gravity, "force"), format_si(piece$diameter, "length")
      )
    )
  }
  list(mass = mass, volume = volume)
}

# Returns the height (m) of a piece on the ground or at the surface. It is the diameter, the edge of
# a cube of equal volume, or the side of a square of equal area. A sheet with vertical lift is
# nearly flat and has 1/10 of this side.
piece_height <- function(piece, volume) {
  if (!is.null(piece$diameter)) return(piece$diameter)
  if (volume > 0) return(volume^(1 / 3))
  area <- first_of(piece_reference_area(piece), NA_real_)
  flat <- if (first_of(piece$lift_direction, "") %in% c("up", "down")) 0.1 else 1
  if (is.na(area)) 0.1 else flat * sqrt(area)
}

piece_reference_area <- function(piece) {
  if (!is.null(piece$area)) return(piece$area)
  if (!is.null(piece$diameter)) pi / 4 * piece$diameter^2 else NA_real_
}
