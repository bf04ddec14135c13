# Beam trawl (short form): a net of two panels behind a frame of a stiff beam on two shoes. The
# outer bridles and the tickler chains are fastened to the toes of the shoes; a middle bridle is
# fastened to the middle of the beam. The headline runs between the ends of the beam, and the
# footrope between the heels of the shoes.

# Struts that make the frame a rigid body, without weight and hydrodynamic forces.
frame_strut <- list(
  carries_compression = TRUE, segments = 1L, diameter = 0.001, axial_stiffness = 1e8,
    mass_per_length = 0,
  volume_per_length = 0, coefficients = list(normal = 0), role = "frame"
)

expand_beam_trawl <- function(fields, plan) {
  check_beam_trawl(fields)
  net <- bottom_trawl_net(fields, plan)
  points <- c(
    list(
      block = list(position = list(0, 0, 0), held = "moved"), bridle_end = nothing,
      toe_port = nothing, toe_starboard = nothing, beam_middle = list(at = "beam.middle")
    ),
    net$points
  )
  start <- beam_trawl_start(fields)
  for (name in names(start)) points[[name]]$near <- as.list(start[[name]])
  ropes <- list(
    warp = rope_between("block", "bridle_end", plan$warp, "warp"),
    # An even number of segments puts a node at mid-beam.
    beam = rope_between("upper_port", "upper_starboard",
      c(plan$beam, if (is.null(plan$beam$segments)) list(segments = 4L),
        list(carries_compression = TRUE)),
      "beam")
  )
  for (side in trawl_sides) {
    ropes[[paste0("bridle_", side)]] <-
      rope_between("bridle_end", paste0("toe_", side), plan$bridles$outer, "bridle")
  }
  if (!is.null(plan$bridles$middle)) {
    ropes$bridle_middle <- rope_between("bridle_end", "beam_middle", plan$bridles$middle, "bridle")
  }
  for (name in names(plan$ticklers)) {
    ropes[[name]] <- rope_between("toe_port", "toe_starboard", plan$ticklers[[name]], "tickler")
  }
  out <- shared_fields(plan, fields)
  out$points <- points
  out$ropes <- c(ropes, frame_struts(start), net$ropes)
  out$panels <- net$panels
  out$seams <- net$seams
  out$pieces <- c(shoe_pieces(fields), trawl_fittings(fields, plan, net))
  out$measures <- beam_trawl_measures(fields)
  out
}

check_beam_trawl <- function(fields) {
  check_section_names(fields)
  check_wing_ends(fields)
  more_than <- function(path, value, least, what) {
    if (value > least) return()
    abort_field(path, format_si(value, "length"),
      paste0("more than ", what, ", ", format_si(least, "length")))
  }
  width <- fields$beam$length
  more_than("warp.length", fields$warp$length, fields$seabed$depth, "the depth of the sea bed")
  more_than("bridles.outer.length", fields$bridles$outer$length, width / 2,
    "half the length of the beam")
  more_than("shoes.height", fields$shoes$height, shoe_middle(fields),
    "the height of the shoe centre above the sea bed")
  for (name in names(fields$ticklers)) {
    more_than(paste0("ticklers.", name, ".length"), fields$ticklers[[name]]$length, width,
      "the length of the beam")
  }
  segments <- fields$beam$segments
  if (!is.null(segments) && segments %% 2 == 1) {
    abort_field("beam.segments", segments, "an even number, so that the beam has a middle")
  }
}

# Half of a shoe as a piece: its toe and its heel each carry half its weight.
half_shoe <- function(fields) {
  shoe <- fields$shoes[setdiff(names(fields$shoes), c("height", "length"))]
  halved <- intersect(c("mass", "volume", "area", "drag_area"), names(shoe))
  shoe[halved] <- lapply(shoe[halved], `/`, 2)
  shoe
}

shoe_pieces <- function(fields) {
  ends <- c(
    shoe_toe_port = "toe_port", shoe_heel_port = "lower_port",
    shoe_toe_starboard = "toe_starboard", shoe_heel_starboard = "lower_starboard"
  )
  lapply(ends, function(end) c(list(at = end), half_shoe(fields), list(role = "shoe_end")))
}

