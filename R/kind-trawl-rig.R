# Parts that the short forms of trawls share: what tows a net and what is fastened to it.

trawl_sides <- c("port", "starboard")

# A towing block's point on each side, half the spacing (m) from the middle at a depth (m).
towing_points <- function(names, spacing, depth = 0) {
  aside <- c(-1, 1) * spacing / 2
  stats::setNames(
    lapply(aside, function(y) list(position = list(0, y, -depth), held = "moved")), names
  )
}

# What is given of a rope or a board on one side: its fields, with what `port` or `starboard` says
# otherwise.
of_side <- function(given, side) {
  own <- given[setdiff(names(given), trawl_sides)]
  own[names(given[[side]])] <- given[[side]]
  own
}

# The warps, from the points `block_*` to the points `board_*` or as named.
trawl_warps <- function(plan, to = "board") {
  given <- plan$warps[setdiff(names(plan$warps), "spacing")]
  warps <- lapply(trawl_sides, function(side) {
    rope_between(paste0("block_", side), paste(to, side, sep = "_"), of_side(given, side), "warp")
  })
  stats::setNames(warps, paste0("warp_", trawl_sides))
}

# The otter boards at the points `board_*`: list(points, pieces, otter_boards). A free one has the
# points `backstrop_upper_*` and `backstrop_lower_*` of its backstrops too.
trawl_boards <- function(plan, free) {
  points <- pieces <- otter_boards <- list()
  for (side in trawl_sides) {
    board <- paste0("board_", side)
    points[[board]] <- nothing
    name <- paste0("otter_board_", side)
    if (free) {
      otter_boards[[name]] <- free_board(plan, side)
      points[paste0(c("backstrop_upper_", "backstrop_lower_"), side)] <- list(nothing)
    } else {
      pieces[[name]] <- c(
        list(at = board), plan$otter_boards[setdiff(names(plan$otter_boards), "attitude")],
        list(lift_direction = side, role = "otter_board")
      )
    }
  }
  list(points = points, pieces = pieces, otter_boards = otter_boards)
}

# A free board and the points of its backstrops.
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
  fixed <- c("lift_coefficient", "drag_coefficient", "diameter", "vertical_lift_coefficient")
  free <- c("chord", "span", "polar", "warp_at", "upper_backstrop_at", "lower_backstrop_at",
    "centre_of_gravity", "centre_of_buoyancy", "centre_of_pressure", "shoe_area",
    "shoe_friction")
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

