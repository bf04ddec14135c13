# Net cage (short form).
#
# Wall panels surround the cage, in order from left to right as seen from outside. The first corner
# is upstream for a current along x. Pointed bottom panels meet at the centre of the bottom. A round
# cage has one below each wall panel, a square cage one below each side.

expand_cage <- function(fields, plan) {
  check_cage(fields, names(plan$collar))
  outline <- cage_outline(fields)
  net <- cage_net(fields, plan, outline)
  frame <- cage_frame(fields, plan, outline)
  moorings <- cage_moorings(fields, plan, outline)
  out <- shared_fields(plan, fields)
  if (!fields$collar$held) out$water$free_surface <- TRUE
  out$points <- c(net$points, moorings$points)
  out$panels <- net$panels
  out$seams <- c(net$seams, frame$seams)
  out$ropes <- c(frame$ropes, moorings$ropes)
  out$pieces <- frame$pieces
  out$measures <- cage_measures(fields, outline, names(moorings$ropes))
  out
}

# given: names of the collar fields in the plan.
check_cage <- function(fields, given) {
  wrong <- function(field, value, allowed) abort_field(field, value, allowed)
  if (fields$shape == "square" && fields$panels %% 4 != 0) {
    wrong("panels", fields$panels, "a multiple of 4 in a square cage")
  }
  collar <- fields$collar
  pipe <- setdiff(given, "held")
  if (collar$held) {
    if (length(pipe)) {
      wrong(paste0("collar.", pipe[1]), collar[[pipe[1]]], "omitted with a held collar")
    }
    if (!is.null(fields$moorings)) {
      wrong("moorings", "given", "omitted with a held collar")
    }
  } else {
    for (due in c("diameter", "bending_stiffness")) {
      if (is.null(collar[[due]])) {
        abort_field(paste0("collar.", due), NULL, "given with a floating collar", "is missing")
      }
    }
    if (collar$bending_stiffness == 0) {
      wrong("collar.bending_stiffness", 0, "greater than 0 with a floating collar")
    }
    if (is.null(collar$material) && is.null(collar$mass_per_length)) {
      abort_field("collar.mass_per_length", NULL, "given with a floating collar", "is missing")
    }
    # A cage in a rig is moored by the plan around it.
    moorings <- fields$moorings
    if (is.null(moorings)) return(check_cage_weight(fields))
    if (moorings$number > fields$panels) {
      wrong("moorings.number", moorings$number,
        paste("at most the", fields$panels, "corners of the wall panels"))
    }
    if (moorings$length^2 < moorings$reach^2 + moorings$anchor_depth^2) {
      wrong("moorings.length", format_si(moorings$length, "length"), paste(
        "at least the distance to the anchor,",
        format_si(sqrt(moorings$reach^2 + moorings$anchor_depth^2), "length")
      ))
    }
  }
  check_cage_weight(fields)
}

check_cage_weight <- function(fields) {
  if (is.null(fields[["bottom"]]) && !is.null(fields$centre_weight)) {
    abort_field("centre_weight", "given", "omitted in a cage without bottom netting")
  }
}

# Returns the outline and the design volume: list(x, y, side, radius, run, bottoms, pipes, top,
# volume (m3)). Lengths are in m. `x`, `y`: position of each corner; `side`: open width of a wall
# panel. `radius`: distance of each corner from the centre; `run`: distance of mid-side from the
# centre; `top`: height of the upper edge. `bottoms` and `pipes` list the wall panels above each
# bottom panel and along each pipe or rope.
cage_outline <- function(fields) {
  n <- fields$panels
  k <- seq_len(n) - 1
  if (fields$shape == "round") {
    radius <- rep(fields$diameter / 2, n)
    angle <- pi + 2 * pi * k / n
    x <- radius * cos(angle)
    y <- radius * sin(angle)
    # A held collar has straight sides between its points; a pipe is round.
    area <- if (fields$collar$held) n / 2 * radius[1]^2 * sin(2 * pi / n) else pi * radius[1]^2
    side <- if (fields$collar$held) 2 * radius[1] * sin(pi / n) else 2 * pi * radius[1] / n
    run <- radius[1]
    bottoms <- as.list(seq_len(n))
    pipes <- list(seq_len(n))
  } else {
    per_side <- n / 4
    s <- (k %% per_side) / per_side - 0.5
    # Upstream, starboard, downstream, port side.
    turn <- k %/% per_side * pi / 2
    x <- fields$diameter * (-0.5 * cos(turn) + s * sin(turn))
    y <- fields$diameter * (-0.5 * sin(turn) - s * cos(turn))
    radius <- sqrt(x^2 + y^2)
    area <- fields$diameter^2
    side <- fields$diameter / per_side
    run <- fields$diameter / 2
    bottoms <- pipes <- unname(split(seq_len(n), k %/% per_side))
  }
  cone <- first_of(fields[["bottom"]]$cone, 0)
  list(
    x = x, y = y, side = side, radius = radius, run = run, bottoms = bottoms, pipes = pipes,
    top = 0,
    volume = area * (fields$depth + if (is.null(fields[["bottom"]])) 0 else cone / 3)
  )
}

