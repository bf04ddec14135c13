# Bottom-set gillnet (short form): one wall of netting along y between two anchors.

expand_gillnet <- function(fields, plan) {
  check_gillnet(fields)
  half <- fields$length / 2
  wall <- fields$wall
  ratio <- fields$length / (wall$mesh_size * wall$meshes$across)
  tall <- wall$mesh_size * wall$meshes$deep * sqrt(1 - ratio^2)
  bed <- -fields$seabed$depth
  own <- plan$wall[setdiff(names(plan$wall), "meshes")]
  across <- wall$meshes$across
  corner <- function(name, y, z) list(at = paste0("wall.", name), near = list(0, y, z))

  out <- shared_fields(plan, fields)
  out$panels <- list(wall = c(own, list(
    meshes = list(upper = across, lower = across, deep = wall$meshes$deep), part = "wall"
  )))
  out$points <- list(
    float_line_port = corner("upper_left", -half, bed + tall),
    float_line_starboard = corner("upper_right", half, bed + tall),
    lead_line_port = corner("lower_left", -half, bed),
    lead_line_starboard = corner("lower_right", half, bed)
  )
  out$ropes <- list(
    float_line = part_with_role(plan$float_line, "float_line", along = "wall.upper",
      length = fields$length),
    lead_line = part_with_role(plan$lead_line, "lead_line", along = "wall.lower",
      length = fields$length)
  )
  for (side in c("port", "starboard")) {
    outward <- if (side == "port") -1 else 1
    out$ropes[[paste0("end_line_", side)]] <- part_with_role(plan$end_lines, "end_line",
      along = if (side == "port") "wall.left" else "wall.right")
    anchor <- paste0("anchor_", side)
    out$points[[anchor]] <- list(
      position = list(0, outward * fields$anchors$apart / 2, bed), held = "fixed"
    )
    out$ropes[[paste0("anchor_line_", side)]] <- rope_between(paste0("lead_line_", side), anchor,
      plan$anchors[names(plan$anchors) != "apart"], "anchor_line")
  }
  pieces <- list()
  pieces$floats <- part_with_role(plan$floats, "float", along = "float_line")
  pieces$weights <- part_with_role(plan$weights, "weight", along = "lead_line")
  if (length(pieces)) out$pieces <- pieces
  out$measures <- list(
    net_height = list(height = c("float_line.middle", "lead_line.middle")),
    end_height = list(height = c("float_line_port", "lead_line_port")),
    net_width = list(spread = c("lead_line_port", "lead_line_starboard")),
    float_line_depth = list(depth = "float_line.middle"),
    net_drag = list(drag = "wall"),
    anchor_tension_port = list(tension = "anchor_line_port.end"),
    anchor_tension_starboard = list(tension = "anchor_line_starboard.end")
  )
  out
}

check_gillnet <- function(fields) {
  wall <- fields$wall
  stretched <- wall$mesh_size * wall$meshes$across
  if (fields$length >= stretched) {
    abort_field("length", format_si(fields$length, "length"), paste(
      "less than the stretched length of its meshes,", format_si(stretched, "length")
    ))
  }
  reach <- fields$length + 2 * fields$anchors$length
  if (fields$anchors$apart > reach || fields$anchors$apart <= fields$length / 2) {
    abort_field("anchors.apart", format_si(fields$anchors$apart, "length"), paste(
      "more than half the length of the net and at most the length of net plus both anchor lines,",
      format_si(reach, "length")
    ))
  }
}
