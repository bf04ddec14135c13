# The midwater trawl's short form and the assembly that it stands for.
#
# Panels around the net follow each other clockwise as seen from the vessel's deck looking aft:
# back, starboard sides from top to bottom, belly, port sides from bottom to top. Seen from outside
# with its front edge up, each panel's left edge meets the panel before it.

# For each number of panels: their names in that order, which of them span each line of the mouth,
# and the seams (panel before the seam) that end in a wing tip.
trawl_rings <- list(
  `2` = list(
    panels = c("back", "belly"),
    mouth = list(head_line = "back", footrope = "belly")
  ),
  `4` = list(
    panels = c("back", "side_starboard", "belly", "side_port"),
    mouth = list(
      head_line = "back", side_line_starboard = "side_starboard", footrope = "belly",
      side_line_port = "side_port"
    )
  ),
  `6` = list(
    panels = c(
      "back", "upper_side_starboard", "lower_side_starboard", "belly", "lower_side_port",
      "upper_side_port"
    ),
    mouth = list(
      head_line = "back", side_line_starboard = c("upper_side_starboard", "lower_side_starboard"),
      footrope = "belly", side_line_port = c("lower_side_port", "upper_side_port")
    )
  )
)

trawl_line_ends <- list(
  head_line = c("upper_port", "upper_starboard"),
  side_line_starboard = c("upper_starboard", "lower_starboard"),
  footrope = c("lower_starboard", "lower_port"),
  side_line_port = c("lower_port", "upper_port")
)

# fields: checked, in SI; plan: as given, so that the assembly keeps the designer's units.
expand_midwater_trawl <- function(fields, plan) {
  check_trawl(fields)
  ring <- trawl_rings[[as.character(fields$panels)]]
  net <- trawl_net(fields, plan, ring)
  rig <- trawl_rig(fields, plan, ring)
  out <- plan[intersect(
    c(
      "codend", "name", "notes", "sources", "water", "seabed", "netting", "coefficients",
      "netting_drag", "slack_twine", "shielding", "materials", "towing", "tow"
    ),
    names(plan)
  )]
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
    abort_field("side_lines", NULL, "given where a trawl has side panels", "is missing")
  }
  check_section <- function(name, path) {
    sections <- names(fields$sections)
    if (!is.null(name) && !name %in% sections) {
      abort_reference(name, name, sections, "section", path)
    }
  }
  check_section(fields$belly_lines$until, "belly_lines.until")
  for (name in names(fields$cross_ropes)) {
    check_section(fields$cross_ropes[[name]]$behind, paste0("cross_ropes.", name, ".behind"))
  }
  if (fields$panels == 2 && is.null(fields$wings) && !is.null(fields$side_lines)) {
    abort_field("side_lines", "given", "left out in a trawl of 2 panels without wings")
  }
  if (!is.null(fields$wings) && fields$panels == 6) {
    abort_field("wings", "given", "left out in a trawl of 6 panels; describe it as an assembly")
  }
}

# A panel of a section as given, with what its side says otherwise.
section_panel <- function(section, panel) {
  side <- if (panel %in% c("back", "belly")) panel else "side"
  own <- section[setdiff(names(section), c("back", "belly", "side"))]
  other <- section[[side]]
  own[names(other)] <- other
  own
}

