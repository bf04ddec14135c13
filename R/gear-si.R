# The gear as SI numbers, the input of the mesh.

# Checks a plan completely: first each field, then the assembly, then the connections of its parts.
#
# `last`: result of this function for another plan, or NULL. Parts identical to that plan are copied
# without a check, which makes slider moves fast. `joined`: FALSE skips the check of connections,
# which a small change of a number does not affect.
#
# Returns a list:
# `plan`: the plan.
# `fields`: its checked fields in SI.
# `derived`: counts from cutting rates and take-up ratios, by path.
# `counted`: result of `complete_counts()`.
# `expanded`, `tree`: the assembly as expanded and in plain form (NULL for an assembly).
# `gears`: the gears that a rig consists of, from `expand_rig()` (NULL for a single gear).
# `assembly`: checked fields of the assembly.
# `si`: SI numbers of `si_of()`.
check_whole <- function(plan, last = NULL, joined = TRUE) {
  fields <- check_plan(plan, last$plan, last$fields)
  withCallingHandlers(
    check_parts(plan, fields, last, joined),
    codend_error_plan = function(e) abort_as_written(e, plan)
  )
}

# The part of `check_whole()` that needs schema-valid fields.
check_parts <- function(plan, fields, last, joined) {
  whole <- counts_again(fields, plan, last)
  now <- list(plan = plan, fields = fields, derived = whole$derived, counted = whole)
  if (fields$kind == "assembly" && !length(fields$gears)) {
    now$assembly <- whole$fields
  } else {
    now[c("expanded", "gears")] <- expanded_again(plan, fields, last)
    if (is.null(now$expanded)) {
      now[c("expanded", "gears")] <- with_plain_numbers(
        if (length(fields$gears)) {
          expand_rig(whole$fields, whole$plan, last$gears)
        } else {
          # `expand_KIND()` returns the tree of an assembly.
          expand <- get(paste0("expand_", fields$kind), mode = "function")
          list(with_roles(expand(whole$fields, whole$plan), fields$kind), NULL)
        }
      )
    }
    now$tree <- plain_groups(now$expanded, last$expanded, last$tree)
    now$assembly <- check_plan(now$tree, last$tree, if (!is.null(last$tree)) last$assembly)
    # Groups copied from the last gear are already complete.
    if (is.null(last$tree) || !identical(now$tree[count_groups], last$tree[count_groups])) {
      now$assembly <- complete_counts(now$assembly, now$tree, twines = FALSE)$fields
    }
  }
  now$si <- si_of(by_method(now$assembly), by_method(last$assembly), last$si)
  if (joined) check_gear(now$si, last$si)
  now
}

# Equivalent to `complete_counts()`. Reuses the counts of the last gear if no input of the counts
# has changed and no twine is given by weight.
counts_again <- function(fields, plan, last) {
  same <- !is.null(last) && identical(plan[count_groups], last$plan[count_groups]) &&
    identical(fields[count_groups], last$fields[count_groups]) && !has_field(fields, "rtex")
  if (!same) return(complete_counts(fields, plan))
  for (group in intersect(count_groups, names(fields))) {
    fields[group] <- last$counted$fields[group]
    if (group %in% names(plan)) plan[group] <- last$counted$plan[group]
  }
  list(fields = fields, plan = plan, derived = last$derived)
}

# Groups that are copied unchanged from a short form to its assembly and affect no other group.
handed_on <- c("name", "towing", "vessel")

# Returns an expanded short form with the roles of its parts, from the measures of its kind.
with_roles <- function(expanded, kind) {
  measures <- expanded$measures
  expanded$nets <- list(net = c(list(kind = kind), Filter(length, list(
    mouth = measures$mouth_area$area, wing_ends = measures$wing_end_spread$spread
  ))))
  expanded
}

