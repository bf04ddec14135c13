# A gear as the engine reads it (src/engine/gear/gear.hpp): numbers alone, places and edges by their
# numbers.

# Names of all places of a gear, in the order of their numbers: points, corners of panels, starts,
# middles and ends of ropes, then places at a share of a rope's length.
place_names <- function(si) {
  of <- function(names, places) {
    if (length(names)) paste0(rep(names, each = length(places)), ".", places)
  }
  c(
    names(si$points),
    of(names(si$panels), c("upper_left", "upper_right", "lower_left", "lower_right")),
    of(names(si$ropes), c("start", "middle", "end")), si$share_places
  )
}

# netting: "bars" or "cells" for every panel, or NULL for each panel's own.
gear_numbers <- function(si, netting = NULL) {
  places <- place_names(si)
  place <- function(text) match(text, places, nomatch = 0L)
  links <- chain_numbers(si)
  list(
    point_count = length(si$points), rope_count = length(si$ropes),
    panel_count = length(si$panels), share_count = length(si$share_places),
    points = lapply(unname(si$points), function(point) {
      list(
        held = is_given(point$held), position = first_of(point$position, numeric(3)),
        has_near = !is.null(point$near), near = first_of(point$near, numeric(3)),
        load = point$load, at = place(first_of(point$at, ""))
      )
    }),
    ropes = Map(function(rope, along) {
      list(
        from = place(first_of(rope$from, "")), to = place(first_of(rope$to, "")),
        through = place(rope$through), along = along,
        shares = first_of(rope$shares, numeric()), length = rope$length,
        diameter = rope$diameter, mass_per_length = rope$mass_per_length,
        volume_per_length = rope$volume_per_length, axial_stiffness = rope$axial_stiffness,
        bending_stiffness = rope$bending_stiffness, strut = rope$strut,
        segments = as.integer(first_of(rope$segments, 0L)),
        friction = first_of(rope$friction, numeric())
      )
    }, unname(si$ropes), links$ropes),
    panels = panel_numbers(si, netting),
    seams = Map(function(seam, chains) {
      list(
        chains = lapply(chains, function(links) list(links = links)),
        gathered_at = place(first_of(seam$gathered_at, "")),
        held_between = place(first_of(seam$held_between, c("", "")))
      )
    }, unname(si$seams), links$seams),
    pieces = Map(function(piece, chain) {
      along <- piece$along
      way <- lift_directions[[if (is.na(piece$lift_direction)) "up" else piece$lift_direction]]
      list(
        at = place(first_of(piece$at, "")),
        rope = if (identical(along$kind, "rope")) match(along$name, names(si$ropes)) else 0L,
        along = chain,
        share = first_of(piece$share, c(0, 1)), end_to_end = isTRUE(piece$end_to_end),
        number = piece$number, mass = piece$mass, volume = piece$volume, height = piece$height,
        drag_area = piece$drag_area, smooth_diameter = piece$smooth_diameter,
        added_mass = piece$added_mass, lift_area = piece$lift_area * way$sign,
        lift_direction = way$to, upward_lift_area = piece$upward_lift_area
      )
    }, unname(si$pieces), links$pieces),
    plates = lapply(unname(si$otter_boards), function(board) {
      list(
        points = place(board$points), attachment = as.double(board$attachment),
        upright = as.double(upright_board(board, c(0, 0, 0))), side = board$side,
        level = is_kite(board), area = board$area, mass = board$mass, volume = board$volume,
        room = board$span / 2 + mean(board$attachment[3, ])
      )
    }),
    share_places = {
      parsed <- lapply(si$share_places, parse_place)
      list(
        rope = match(vapply(parsed, `[[`, "", "name"), names(si$ropes)),
        share = vapply(parsed, `[[`, 0, "place")
      )
    },
    bag = if (!is.null(si$catch)) {
      list(panels = match(si$catch$panels, names(si$panels)), deep = si$catch$deep)
    },
    ground = si$ground[c("normal", "height")],
    density = si$water$density, speed = si$towing$speed + si$water$current$x[1],
    free_surface = si$water$free_surface,
    shot_along = match(first_of(si$shooting$rope, ""), names(si$ropes), nomatch = 0L)
  )
}

