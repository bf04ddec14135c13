# Bottom trawl (short form).
#
# From fore to aft on each side: warp, otter board, sweep, bridles, wing end. The net has upper
# wings and a square above, and lower wings below. A net of four panels also has a wing panel on
# each side, with an optional jib at its front for a middle bridle. The side line follows the wing
# end from the headline to the footrope.

expand_bottom_trawl <- function(fields, plan) {
  check_bottom_trawl(fields)
  rig <- bottom_trawl_rig(fields, plan)
  out <- rigged_net(fields, plan, rig)
  out$measures <- bottom_trawl_measures(fields, names(rig$otter_boards))
  out
}

# Returns the assembly of a bottom trawl's net and its rig.
rigged_net <- function(fields, plan, rig) {
  net <- bottom_trawl_net(fields, plan)
  # A jib has a point at its tip even without a middle bridle.
  if (!is.null(fields$bridles$middle) || !is.null(fields$wings$jib)) {
    net$points <- c(net$points, middle_points(net, fields))
  }
  trawl_assembly(fields, plan, net, rig)
}

# Returns the assembly of a trawl from its net and its rig.
trawl_assembly <- function(fields, plan, net, rig) {
  out <- shared_fields(plan, fields)
  out$points <- c(rig$points, net$points)
  out$ropes <- c(rig$ropes, net$ropes)
  out[c("panels", "seams")] <- net[c("panels", "seams")]
  out$pieces <- c(rig$pieces, trawl_fittings(fields, plan, net))
  out$otter_boards <- rig$otter_boards
  out
}