# Returns the height (m) of a shoe's centre above the seabed. The frame is joined to this centre.
shoe_middle <- function(fields) {
  shoe <- half_shoe(fields)
  piece_height(shoe, piece_body(shoe, "shoes", fields)$volume) / 2
}

# Returns the initial position (x, y, z in m) of each point of frame and bridle: list(bridle_end,
# upper_port, ...). The frame is upright on the seabed, and the bridle is in line with the warp.
# These positions define the shape of the frame. A frame on its side or upside down is also an
# equilibrium, so the initial frame must be upright.
beam_trawl_start <- function(fields) {
  seabed <- fields$seabed
  half <- fields$beam$length / 2
  sole <- fields$shoes$length / 2
  reach <- sqrt(fields$bridles$outer$length^2 - half^2)
  foot <- shoe_middle(fields)
  down <- (seabed$depth - foot) / (fields$warp$length + reach)
  ahead <- reach * sqrt(1 - down^2)
  x <- (fields$warp$length + reach) * sqrt(1 - down^2) + sole
  slope <- first_of(seabed$slope, list(angle = 0, toward = 0))
  place <- function(x, y, height) {
    fall <- tan(slope$angle) * (x * cos(slope$toward) + y * sin(slope$toward))
    c(x, y, height - seabed$depth - fall)
  }
  list(
    bridle_end = place(x - sole - ahead, 0, foot + reach * down),
    upper_port = place(x, -half, fields$shoes$height),
    upper_starboard = place(x, half, fields$shoes$height),
    lower_port = place(x + sole, -half, foot), lower_starboard = place(x + sole, half, foot),
    toe_port = place(x - sole, -half, foot), toe_starboard = place(x - sole, half, foot),
    beam_middle = place(x, 0, fields$shoes$height)
  )
}

# Returns struts that make the frame rigid together with the beam: around each shoe, between heels,
# between toes, crosswise between the shoes, and from the heels to mid-beam.
frame_struts <- function(start) {
  strut <- function(from, to) {
    between <- sqrt(sum((start[[from]] - start[[to]])^2))
    c(list(from = from, to = to, length = between), frame_strut)
  }
  out <- list()
  for (side in trawl_sides) {
    other <- setdiff(trawl_sides, side)
    end <- function(of, which = side) paste(of, which, sep = "_")
    out[[end("shoe_rear")]] <- strut(end("upper"), end("lower"))
    out[[end("shoe_front")]] <- strut(end("upper"), end("toe"))
    out[[end("shoe_sole")]] <- strut(end("toe"), end("lower"))
    out[[end("brace_upper")]] <- strut(end("lower"), "beam_middle")
    out[[end("brace_lower")]] <- strut(end("toe"), end("lower", other))
  }
  c(out, list(
    strut_toes = strut("toe_port", "toe_starboard"),
    strut_heels = strut("lower_port", "lower_starboard")
  ))
}

beam_trawl_measures <- function(fields) {
  out <- list(
    beam_height = list(clearance = "beam.middle"),
    toe_height = list(clearance = "toe_port"),
    wing_end_spread = list(spread = c("lower_port", "lower_starboard")),
    net_mouth_height = list(height = c("headline.middle", "footrope.middle")),
    headline_height = list(clearance = "headline.middle"),
    footrope_height = list(clearance = "footrope.middle"),
    mouth_area = list(area = mouth_ropes(fields)),
    warp_tension = list(tension = "warp.start"),
    warp_declination = list(angle = list(warp.start = "declination")),
    bridle_outer_tension = list(tension = "bridle_port.end")
  )
  if (!is.null(fields$bridles$middle)) {
    out$bridle_middle_tension <- list(tension = "bridle_middle.end")
  }
  for (name in names(fields$ticklers)) {
    out[[paste0(name, "_tension")]] <- list(tension = paste0(name, ".start"))
  }
  c(out, list(net_length = list(length = c("upper_port", "codline"))), grid_measures(fields))
}