# Returns the last assembly with this plan's copied groups, and its gears; NULL if another group has
# changed.
expanded_again <- function(plan, fields, last) {
  rest <- setdiff(names(plan), handed_on)
  same <- !is.null(last$expanded) && identical(names(plan), names(last$plan)) &&
    identical(plan[rest], last$plan[rest]) &&
    identical(fields[setdiff(names(fields), handed_on)],
      last$fields[setdiff(names(last$fields), handed_on)])
  changed <- intersect(handed_on, names(plan))
  if (!same || !all(changed %in% names(last$expanded))) return(NULL)
  expanded <- last$expanded
  expanded[changed] <- plan[changed]
  list(expanded, last$gears)
}

# Returns the fields of an assembly with the model choices of its `method` in place of its own.
#
# `method: paper` follows Li and others, Modeling of the Midwater Trawl Dynamical Behavior Based on
# R Language. Mass points are at knots and mid-bar. Drag and lift of a bar depend on its angle to
# the flow (eq. 4 and 5; the coefficients are not published, here Hoerner's). Drag is a sum over all
# bars, and added mass is a number (eq. 8).
by_method <- function(fields) {
  if (is.null(fields$method)) return(fields)
  fields$netting <- "bars"
  fields$netting_drag <- "morison"
  fields$coefficients <- "hoerner"
  fields$slack_twine <- "straight"
  fields$shielding <- "none"
  alike <- list(normal = 1, tangential = 1)
  fields$materials <- lapply(fields$materials, function(material) {
    material[names(material) != "coefficients"]
  })
  fields$ropes <- lapply(fields$ropes, function(rope) {
    rope$coefficients <- NULL
    rope$added_mass <- alike
    rope
  })
  fields$panels <- lapply(fields$panels, function(panel) {
    panel[c("netting", "netting_drag", "coefficients", "shielding")] <- NULL
    panel$added_mass <- alike
    panel$bar_segments <- first_of(panel$bar_segments, 2L)
    # Its knots are spheres without weight (eq. 3).
    if (panel$knotted) panel$knot_twine <- 0
    panel
  })
  fields
}

# Returns the gear as SI numbers with all defaults, from the checked fields of its assembly.
# `last_fields`, `last`: fields of another gear and the result of this function for them, or NULL.
#
# Returns list(name, kind = "assembly", water, towing, netting, slack_twine, points, ropes, panels,
# seams, pieces, otter_boards, ground, shooting, laid, vessel, nets, measures, share_places).
# Positions remain strings for `parse_place()`. A chain is a list of list(panel, edge, from, to,
# reversed); `from` and `to` are fractions of the edge. An optional field without a default is NULL
# (position, at, near, from, to, along, shares, held_between, segments, columns, rows,
# opening_stiffness, catch). A single number or string is NA instead.
si_of <- function(fields, last_fields = NULL, last = NULL) {
  law <- drag_model(fields$coefficients)
  si <- list(
    name = fields$name, kind = "assembly",
    water = si_water(fields$water, fields$seabed), towing = fields$towing,
    netting = fields$netting, slack_twine = fields$slack_twine, multipliers = fields$multipliers
  )
  same <- function(names) !is.null(last) && identical(fields[names], last_fields[names])
  # Returns the reusable parts of the last gear, if all other inputs are the same.
  kept <- function(group, same, made = last[[group]]) {
    if (same) list(parts = last_fields[[group]][names(made)], made = made)
  }
  lines <- c("materials", "coefficients", "netting", "netting_drag", "shielding")
  si$panels <- map_named(
    fields$panels, "panels", si_panel, fields, law, kept = kept("panels", same(lines))
  )
  known <- list(
    points = names(fields$points), ropes = names(fields$ropes), panels = panel_shapes(si$panels)
  )
  edges <- function(panels) lapply(panels, `[`, c("upper", "lower", "deep"))
  same_known <- identical(edges(known$panels), edges(last$panels)) &&
    identical(known$points, names(last$points)) && identical(known$ropes, names(last$ropes))
  # The length of netting affects only ropes along it.
  same_ropes <- if (identical(known$panels, panel_shapes(last$panels))) last$ropes else
    Filter(function(rope) is.null(rope$along), last$ropes)
  si$points <- map_named(
    fields$points, "points", si_point, known, kept = kept("points", same_known)
  )
  si$ropes <- map_named(
    fields$ropes, "ropes", si_rope, fields, law, known,
    kept = kept("ropes", same_known && same(lines), same_ropes)
  )
  si$seams <- map_named(fields$seams, "seams", si_seam, known, kept = kept("seams", same_known))
  si$pieces <- map_named(
    fields$pieces, "pieces", si_piece, fields, known,
    kept = kept("pieces", same_known && same("water"))
  )
  si$catch <- if (!is.null(fields$catch)) si_catch(fields$catch, "catch", si$panels)
  # Kites are otter boards with upward or downward lift.
  si$otter_boards <- c(
    map_named(fields$otter_boards, "otter_boards", si_otter_board, fields, known),
    map_named(fields$kites, "kites", si_kite, fields, known)
  )
  known$otter_boards <- names(si$otter_boards)
  known$pieces <- names(si$pieces)
  known$ground <- !is.null(fields$seabed)
  longest <- if (length(si$ropes)) max(vapply(si$ropes, `[[`, 0, "length")) else Inf
  si$ground <- si_seabed(fields$seabed, fields$towing$speed, longest)
  si$vessel <- if (!is.null(last) && same("vessel")) {
    last$vessel
  } else if (!is.null(fields$vessel)) {
    si_vessel(fields$vessel, "vessel")
  }
  si$sticking <- isTRUE(fields$seabed$sticking)
  si$shooting <- if (!is.null(fields$shooting)) si_shooting(fields$shooting, "shooting", known)
  si$laid <- if (!is.null(fields$laid)) si_laid(fields$laid, "laid", known)
  same_bodies <- identical(known$otter_boards, names(last$otter_boards)) &&
    identical(known$pieces, names(last$pieces)) && known$ground == !is.null(last$ground)
  si$measures <- map_named(
    fields$measures, "measures", si_measure, known,
    kept = kept("measures", same_known && same_bodies)
  )
  si$nets <- map_named(fields$nets, "nets", si_net, known)
  si$share_places <- share_places(si)
  si
}

