# Numbers outside the range that is possible for any gear.

# Returns a ratio of two positive numbers, else NA.
positive_ratio <- function(above, below) {
  if (isTRUE(above > 0) && isTRUE(below > 0)) above / below else NA_real_
}

# ---- plan ----------------------------------------------------------------------------------------

# TRUE for ropes that may be as thick as discs and bobbins.
is_thick <- function(rope) {
  rope$strut || rope$role %in% c("ground_gear", "footrope", "footrope_extension")
}

define_part_number("rope diameter", "rope", function(rope) {
  if (is_thick(rope)) NA_real_ else in_unit(rope$diameter, "mm")
})

define_part_number("body diameter", "rope", function(rope) {
  if (is_thick(rope)) in_unit(rope$diameter, "mm") else NA_real_
})

# Usual ranges of parts by role and quantity.
role_ranges <- package_table("role_ranges.csv")

# Returns the numbers of parts that have a range for their role.
numbers_by_role <- function(parts, kind, quantity, unit) {
  ranges <- role_ranges[role_ranges$quantity == quantity, ]
  row <- match(vapply(parts, function(part) first_of(part$role, ""), ""), ranges$role)
  found <- numbers_of_parts(parts[!is.na(row)], kind, function(part) {
    as.double(in_unit(part[[quantity]], unit))
  })
  structure(found, limits = ranges[row[!is.na(row)], ])
}

define_number("length for its role", function(si, state) {
  free <- Filter(function(rope) is.null(rope$along), si$ropes)
  numbers_by_role(free, "rope", "length", "m")
})

define_number("diameter for its role", function(si, state) {
  numbers_by_role(si$ropes, "rope", "diameter", "mm")
})

define_number("mass for its role", function(si, state) {
  numbers_by_role(si$pieces, "piece", "mass", "kg")
})

# Other kinds of gears have a band.
define_number("speed", function(si, state) {
  if (si$towing$speed > 0 && is.null(band_of("towing speed", si_by_net(si)[[1L]]))) {
    in_unit(si$towing$speed, "knot")
  }
})

define_number("current", function(si, state) max(current_speeds(si)))

define_number("lift coefficient", function(si, state) body_coefficients(si, "lift"))

define_number("drag coefficient", function(si, state) body_coefficients(si, "drag"))

# Returns the lift or drag coefficients of pieces, and the largest ones of free boards and kites.
body_coefficients <- function(si, force) {
  c(
    numbers_of_parts(si$pieces, "piece", function(piece) {
      positive_ratio(piece[[paste0(force, "_area")]], piece$area)
    }),
    numbers_of_parts(si$otter_boards, "piece", function(board) max(board$polar[[force]]))
  )
}

define_part_number("twine", "panel", function(panel) in_unit(panel$twine_diameter, "mm"))

define_part_number("twine over bar", "panel", function(panel) {
  100 * panel$twine_diameter / (panel$mesh_size / 2)
})

define_part_number("breaking strain", "rope", function(rope) {
  100 * positive_ratio(rope$strength, rope$axial_stiffness)
})

# Tests in air are omitted.
define_number("water density", function(si, state) {
  if (si$water$density > 2) si$water$density
})

define_number("density", function(si, state) {
  c(
    numbers_of_parts(Filter(is_hollow, si$ropes), "rope", rope_density),
    numbers_of_parts(si$pieces, "piece", function(piece) positive_ratio(piece$mass, piece$volume))
  )
})

rope_density <- function(rope) positive_ratio(rope$mass_per_length, rope$volume_per_length)

# TRUE for ropes that may contain air or foam.
is_hollow <- function(rope) rope$strut || rope$role %in% "float_line"

define_part_number("rope density", "rope", function(rope) {
  if (is_hollow(rope)) NA_real_ else rope_density(rope)
})

define_number("taper", function(si, state) {
  cut <- edge_keys(lapply(si$ropes[ropes_of_role(si, "grid")], `[[`, "along"))
  cut <- sub(" .*", "", cut)
  numbers_of_parts(si$panels[setdiff(names(si$panels), cut)], "panel", function(panel) {
    abs(panel$upper - panel$lower) / panel$deep
  })
})

define_part_number("mesh count", "panel", function(panel) {
  along <- c(panel$upper, panel$lower)
  # A triangle has no mesh along one edge.
  min(panel$deep, along[along > 0])
})

define_part_number("panel depth", "panel", function(panel) panel$deep * panel$mesh_size)

define_part_number("narrow panel", "panel", function(panel) {
  max(panel$upper, panel$lower) / panel$deep
})

define_number("long bridle", function(si, state) {
  along <- Filter(function(rope) !is.null(rope$along), si$ropes)
  longest <- max(0, vapply(along, `[[`, 0, "length"))
  bridles <- Filter(function(rope) rope$role %in% "bridle", si$ropes)
  numbers_of_parts(bridles, "rope", function(rope) positive_ratio(rope$length, longest))
})

