# Stow net (short form): a bag of four panels that a tidal current keeps open. Its mouth is between
# an upper beam with floats and a lower beam, on bridles from an anchor.

expand_stow_net <- function(fields, plan) {
  check_stow_net(fields)
  around <- panels_by_number$`4`
  net <- joined_grid(section_grid(fields, plan, around))
  first <- names(plan$sections)[1L]
  edge <- function(panel) paste0(section_panel_name(panel, first), ".upper")
  width <- fields$mouth$width
  # Initial position: downstream of the anchor, with a fully open mouth.
  aft <- sqrt(fields$bridles$length^2 - (width / 2)^2) + fields$anchor_line$length * 0.9
  top <- -0.3 * fields$anchor_depth
  corner <- function(panel, side, y, tier) {
    list(at = paste0(section_panel_name(panel, first), ".upper_", side),
      near = list(aft, y, top - tier * fields$mouth$height))
  }
  out <- shared_fields(plan, fields)
  out$water$free_surface <- TRUE
  out$panels <- net$panels
  out$seams <- net$seams
  out$points <- c(net$points, list(
    anchor = list(position = list(0, 0, -fields$anchor_depth), held = "fixed"),
    bridle_end = nothing,
    upper_port = corner("back", "left", -width / 2, 0),
    upper_starboard = corner("back", "right", width / 2, 0),
    lower_starboard = corner("belly", "left", width / 2, 1),
    lower_port = corner("belly", "right", -width / 2, 1)
  ))
  out$ropes <- list(
    anchor_line = rope_between("anchor", "bridle_end", plan$anchor_line, "anchor_line"),
    upper_beam = part_with_role(plan$upper_beam, "beam", along = edge("back"), length = width),
    lower_beam = part_with_role(plan$lower_beam, "beam", along = edge("belly"), length = width)
  )
  for (side in c("port", "starboard")) {
    out$ropes[[paste0("side_line_", side)]] <- part_with_role(plan$side_lines, "side_line",
      along = edge(paste0("side_", side)), length = fields$mouth$height)
    for (tier in c("upper", "lower")) {
      out$ropes[[paste("bridle", tier, side, sep = "_")]] <-
        rope_between("bridle_end", paste(tier, side, sep = "_"), plan$bridles, "bridle")
    }
  }
  pieces <- list()
  pieces$floats <- part_with_role(plan$floats, "float", along = "upper_beam")
  pieces$weights <- part_with_role(plan$weights, "weight", along = "lower_beam")
  if (length(pieces)) out$pieces <- pieces
  out$measures <- list(
    mouth_height = list(height = c("upper_beam.middle", "lower_beam.middle")),
    mouth_width = list(spread = c("upper_port", "upper_starboard")),
    mouth_area = list(
      area = c("upper_beam", "side_line_starboard", "lower_beam", "side_line_port")
    ),
    upper_beam_depth = list(depth = "upper_beam.middle"),
    net_drag = list(drag = names(net$panels)),
    anchor_tension = list(tension = "anchor_line.start"),
    codline_depth = list(depth = "codline")
  )
  out
}

check_stow_net <- function(fields) {
  for (beam in c("upper_beam", "lower_beam")) {
    if (fields[[beam]]$bending_stiffness == 0) {
      abort_field(paste0(beam, ".bending_stiffness"), 0, "greater than 0")
    }
  }
  half <- fields$mouth$width / 2
  if (fields$bridles$length <= half) {
    abort_field("bridles.length", format_si(fields$bridles$length, "length"),
      paste("more than half the width of the mouth,", format_si(half, "length")))
  }
}
