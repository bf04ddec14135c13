# The engine's input (src/engine/gear/gear.hpp): numbers, with indices for positions and edges.

# Returns the names of all positions of a gear in index order. They are points, corners of panels,
# starts, middles and ends of ropes, and positions at a fraction of a rope's length.
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

# Returns the engine's input of a gear. `netting`: "bars" or "cells" for every panel, or NULL for
# each panel's own. `like`: NULL, or list(si, gear) of another gear with the same netting. Identical
# parts are copied from it.
gear_numbers <- function(si, netting = NULL, like = NULL) {
  places <- place_names(si)
  place <- function(text) match(text, places, nomatch = 0L)
  same_places <- !is.null(like) && identical(places, place_names(like$si)) &&
    identical(names(si$panels), names(like$si$panels))
  group <- function(name, make, of = name) {
    if (same_places && identical(si[[of]], like$si[[of]])) like$gear[[name]] else make()
  }
  each <- function(name, make, ..., of = name) {
    parts <- unname(si[[of]])
    made <- if (same_places && length(parts) == length(like$si[[of]])) like$gear[[name]]
    fresh <- if (is.null(made)) seq_along(parts) else changed_parts(parts, like$si[[of]])
    if (is.null(made)) made <- vector("list", length(parts))
    made[fresh] <- lapply(parts[fresh], make, ...)
    made
  }
  shares <- lapply(si$share_places, parse_place)
  list(
    point_count = length(si$points), rope_count = length(si$ropes),
    panel_count = length(si$panels), share_count = length(si$share_places),
    points = each("points", point_numbers, place),
    ropes = each("ropes", rope_numbers, place, si),
    panels = group("panels", function() panel_numbers(si, netting)),
    seams = group("seams", function() {
      lapply(unname(si$seams), function(seam) {
        list(
          chains = lapply(unname(seam$edges), function(chain) {
            list(links = link_numbers(chain, si))
          }),
          gathered_at = place(first_of(seam$gathered_at, "")),
          held_between = place(first_of(seam$held_between, c("", "")))
        )
      })
    }),
    pieces = each("pieces", piece_numbers, place, si),
    plates = each("plates", plate_numbers, place, of = "otter_boards"),
    share_places = list(
      rope = match(vapply(shares, `[[`, "", "name"), names(si$ropes)),
      share = vapply(shares, `[[`, 0, "place")
    ),
    bag = if (!is.null(si$catch)) {
      list(panels = match(si$catch$panels, names(si$panels)), deep = si$catch$deep)
    },
    ground = si$ground[c("normal", "height")],
    density = si$water$density, speed = si$towing$speed + si$water$current$x[1],
    free_surface = si$water$free_surface,
    shot_along = match(first_of(si$shooting$rope, ""), names(si$ropes), nomatch = 0L)
  )
}

# Returns the indices of parts that differ between two gears with equally many parts.
changed_parts <- function(parts, before) {
  which(!mapply(identical, unname(parts), unname(before), USE.NAMES = FALSE))
}

point_numbers <- function(point, place) {
  list(
    held = is_given(point$held), position = first_of(point$position, numeric(3)),
    has_near = !is.null(point$near), near = first_of(point$near, numeric(3)),
    load = point$load, at = place(first_of(point$at, ""))
  )
}

rope_numbers <- function(rope, place, si) {
  list(
    from = place(first_of(rope$from, "")), to = place(first_of(rope$to, "")),
    through = place(rope$through), along = link_numbers(rope$along, si),
    shares = first_of(rope$shares, numeric()), length = rope$length,
    diameter = rope$diameter, mass_per_length = rope$mass_per_length,
    volume_per_length = rope$volume_per_length, weight_factor = 1,
    axial_stiffness = rope$axial_stiffness, bending_stiffness = rope$bending_stiffness,
    strut = rope$strut, segments = as.integer(first_of(rope$segments, 0L)),
    friction = first_of(rope$friction, numeric())
  )
}

piece_numbers <- function(piece, place, si) {
  along <- piece$along
  way <- lift_directions[[if (is.na(piece$lift_direction)) "up" else piece$lift_direction]]
  list(
    at = place(first_of(piece$at, "")),
    rope = if (identical(along$kind, "rope")) match(along$name, names(si$ropes)) else 0L,
    along = link_numbers(if (identical(along$kind, "chain")) along$edges, si),
    share = first_of(piece$extent, c(0, 1)), end_to_end = isTRUE(piece$end_to_end),
    number = piece$number, mass = piece$mass, volume = piece$volume, height = piece$height,
    drag_area = piece$drag_area, smooth_diameter = piece$smooth_diameter,
    added_mass = piece$added_mass, lift_area = piece$lift_area * way$sign,
    lift_direction = way$to, upward_lift_area = piece$upward_lift_area
  )
}

plate_numbers <- function(board, place) {
  list(
    points = place(board$points), attachment = as.double(board$attachment),
    upright = as.double(upright_board(board, c(0, 0, 0))), side = board$side,
    level = is_kite(board), area = board$area, mass = board$mass, volume = board$volume,
    room = board$span / 2 + mean(board$attachment[3, ])
  )
}