# Returns the meshes across an open width (m) and down an open depth (m), rounded to 0.1 mesh.
open_meshes <- function(netting, width, depth) {
  ratio <- netting$hanging_ratio
  one <- netting$mesh_size * if (netting$orientation == "square") {
    c(0.5, 0.5)
  } else {
    c(ratio, sqrt(1 - ratio^2))
  }
  pmax(0.1, round(c(width, depth) / one, 1))
}

cage_net <- function(fields, plan, outline) {
  n <- fields$panels
  around <- seq_len(n)
  after <- around %% n + 1L
  panels <- seams <- points <- list()
  twine <- function(given) given[setdiff(names(given), c("hanging_ratio", "cone"))]
  place <- function(x, y, z) list(near = list(x, y, z))
  meshes <- open_meshes(fields$wall, outline$side, fields$depth)
  for (k in around) {
    wall <- paste0("wall_", k)
    panels[[wall]] <- c(
      twine(plan$wall),
      list(meshes = list(upper = meshes[1], lower = meshes[1], deep = meshes[2]), part = "wall")
    )
    if (is.null(panels[[wall]]$orientation)) panels[[wall]]$orientation <- "square"
    at_collar <- list(outline$x[k], outline$y[k], outline$top)
    points[[paste0("collar_", k)]] <- if (fields$collar$held) {
      list(position = at_collar, held = "fixed")
    } else {
      list(at = paste0(wall, ".upper_left"), near = at_collar)
    }
    points[[paste0("foot_", k)]] <- c(
      list(at = paste0(wall, ".lower_left")),
      place(outline$x[k], outline$y[k], outline$top - fields$depth)
    )
    seams[[paste0("walls_", k)]] <-
      list(edges = c(paste0(wall, ".right"), paste0("wall_", after[k], ".left")))
  }
  if (!is.null(plan[["bottom"]])) {
    # Default: bottom netting identical to the walls.
    given <- twine(plan$wall)
    own <- twine(plan[["bottom"]])
    given[names(own)] <- own
    kind <- fields$wall
    kind[names(fields[["bottom"]])] <- fields$bottom
    cone <- fields[["bottom"]]$cone
    number <- length(outline$bottoms)
    below <- seq_len(number)
    for (k in below) {
      bottom <- paste0("bottom_", k)
      over <- paste0("wall_", outline$bottoms[[k]], ".lower")
      meshes <- open_meshes(
        kind, outline$side * length(over), sqrt(outline$run^2 + cone^2)
      )
      panels[[bottom]] <- c(
        given, list(meshes = list(upper = meshes[1], lower = 0, deep = meshes[2]), part = "bottom")
      )
      if (is.null(panels[[bottom]]$orientation)) panels[[bottom]]$orientation <- "square"
      seams[[paste0("foot_", k)]] <-
        list(edges = list(over, paste0(bottom, ".upper")))
      seams[[paste0("bottoms_", k)]] <-
        list(edges = c(paste0(bottom, ".right"), paste0("bottom_", k %% number + 1L, ".left")))
    }
    seams$bottom_centre <-
      list(edges = paste0("bottom_", below, ".lower"), gathered_at = "bottom_centre")
    points$bottom_centre <- place(0, 0, outline$top - fields$depth - cone)
  }
  list(panels = panels, seams = seams, points = points)
}

