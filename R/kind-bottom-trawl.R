# Bottom trawl (short form).
#
# From fore to aft on each side: warp, otter board, sweep, bridles, wing end. The net has upper
# wings and a square above, and lower wings below. A net of four panels also has a wing panel on
# each side, with an optional jib at its front for a middle bridle. The side line follows the wing
# end from the headline to the footrope.

bottom_trawl_rings <- list(
  `2` = c("back", "belly"), `4` = c("back", "side_starboard", "belly", "side_port")
)

expand_bottom_trawl <- function(fields, plan) {
  check_bottom_trawl(fields)
  rig <- bottom_trawl_rig(fields, plan)
  out <- rigged_net(fields, plan, rig)
  out$otter_boards <- rig$otter_boards
  out$measures <- bottom_trawl_measures(fields, names(rig$otter_boards))
  out
}

# Returns the assembly of a bottom trawl's net and its rig.
rigged_net <- function(fields, plan, rig) {
  net <- bottom_trawl_net(fields, plan)
  out <- shared_fields(plan, fields)
  out$points <- c(rig$points, net$points)
  out$ropes <- c(rig$ropes, net$ropes)
  out$panels <- net$panels
  out$seams <- net$seams
  out$pieces <- c(rig$pieces, trawl_fittings(fields, plan, panels_around(fields)))
  out
}

# Returns a rig without otter boards: warps from separate points, and legs from the warp ends.
boardless_rig <- function(fields, plan, apart) {
  check_section_names(fields)
  check_wing_ends(fields)
  check_middle_bridle(fields)
  ends <- paste0("warp_end_", trawl_sides)
  rig <- list(
    points = c(
      towing_points(paste0("block_", trawl_sides), apart),
      stats::setNames(list(nothing, nothing), ends)
    ),
    ropes = trawl_warps(plan, to = "warp_end")
  )
  trawl_legs(plan, fields, rig, ends)
}

check_bottom_trawl <- function(fields) {
  if (is.null(fields$towing_points)) {
    for (part in c("warps", "otter_boards")) {
      if (is.null(fields[[part]])) {
        abort_field(part, NULL, "given in a plan without `towing_points`", "is missing")
      }
    }
    check_boards(fields)
    free <- fields$otter_boards$attitude == "free"
    if (free && is.null(fields$backstrops)) {
      abort_field("backstrops", NULL, "given with free otter boards", "is missing")
    }
  } else {
    for (part in c("warps", "otter_boards", "backstrops")) {
      if (!is.null(fields[[part]])) {
        abort_field(part, "given", "omitted in a plan with `towing_points`")
      }
    }
    free <- FALSE
    if (fields$towing_points$height >= fields$seabed$depth) {
      abort_field("towing_points.height", fields$towing_points$height,
        paste("less than the depth of the sea bed,", format_si(fields$seabed$depth, "length")))
    }
  }
  if (!free && !is.null(fields$backstrops)) {
    abort_field("backstrops", "given", "omitted without free otter boards")
  }
  check_section_names(fields)
  check_wing_ends(fields)
  check_middle_bridle(fields)
}

# Returns the stretched depth (m) along the upper, lower and side seams ahead of section 1.
front_depth <- function(fields) {
  deep <- function(panel) {
    if (is.null(panel)) return(0)
    panel$mesh_size * (panel$meshes$deep - first_of(panel$flying, 0))
  }
  c(
    upper = deep(fields$wings$upper) + deep(fields$square), lower = deep(fields$wings$lower),
    side = deep(fields$wings$side)
  )
}