define_number("branch lines", function(si, state) {
  lines <- si$ropes[ropes_of_role(si, "main_line")]
  numbers_of_parts(si$ropes[ropes_of_role(si, "branch_line")], "rope", function(branch) {
    next_to <- Filter(function(line) branch$from %in% c(line$from, line$to), lines)
    if (!length(next_to)) return(NA_real_)
    branch$length / max(vapply(next_to, `[[`, 0, "length"))
  })
})

define_number("rope over twine", function(si, state) {
  numbers_of_parts(si$ropes, "rope", function(rope) {
    panels <- intersect(sub("[.].*", "", unlist(rope$along)), names(si$panels))
    if (rope$strut || !length(panels)) return(NA_real_)
    rope$diameter / max(vapply(si$panels[panels], `[[`, 0, "twine_diameter"))
  })
})

define_part_number("short rope", "rope", function(rope) {
  if (rope$strut) NA_real_ else rope$length / rope$diameter
})

define_part_number("body size", "piece", function(piece) {
  positive_ratio(piece$volume^(2 / 3), piece$area)
})

define_part_number("body drag", "piece", function(piece) {
  positive_ratio(piece$drag_area, piece$volume^(2 / 3))
})

define_part_number("rope volume", "rope", function(rope) {
  positive_ratio(rope$volume_per_length, pi / 4 * rope$diameter^2)
})

define_part_number("normal drag coefficient of ropes", "rope", function(rope) {
  nonzero_coefficient(rope, "normal")
})

define_part_number("tangential drag coefficient of ropes", "rope", function(rope) {
  nonzero_coefficient(rope, "tangential")
})

nonzero_coefficient <- function(rope, along) {
  coefficient <- rope$coefficients[[along]]
  if (isTRUE(coefficient != 0)) coefficient else NA_real_
}

# Roles of bodies and ropes that float (-1) or sink (1).
sinking_roles <- c(
  float = -1, weight = 1, sinker = 1, anchor = 1, ring = 1, disc = 1, hammer = 1, hook = 1,
  shoe_end = 1, ground_gear = 1, lead_line = 1, tickler = 1
)

# Returns the parts of a gear with their mass and displaced volume: list(ropes, pieces). A rope
# includes the pieces mounted on it.
loaded_parts <- function(si) {
  ropes <- Map(function(rope, name) {
    on <- Filter(function(piece) identical(piece$along$name, name), si$pieces)
    sum_of <- function(field) {
      sum(vapply(on, function(piece) first_of(piece$number, 1) * piece[[field]], 0))
    }
    list(role = rope$role, mass = rope$length * rope$mass_per_length + sum_of("mass"),
      volume = rope$length * rope$volume_per_length + sum_of("volume"))
  }, si$ropes, names(si$ropes))
  list(ropes = ropes, pieces = si$pieces)
}

define_number("weight that floats", function(si, state) {
  parts <- loaded_parts(si)
  sinking <- function(part) {
    if (!isTRUE(part$mass > 0)) return(NA_real_)
    way <- unname(sinking_roles[first_of(part$role, "")])
    way * (1 - si$water$density * part$volume / part$mass)
  }
  c(numbers_of_parts(parts$pieces, "piece", sinking),
    numbers_of_parts(parts$ropes, "rope", sinking))
})

define_number("hanging ratio", function(si, state) {
  numbers_of_parts(si$ropes, "rope", function(rope) {
    if (is.null(rope$along)) return(NA_real_)
    netting <- vapply(rope$along, function(edge) chain_length(list(edge), si$panels), 0)
    ratio <- if (is.null(rope$shares)) {
      rope$length / sum(netting)
    } else {
      (rope$length * rope$shares / netting)[netting > 0]
    }
    ratio[which.max(abs(log(ratio)))]
  })
})

# Returns the ratio of the largest to the smallest number of the panels at each seam.
ratios_at_seams <- function(si, field) {
  numbers_of_parts(si$seams, "seam", function(seam) {
    panels <- unique(sub("[.].*", "", unlist(seam$edges)))
    found <- vapply(si$panels[intersect(panels, names(si$panels))], `[[`, 0, field)
    if (length(found)) max(found) / min(found) else NA_real_
  })
}

define_number("twines at a seam", function(si, state) ratios_at_seams(si, "twine_diameter"))

define_number("meshes at a seam", function(si, state) ratios_at_seams(si, "mesh_size"))

# ---- state ---------------------------------------------------------------------------------------