# kept: list(parts, made) of another gear whose results can be reused for identical parts, or NULL.
map_named <- function(parts, group, convert, ..., kept = NULL) {
  if (!is.null(kept$parts) && identical(parts, kept$parts)) return(kept$made)
  names <- as.character(names(parts))
  paths <- paste0(group, ".", names)
  out <- vector("list", length(parts))
  for (i in seq_along(parts)) {
    same <- names[i] %in% names(kept$made) && identical(parts[[i]], kept$parts[[names[i]]])
    out[[i]] <- if (same) kept$made[[names[i]]] else convert(parts[[i]], path = paths[i], ...)
  }
  stats::setNames(out, names)
}

si_water <- function(water, seabed = NULL) {
  layers <- water$current
  if (is.null(layers)) layers <- list(speed = 0, toward = 0)
  if (!is.null(names(layers))) layers <- list(c(layers, depth = 0))
  pick <- function(field) vapply(layers, `[[`, 0, field)
  depth <- pick("depth")
  if (is.unsorted(depth, strictly = TRUE)) {
    abort_field("water.current", depth, NULL,
      "must list its depths from the surface down, each once")
  }
  si <- list(
    density = water$density, viscosity = water$viscosity,
    free_surface = water$free_surface || !is.null(water$waves),
    current = list2DF(list(
      depth = depth,
      x = pick("speed") * cos(pick("toward")), y = pick("speed") * sin(pick("toward"))
    ))
  )
  if (!is.null(water$waves)) si$waves <- si_waves(water$waves, seabed)
  si
}

# Returns coefficients on diameter times length: list(law, normal, tangential, skin). The numbers
# are NA for a model that depends on Reynolds number or solidity.
drag_model <- function(coefficients) {
  constant <- function(numbers) {
    list(law = "constant", normal = numbers$normal, tangential = numbers$tangential,
      skin = numbers$skin)
  }
  if (is.list(coefficients)) return(constant(coefficients))
  row <- laws[laws$of == "twine" & laws$name == coefficients, ]
  if (row$form == "numbers") return(constant(row))
  list(law = coefficients, normal = NA_real_, tangential = NA_real_, skin = NA_real_)
}