trawl_net <- function(fields, plan, ring) {
  panels <- seams <- ropes <- list()
  around <- ring$panels
  n <- length(around)
  after <- c(around[-1L], around[1L])
  sections <- names(plan$sections)
  id <- function(panel, section) paste0(panel, "_", section)
  for (section in sections) {
    for (panel in around) {
      panels[[id(panel, section)]] <- c(
        section_panel(plan$sections[[section]], panel), list(part = section)
      )
    }
    for (k in seq_len(n)) {
      seams[[paste(section, around[k], after[k], sep = "_")]] <- list(edges = c(
        paste0(id(around[k], section), ".right"), paste0(id(after[k], section), ".left")
      ))
    }
  }
  for (k in seq_along(sections)[-1L]) {
    for (panel in around) {
      seams[[paste(panel, sections[k - 1L], sections[k], sep = "_")]] <- list(edges = c(
        paste0(id(panel, sections[k - 1L]), ".lower"), paste0(id(panel, sections[k]), ".upper")
      ))
    }
  }
  last <- sections[length(sections)]
  seams$codline_gathered <- list(
    edges = paste0(vapply(around, id, "", section = last), ".lower"), gathered_at = "codline"
  )
  points <- list(codline = stats::setNames(list(), character()))

  # The front: along the first section's front edges, or ahead of them along the wings' inner edges.
  first <- sections[1L]
  front <- stats::setNames(
    lapply(around, function(panel) paste0(id(panel, first), ".upper")), around
  )
  outer <- stats::setNames(lapply(around, function(panel) character()), around)
  if (!is.null(plan$wings)) {
    wings <- trawl_wings(fields, plan, around, after, first)
    panels <- c(wings$panels, panels)
    seams <- c(wings$seams, seams)
    front <- wings$front
    outer <- wings$outer
    points <- c(wings$points, points)
  } else {
    # The wing tips are the front corners of the panels that a line of the mouth begins with.
    for (line in names(ring$mouth)) {
      tip <- trawl_line_ends[[line]][1L]
      corner <- paste0(id(ring$mouth[[line]][1L], first), ".upper_left")
      if (!tip %in% names(points)) points[[tip]] <- list(at = corner)
    }
    if (n == 2L) {
      points$upper_starboard <- list(at = paste0(id("back", first), ".upper_right"))
      points$lower_port <- list(at = paste0(id("belly", first), ".upper_right"))
    }
  }

  line <- function(given, role, along) c(list(along = along), given, list(role = role))
  for (name in names(ring$mouth)) {
    along <- unlist(front[ring$mouth[[name]]], use.names = FALSE)
    role <- sub("_(port|starboard)$", "", name)
    given <- if (role == "side_line") plan$side_lines else plan[[name]]
    ropes[[name]] <- line(given, role, along)
  }
  if (!is.null(plan$belly_lines)) {
    until <- first_of(plan$belly_lines$until, last)
    covered <- sections[seq_len(match(until, sections))]
    given <- plan$belly_lines[setdiff(names(plan$belly_lines), "until")]
    for (k in seq_len(n)) {
      panel <- after[k]
      along <- c(outer[[panel]], paste0(vapply(covered, id, "", panel = panel), ".left"))
      ropes[[paste("belly_line", around[k], after[k], sep = "_")]] <-
        line(given, "belly_line", unname(along))
    }
  }
  for (name in names(plan$cross_ropes)) {
    given <- plan$cross_ropes[[name]]
    along <- paste0(vapply(around, id, "", section = given$behind), ".lower")
    ropes[[name]] <- line(given[setdiff(names(given), "behind")], "cross_rope", along)
  }
  list(panels = panels, seams = seams, ropes = ropes, points = points)
}

