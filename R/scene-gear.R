# Scene for the viewer (web/src/view/scene.ts): a list that becomes JSON, with the same structure
# for a state, a trajectory and the tank's designs. Connectivity is separate from moving data, so
# that the tank sends it once.

# Maximum number of lines and cells in a scene.
scene_limit <- 12000L

# Returns the shape of a state, a list. `fixed`: data that do not move. `points`: 3 x n, m. `ropes`:
# tensions (N) of ropes, then of seams. `rope_part`: part of each, for a seam the part of its
# netting. `u`, `v`: tensions (N) of netting. `drag`: see `part_drag_over_size()`. `places`:
# positions of marks (3 x marks, m). `boards`: corners of boards (3 x 4 per board, m).
scene_shape <- function(state, limit = scene_limit) {
  points <- state_points(state)
  groups <- rope_groups(state, limit)
  netting <- netting_surfaces(state, limit)
  seams <- seams_of_bars(state, netting_of_bars(state))
  if (length(seams$nodes)) {
    k <- ceiling(sum(lengths(seams$nodes)) / limit)
    groups <- join_groups(groups, seam_groups(state, netting_parts(state), seams, k))
  }
  ropes <- group_lines(state, points, groups)
  marks <- rbind(piece_marks(state, points), board_marks(state), support_marks(state))
  marks$board <- match(marks$part, names(state$si$otter_boards), 0L)
  drawn <- unique(c(ropes$ends, unlist(lapply(netting$panels, `[[`, "point"))))
  list(
    fixed = list(
      ropes = ropes, groups = groups, netting = netting, marks = marks, drawn = drawn, state = state
    ),
    points = points[, drawn, drop = FALSE], ropes = ropes$tension,
    rope_part = ropes$part, u = netting$u, v = netting$v,
    drag = part_drag_over_size(state), kind = state$mesh$parts$kind,
    places = t(as.matrix(marks[c("x", "y", "z")])), boards = board_corners(state)
  )
}

# Adds opening (%) and angle (deg) of meshes at the points of netting, NULL without netting.
with_meshes <- function(shape) {
  state <- shape$fixed$state
  netting <- shape$fixed$netting
  found <- if (length(netting$u)) mesh_places(state)
  mean_of <- function(colour) {
    if (!is.null(found)) mesh_means(state, netting$panel, netting$at, colour, found)
  }
  c(shape, list(opening = mean_of("mesh_opening"), angle = mean_of("mesh_angle")))
}

# Returns the hydrodynamic force along the flow divided by size for every part. The size is length
# (ropes, N/m) or area of taut netting with square meshes (N/m2). Other parts have 0.
part_drag_over_size <- function(state) {
  size <- part_sizes(state$si, state$mesh)
  drag <- drop(flow_axes(state$si)[, "flow"] %*% part_drag(state))
  ifelse(size > 0, pmax(drag, 0) / pmax(size, 1e-9), 0)
}

# Returns the size of every part; see `part_drag_over_size()`.
part_sizes <- function(si, mesh) {
  size <- numeric(nrow(mesh$parts))
  size[seq_along(si$ropes)] <- vapply(si$ropes, `[[`, 0, "length")
  size[length(si$ropes) + seq_along(si$panels)] <- vapply(si$panels, function(panel) {
    panel_bars(panel) * (panel$mesh_size / 2)^2
  }, 0)
  size
}

scene_fixed <- function(shape) {
  fixed <- shape$fixed
  state <- fixed$state
  c(
    scene_joints(fixed$ropes[c("ends", "part")], fixed$netting$panels, fixed$drawn),
    list(
      parts = scene_parts(state), marks = scene_marks(fixed$marks),
      vessels = lapply(scene_vessels(state, fixed$marks), I)
    )
  )
}

scene_joints <- remembered(new_scene_joints)

new_scene_joints <- function(ropes, panels, drawn) {
  point <- function(number) packed_integers(match(number, drawn) - 1L)
  list(
    ropes = list(ends = point(ropes$ends), part = packed_integers(ropes$part - 1L)),
    netting = lapply(panels, function(panel) {
      list(
        part = panel$part - 1L, columns = panel$columns, rows = panel$rows, down = I(panel$down),
        full = panel$full, point = point(panel$point), mesh = packed_floats(panel$mesh),
        scale = panel$scale, offset = I(panel$offset)
      )
    })
  )
}

# Returns name, kind and role of every part with thickness (m), bar length and mesh size (m) and
# strength (N), 0 if undefined.
scene_parts <- function(state) {
  si <- state$si
  parts <- state$mesh$parts
  n <- nrow(parts)
  thickness <- strength <- mesh <- bar <- numeric(n)
  rope <- seq_along(si$ropes)
  net <- length(rope) + seq_along(si$panels)
  thickness[rope] <- vapply(si$ropes, function(rope) first_of(rope$diameter, 0), 0)
  strength[rope] <- vapply(si$ropes, function(rope) as.double(first_of(rope$strength, 0)), 0)
  strength[is.na(strength)] <- 0
  thickness[net] <- vapply(si$panels, twine_width, 0)
  mesh[net] <- vapply(si$panels, `[[`, 0, "mesh_size")
  bar[net] <- vapply(si$panels, function(panel) panel$mesh_size / 2, 0)
  list(
    name = I(parts$name), kind = I(parts$kind), role = I(ifelse(is.na(parts$role), "", parts$role)),
    thickness = I(thickness), strength = I(strength), mesh = I(mesh), bar = I(bar),
    form = I(c(unname(vapply(si$ropes, rope_form, 0L)), rep(4L, n - length(rope))))
  )
}