# Returns coefficients of a rope or twine: its own, its material's or the plan's (`law`).
line_drag_coefficients <- function(own, material, fields, law) {
  if (is.null(own) && !is.null(material)) own <- fields$materials[[material]]$coefficients
  if (is.null(own)) law else drag_model(own)
}

si_added_mass <- function(added_mass) {
  c(normal = added_mass$normal, tangential = added_mass$tangential)
}

# Default knot diameter in twine diameters. A knot of two turns measures 2 to 3 twine diameters
# across; models with spherical knots use 2.
usual_knot <- 2

# Default length of twine in a knot, in twine diameters: a single knot (sheet bend). The ratio of
# the weights of knotted and knotless netting is 1 + 16 d / mesh size in the table of J. Prado and
# P. Y. Dremiere, Fisherman's Workbook, FAO 1990. It is recalled, an assumption until it is checked
# there. A netting mesh has one knot.
usual_knot_twine <- 16

si_panel <- function(panel, path, fields, law) {
  meshes <- panel$meshes
  if (meshes$upper == 0 && meshes$lower == 0) {
    abort_field(paste0(path, ".meshes"), meshes, NULL,
      "has 0 meshes at both edges; only one edge may have 0")
  }
  twine <- panel$twine
  bar <- panel$mesh_size / 2
  if (twine$diameter >= bar) {
    abort_field(paste0(path, ".twine.diameter"), twine$diameter,
      paste("less than half the mesh size,", format_si(bar, "length")))
  }
  line <- line_properties(twine, fields$materials, paste0(path, ".twine"))
  count <- if (twine$double) 2 else 1
  for (field in if (!panel$knotted) intersect(c("knot_diameter", "knot_twine"), names(panel))) {
    abort_field(paste0(path, ".", field), panel[[field]], NULL,
      sprintf("is given, but `%s.knotted` is no", path))
  }
  in_knots <- if (panel$knotted) twine$diameter else 0
  hexagons <- si_hexagons(panel, path)
  # Hexagonal netting does not support `blended`.
  usual_drag <- if (hexagons > 0 && fields$netting_drag == "blended") {
    "morison"
  } else {
    fields$netting_drag
  }
  lost <- edge_losses(panel, path)
  si <- list(
    mesh_size = panel$mesh_size,
    upper = meshes$upper, lower = meshes$lower, deep = meshes$deep,
    twine_diameter = twine$diameter, twine_count = count,
    axial_stiffness = line$axial_stiffness * count,
    load_table = if (!is.null(line$load_table)) {
      list(strain = line$load_table$strain, load = line$load_table$load * count)
    },
    damping = line$damping * count,
    mass_per_length = line$mass_per_length * count,
    volume_per_length = line$volume_per_length * count,
    strength = line$strength * count,
    material = first_of(twine$material, NA_character_),
    orientation = panel$orientation, straight_bar = hexagons,
    lost_left = lost[["left"]], lost_right = lost[["right"]],
    knot_diameter = first_of(panel$knot_diameter, usual_knot * in_knots),
    knot_twine = first_of(panel$knot_twine, usual_knot_twine) * in_knots,
    netting = first_of(panel$netting, fields$netting),
    shielding = first_of(panel$shielding, fields$shielding),
    coefficients = line_drag_coefficients(panel$coefficients, twine$material, fields, law),
    netting_drag = first_of(panel$netting_drag, usual_drag),
    added_mass = si_added_mass(panel$added_mass),
    columns = panel$columns, rows = panel$rows,
    bar_segments = panel$bar_segments, part = first_of(panel$part, NA_character_)
  )
  stiff <- first_of(panel$opening_stiffness, usual_opening_stiffness(si))
  if (isTRUE(stiff$couple > 0)) si$opening_stiffness <- stiff
  si
}

