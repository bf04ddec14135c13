# Midwater trawl (short form).

# By number of panels: names in order around the net, and the panels along each mouth line.
trawl_rings <- list(
  `2` = list(
    panels = c("back", "belly"),
    mouth = list(headline = "back", footrope = "belly")
  ),
  `4` = list(
    panels = c("back", "side_starboard", "belly", "side_port"),
    mouth = list(
      headline = "back", side_line_starboard = "side_starboard", footrope = "belly",
      side_line_port = "side_port"
    )
  ),
  `6` = list(
    panels = c(
      "back", "upper_side_starboard", "lower_side_starboard", "belly", "lower_side_port",
      "upper_side_port"
    ),
    mouth = list(
      headline = "back", side_line_starboard = c("upper_side_starboard", "lower_side_starboard"),
      footrope = "belly", side_line_port = c("lower_side_port", "upper_side_port")
    )
  )
)

trawl_line_ends <- list(
  headline = c("upper_port", "upper_starboard"),
  side_line_starboard = c("upper_starboard", "lower_starboard"),
  footrope = c("lower_starboard", "lower_port"),
  side_line_port = c("lower_port", "upper_port")
)

expand_midwater_trawl <- function(fields, plan) {
  check_trawl(fields)
  ring <- trawl_rings[[as.character(fields$panels)]]
  net <- trawl_net(fields, plan, ring)
  rig <- trawl_rig(fields, plan, ring)
  out <- shared_fields(plan, fields)
  out$points <- c(rig$points, net$points)
  out$ropes <- c(rig$ropes, net$ropes)
  out$panels <- net$panels
  out$seams <- net$seams
  out$pieces <- rig$pieces
  out$otter_boards <- rig$otter_boards
  out$measures <- trawl_measures(ring, names(rig$otter_boards))
  out
}

check_trawl <- function(fields) {
  check_boards(fields)
  if (fields$panels > 2 && is.null(fields$side_lines)) {
    abort_field("side_lines", NULL, "given in a trawl with side panels", "is missing")
  }
  check_section_names(fields)
  if (fields$panels == 2 && is.null(fields$wings) && !is.null(fields$side_lines)) {
    abort_field("side_lines", "given", "omitted in a trawl of 2 panels without wings")
  }
  if (!is.null(fields$wings) && fields$panels == 6) {
    abort_field("wings", "given", "omitted in a trawl of 6 panels; use an assembly for such wings")
  }
}

trawl_net <- function(fields, plan, ring) {
  around <- ring$panels
  n <- length(around)
  net <- trawl_sections(plan, around)
  first <- names(plan$sections)[1L]

  # Front: the front edges of the first section, or the inner edges of the wings.
  if (!is.null(plan$wings)) {
    wings <- trawl_wings(fields, plan, around, first)
    net$panels <- c(wings$panels, net$panels)
    net$seams <- c(wings$seams, net$seams)
    net$points <- c(wings$points, net$points)
    front <- wings$front
    outer <- wings$outer
  } else {
    front <- lapply(stats::setNames(nm = around), function(panel) {
      paste0(section_panel_name(panel, first), ".upper")
    })
    outer <- list()
    # The wing tips are the front corners of the first panel along each line of the mouth.
    for (line in names(ring$mouth)) {
      tip <- trawl_line_ends[[line]][1L]
      corner <- paste0(section_panel_name(ring$mouth[[line]][1L], first), ".upper_left")
      if (!tip %in% names(net$points)) net$points[[tip]] <- list(at = corner)
    }
    if (n == 2L) {
      net$points$upper_starboard <-
        list(at = paste0(section_panel_name("back", first), ".upper_right"))
      net$points$lower_port <- list(at = paste0(section_panel_name("belly", first), ".upper_right"))
    }
  }
  mouth <- lapply(ring$mouth, function(panels) front[panels])
  lines <- c(headline = "headline", footrope = "footrope", side_lines = "side_line_port")
  for (line in intersect(names(lines), names(plan))) {
    edges <- length(unlist(mouth[[lines[[line]]]]))
    plan[[line]] <- hung_line(fields, plan, line, edges)
  }
  net$ropes <- trawl_lines(plan, around, mouth, outer)
  net
}