check_wing_ends <- function(fields) {
  wings <- fields$wings
  sides <- fields$panels == 4
  if (sides && is.null(wings$side)) {
    abort_field("wings.side", NULL, "given in a trawl of 4 panels", "is missing")
  }
  for (part in c("side", "jib")) {
    if (!sides && !is.null(wings[[part]])) {
      abort_field(paste0("wings.", part), "given", "omitted in a trawl of 2 panels")
    }
  }
  for (tier in names(wings)[names(wings) %in% c("upper", "lower")]) {
    wing <- wings[[tier]]
    if (wing$flying >= wing$meshes$deep) {
      abort_field(paste0("wings.", tier, ".flying"), wing$flying,
        paste("less than the wing's", format(wing$meshes$deep), "meshes deep"))
    }
  }
  height <- sum(unlist(lapply(wings[c("upper", "lower")], function(wing) {
    wing$meshes$tip + wing$flying
  })))
  if (!sides && height == 0) {
    abort_field("wings.lower.meshes.tip", 0,
      "greater than 0 without a flying wing or blunt tip; otherwise the wing ends have no height")
  }
  depth <- front_depth(fields)
  long <- function(x) format_si(x, "length")
  # Returns the number of meshes of a wing with that length.
  meshes_of <- function(x, wing) {
    format(round(x / wing$mesh_size + first_of(wing$flying, 0)))
  }
  alike <- function(a, b) abs(a - b) <= 0.05 * max(a, b)
  lower <- if (sides) depth[["side"]] else depth[["upper"]]
  if (!alike(depth[["lower"]], lower)) {
    abort_field("wings.lower.meshes.deep", fields$wings$lower$meshes$deep, sprintf(
      paste(
        "a count that makes the lower wings as deep as %s, %s, within 5 %% (%s meshes); they",
        "are %s deep"
      ),
      if (sides) "the side wings" else "upper wings plus square",
      long(lower), meshes_of(lower, wings$lower), long(depth[["lower"]])
    ))
  }
  if (sides) {
    ahead <- depth[["upper"]] - depth[["side"]]
    if (is.null(wings$jib) && !alike(depth[["upper"]], depth[["side"]])) {
      abort_field("wings.side.meshes.deep", wings$side$meshes$deep, sprintf(
        paste(
          "a count that makes the side wings as deep as upper wings plus square, %s, within 5 %%",
          "(%s meshes; a jib may be longer); they are %s deep"
        ),
        long(depth[["upper"]]), meshes_of(depth[["upper"]], wings$side), long(depth[["side"]])
      ))
    }
    if (!is.null(wings$jib)) {
      reach <- wings$jib$deep * wings$side$mesh_size
      if (ahead < -0.05 * depth[["side"]] || ahead >= reach) {
        abort_field("wings.jib.deep", wings$jib$deep, sprintf(
          paste(
            "more than %s (%s meshes), the depth of upper wings plus square minus the depth of the",
            "side wings, which must not be negative; the jib is %s deep"
          ),
          long(ahead), meshes_of(ahead, wings$side), long(reach)
        ))
      }
    }
  }
}

check_middle_bridle <- function(fields) {
  if (!is.null(fields$bridles$middle) && is.null(fields$wings$jib)) {
    # Suggest a jib half as deep as the side wing.
    deep <- ceiling(fields$wings$side$meshes$deep / 2)
    words <- "omitted in a plan without `wings.jib`"
    if (length(deep)) words <- sprintf("%s, such as `jib: {deep: %s}`", words, format(deep))
    if (fields$panels == 2) words <- paste(words, "(in a trawl of 4 panels)")
    abort_field("bridles.middle", "given", words)
  }
}

panels_around <- function(fields) bottom_trawl_rings[[as.character(fields$panels)]]