si_point <- function(point, path, known) {
  if (!is.null(point$near) && !is.null(point$position)) {
    abort_field(paste0(path, ".near"), point$near, "omitted if `position` is given")
  }
  list(
    position = point$position, held = first_of(point$held, NA_character_),
    at = if (!is.null(point$at)) find_place(point$at, paste0(path, ".at"), known),
    near = point$near,
    load = first_of(point$load, c(0, 0, 0))
  )
}

si_rope <- function(rope, path, fields, law, known) {
  line <- line_properties(rope, fields$materials, path)
  along <- NULL
  length <- rope[["length"]]
  shares <- NULL
  if (!is.null(rope$along)) {
    along <- find_chain(rope$along, paste0(path, ".along"), known)
    netting <- chain_length(along, known$panels)
    if (netting == 0) {
      abort_field(paste0(path, ".along"), rope$along, NULL,
        "has no length because its edges have no meshes")
    }
    lengths <- edge_lengths(rope, path, along, known$panels)
    if (!is.null(lengths)) {
      length <- sum(lengths)
      shares <- lengths / length
    }
    if (is.null(length)) length <- rope$hanging_ratio * netting
  }
  if (!is.null(line$load_table) && length(rope$through)) {
    abort_field(paste0(path, ".load_by_elongation"), rope$load_by_elongation, NULL,
      "is given, but the rope slides: use `axial_stiffness`")
  }
  list(
    material = first_of(rope$material, NA_character_),
    from = if (!is.null(rope$from)) find_place(rope$from, paste0(path, ".from"), known),
    to = if (!is.null(rope$to)) find_place(rope$to, paste0(path, ".to"), known),
    along = along,
    through = vapply(as.character(rope$through), find_place, "",
      path = paste0(path, ".through"), known = known, USE.NAMES = FALSE),
    length = length, shares = shares, diameter = rope$diameter,
    axial_stiffness = line$axial_stiffness, load_table = line$load_table,
    damping = line$damping,
    bending_stiffness = rope$bending_stiffness,
    strut = rope$carries_compression || rope$bending_stiffness > 0,
    mass_per_length = line$mass_per_length,
    volume_per_length = line$volume_per_length,
    coefficients = strummed(line_drag_coefficients(rope$coefficients, rope$material, fields, law),
      rope$strumming, path),
    added_mass = si_added_mass(rope$added_mass),
    strength = line$strength,
    friction = if (!is.null(rope$friction)) c(rope$friction$along, rope$friction$across),
    segments = rope$segments, role = first_of(rope$role, NA_character_)
  )
}

# Returns lengths (m) of a rope along its edges from `lengths` or `hanging_ratios`, or NULL.
edge_lengths <- function(rope, path, along, panels) {
  field <- intersect(c("lengths", "hanging_ratios"), names(rope))
  if (!length(field)) return(NULL)
  given <- rope[[field]]
  if (length(given) != length(along)) {
    abort_field(paste(path, field, sep = "."), given,
      sprintf("one %s for each of the %d edges of `along`",
        if (field == "lengths") "length" else "ratio", length(along)))
  }
  if (field == "lengths") return(given)
  given * vapply(seq_along(along), function(k) chain_length(along[k], panels), 0)
}

si_seam <- function(seam, path, known) {
  edges <- as.list(seam$edges)
  for (i in seq_along(edges)) {
    edges[[i]] <- find_chain(edges[[i]], paste0(path, ".edges[", i, "]"), known)
  }
  gathered <- if (!is.null(seam$gathered_at)) {
    find_place(seam$gathered_at, paste0(path, ".gathered_at"), known)
  }
  between <- vapply(seam$held_between, find_place, "",
    path = paste0(path, ".held_between"), known = known, USE.NAMES = FALSE)
  if (!is.null(gathered) && length(between)) {
    abort_both(path, "gathered_at", "held_between", seam)
  }
  list(edges = edges, gathered_at = gathered, held_between = if (length(between)) between)
}

# Returns the speed of the current in each layer, m/s.
current_speeds <- function(si) sqrt(si$water$current$x^2 + si$water$current$y^2)

# Returns the greatest of the towing and current speeds, m/s.
flow_speed <- function(si) max(si$towing$speed, current_speeds(si))