# Returns a rig without otter boards: warps from separate points, and legs from the warp ends.
boardless_rig <- function(fields, plan, apart) {
  check_section_names(fields)
  check_wing_ends(fields)
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
  check_section_names(fields)
  check_wing_ends(fields)
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
  if (!is.null(fields$net)) return(invisible())
  wings <- fields$wings
  sides <- isTRUE(fields$panels == 4)
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

# Returns list(panels, seams, points, ropes) of the net of a bottom trawl.
bottom_trawl_net <- function(fields, plan) {
  grid <- if (is.null(fields$net)) bottom_trawl_grid(fields, plan) else net_grid(fields, plan)
  trawl_net(grid, fields, plan)
}

# Returns the points at the ends of the middle bridles: the tip of a pointed piece at the front of a
# side panel, otherwise the joints between sections of the side line, or points at equal distances
# along it.
middle_points <- function(net, fields) {
  tiers <- setdiff(names(bridle_tiers(fields$bridles)), c("upper", "lower"))
  if (!length(tiers)) tiers <- "middle"
  count <- length(tiers)
  sections <- length(fields$side_lines$sections)
  out <- list()
  for (k in seq_along(tiers)) {
    for (side in trawl_sides) {
      piece <- net$fronts[[side]]
      line <- paste0("side_line_", side)
      port <- side == "port"
      out[[paste(tiers[k], side, sep = "_")]] <- list(at =
        if (length(piece) && net$panels[[piece]]$meshes$upper == 0) {
          if (count > 1L) {
            abort_field("bridles.middle", count, "one bridle to the tip of the side panel",
              is = paste("has", count, "bridles"))
          }
          paste0(piece, ".upper_left")
        } else if (sections > 0L) {
          if (sections != count + 1L) {
            abort_field("side_lines.sections", sections, sprintf(
              "%d sections, with one joint for each middle bridle", count + 1L
            ), is = paste("has", sections))
          }
          # Chains of side lines run upwards on the port side.
          ropes <- rope_names(line, fields, "side_lines")
          if (port) paste0(rev(ropes)[k], ".start") else paste0(ropes[k], ".end")
        } else if (count == 1L) {
          paste0(line, ".middle")
        } else {
          from_top <- k / (count + 1L)
          sprintf("%s[%.6g]", line, if (port) 1 - from_top else from_top)
        })
    }
  }
  out
}

# Returns the grid of a bottom trawl: wings, jibs and square ahead of the sections.
bottom_trawl_grid <- function(fields, plan) {
  grid <- section_grid(fields, plan, panels_around(fields))
  # Returns a tier's pair of wings ahead of a cell, or NULL without wings.
  wings <- function(panel, tier, behind) {
    wing <- fields$wings[[tier]]
    if (is.null(wing)) return(NULL)
    given <- plan$wings[[tier]]
    counts <- wing_counts(wing$meshes, behind$counts$upper, paste0("wings.", tier, ".meshes"))
    wing_cell(paste0(panel, "_wing"), given[setdiff(names(given), c("flying", "meshes"))], counts,
      wing$mesh_size, wing$flying)
  }
  square <- if (!is.null(plan$square)) {
    new_cell(list(back_square = c(plan$square, list(part = "square"))), fields$square$meshes,
      fields$square$mesh_size)
  }
  first <- lapply(stats::setNames(nm = names(grid$columns)), function(panel) {
    column_cells(grid, panel)[[1L]]
  })
  ahead <- list(
    back_upper_wings = wings("back", "upper", first_of(square, first$back)),
    belly_lower_wings = wings("belly", "lower", first$belly)
  )
  if (isTRUE(fields$panels == 4)) {
    ahead <- c(ahead, side_cells(fields, plan, "port"), side_cells(fields, plan, "starboard"))
  }
  ahead <- Filter(Negate(is.null), c(ahead, list(back_square = square)))
  for (panel in names(grid$columns)) {
    rows <- paste(panel, c("upper_wings", "lower_wings", "jib", "wing", "square"), sep = "_")
    rows <- sub(paste0(panel, "_"), "", intersect(rows, names(ahead)), fixed = TRUE)
    grid$columns[[panel]] <- c(rows, grid$columns[[panel]])
  }
  grid$cells <- c(ahead, grid$cells)
  grid
}

# Returns the side wing of one side of a net of four panels and its jib. A side wing has the width
# of the side panel behind it. A jib is pointed and has one straight edge in line with the upper
# seam.
side_cells <- function(fields, plan, side) {
  wing <- fields$wings$side
  given <- plan$wings$side
  name <- paste0("side_", side, c("_wing", "_jib"))
  piece <- function(name, given) stats::setNames(list(c(given, list(part = "wings"))), name)
  cells <- list(new_cell(piece(name[1L], given), wing$meshes, wing$mesh_size))
  names(cells) <- name[1L]
  deep <- fields$wings$jib$deep
  if (is.null(deep)) return(cells)
  depth <- front_depth(fields)
  # Meshes of the jib along the upper seam, behind the headline end.
  seamed <- max(depth[["upper"]] - depth[["side"]], 0) / wing$mesh_size
  free <- c(left = deep, right = deep)
  free[[if (side == "starboard") "left" else "right"]] <- deep - seamed
  counts <- list(upper = 0, lower = wing$meshes$upper, deep = deep)
  jib <- c(given[setdiff(names(given), c("meshes", "cutting"))], list(
    meshes = counts, tapered = if (side == "starboard") "right" else "left"
  ))
  cells[[name[2L]]] <- new_cell(piece(name[2L], jib), counts, wing$mesh_size, free)
  cells
}

# Mass in air over mass in water of steel, for ground gear with only the mass in water.
steel_in_air <- 7850 / (7850 - 1025)

# Returns the ground gear as a rope along the footrope. `lengths`: lengths of the footrope along
# each edge, which define the distribution of the ground gear, or NULL.
ground_gear_rope <- function(fields, plan, along, lengths) {
  gear <- fields$ground_gear
  own <- plan$ground_gear[names(plan$ground_gear) != "discs"]
  own <- weighed_line(gear, own, fields$water$density)
  if (!is.null(lengths) && !is.null(gear[["length"]])) {
    own$length <- NULL
    own$lengths <- lengths * gear[["length"]] / sum(lengths)
  }
  c(list(along = along), own, list(role = "ground_gear"))
}

# Returns the fields `own` of ground gear with its mass in air and its volume, from its material or
# its mass in water. `gear`: the fields in SI; `density`: of the water.
weighed_line <- function(gear, own, density) {
  if (!is.null(gear$material) || is.null(gear$mass_in_water)) return(own)
  in_air <- first_of(gear$mass_per_length, steel_in_air * gear$mass_in_water)
  if (in_air < gear$mass_in_water) {
    abort_field("ground_gear.mass_per_length", in_air,
      paste("at least the mass in water,", format_si(gear$mass_in_water, "mass_per_length")))
  }
  own <- own[setdiff(names(own), c("mass_in_water", "mass_per_length"))]
  own$mass_per_length <- in_air
  own$volume_per_length <- if (density > 0) (in_air - gear$mass_in_water) / density else 0
  own
}

bottom_trawl_rig <- function(fields, plan) {
  if (!is.null(plan$towing_points)) {
    tow <- fields$towing_points
    points <- towing_points(paste0("board_", trawl_sides), tow$spread,
      fields$seabed$depth - tow$height)
    return(trawl_legs(plan, fields, list(points = points), paste0("board_", trawl_sides)))
  }
  rig <- boards_on_warps(fields, plan)
  start <- paste0("board_", trawl_sides)
  if (!is.null(plan$backstrops)) {
    start <- paste0("backstrop_end_", trawl_sides)
    rig$points[start] <- list(nothing)
    for (side in trawl_sides) {
      for (tier in c("upper", "lower")) {
        name <- paste("backstrop", tier, side, sep = "_")
        # A board of fixed attitude is a point, from which both backstrops lead.
        from <- if (length(rig$otter_boards)) name else paste0("board_", side)
        rig$ropes[[name]] <- rope_between(from, paste0("backstrop_end_", side),
          of_side(plan$backstrops, side), "backstrop")
      }
    }
  }
  trawl_legs(plan, fields, rig, start)
}

# Returns the ropes around the mouth in order.
mouth_ropes <- function(fields) {
  side <- function(of) rope_names(paste0("side_line_", of), fields, "side_lines")
  c(rope_names("headline", fields), side("starboard"), rope_names("footrope", fields), side("port"))
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
    mouth_area = list(area = mouth_ropes(fields)),
    bridle_angle = list(angle = stats::setNames(list("divergence", "divergence"),
      paste0(pair(first), ".start")))
  )
  names(out)[1L] <- measure
  if (!is.null(fields$seabed)) {
    out <- append(out, after = match("net_mouth_height", names(out)), list(
      headline_height = list(clearance = "headline.middle"),
      footrope_height = list(clearance = "footrope.middle")
    ))
  }
  bridles <- names(bridle_tiers(fields$bridles))
  middle <- setdiff(bridles, c("upper", "lower"))
  out <- append(out, after = match("lower_wing_spread", names(out)), stats::setNames(
    lapply(middle, function(tier) list(spread = pair(tier))),
    sub("(_[0-9]+)?$", "_wing_spread\\1", middle)
  ))
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
  for (tier in bridles) {
    out[[paste0("bridle_", tier, "_tension")]] <-
      list(tension = paste0("bridle_", tier, "_port.end"))
  }
  out$net_length <- list(length = c("upper_port", "codline"))
  c(out, grid_measures(fields))
}