bottom_trawl_net <- function(fields, plan) {
  around <- panels_around(fields)
  net <- trawl_sections(plan, around)
  first <- names(plan$sections)[1L]
  behind <- c(back = section_panel_name("back", first), belly = section_panel_name("belly", first))
  across <- c(
    back = section_panel(fields$sections[[first]], "back")$meshes$upper,
    belly = section_panel(fields$sections[[first]], "belly")$meshes$upper
  )
  panels <- seams <- list()
  if (!is.null(plan$square)) {
    panels$back_square <- c(plan$square, list(part = "square"))
    seams$back_square <- list(edges = c("back_square.lower", paste0(behind[["back"]], ".upper")))
    behind[["back"]] <- "back_square"
    across[["back"]] <- fields$square$meshes$upper
  }
  # Without upper wings the headline follows the whole front of the back.
  tiers <- c(back = "upper", belly = "lower")
  tiers <- tiers[tiers %in% names(plan$wings)]
  pairs <- Map(function(panel, tier) {
    given <- plan$wings[[tier]]
    wing_pair(panel, behind[[panel]], across[[panel]], given[names(given) != "flying"],
      fields$wings[[tier]]$meshes, paste0("wings.", tier, ".meshes"))
  }, stats::setNames(nm = names(tiers)), tiers)
  sides <- if (fields$panels == 4) side_wings(fields, plan, first) else NULL
  square <- if (!is.null(plan$square)) c(left = "back_square.left", right = "back_square.right")

  # Edges along the seams ahead of the first section, from the front, by panel.
  outer <- function(panel, side) {
    part <- if (panel %in% names(tiers)) {
      flying_edge(fields$wings[[tiers[[panel]]]], pairs[[panel]][[side]], side)
    }
    c(part$joined, if (panel == "back" && !is.null(square)) square[[side]])
  }
  left <- c(list(back = outer("back", "left"), belly = outer("belly", "left")), sides$left)
  right <- c(list(back = outer("back", "right"), belly = outer("belly", "right")), sides$right)
  after <- panel_after(around)
  for (k in seq_along(around)) {
    seams[[paste("wings", around[k], after[k], sep = "_")]] <-
      list(edges = list(right[[around[k]]], left[[after[k]]]))
  }

  net$panels <- c(pairs$back$panels, pairs$belly$panels, sides$panels, panels, net$panels)
  net$seams <- c(pairs$back$seams, pairs$belly$seams, sides$seams, seams, net$seams)
  net$points <- c(
    list(
      upper_port = list(at = first_of(tip_corner(pairs$back, "left"),
        paste0(behind[["back"]], ".upper_left"))),
      upper_starboard = list(at = first_of(tip_corner(pairs$back, "right"),
        paste0(behind[["back"]], ".upper_right"))),
      lower_port = list(at = tip_corner(pairs$belly, "right")),
      lower_starboard = list(at = tip_corner(pairs$belly, "left"))
    ),
    if (!is.null(fields$wings$jib)) {
      list(
        middle_port = list(at = "side_port_jib.upper_left"),
        middle_starboard = list(at = "side_starboard_jib.upper_left")
      )
    },
    net$points
  )
  # Wing end: tip and free outer edge, from port to starboard above and back below.
  end <- function(panel, side) {
    if (!panel %in% names(tiers)) return(NULL)
    tier <- tiers[[panel]]
    wing <- fields$wings[[tier]]
    free <- flying_edge(wing, pairs[[panel]][[side]], side)$free
    tip <- if (wing$meshes$tip > 0) paste0(pairs[[panel]][[side]], ".upper")
    if (side == "right") c(tip, free) else c(if (!is.null(free)) paste0("-", free), tip)
  }
  mouth <- list(
    headline = first_of(pairs$back$inner, paste0(behind[["back"]], ".upper")),
    side_line_starboard = c(end("back", "right"), sides$end$starboard, end("belly", "left")),
    footrope = pairs$belly$inner,
    side_line_port = c(end("belly", "right"), sides$end$port, end("back", "left"))
  )
  # Separate the hanging of headline and footrope into bosom and wings.
  for (line in c("headline", "footrope")) {
    plan[[line]] <- hung_line(fields, plan, line, length(mouth[[line]]))
  }
  net$ropes <- trawl_lines(plan, around, mouth, left)
  if (!is.null(plan$ground_gear)) {
    net$ropes$ground_gear <- ground_gear_rope(fields, plan, mouth$footrope, plan$footrope$lengths)
  }
  net
}

# Returns the corner of a wing tip at the end of the mouth line, or NULL without wings.
tip_corner <- function(pair, side) {
  if (is.null(pair)) return(NULL)
  paste0(pair[[side]], if (side == "left") ".upper_right" else ".upper_left")
}