# Adds to a rig (list of points, ropes, pieces, otter_boards) what follows on each side from these
# points: sweep, bridles to the wing ends with what they begin and end at, and extensions of head
# line and footrope. fields: the plan's, checked, in SI.
trawl_legs <- function(plan, fields, rig, from) {
  for (name in names(plan$ticklers)) {
    rig$ropes[[name]] <-
      rope_between("lower_port", "lower_starboard", plan$ticklers[[name]], "tickler")
  }
  tiers <- intersect(c("upper", "middle", "lower"), names(plan$bridles))
  extensions <- list(
    upper = plan[["head_line_extensions"]], lower = plan[["footrope_extensions"]]
  )
  points <- c(upper = "head_line_extension", lower = "extension")
  roles <- c(upper = "head_line_extension", lower = "footrope_extension")
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
    for (tier in tiers) {
      extended <- !is.null(extensions[[tier]])
      rig$ropes[[named("bridle", tier)]] <- rope_between(
        start, named(if (extended) points[[tier]] else tier),
        set_back(plan$bridles[[tier]], fields$bridles[[tier]], side), "bridle"
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

# A bridle on one side, with its setback as more of it.
set_back <- function(given, fields, side) {
  own <- of_side(given[names(given) != "setback"], side)
  # as written where nothing is set back
  if (isTRUE(fields$setback > 0)) own$length <- of_side(fields, side)$length + fields$setback
  own
}

# A group of floats as a piece along the head line. fields: the group, checked; given: as in the
# plan; line: the head line's fields; path: of the group.
float_group <- function(fields, given, line, path) {
  piece <- c(list(along = "head_line"), given[setdiff(names(given), "spacing")],
    list(role = "float"))
  spaced_group(piece, fields, given, line, path, "the head line")
}

# A group of discs or bobbins as a piece along the ground gear. A disc weighs and displaces as a
# full cylinder of its material does, and drags as a short cylinder with its axis across the flow.
disc_group <- function(fields, given, line, path) {
  full <- pi / 4 * fields$diameter^2 * fields$width
  density <- first_of(fields$density, rubber_density)
  mass <- first_of(fields$mass, density * full)
  volume <- if (!is.null(fields$mass) && !is.null(fields$density)) mass / density else full
  piece <- c(
    list(along = "ground_gear"), given[intersect(c("number", "share"), names(given))],
    list(mass = mass, volume = volume, area = fields$diameter * fields$width,
      drag_coefficient = fields$drag_coefficient, role = "disc")
  )
  spaced_group(piece, fields, given, line, path, "the ground gear")
}

# kg/m3, where a plan says nothing. An assumption: natural rubber is 920 raw and vulcanised with
# fillers 1100 to 1500 by what is in it, of which makers of discs print nothing.
rubber_density <- 1250

# Groups along a line, one or a list of them, as pieces: `name`, or `name_1`, `name_2`...
grouped_pieces <- function(group, fields, given, line, name, path) {
  if (is.null(given)) return(list())
  if (!is.null(names(given))) {
    return(stats::setNames(list(group(fields, given, line, path)), name))
  }
  pieces <- lapply(seq_along(given), function(k) {
    group(fields[[k]], given[[k]], line, sprintf("%s[%d]", path, k))
  })
  stats::setNames(pieces, sprintf("%s_%d", name, seq_along(given)))
}

# A piece along a line, spread over the room that the `spacing` of its group takes.
spaced_group <- function(piece, fields, given, line, path, called) {
  if (is.null(fields$spacing)) return(piece)
  if (is.null(line$length)) {
    abort_field(paste0(path, ".spacing"), given$spacing,
      sprintf("given where %s has a `length`", called))
  }
  share <- first_of(fields$share, c(0, 1))
  room <- diff(share) * line$length
  number <- first_of(fields$number, floor(room / fields$spacing + 1e-9) + 1)
  taken <- (number - 1) * fields$spacing
  if (taken > room + 1e-6) {
    abort_field(paste0(path, ".spacing"), given$spacing, sprintf(
      "at most %s, or %s of them take more than the %s of line that they are on",
      format_si(room / (number - 1), "length"), format(number), format_si(room, "length")
    ))
  }
  if (number == 1) return(piece)
  piece$number <- number
  piece$share <- mean(share) + c(-0.5, 0.5) * taken / line$length
  piece$share <- pmin(pmax(piece$share, 0), 1)
  piece$end_to_end <- TRUE
  piece
}

# Floats along the head line, discs along the ground gear, grids, and a catch as a piece at the
# codline. around: the panels around the net.
trawl_fittings <- function(fields, plan, around) {
  pieces <- c(
    grouped_pieces(float_group, fields$floats, plan$floats, fields$head_line, "floats", "floats"),
    grouped_pieces(disc_group, fields$ground_gear$discs, plan$ground_gear$discs,
      fields$ground_gear, "discs", "ground_gear.discs"),
    trawl_grids(fields, around)
  )
  pieces$canvas <- part_with_role(plan$canvas, "canvas", along = "head_line",
    lift_direction = "up")
  pieces$catch <- part_with_role(plan$catch, "catch", at = "codline")
  pieces
}

# Measures of attack and heel of the free boards.
board_measures <- function(free_boards) {
  angles <- lapply(stats::setNames(nm = free_boards), function(board) {
    stats::setNames(
      lapply(c("attack", "heel"), function(a) list(attitude = stats::setNames(list(a), board))),
      paste0(c("attack", "heel"), sub("otter_board", "", board, fixed = TRUE))
    )
  })
  unlist(unname(angles), recursive = FALSE)
}