# Two wings a panel, at the ends of its front edge; each ends gathered in the wing tip at its corner.
trawl_wings <- function(fields, plan, around, after, first) {
  given <- plan$wings
  count <- fields$wings$meshes
  own <- given[setdiff(names(given), "meshes")]
  wing <- function(panel, side) paste(panel, "wing", side, sep = "_")
  panels <- seams <- front <- outer <- list()
  tips <- wing_corners(around)
  for (panel in around) {
    across <- section_panel(fields$sections[[first]], panel)$meshes$upper
    if (2 * count$base > across) {
      abort_field("wings.meshes.base", count$base,
        paste("at most half the", format(across), "meshes of the first section's front edge"))
    }
    meshes <- list(upper = count$tip, lower = count$base, deep = count$deep)
    edge <- paste0(panel, "_", first, ".upper")
    base <- format(count$base)
    from <- format(across - count$base)
    for (side in c("left", "right")) {
      panels[[wing(panel, side)]] <- c(
        own, list(meshes = meshes, tapered = if (side == "left") "right" else "left", part = "wings")
      )
    }
    whole <- format(across)
    seams[[wing(panel, "left")]] <- list(edges = c(
      paste0(wing(panel, "left"), ".lower"), paste0(edge, "[0:", base, "]")
    ))
    seams[[wing(panel, "right")]] <- list(edges = c(
      paste0(wing(panel, "right"), ".lower"), paste0(edge, "[", from, ":", whole, "]")
    ))
    front[[panel]] <- c(
      paste0(wing(panel, "left"), ".right"),
      if (2 * count$base < across) paste0(edge, "[", base, ":", from, "]"),
      paste0("-", wing(panel, "right"), ".left")
    )
    outer[[panel]] <- paste0(wing(panel, "left"), ".left")
  }
  points <- list()
  for (k in seq_along(around)) {
    # In a net of two panels the upper and the lower wings end apart.
    joined <- length(around) > 2L
    left <- wing(after[k], "left")
    right <- wing(around[k], "right")
    if (joined) {
      seams[[paste("wings", around[k], after[k], sep = "_")]] <-
        list(edges = c(paste0(right, ".right"), paste0(left, ".left")))
    }
    points[[tips[[left]]]] <- stats::setNames(list(), character())
    points[[tips[[right]]]] <- stats::setNames(list(), character())
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

# The wing tip at which each wing ends, for nets of 2 and 4 panels.
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

# A free board and the points of its backstrops, where the hand ropes begin.
free_board <- function(plan, side) {
  given <- plan$otter_boards
  points <- paste0(c("board_", "backstrop_upper_", "backstrop_lower_"), side)
  attachments <- given[c("warp_at", "upper_backstrop_at", "lower_backstrop_at")]
  c(
    list(pushes = side),
    given[setdiff(names(given), c("attitude", names(attachments)))],
    list(attachments = stats::setNames(attachments, points))
  )
}

# What a trawl's boards need by their attitude, and what they cannot take.
check_boards <- function(fields) {
  boards <- fields$otter_boards
  fixed <- c("lift_coefficient", "drag_coefficient", "diameter")
  free <- c("chord", "span", "polar", "warp_at", "upper_backstrop_at", "lower_backstrop_at",
    "centre_of_gravity", "centre_of_buoyancy", "centre_of_pressure", "shoe_area")
  is_free <- boards$attitude == "free"
  due <- if (is_free) c("mass", free[1:6]) else c("area", fixed[1:2])
  missing <- setdiff(due, names(boards))
  if (length(missing)) {
    abort_field(paste0("otter_boards.", missing[1]), NULL,
      sprintf("given where the attitude is %s", boards$attitude), "is missing")
  }
  excess <- intersect(if (is_free) fixed else free, names(boards))
  if (length(excess)) {
    abort_field(paste0("otter_boards.", excess[1]), boards[[excess[1]]],
      sprintf("left out where the attitude is %s", boards$attitude))
  }
}

trawl_rig <- function(fields, plan, ring) {
  points <- ropes <- pieces <- otter_boards <- list()
  nothing <- stats::setNames(list(), character())
  warp <- plan$warps[setdiff(names(plan$warps), "spacing")]
  aside <- fields$warps$spacing / 2
  free <- fields$otter_boards$attitude == "free"
  without <- function(given, drop) given[setdiff(names(given), drop)]
  for (side in c("port", "starboard")) {
    block <- paste0("block_", side)
    board <- paste0("board_", side)
    points[[block]] <- list(
      position = list(0, if (side == "port") -aside else aside, 0), held = "moved"
    )
    points[[board]] <- nothing
    ropes[[paste0("warp_", side)]] <- c(list(from = block, to = board), warp, list(role = "warp"))
    for (level in c("upper", "lower")) {
      ropes[[paste("hand_rope", level, side, sep = "_")]] <- c(
        list(
          from = if (free) paste0("backstrop_", level, "_", side) else board,
          to = paste(level, side, sep = "_")
        ),
        plan$hand_ropes[[level]],
        list(role = "hand_rope")
      )
    }
    if (free) {
      otter_boards[[paste0("otter_board_", side)]] <- free_board(plan, side)
      points[paste0(c("backstrop_upper_", "backstrop_lower_"), side)] <- list(nothing)
    } else {
      pieces[[paste0("otter_board_", side)]] <- c(
        list(at = board), plan$otter_boards[setdiff(names(plan$otter_boards), "attitude")],
        list(lift_direction = side, role = "otter_board")
      )
    }
    if (!is.null(plan$hammers)) {
      pieces[[paste0("hammer_", side)]] <- c(
        list(at = paste0("lower_", side)), plan$hammers, list(role = "hammer")
      )
    }
    # Where no side panel holds them, the wing tips are joined by the side line alone.
    if (is.null(ring$mouth$side_line_port) && !is.null(plan$side_lines)) {
      ropes[[paste0("side_line_", side)]] <- c(
        list(from = paste0("upper_", side), to = paste0("lower_", side)), plan$side_lines,
        list(role = "side_line")
      )
    }
  }
  if (!is.null(plan$floats)) {
    pieces$floats <- c(list(along = "head_line"), plan$floats, list(role = "float"))
  }
  if (!is.null(plan$canvas)) {
    pieces$canvas <- c(
      list(along = "head_line"), plan$canvas, list(lift_direction = "up", role = "canvas")
    )
  }
  if (!is.null(plan$catch)) {
    pieces$catch <- c(list(at = "codline"), plan$catch, list(role = "catch"))
  }
  list(points = points, ropes = ropes, pieces = pieces, otter_boards = otter_boards)
}

trawl_measures <- function(ring, free_boards) {
  pair <- function(level) paste0(level, c("_port", "_starboard"))
  out <- list(
    door_spread = list(spread = pair("board")),
    wing_end_spread = list(spread = list(pair("upper"), pair("lower"))),
    net_mouth_height = list(height = c("head_line.middle", "footrope.middle")),
    wing_end_height = list(height = c("upper_port", "lower_port"))
  )
  if (length(ring$mouth) == 4L) out$mouth_area <- list(area = names(ring$mouth))
  angles <- lapply(stats::setNames(nm = free_boards), function(board) {
    stats::setNames(
      lapply(c("attack", "heel"), function(a) list(attitude = stats::setNames(list(a), board))),
      paste0(c("attack", "heel"), sub("otter_board", "", board, fixed = TRUE))
    )
  })
  out <- c(out, unlist(unname(angles), recursive = FALSE))
  c(out, list(
    door_depth = list(depth = "board_port"),
    headline_depth = list(depth = "head_line.middle"),
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