# Splits a wing's outer edge: list(free = its flying part, or NULL; joined = the rest).
flying_edge <- function(wing, name, side) {
  edge <- paste0(name, ".", side)
  if (wing$flying == 0) return(list(free = NULL, joined = edge))
  split <- format(wing$flying, digits = 15)
  list(
    free = paste0(edge, "[0:", split, "]"),
    joined = paste0(edge, "[", split, ":", format(wing$meshes$deep, digits = 15), "]")
  )
}

# Returns the side wings of a net of four panels and their jibs. A side wing has the width of the
# side panel behind it. A jib is pointed and has one straight edge in line with the upper seam.
# Returns list(panels, seams, left, right = edges along seams by panel, end = wing end by side).
side_wings <- function(fields, plan, first) {
  out <- list(panels = list(), seams = list(), left = list(), right = list(), end = list())
  wing <- fields$wings$side
  given <- plan$wings$side
  depth <- front_depth(fields)
  # Meshes of the jib along the upper seam, behind the headline end.
  seamed <- max(depth[["upper"]] - depth[["side"]], 0) / wing$mesh_size
  for (side in trawl_sides) {
    panel <- paste0("side_", side)
    name <- paste0(panel, "_wing")
    out$panels[[name]] <- c(given, list(part = "wings"))
    out$seams[[name]] <- list(edges = c(
      paste0(name, ".lower"), paste0(section_panel_name(panel, first), ".upper")
    ))
    edges <- list(left = paste0(name, ".left"), right = paste0(name, ".right"))
    end <- paste0(name, ".upper")
    if (!is.null(fields$wings$jib)) {
      jib <- paste0(panel, "_jib")
      deep <- fields$wings$jib$deep
      straight <- if (side == "starboard") "left" else "right"
      slanted <- setdiff(c("left", "right"), straight)
      own <- given[setdiff(names(given), c("meshes", "cutting"))]
      out$panels[[jib]] <- c(own, list(
        meshes = list(upper = 0, lower = wing$meshes$upper, deep = deep), tapered = slanted,
        part = "wings"
      ))
      out$seams[[jib]] <- list(edges = c(paste0(jib, ".lower"), paste0(name, ".upper")))
      free <- format(deep - seamed, digits = 15)
      if (seamed > 0) {
        edges[[straight]] <- c(
          paste0(jib, ".", straight, "[", free, ":", format(deep), "]"), edges[[straight]]
        )
      }
      upper <- paste0(jib, ".", straight, if (seamed > 0) paste0("[0:", free, "]"))
      end <- if (side == "starboard") {
        c(paste0("-", upper), paste0(jib, ".right"))
      } else {
        c(paste0("-", jib, ".left"), upper)
      }
    }
    out$left[[panel]] <- edges$left
    out$right[[panel]] <- edges$right
    out$end[[side]] <- end
  }
  out
}

# Mass in air over mass in water of steel, for ground gear with only the mass in water.
steel_in_air <- 7850 / (7850 - 1025)

# Returns the ground gear as a rope along the footrope, from its material or its mass in water. The
# difference of mass and mass in water gives its volume. `lengths`: lengths of the footrope along
# each edge, which define the distribution of the ground gear, or NULL.
ground_gear_rope <- function(fields, plan, along, lengths) {
  gear <- fields$ground_gear
  density <- fields$water$density
  own <- plan$ground_gear[names(plan$ground_gear) != "discs"]
  if (is.null(gear$material)) {
    in_air <- first_of(gear$mass_per_length, steel_in_air * gear$mass_in_water)
    if (in_air < gear$mass_in_water) {
      abort_field("ground_gear.mass_per_length", in_air,
        paste("at least the mass in water,", format_si(gear$mass_in_water, "mass_per_length")))
    }
    own <- own[setdiff(names(own), c("mass_in_water", "mass_per_length"))]
    own$mass_per_length <- in_air
    own$volume_per_length <- if (density > 0) (in_air - gear$mass_in_water) / density else 0
  }
  if (!is.null(lengths) && !is.null(gear[["length"]])) {
    own$length <- NULL
    own$lengths <- lengths * gear[["length"]] / sum(lengths)
  }
  c(list(along = along), own, list(role = "ground_gear"))
}

