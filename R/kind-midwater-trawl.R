# Midwater trawl (short form).

expand_midwater_trawl <- function(fields, plan) {
  check_trawl(fields)
  grid <- if (is.null(fields$net)) midwater_trawl_grid(fields, plan) else net_grid(fields, plan)
  net <- trawl_net(grid, fields, plan)
  rig <- trawl_rig(fields, plan, net)
  out <- trawl_assembly(fields, plan, net, rig)
  out$measures <- trawl_measures(fields, names(rig$otter_boards))
  out
}

check_trawl <- function(fields) {
  check_boards(fields)
  if (fields$panels > 2 && is.null(fields$side_lines)) {
    abort_field("side_lines", NULL, "given in a trawl with side panels", "is missing")
  }
  check_section_names(fields)
  if (fields$panels == 2 && is.null(fields$wings) && is.null(fields$net) &&
    !is.null(fields$side_lines)) {
    abort_field("side_lines", "given", "omitted in a trawl of 2 panels without wings")
  }
  if (!is.null(fields$wings) && fields$panels == 6) {
    abort_field("wings", "given", "omitted in a trawl of 6 panels; use an assembly for such wings")
  }
}

# Returns the grid of a midwater trawl: two wings ahead of each panel and the sections. Each wing is
# gathered at its wing tip.
midwater_trawl_grid <- function(fields, plan) {
  around <- panels_around(fields)
  grid <- section_grid(fields, plan, around)
  if (is.null(plan$wings)) return(grid)
  given <- plan$wings[setdiff(names(plan$wings), "meshes")]
  wings <- lapply(stats::setNames(around, paste0(around, "_wings")), function(panel) {
    across <- column_cells(grid, panel)[[1L]]$counts$upper
    wing_cell(paste0(panel, "_wing"), given,
      wing_counts(fields$wings$meshes, across, "wings.meshes"), fields$wings$mesh_size)
  })
  list(columns = lapply(grid$columns, function(rows) c("wings", rows)),
    cells = c(wings, grid$cells), gathered = TRUE, separators = grid$separators)
}

trawl_rig <- function(fields, plan, net) {
  rig <- boards_on_warps(fields, plan)
  free <- length(rig$otter_boards) > 0L
  for (side in trawl_sides) {
    for (tier in c("upper", "lower")) {
      rig$ropes[[paste("hand_rope", tier, side, sep = "_")]] <- part_with_role(
        of_side(plan$hand_ropes[[tier]], side), "hand_rope",
        from = if (free) paste0("backstrop_", tier, "_", side) else paste0("board_", side),
        to = paste(tier, side, sep = "_")
      )
    }
    rig$pieces[[paste0("hammer_", side)]] <- part_with_role(plan$hammers, "hammer",
      at = paste0("lower_", side))
    if (!"side_lines" %in% names(net$lines)) {
      if (!is.null(plan$side_lines$sections)) {
        abort_field("side_lines.sections", "given", "omitted in a net with gathered wing tips")
      }
      rig$ropes[[paste0("side_line_", side)]] <- part_with_role(plan$side_lines, "side_line",
        from = paste0("upper_", side), to = paste0("lower_", side))
    }
  }
  rig
}

trawl_measures <- function(fields, free_boards) {
  pair <- function(tier) paste0(tier, c("_port", "_starboard"))
  out <- list(
    door_spread = list(spread = pair("board")),
    wing_end_spread = list(spread = list(pair("upper"), pair("lower"))),
    net_mouth_height = list(height = c("headline.middle", "footrope.middle")),
    wing_end_height = list(height = c("upper_port", "lower_port"))
  )
  if (fields$panels > 2) {
    out$mouth_area <- list(area = mouth_ropes(fields))
  }
  out <- c(out, board_measures(free_boards))
  c(out, list(
    door_depth = list(depth = "board_port"),
    headline_depth = list(depth = "headline.middle"),
    footrope_depth = list(depth = "footrope.middle"),
    warp_tension_port = list(tension = "warp_port.start"),
    warp_tension_starboard = list(tension = "warp_starboard.start"),
    warp_declination = list(angle = list(warp_port.start = "declination")),
    warp_divergence = list(angle = list(warp_port.start = "divergence")),
    hand_rope_upper_tension = list(tension = "hand_rope_upper_port.end"),
    hand_rope_lower_tension = list(tension = "hand_rope_lower_port.end"),
    net_length = list(length = c("upper_port", "codline"))
  ), grid_measures(fields))
}