# Links of all chains of a gear at once: of every rope and piece its chain (of no links where it has
# none), of every seam its chains, each list(edge, from, to).
chain_numbers <- function(si) {
  of_pieces <- lapply(unname(si$pieces), function(piece) {
    if (identical(piece$along$kind, "chain")) piece$along$edges
  })
  of_seams <- lapply(unname(si$seams), function(seam) unname(seam$edges))
  chains <- c(
    lapply(unname(si$ropes), `[[`, "along"), of_pieces, unlist(of_seams, recursive = FALSE)
  )
  links <- unlist(unname(chains), recursive = FALSE)
  at <- function(field, of) vapply(links, `[[`, of, field, USE.NAMES = FALSE)
  ends <- rbind(at("from", 0), at("to", 0))
  reversed <- at("reversed", NA)
  ends[, reversed] <- ends[2:1, reversed]
  edge <- edge_number(si$panels, at("panel", ""), at("edge", ""))
  size <- lengths(chains)
  last <- cumsum(size)
  all <- lapply(seq_along(chains), function(k) {
    mine <- seq.int(to = last[k], length.out = size[k])
    list(edge = edge[mine], from = ends[1L, mine], to = ends[2L, mine])
  })
  ropes <- seq_along(si$ropes)
  pieces <- length(ropes) + seq_along(of_pieces)
  in_seam <- lengths(of_seams)
  first <- length(ropes) + length(pieces) + cumsum(in_seam) - in_seam
  list(
    ropes = all[ropes], pieces = all[pieces],
    seams = lapply(seq_along(of_seams), function(s) all[first[s] + seq_len(in_seam[s])])
  )
}

# The columns of a gear's panels; 0 for counts that a plan leaves open.
panel_numbers <- function(si, netting) {
  panels <- unname(si$panels)
  field <- function(name, of = 0) vapply(panels, `[[`, of, name)
  count <- function(name) {
    vapply(panels, function(panel) as.integer(first_of(panel[[name]], 0L)), 0L)
  }
  numbers <- c(
    "mesh_size", "upper", "lower", "deep", "taper_left", "taper_right", "mass_per_length",
    "volume_per_length", "twine_diameter", "twine_count", "knot_diameter", "knot_twine",
    "straight_bar"
  )
  opening <- function(name) {
    vapply(panels, function(panel) as.double(first_of(panel$opening_stiffness[[name]], 0)), 0)
  }
  turned <- field("orientation", "") == "turned"
  angle <- opening("angle")
  angle[turned] <- pi - angle[turned]
  c(
    lapply(stats::setNames(nm = numbers), field),
    list(
      orientation = field("orientation", ""), shielding = field("shielding", ""),
      drag = field("netting_drag", ""), columns = count("columns"), rows = count("rows"),
      bar_segments = count("bar_segments"), bars = unname(panels_of_bars(si, netting)),
      stiff = !vapply(lapply(panels, `[[`, "opening_stiffness"), is.null, NA),
      opening_couple = opening("couple"), opening_angle = angle
    )
  )
}

lift_directions <- list(
  up = list(to = "up", sign = 1), down = list(to = "up", sign = -1),
  starboard = list(to = "sideways", sign = 1), port = list(to = "sideways", sign = -1)
)

# Edge ids: 4 (p - 1) + 1 upper, 2 lower, 3 left, 4 right, for panel p.
edge_number <- function(panels, panel, edge) {
  4L * (match(panel, names(panels)) - 1L) + match(edge, c("upper", "lower", "left", "right"))
}

# The engine's water: the current as the gear meets it, which is towed along -x.
engine_water <- function(si) {
  water <- list(
    density = si$water$density, viscosity = si$water$viscosity,
    free_surface = si$water$free_surface, depth = si$water$current$depth,
    x = si$water$current$x + si$towing$speed, y = si$water$current$y
  )
  water$waves <- engine_waves(si$water$waves)
  water
}

# Whether a plan gives an optional value.
is_given <- function(x) length(x) > 0L && !anyNA(x)

# Netting hangs open to about this share of its stretched width, to begin with.
nominal_hanging_ratio <- 0.3
nominal_depth_ratio <- sqrt(1 - nominal_hanging_ratio^2)
