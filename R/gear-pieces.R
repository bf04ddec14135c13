sphere_drag_coefficient <- 0.47

si_piece <- function(piece, path, fields, known) {
  place <- if (!is.null(piece[["at"]])) find_place(piece[["at"]], paste0(path, ".at"), known)
  along <- if (!is.null(piece$along)) find_run(piece$along, paste0(path, ".along"), known)
  share <- if (is.null(along)) NULL else first_of(piece$extent, c(0, 1))
  if (!is.null(share) && share[1] >= share[2]) {
    abort_field(paste0(path, ".extent"), piece$extent, "a smaller fraction, then a larger one")
  }
  if (piece$end_to_end && piece$number < 2) {
    abort_field(paste0(path, ".number"), piece$number, "at least 2 with `end_to_end`")
  }
  water <- fields$water$density
  body <- piece_body(piece, path, fields)
  if (!is.null(piece$polar)) piece <- attacked_piece(piece, path)
  smooth <- identical(piece$drag_coefficient, "smooth_sphere")
  if (smooth) {
    if (is.null(piece$diameter)) {
      abort_field(paste0(path, ".diameter"), NULL, "given with `smooth_sphere`", "is missing")
    }
    # Projected area; the engine supplies the coefficient.
    piece$drag_coefficient <- 1
    piece$area <- pi / 4 * piece$diameter^2
  }
  drag <- piece_area(piece, path, "drag",
    if (!is.null(piece$diameter)) sphere_drag_coefficient else 1)
  lift <- piece_area(piece, path, "lift", NULL)
  if (lift > 0 && is.null(piece$lift_direction)) {
    abort_field(paste0(path, ".lift_direction"), NULL, "given with lift", "is missing")
  }
  upward <- first_of(piece$vertical_lift_coefficient, 0) * first_of(piece$area, 0)
  if (upward != 0 && first_of(piece$lift_direction, "") %in% c("up", "down")) {
    abort_field(paste0(path, ".vertical_lift_coefficient"), piece$vertical_lift_coefficient,
      "omitted if `lift_direction` is up or down")
  }
  if (body$mass == 0 && body$volume == 0 && drag == 0 && lift == 0 && upward == 0 &&
    is.null(piece$added_mass_kg)) {
    abort_field(path, piece, NULL, "has no effect: give it mass, buoyancy, an area or lift")
  }
  list(
    at = place, along = along, extent = share, number = piece$number, end_to_end = piece$end_to_end,
    mass = body$mass, volume = body$volume,
    area = piece_reference_area(piece), drag_area = drag, lift_area = lift,
    upward_lift_area = upward,
    smooth_diameter = if (smooth) piece$diameter else 0,
    lift_direction = first_of(piece$lift_direction, NA_character_),
    added_mass = first_of(piece$added_mass_kg, piece$added_mass * body$volume * water),
    height = piece_height(piece, body$volume),
    role = first_of(piece$role, NA_character_)
  )
}

# Replaces the polar of a piece by its coefficients at the angle of attack.
attacked_piece <- function(piece, path) {
  excess <- intersect(
    c("lift_coefficient", "lift_area", "drag_coefficient", "drag_area"), names(piece)
  )
  if (length(excess)) {
    abort_both(path, "polar", excess[1], piece)
  }
  # The aspect ratio of 2 affects only angles beyond stall.
  polar <- engine_polar(si_polar(piece$polar, paste0(path, ".polar"), 2))
  at <- function(value, slope) {
    stats::splinefunH(polar$angle, polar[[value]], polar[[slope]])(piece$attack)
  }
  lift <- at("lift", "lift_slope")
  if (lift < 0) {
    abort_field(paste0(path, ".attack"), format_si(piece$attack, "angle"),
      "an angle at which its polar lifts")
  }
  piece$lift_coefficient <- lift
  piece$drag_coefficient <- at("drag", "drag_slope")
  piece
}

# Returns coefficient times area (m2) of drag or lift.
piece_area <- function(piece, path, force, default) {
  coefficient <- piece[[paste0(force, "_coefficient")]]
  product <- piece[[paste0(force, "_area")]]
  area <- piece_reference_area(piece)
  if (!is.null(product)) {
    if (!is.null(coefficient)) {
      abort_both(path, paste0(force, "_area"), paste0(force, "_coefficient"), piece)
    }
    return(product)
  }
  if (!is.null(coefficient) && is.na(area)) {
    abort_field(paste0(path, ".area"), NULL, sprintf("given with `%s_coefficient`", force),
      "is missing")
  }
  coefficient <- first_of(coefficient, default)
  if (is.null(coefficient) || is.na(area)) 0 else coefficient * area
}
