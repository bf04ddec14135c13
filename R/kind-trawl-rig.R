# Common parts of trawl short forms: the towing gear of a net and its fittings.

trawl_sides <- c("port", "starboard")

# Returns the towing points: one per side, half the spacing (m) off centre, at a depth (m).
towing_points <- function(names, spacing, depth = 0) {
  aside <- c(-1, 1) * spacing / 2
  stats::setNames(
    lapply(aside, function(y) list(position = list(0, y, -depth), held = "moved")), names
  )
}

# Returns the fields on one side; `port` or `starboard` overrides the common fields.
of_side <- function(given, side) {
  own <- given[setdiff(names(given), trawl_sides)]
  own[names(given[[side]])] <- given[[side]]
  own
}

# Returns the warps from the points `block_*` to the points `board_*`, or to the prefix `to`.
trawl_warps <- function(plan, to = "board") {
  given <- plan$warps[setdiff(names(plan$warps), "spacing")]
  warps <- lapply(trawl_sides, function(side) {
    rope_between(paste0("block_", side), paste(to, side, sep = "_"), of_side(given, side), "warp")
  })
  stats::setNames(warps, paste0("warp_", trawl_sides))
}

# Returns warps with otter boards at the points `board_*`: list(points, ropes, pieces,
# otter_boards). A free board also has the points `backstrop_upper_*` and `backstrop_lower_*`.
boards_on_warps <- function(fields, plan) {
  rig <- list(points = towing_points(paste0("block_", trawl_sides), fields$warps$spacing),
    ropes = trawl_warps(plan))
  for (side in trawl_sides) {
    board <- paste0("board_", side)
    rig$points[[board]] <- nothing
    name <- paste0("otter_board_", side)
    if (fields$otter_boards$attitude == "free") {
      rig$otter_boards[[name]] <- free_board(plan, side)
      rig$points[paste0(c("backstrop_upper_", "backstrop_lower_"), side)] <- list(nothing)
    } else {
      rig$pieces[[name]] <- c(
        list(at = board), plan$otter_boards[setdiff(names(plan$otter_boards), "attitude")],
        list(lift_direction = side, role = "otter_board")
      )
    }
  }
  rig
}

free_board <- function(plan, side) {
  given <- plan$otter_boards
  points <- paste0(c("board_", "backstrop_upper_", "backstrop_lower_"), side)
  attachments <- given[c("warp_at", "upper_backstrop_at", "lower_backstrop_at")]
  c(
    list(lift_direction = side),
    given[setdiff(names(given), c("attitude", names(attachments)))],
    list(attachments = stats::setNames(attachments, points))
  )
}

# Checks the fields of otter boards: an attitude requires some fields and excludes others.
check_boards <- function(fields) {
  boards <- fields$otter_boards
  fixed <- c("lift_coefficient", "drag_coefficient", "diameter", "vertical_lift_coefficient")
  free <- c("chord", "span", "polar", "warp_at", "upper_backstrop_at", "lower_backstrop_at",
    "centre_of_gravity", "centre_of_buoyancy", "centre_of_pressure", "shoe_area",
    "shoe_friction")
  is_free <- boards$attitude == "free"
  due <- if (is_free) c("mass", free[1:6]) else c("area", fixed[1:2])
  missing <- setdiff(due, names(boards))
  if (length(missing)) {
    abort_field(paste0("otter_boards.", missing[1]), NULL,
      sprintf("given with the attitude %s", boards$attitude), "is missing")
  }
  excess <- intersect(if (is_free) fixed else free, names(boards))
  if (length(excess)) {
    abort_field(paste0("otter_boards.", excess[1]), boards[[excess[1]]],
      sprintf("omitted with the attitude %s", boards$attitude))
  }
}

# Adds the legs behind the points `from` to a rig (list of points, ropes, pieces, otter_boards).
# Legs are sweeps, bridles to the wing ends with the weights at their ends, and extensions of
# headline and footrope. `fields`: checked, in SI.
trawl_legs <- function(plan, fields, rig, from) {
  for (name in names(plan$ticklers)) {
    rig$ropes[[name]] <-
      rope_between("lower_port", "lower_starboard", plan$ticklers[[name]], "tickler")
  }
  bridles <- bridle_tiers(plan$bridles)
  extensions <- list(
    upper = plan[["headline_extensions"]], lower = plan[["footrope_extensions"]]
  )
  points <- c(upper = "headline_extension", lower = "extension")
  roles <- c(upper = "headline_extension", lower = "footrope_extension")
  for (k in 1:2) {
    side <- trawl_sides[k]
    named <- function(...) paste(..., side, sep = "_")
    start <- from[k]
    if (!is.null(plan$sweeps)) {
      rig$points[[named("sweep_end")]] <- nothing
      rig$ropes[[named("sweep")]] <-
        rope_between(start, named("sweep_end"), of_side(plan$sweeps, side), "sweep")
      start <- named("sweep_end")
    }
    for (tier in names(bridles)) {
      extended <- !is.null(extensions[[tier]])
      rig$ropes[[named("bridle", tier)]] <- rope_between(
        start, named(if (extended) points[[tier]] else tier),
        set_back(bridles[[tier]], bridle_tiers(fields$bridles)[[tier]], side), "bridle"
      )
      if (!extended) next
      rig$points[[named(points[[tier]])]] <- nothing
      rig$ropes[[named(roles[[tier]])]] <- rope_between(named(points[[tier]]), named(tier),
        of_side(extensions[[tier]], side), roles[[tier]])
    }
    rig$pieces[[named("danleno")]] <- part_with_role(plan$danlenos, "weight", at = start)
    rig$pieces[[named("wing_end_weight")]] <- part_with_role(plan$wing_end_weights, "weight",
      at = named("lower"))
  }
  rig
}