# Returns a chain as list(edge, from, to), without links for NULL.
link_numbers <- function(chain, si) {
  at <- function(field, of) vapply(chain, `[[`, of, field, USE.NAMES = FALSE)
  ends <- rbind(at("from", 0), at("to", 0))
  reversed <- at("reversed", NA)
  ends[, reversed] <- ends[2:1, reversed]
  list(
    edge = edge_number(si$panels, at("panel", ""), at("edge", "")), from = ends[1L, ],
    to = ends[2L, ]
  )
}

# Returns the columns of a gear's panels; 0 for counts that the plan omits.
panel_numbers <- function(si, netting) {
  panels <- unname(si$panels)
  word <- function(name) vapply(panels, `[[`, "", name)
  count <- function(name) {
    vapply(panels, function(panel) as.integer(first_of(panel[[name]], 0L)), 0L)
  }
  opening <- function(name) {
    vapply(panels, function(panel) as.double(first_of(panel$opening_stiffness[[name]], 0)), 0)
  }
  turned <- word("orientation") == "turned"
  angle <- opening("angle")
  angle[turned] <- pi - angle[turned]
  c(
    panel_table(panels),
    list(
      shielding = word("shielding"), drag = word("netting_drag"), columns = count("columns"),
      rows = count("rows"), bar_segments = count("bar_segments"),
      bars = unname(panels_of_bars(si, netting)),
      stiff = !vapply(lapply(panels, `[[`, "opening_stiffness"), is.null, NA),
      opening_couple = opening("couple"), opening_angle = angle,
      knot_drag = rep(1, length(panels))
    )
  )
}

lift_directions <- list(
  up = list(to = "up", sign = 1), down = list(to = "up", sign = -1),
  starboard = list(to = "sideways", sign = 1), port = list(to = "sideways", sign = -1)
)

# Returns edge indices: 4 (p - 1) + 1 upper, 2 lower, 3 left, 4 right, for panel p.
edge_number <- function(panels, panel, edge) {
  4L * (match(panel, names(panels)) - 1L) + match(edge, c("upper", "lower", "left", "right"))
}

# Returns the input of a model in addition to its mesh (src/engine/gear/gear_model.hpp). `like`: as
# for gear_numbers(), with its `model`.
model_numbers <- function(si, like = NULL) {
  lines <- c("ropes", "panels", "otter_boards")
  same <- vapply(lines, function(group) identical(si[[group]], like$si[[group]]), NA)
  before <- c(0L, cumsum(lengths(like$si[lines])))
  materials <- function(group) {
    k <- match(group, lines)
    made <- function(of) {
      twine_materials(if (group == "otter_boards") lapply(of, strut_line) else of)
    }
    parts <- si[[group]]
    if (is.null(like) || length(parts) != before[k + 1L] - before[k]) return(made(parts))
    kept <- lapply(like$model$materials, `[`, seq_along(parts) + before[k])
    fresh <- if (!same[k]) changed_parts(parts, like$si[[group]])
    if (!length(fresh)) return(kept)
    Map(function(kept, made) {
      kept[fresh] <- made
      kept
    }, kept, made(parts[fresh]))
  }
  blends <- any(vapply(si$panels, function(panel) identical(panel$netting_drag, "blended"), NA))
  c(
    list(water = engine_water(si), ground = si$ground, slack_twine = si$slack_twine),
    if (!is.null(like) && all(same)) like$model[c("materials", "blended", "load_table")] else list(
      materials = do.call(Map, c(list(c), lapply(lines, materials))),
      blended = twine_materials(if (blends) si$panels, alone = FALSE),
      load_table = load_rows(c(si$ropes, si$panels))
    ),
    list(
      # The engine inserts the nodes of the mesh here.
      plates = lapply(unname(si$otter_boards), engine_board, 1:3, si$water$density),
      multipliers = list(
        normal = rep(1, sum(lengths(si[lines]))), blended_normal = 1, screen_drag = 1,
        screen_lift = 1
      ),
      drag_coefficient = first_of(si$catch$drag_coefficient, 0)
    )
  )
}

# Returns list(gear, model) with multiplied force components; reuses the last gear.
mesh_numbers <- function(si, netting) {
  like <- if (identical(netting, last_numbers$netting)) last_numbers$own
  own <- list(si = si, gear = gear_numbers(si, netting, like), model = model_numbers(si, like))
  last_numbers$own <- own
  last_numbers$netting <- netting
  multiplied_numbers(own[c("gear", "model")], si)
}

last_numbers <- new.env(parent = emptyenv())

# Returns the engine's water. The current is relative to the gear, which is towed along -x.
engine_water <- function(si) {
  x <- si$water$current$x + si$towing$speed
  y <- si$water$current$y
  water <- list(
    density = si$water$density, viscosity = si$water$viscosity,
    free_surface = si$water$free_surface, speed = sqrt(max(x^2 + y^2)),
    depth = si$water$current$depth, x = x, y = y
  )
  water$waves <- engine_waves(si$water$waves)
  water
}

is_given <- function(x) length(x) > 0L && !anyNA(x)

# Initial hanging ratio of netting: width over stretched width.
nominal_hanging_ratio <- 0.3
nominal_depth_ratio <- sqrt(1 - nominal_hanging_ratio^2)