bottom_trawl_rig <- function(fields, plan) {
  if (!is.null(plan$towing_points)) {
    tow <- fields$towing_points
    points <- towing_points(paste0("board_", trawl_sides), tow$spread,
      fields$seabed$depth - tow$height)
    return(trawl_legs(plan, fields, list(points = points), paste0("board_", trawl_sides)))
  }
  free <- fields$otter_boards$attitude == "free"
  boards <- trawl_boards(plan, free)
  start <- paste0("board_", trawl_sides)
  rig <- list(
    points = c(towing_points(paste0("block_", trawl_sides), fields$warps$spacing), boards$points),
    ropes = trawl_warps(plan), pieces = boards$pieces, otter_boards = boards$otter_boards
  )
  if (free) {
    start <- paste0("backstrop_end_", trawl_sides)
    rig$points[start] <- list(nothing)
    for (side in trawl_sides) {
      for (tier in c("upper", "lower")) {
        name <- paste("backstrop", tier, side, sep = "_")
        rig$ropes[[name]] <- rope_between(name, paste0("backstrop_end_", side),
          of_side(plan$backstrops, side), "backstrop")
      }
    }
  }
  trawl_legs(plan, fields, rig, start)
}

# joint: name of the points between warp and sweep or bridles; measure: name of their spread.
bottom_trawl_measures <- function(fields, free_boards, joint = "board",
                                  measure = "door_spread") {
  pair <- function(tier) paste0(tier, c("_port", "_starboard"))
  lower <- if (is.null(fields$footrope_extensions)) "lower" else "extension"
  first <- if (is.null(fields$sweeps)) "bridle_lower" else "sweep"
  angle <- function(rope, kind) {
    list(angle = stats::setNames(list(kind), paste0(rope, "_port.start")))
  }
  out <- list(
    list(spread = pair(joint)),
    wing_end_spread = list(spread = list(pair("upper"), pair(lower))),
    upper_wing_spread = list(spread = pair("upper")),
    lower_wing_spread = list(spread = pair(lower)),
    net_mouth_height = list(height = c("headline.middle", "footrope.middle")),
    headline_depth = list(depth = "headline.middle"),
    wing_end_height = list(height = paste0(c("upper", lower), "_port")),
    mouth_area = list(
      area = c("headline", "side_line_starboard", "footrope", "side_line_port")
    ),
    bridle_angle = angle(first, "divergence")
  )
  names(out)[1L] <- measure
  if (!is.null(fields$seabed)) {
    out <- append(out, after = match("net_mouth_height", names(out)), list(
      headline_height = list(clearance = "headline.middle"),
      footrope_height = list(clearance = "footrope.middle")
    ))
  }
  if (!is.null(fields$bridles$middle)) {
    out <- append(out, after = match("lower_wing_spread", names(out)),
      list(middle_wing_spread = list(spread = pair("middle"))))
  }
  out <- c(out, board_measures(free_boards))
  if (is.null(fields$towing_points)) {
    out <- c(out, list(
      list(depth = paste0(joint, "_port")),
      warp_tension_port = list(tension = "warp_port.start"),
      warp_tension_starboard = list(tension = "warp_starboard.start"),
      warp_declination = angle("warp", "declination"),
      warp_divergence = angle("warp", "divergence")
    ))
    names(out)[names(out) == ""] <- sub("spread", "depth", measure, fixed = TRUE)
  }
  if (!is.null(fields$sweeps)) out$sweep_tension <- list(tension = "sweep_port.start")
  for (tier in intersect(c("upper", "middle", "lower"), names(fields$bridles))) {
    out[[paste0("bridle_", tier, "_tension")]] <-
      list(tension = paste0("bridle_", tier, "_port.end"))
  }
  out$net_length <- list(length = c("upper_port", "codline"))
  out
}