# Returns two wings per panel, at the ends of its front edge, each gathered at its wing tip.
trawl_wings <- function(fields, plan, around, first) {
  panels <- seams <- front <- outer <- list()
  tips <- wing_corners(around)
  for (panel in around) {
    across <- section_panel(fields$sections[[first]], panel)$meshes$upper
    pair <- wing_pair(panel, section_panel_name(panel, first), across, plan$wings,
      fields$wings$meshes, "wings.meshes")
    panels <- c(panels, pair$panels)
    seams <- c(seams, pair$seams)
    front[[panel]] <- pair$inner
    outer[[panel]] <- paste0(pair$left, ".left")
  }
  after <- panel_after(around)
  points <- list()
  for (k in seq_along(around)) {
    # In a net of two panels, upper and lower wings have separate ends.
    joined <- length(around) > 2L
    left <- paste0(after[k], "_wing_left")
    right <- paste0(around[k], "_wing_right")
    if (joined) {
      seams[[paste("wings", around[k], after[k], sep = "_")]] <-
        list(edges = c(paste0(right, ".right"), paste0(left, ".left")))
    }
    points[[tips[[left]]]] <- nothing
    points[[tips[[right]]]] <- nothing
    if (tips[[left]] == tips[[right]]) {
      seams[[paste0("tip_", tips[[left]])]] <-
        list(edges = paste0(c(right, left), ".upper"), gathered_at = tips[[left]])
    } else {
      for (end in c(left, right)) {
        seams[[paste0("tip_", tips[[end]])]] <-
          list(edges = paste0(end, ".upper"), gathered_at = tips[[end]])
      }
    }
  }
  list(panels = panels, seams = seams, front = front, outer = outer, points = points)
}

# Returns the wing tip of each wing, for nets of 2 and 4 panels.
wing_corners <- function(around) {
  corners <- list(
    back = c("upper_port", "upper_starboard"), belly = c("lower_starboard", "lower_port"),
    side_starboard = c("upper_starboard", "lower_starboard"),
    side_port = c("lower_port", "upper_port")
  )
  out <- list()
  for (panel in around) {
    out[[paste0(panel, "_wing_left")]] <- corners[[panel]][1L]
    out[[paste0(panel, "_wing_right")]] <- corners[[panel]][2L]
  }
  out
}

trawl_rig <- function(fields, plan, ring) {
  free <- fields$otter_boards$attitude == "free"
  boards <- trawl_boards(plan, free)
  points <- c(
    towing_points(paste0("block_", trawl_sides), fields$warps$spacing), boards$points
  )
  ropes <- trawl_warps(plan)
  pieces <- boards$pieces
  for (side in trawl_sides) {
    for (tier in c("upper", "lower")) {
      ropes[[paste("hand_rope", tier, side, sep = "_")]] <- part_with_role(
        of_side(plan$hand_ropes[[tier]], side), "hand_rope",
        from = if (free) paste0("backstrop_", tier, "_", side) else paste0("board_", side),
        to = paste(tier, side, sep = "_")
      )
    }
    pieces[[paste0("hammer_", side)]] <- part_with_role(plan$hammers, "hammer",
      at = paste0("lower_", side))
    # Without side panels, only the side line connects the wing tips.
    if (is.null(ring$mouth$side_line_port)) {
      ropes[[paste0("side_line_", side)]] <- part_with_role(plan$side_lines, "side_line",
        from = paste0("upper_", side), to = paste0("lower_", side))
    }
  }
  list(
    points = points, ropes = ropes, pieces = c(pieces, trawl_fittings(fields, plan, ring$panels)),
    otter_boards = boards$otter_boards
  )
}

trawl_measures <- function(ring, free_boards) {
  pair <- function(tier) paste0(tier, c("_port", "_starboard"))
  out <- list(
    door_spread = list(spread = pair("board")),
    wing_end_spread = list(spread = list(pair("upper"), pair("lower"))),
    net_mouth_height = list(height = c("headline.middle", "footrope.middle")),
    wing_end_height = list(height = c("upper_port", "lower_port"))
  )
  if (length(ring$mouth) == 4L) out$mouth_area <- list(area = names(ring$mouth))
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
  ))
}