cage_frame <- function(fields, plan, outline) {
  n <- fields$panels
  around <- seq_len(n)
  after <- around %% n + 1L
  ropes <- seams <- pieces <- list()
  upper <- paste0("wall_", around, ".upper")
  lower <- paste0("wall_", around, ".lower")
  collar <- plan$collar[setdiff(names(plan$collar), "held")]
  if (fields$collar$held) {
    for (k in around) {
      seams[[paste0("collar_", k)]] <-
        list(edges = upper[k], held_between = paste0("collar_", c(k, after[k])))
    }
  } else {
    ropes <- cage_pipes("collar", upper, collar, outline)
  }
  if (!fields$collar$held && fields$shape == "square") {
    per_side <- n / 4
    # Stiff braces without weight and drag keep the frame square.
    stiff <- line_properties(fields$collar, fields$materials, "collar")$axial_stiffness
    for (brace in 1:2) {
      corner <- (brace - 1) * per_side + 1
      ropes[[paste0("brace_", brace)]] <- list(
        from = paste0("collar_", corner), to = paste0("collar_", corner + 2 * per_side),
        length = sqrt(2) * fields$diameter, diameter = fields$collar$diameter / 100,
        axial_stiffness = stiff, mass_per_length = 0, volume_per_length = 0,
          carries_compression = TRUE,
        segments = 1, coefficients = list(normal = 0), role = "brace"
      )
    }
  }
  if (!is.null(plan$bottom_rope)) {
    ropes <- c(ropes, cage_pipes("bottom_rope", lower, plan$bottom_rope, outline))
  }
  for (k in around) {
    ropes[[paste0("side_rope_", k)]] <- part_with_role(plan$side_ropes, "side_rope",
      along = paste0("wall_", k, ".left"), length = fields$depth)
    pieces[[paste0("sinker_", k)]] <- part_with_role(plan$sinkers, "weight",
      at = paste0("foot_", k))
  }
  pieces$centre_weight <- part_with_role(plan$centre_weight, "weight", at = "bottom_centre")
  list(ropes = ropes, seams = seams, pieces = pieces)
}

cage_moorings <- function(fields, plan, outline) {
  points <- ropes <- list()
  if (is.null(plan$moorings)) return(list(points = points, ropes = ropes))
  given <- plan$moorings
  moorings <- fields$moorings
  line <- given[setdiff(names(given), c("number", "bearing", "anchor_depth", "reach"))]
  bearing <- atan2(outline$y, outline$x)
  wanted <- pi + moorings$bearing + 2 * pi * (seq_len(moorings$number) - 1) / moorings$number
  for (m in seq_len(moorings$number)) {
    k <- which.max(cos(bearing - wanted[m]))
    out <- 1 + moorings$reach / outline$radius[k]
    anchor <- paste0("anchor_", m)
    points[[anchor]] <- list(
      position = list(out * outline$x[k], out * outline$y[k], -moorings$anchor_depth),
      held = "fixed"
    )
    ropes[[paste0("mooring_", m)]] <- rope_between(paste0("collar_", k), anchor, line, "mooring")
  }
  list(points = points, ropes = ropes)
}

cage_pipes <- function(role, edges, given, outline) {
  pipes <- lapply(outline$pipes, function(on) {
    c(list(along = edges[on], length = length(on) * outline$side), given, list(role = role))
  })
  number <- length(pipes)
  stats::setNames(pipes, if (number == 1) role else paste0(role, "_", seq_len(number)))
}

cage_measures <- function(fields, outline, moorings) {
  around <- seq_len(fields$panels)
  panels <- c(paste0("wall_", around), if (!is.null(fields[["bottom"]])) {
    paste0("bottom_", seq_along(outline$bottoms))
  })
  out <- list(
    net_volume = list(volume = panels),
    volume_left = list(volume_fraction = list(panels = panels, of = outline$volume)),
    net_drag = list(drag = panels), net_lift = list(lift = panels),
    upstream_foot_depth = list(depth = "foot_1"),
    downstream_foot_depth = list(depth = paste0("foot_", length(around) %/% 2 + 1))
  )
  if (!is.null(fields[["bottom"]])) out$bottom_depth <- list(depth = "bottom_centre")
  for (rope in moorings) {
    out[[paste0(rope, "_tension")]] <- list(tension = paste0(rope, ".start"))
  }
  out
}