# Returns the appearance of a rope in close view: 0 laid strands, 1 chain links, 2 discs, 3 smooth
# pipe (4: seam of netting).
rope_form <- function(rope) {
  if (identical(rope$role, "ground_gear")) return(2L)
  if (rope$strut) return(3L)
  if (grepl("chain", first_of(rope$material, ""), fixed = TRUE)) 1L else 0L
}

scene_marks <- function(marks) {
  symbol <- symbol_of(marks$role)
  list(
    role = I(as.character(marks$role)), label = I(as.character(symbol$label)),
    fill = I(as.character(symbol$solid)), part = I(as.character(marks$part)),
    size = I(ifelse(is.na(marks$size), 0, marks$size)),
    direction = I(ifelse(is.na(marks$direction), "", marks$direction)),
    board = I(as.integer(marks$board) - 1L)
  )
}

# Towing points within this distance (m) belong to the same vessel.
one_vessel <- 40

# Returns the vessels that tow: for each the numbers, from 0, of its marks at the surface.
scene_vessels <- function(state, marks) {
  if (state$si$towing$speed == 0 || state$si$water$density == 0) return(list())
  own <- which(marks$role == "moved" & marks$z > -1)
  if (!length(own)) return(list())
  if (length(own) == 1L) return(list(own - 1L))
  apart <- stats::hclust(stats::dist(marks[own, c("x", "y", "z")]), "single")
  unname(split(own - 1L, stats::cutree(apart, h = one_vessel)))
}

scene_moved <- function(shapes) {
  times <- length(shapes)
  # A tenth of a pixel if the net spans the whole screen.
  net <- unlist(lapply(shapes[[1L]]$fixed$netting$panels, `[[`, "point"))
  drawn <- shapes[[1L]]$fixed$drawn
  at <- shapes[[1L]]$points[, if (length(net)) drawn %in% net else TRUE, drop = FALSE]
  step <- max(apply(at, 1L, max) - apply(at, 1L, min)) / 20000
  all <- function(field) unlist(lapply(shapes, `[[`, field), use.names = FALSE)
  values <- function(field) packed_values(as.double(all(field)), times)
  moved <- list(
    points = packed_places(all("points"), times, step), rope_tension = values("ropes"),
    u = values("u"), v = values("v"), drag = values("drag"),
    places = packed_places(as.double(all("places")), times, step),
    boards = packed_places(as.double(all("boards")), times, step / 10)
  )
  if (!is.null(shapes[[1L]]$opening)) {
    moved$opening <- values("opening")
    moved$angle <- values("angle")
  }
  moved
}

scene_scales <- function(shapes) {
  all <- function(field) unlist(lapply(shapes, `[[`, field), use.names = FALSE)
  drag <- function(kind) as.double(unlist(lapply(shapes, function(s) s$drag[s$kind == kind])))
  of_seam <- unlist(lapply(shapes, function(s) s$kind[s$rope_part] == "netting"))
  tension <- c(all("u"), all("v"), all("ropes")[of_seam])
  meshes <- function(field, colour) {
    list(netting = scale_with_label(mesh_scale(all(field), colour), "netting"))
  }
  list(
    tension = list(
      rope = scale_with_label(tension_scale(all("ropes")[!of_seam], "rope"), "rope"),
      netting = scale_with_label(tension_scale(tension[!is.na(tension)], "netting"), "netting")
    ),
    mesh_opening = meshes("opening", "mesh_opening"), mesh_angle = meshes("angle", "mesh_angle"),
    drag = list(
      rope = scale_with_label(drag_scale(drag("rope"), "rope"), "rope"),
      netting = scale_with_label(drag_scale(drag("netting"), "netting"), "netting")
    )
  )
}

drag_scale <- function(drag, kind) {
  scale <- tension_scale(drag, kind)
  if (is.null(scale)) return(NULL)
  # Drag is always in newtons.
  scale$ticks <- scale$ticks * scale$per_unit
  scale$per_unit <- 1
  scale$unit <- if (kind == "rope") "N/m" else "N/m2"
  scale$words <- if (kind == "rope") "Drag of ropes" else "Drag over area of netting"
  scale
}

scale_with_label <- function(scale, kind) {
  if (is.null(scale)) return(NULL)
  list(
    heading = scale_heading(scale, kind), unit = scale$unit, per_unit = scale$per_unit,
    log = scale$log, limits = I(as.double(scale$limits)),
    ticks = I(trimws(tick_labels(scale))), at = I(scale_share(scale, scale$ticks * scale$per_unit))
  )
}

scene_about <- function(state, shapes) {
  bed <- drawn_bed(state)
  list(
    name = state$gear$plan$name, conditions = state_conditions(state),
    water = state$si$water$density > 0, flow = I(flow_past(state)),
    bed = if (!is.null(bed)) list(normal = I(bed$normal), height = bed$height),
    scales = scene_scales(shapes), colours = scene_colours()
  )
}

# Returns stops of both palettes, and the colours of slack: alone and among tensions.
scene_colours <- function() {
  stops <- function(kind) {
    colours <- tension_palette(kind)
    I(colours[round(seq(1, length(colours), length.out = 32L))])
  }
  list(
    rope = stops("rope"), netting = stops("netting"), slack = slack_colour,
    slack_muted = muted_slack_colour
  )
}

state_scene <- function(state, colour = "tension") {
  shape <- with_meshes(scene_shape(state))
  c(
    list(times = I(0), labels = I(""), colour = colour), scene_about(state, list(shape)),
    scene_fixed(shape), scene_moved(list(shape))
  )
}