# Returns the bridles of a side from top to bottom, by tier: upper, middle (or middle_1, middle_2
# and so on), lower.
bridle_tiers <- function(bridles) {
  middle <- bridles["middle"]
  if (is.null(names(middle$middle)) && length(middle$middle)) {
    middle <- middle$middle
    names(middle) <- paste0("middle_", seq_along(middle))
  }
  Filter(length, c(bridles["upper"], middle, bridles["lower"]))
}

# Returns a bridle on one side. Its setback is added to its length.
set_back <- function(given, fields, side) {
  own <- of_side(given[names(given) != "setback"], side)
  # Without a setback, keep the length as written in the plan.
  if (isTRUE(fields$setback > 0)) own$length <- of_side(fields, side)$length + fields$setback
  own
}

# Returns a group of floats as a piece along the headline. `fields`: the checked group; `given`: as
# in the plan; `line`: fields of the line; `path`: path of the group; `along`: its rope or chain.
float_group <- function(fields, given, line, path, along) {
  piece <- c(list(along = along), given[setdiff(names(given), "spacing")],
    list(role = "float"))
  spaced_group(piece, fields, given, line, path, "the headline")
}

# Returns a group of discs or bobbins as a piece along the ground gear. Mass and volume equal a
# solid cylinder. The drag equals a short cylinder with its axis normal to the flow.
disc_group <- function(fields, given, line, path, along) {
  full <- pi / 4 * fields$diameter^2 * fields$width
  density <- first_of(fields$density, rubber_density)
  mass <- first_of(fields$mass, density * full)
  volume <- if (!is.null(fields$mass) && !is.null(fields$density)) mass / density else full
  piece <- c(
    list(along = along), given[intersect(c("number", "extent"), names(given))],
    list(mass = mass, volume = volume, area = fields$diameter * fields$width,
      drag_coefficient = fields$drag_coefficient, role = "disc")
  )
  spaced_group(piece, fields, given, line, path, "the ground gear")
}

# Default density, kg/m3 (an assumption). Raw natural rubber has 920; vulcanised rubber with fillers
# has 1100 to 1500. Makers of discs do not publish theirs.
rubber_density <- 1250

# Returns one group or a list of groups along a line as pieces: `name`, or `name_1`, `name_2`...
grouped_pieces <- function(group, fields, given, line, name, path, along) {
  if (is.null(given)) return(list())
  if (!is.null(names(given))) {
    return(stats::setNames(list(group(fields, given, line, path, along)), name))
  }
  pieces <- lapply(seq_along(given), function(k) {
    group(fields[[k]], given[[k]], line, sprintf("%s[%d]", path, k), along)
  })
  stats::setNames(pieces, sprintf("%s_%d", name, seq_along(given)))
}

# Limits a piece along a line to the stretch that the `spacing` of its group takes.
spaced_group <- function(piece, fields, given, line, path, called) {
  if (is.null(fields$spacing)) return(piece)
  if (is.null(line$length)) {
    abort_field(paste0(path, ".spacing"), given$spacing,
      sprintf("used only if %s has a `length`", called))
  }
  share <- first_of(fields$extent, c(0, 1))
  room <- diff(share) * line$length
  number <- first_of(fields$number, floor(room / fields$spacing + 1e-9) + 1)
  taken <- (number - 1) * fields$spacing
  if (taken > room + 1e-6) {
    abort_field(paste0(path, ".spacing"), given$spacing, sprintf(
      "at most %s, so that all %s fit on %s",
      format_si(room / (number - 1), "length"), format(number), format_si(room, "length")
    ))
  }
  if (number == 1) return(piece)
  piece$number <- number
  piece$extent <- mean(share) + c(-0.5, 0.5) * taken / line$length
  piece$extent <- pmin(pmax(piece$extent, 0), 1)
  piece$end_to_end <- TRUE
  piece
}

# Returns floats on the headline, discs on the ground gear, grids, and a catch as a piece at the
# codline. `net`: result of `trawl_net()`.
trawl_fittings <- function(fields, plan, net) {
  headline <- net$headline
  if (!is.null(fields$floats) && !is.null(fields$headline$sections)) {
    abort_field("floats", "given", "replaced by `floats` of each of `headline.sections`")
  }
  pieces <- c(
    grouped_pieces(float_group, fields$floats, plan$floats, fields$headline, "floats", "floats",
      headline),
    do.call(c, lapply(setdiff(names(net$lines), c("ground_gear", "cross_ropes")), section_pieces,
      mounted = "floats", float_group, fields, plan, net)),
    grouped_pieces(disc_group, fields$ground_gear$discs, plan$ground_gear$discs,
      fields$ground_gear, "discs", "ground_gear.discs", "ground_gear"),
    section_pieces("ground_gear", "discs", disc_group, fields, plan, net),
    net$pieces
  )
  pieces$canvas <- part_with_role(plan$canvas, "canvas", along = headline, lift_direction = "up")
  pieces$catch <- part_with_role(plan$catch, "catch", at = "codline")
  pieces
}

# Returns the measures of attack and heel of the free boards.
board_measures <- function(free_boards) {
  angles <- lapply(stats::setNames(nm = free_boards), function(board) {
    stats::setNames(
      lapply(c("attack", "heel"), function(a) list(attitude = stats::setNames(list(a), board))),
      paste0(c("attack", "heel"), sub("otter_board", "", board, fixed = TRUE))
    )
  })
  unlist(unname(angles), recursive = FALSE)
}
