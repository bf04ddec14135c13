# The beam trawl's short form: a net of two panels behind a frame of a stiff beam on two shoes. The
# head line's ends are fastened to the ends of the beam and the footrope's to the shoes; bridles run
# from both to the one warp.

# Stiffness and thickness of the posts between beam and shoes.
shoe_post <- list(
  pushes = TRUE, segments = 1L, diameter = 0.05, axial_stiffness = 5e7, mass_per_length = 0,
  volume_per_length = 0
)

# fields: checked, in SI; plan: as given, so that the assembly keeps the designer's units.
expand_beam_trawl <- function(fields, plan) {
  fields$panels <- 2
  check_section_names(fields)
  check_wing_ends(fields)
  net <- bottom_trawl_net(fields, plan)
  points <- list(
    block = list(position = list(0, 0, 0), held = "moved"), warp_end = nothing
  )
  ropes <- list(
    warp = c(list(from = "block", to = "warp_end"), plan$warp, list(role = "warp")),
    beam = c(
      list(from = "upper_port", to = "upper_starboard"), plan$beam,
      list(pushes = TRUE, role = "beam")
    )
  )
  pieces <- list()
  own <- plan$shoes[setdiff(names(plan$shoes), "height")]
  for (side in trawl_sides) {
    ends <- stats::setNames(paste0(c("upper_", "lower_"), side), c("upper", "lower"))
    ropes[[paste0("post_", side)]] <- c(
      list(from = ends[["upper"]], to = ends[["lower"]], length = fields$shoes$height), shoe_post,
      list(role = "shoe")
    )
    for (level in names(ends)) {
      ropes[[paste("bridle", level, side, sep = "_")]] <- c(
        list(from = "warp_end", to = ends[[level]]), plan$bridles[[level]], list(role = "bridle")
      )
    }
    pieces[[paste0("shoe_", side)]] <- c(list(at = ends[["lower"]]), own, list(role = "shoe"))
  }
  out <- shared_fields(plan)
  out$points <- c(points, net$points)
  out$ropes <- c(ropes, net$ropes)
  out$panels <- net$panels
  out$seams <- net$seams
  out$pieces <- c(pieces, trawl_fittings(plan))
  out$measures <- beam_trawl_measures()
  out
}

beam_trawl_measures <- function() {
  list(
    beam_spread = list(spread = c("upper_port", "upper_starboard")),
    beam_height = list(clearance = "beam.middle"),
    wing_end_spread = list(spread = c("lower_port", "lower_starboard")),
    net_mouth_height = list(height = c("head_line.middle", "footrope.middle")),
    headline_height = list(clearance = "head_line.middle"),
    footrope_height = list(clearance = "footrope.middle"),
    warp_tension = list(tension = "warp.start"),
    warp_declination = list(angle = list(warp.start = "declination")),
    bridle_upper_tension = list(tension = "bridle_upper_port.end"),
    bridle_lower_tension = list(tension = "bridle_lower_port.end"),
    net_length = list(length = c("upper_port", "codline"))
  )
}