define_number("slack rope", function(si, state) {
  if (!is.null(state$time)) return(numeric())
  free <- Filter(function(rope) {
    is.null(rope$along) && !rope$strut && !length(rope$through) && rope$from != rope$to
  }, si$ropes)
  distance <- function(from, to) {
    points <- si$points[c(from, to)]
    planned <- lapply(points, function(point) unlist(first_of(point$position, point$near)))
    settled <- lapply(c(from, to), function(name) state$position[, state$mesh$places[[name]]])
    ends <- if (all(lengths(planned) == 3L)) list(settled, planned) else list(settled)
    min(vapply(ends, function(x) sqrt(sum((x[[2L]] - x[[1L]])^2)), 0))
  }
  # The segments of a main line between branch lines count as one rope.
  main <- free[vapply(free, function(rope) rope$role %in% "main_line", NA)]
  ends <- unlist(lapply(main, `[`, c("from", "to")))
  ends <- ends[!ends %in% ends[duplicated(ends)]]
  if (length(ends) == 2L) {
    long <- sum(vapply(main, `[[`, 0, "length"))
    whole <- list(from = ends[[1L]], to = ends[[2L]], length = long)
    free <- c(free, setNames(list(whole), names(main)[1L]))
  }
  numbers_of_parts(free, "rope", function(rope) {
    100 * distance(rope$from, rope$to) / rope$length
  })
})

define_number("depth", function(si, state) {
  deepest <- which.min(state$position[3, ])
  setNames(-state$position[3, deepest], describe_node(state$mesh, deepest))
})

define_number("mouth blockage", function(si, state) 100 * measure_value(state, "mouth_blockage"))

# Strain (fraction) at which a rope or twine of unknown strength is assumed to break: polyamide and
# polyethylene break at 20 to 25 %.
assumed_breaking_strain <- 0.2

define_number("load", function(si, state) {
  parts <- c(si$ropes, si$panels)
  table <- tension_table(state)
  strength <- vapply(parts[table$part], function(part) {
    if (is.na(part$strength)) assumed_breaking_strain * part$axial_stiffness else part$strength
  }, 0)
  is_rope <- table$kind == "rope"
  load <- 100 * 1000 * ifelse(is_rope, table$max_kN, table$most_loaded_kN) / strength
  names(load) <- paste(ifelse(is_rope, "rope", "panel"), table$part)
  field <- ifelse(is_rope, "diameter", "twine")
  sorted <- order(load, decreasing = TRUE)
  structure(load[sorted], limits = data.frame(least = NA, greatest = 40, field = field[sorted]))
})

define_number("below the anchors", function(si, state) {
  moored <- si$ropes[ropes_of_role(si, c("mooring", "anchor_line"))]
  held <- Filter(function(point) identical(point$held, "fixed"), si$points)
  anchors <- held[intersect(names(held), unlist(lapply(moored, `[`, c("from", "to"))))]
  if (!length(anchors)) return(numeric())
  deepest <- which.min(state$position[3L, ])
  depth <- min(vapply(anchors, function(point) point$position[3L], 0)) -
    state$position[3L, deepest]
  setNames(depth, describe_node(state$mesh, deepest))
})

define_number("out of the water", function(si, state) {
  mesh <- state$mesh
  up <- Filter(function(point) isTRUE(point$position[3L] > 0), si$points)
  held <- mesh$points[names(up)]
  led <- lapply(mesh$ropes, function(rope) if (any(held %in% rope$node)) rope$node)
  height <- replace(state$position[3L, ], c(held, unlist(led)), -Inf)
  highest <- which.max(height)
  setNames(height[highest], describe_node(mesh, highest))
})

define_number("bundle", function(si, state) {
  if (!is.null(state$time)) return(numeric())
  asked <- Filter(function(one) identical(one$kind, "enclosed_volume"), si$measures)
  numbers_of_parts(setNames(asked, vapply(asked, `[[`, "", "rope")), "rope", function(measure) {
    depth <- -min(state$position[3L, state$mesh$ropes[[measure$rope]]$node])
    open <- si$ropes[[measure$rope]]$length^2 / (4 * pi) * depth
    100 * measure_values(state, list(measure)) / open
  })
})

define_number("cells finer than meshes", function(si, state) {
  cells <- state$mesh$model$cells
  plain <- cells$straight == 0
  panel <- cell_panel(si, state$mesh)[plain]
  bars_a_mesh <- 2 - is_square(panel_table(si$panels))
  meshes <- state$mesh$model$frame$cells$bars[plain] / bars_a_mesh[panel]
  middle <- vapply(split(meshes, names(si$panels)[panel]), stats::median, 0)
  # Skip panels for which bars would change more than the mesh size.
  stays <- Filter(function(panel) {
    !is.null(panel$opening_stiffness) && !isTRUE(panel$opening_stiffness$assumed)
  }, si$panels)
  middle <- middle[!names(middle) %in% c(names(stays), si$catch$panels)]
  worst <- middle[which.min(middle)]
  setNames(worst, paste("panel", names(worst), recycle0 = TRUE))
})
