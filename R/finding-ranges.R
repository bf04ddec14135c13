# Numbers outside the range that is possible for any gear. Each check has one range for all kinds.

# Defines a check of numbers. `least`, `greatest`: limits of usual numbers; `unit`: their unit, as
# text. `values(gear, state)`: numbers, named by location as in finding(). `quantity`: name of the
# number in messages. Numbers with the attributes `least` and `greatest` have their own limits.
# `field`: as in finding(), or fields by kind of part. Other arguments: as in define_finding() and
# finding().
define_range <- function(name, of, message, quantity, least, greatest, unit, values, advice,
                         field = NULL, rank = 1L) {
  define_finding(name, of, message, function(gear, state) {
    found <- values(gear, state)
    least <- rep_len(first_of(attr(found, "least"), least), length(found))
    greatest <- rep_len(first_of(attr(found, "greatest"), greatest), length(found))
    lapply(which(is.finite(found) & (found < least | found > greatest)), function(k) {
      location <- names(found)[k]
      own <- if (length(field) > 1L) field[[sub(" .*", "", location)]] else field
      unusual_number(quantity, found[[k]], unit, least[k], greatest[k], location, advice, own)
    })
  }, rank = rank)
}

# Returns a number for each part of a list, named by location. `of(part)`: the number or NA.
numbers_of_parts <- function(parts, kind, of) {
  found <- vapply(parts, of, 0)
  setNames(found, paste(kind, names(parts), recycle0 = TRUE))
}

# Returns a ratio of two positive numbers, else NA.
positive_ratio <- function(above, below) {
  if (isTRUE(above > 0) && isTRUE(below > 0)) above / below else NA_real_
}

# Roles of ropes that may be as thick as discs and bobbins; poles may be too.
thick_roles <- c("ground_gear", "footrope", "footrope_extension")

# Returns the diameters of ropes (mm). `thick`: TRUE for ground gear and poles only.
rope_diameters <- function(si, thick) {
  ropes <- Filter(function(rope) thick == (rope$strut || rope$role %in% thick_roles), si$ropes)
  numbers_of_parts(ropes, "rope", function(rope) in_unit(rope$diameter, "mm"))
}

define_range("rope diameter", "plan",
  "A rope is thicker than 200 mm or thinner than 0.2 mm: a unit may be missing.",
  "diameter", 0.2, 200, "mm", function(gear, state) rope_diameters(gear_si(gear), FALSE),
  "Check the unit: a number without a unit is in metres.", "diameter"
)

define_range("body diameter", "plan",
  "A ground gear or a pole is thicker than 1.5 m or thinner than 0.2 mm: a unit may be missing.",
  "diameter", 0.2, 1500, "mm", function(gear, state) rope_diameters(gear_si(gear), TRUE),
  "Check the unit: a number without a unit is in metres.", "diameter"
)

# Returns the usual ranges of parts by role and quantity.
known_role_ranges <- remembered(function() {
  utils::read.csv(system.file("extdata", "role_ranges.csv", package = "codend"))
})

# Returns the numbers of parts that have a range for their role, with the limits as attributes.
numbers_by_role <- function(parts, kind, quantity, unit) {
  rows <- known_role_ranges()
  rows <- rows[rows$quantity == quantity, ]
  row <- match(vapply(parts, function(part) first_of(part$role, ""), ""), rows$role)
  found <- numbers_of_parts(parts[!is.na(row)], kind, function(part) {
    as.double(in_unit(part[[quantity]], unit))
  })
  row <- row[!is.na(row)]
  structure(found, least = rows$least[row], greatest = rows$greatest[row])
}

define_range("length for its role", "plan",
  "The length of a rope without netting is outside the range of its role. Range:
  `role_ranges.csv`.",
  "length", -Inf, Inf, "m",
  function(gear, state) {
    free <- Filter(function(rope) is.null(rope$along), gear_si(gear)$ropes)
    numbers_by_role(free, "rope", "length", "m")
  },
  "Check the number and its unit.", "length"
)

define_range("diameter for its role", "plan",
  "The diameter of a rope is outside the range of its role. Range: `role_ranges.csv`.",
  "diameter", -Inf, Inf, "mm",
  function(gear, state) numbers_by_role(gear_si(gear)$ropes, "rope", "diameter", "mm"),
  "Check the number and its unit.", "diameter"
)

define_range("mass for its role", "plan",
  "The mass of a body is outside the range of its role. Range: `role_ranges.csv`.",
  "mass", -Inf, Inf, "kg",
  function(gear, state) numbers_by_role(gear_si(gear)$pieces, "piece", "mass", "kg"),
  "Check the number and its unit.", "mass"
)

# The fastest towed survey instruments run at 12 knots; no fishing gear reaches 10 knots. Models in
# flume tanks are tested from about 0.2 m/s. Other kinds of gears have a band.
define_range("speed", "plan",
  "The towing speed is above 12 knot or below 0.25 knot. Fishing gear is towed at 1 to 7 knot.",
  "towing speed", 0.25, 12, "knot",
  function(gear, state) {
    si <- gear_si(gear)
    if (si$towing$speed > 0 && is.null(band_of("towing speed", si_by_net(si)[[1L]]))) {
      c(towing.speed = in_unit(si$towing$speed, "knot"))
    }
  },
  "Check the unit: a number without a unit is in m/s."
)

define_range("current", "plan",
  "A current is above 3 m/s.",
  "current", -Inf, 3, "m/s",
  function(gear, state) c(water.current = max(current_speeds(gear_si(gear)))),
  "Check the unit: a number without a unit is in m/s."
)

# The largest published lift coefficients are 2.54 for boards (high_lift), 1.2 for lifting canvas
# and about 1.5 for kites.
define_range("lift coefficient", "plan",
  "A lift coefficient is above 3. The largest published coefficient of an otter board is 2.54.",
  "lift coefficient", -Inf, 3, "",
  function(gear, state) body_coefficients(gear_si(gear), "lift"),
  "Check the coefficient and its reference area.", "lift_coefficient", rank = 2L
)

# Streamlined floats and boards have 0.2 or more, based on their frontal area. Tested boards have up
# to 1.5.
define_range("drag coefficient", "plan",
  "The drag coefficient of a body is below 0.1 or above 2.5. Streamlined bodies have 0.2 or more,
  otter boards up to 1.5.",
  "drag coefficient", 0.1, 2.5, "",
  function(gear, state) body_coefficients(gear_si(gear), "drag"),
  "Check the coefficient and its reference area.", "drag_coefficient", rank = 2L
)

# Returns the lift or drag coefficients of pieces, and the largest ones of free boards and kites.
body_coefficients <- function(si, force) {
  c(
    numbers_of_parts(si$pieces, "piece", function(piece) {
      positive_ratio(piece[[paste0(force, "_area")]], piece$area)
    }),
    numbers_of_parts(si$otter_boards, "piece", function(board) max(board$polar[[force]]))
  )
}

# The thickest twine is in the front meshes of large midwater trawls; thicker lines between knots
# are ropes. No thinner twine or monofilament is sold.
define_range("twine", "plan",
  "A twine is thicker than 24 mm or thinner than 0.05 mm: a unit may be missing.",
  "twine diameter", 0.05, 24, "mm",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$panels, "panel", function(panel) {
      in_unit(panel$twine_diameter, "mm")
    })
  },
  "Check the unit: a number without a unit is in metres.", "twine"
)

# Netting of codends and cages has up to 11 %, double twine in small meshes up to 20 %. The largest
# front meshes in use (14 mm twine, bars of 16 to 32 m) have 0.04 to 0.09 %.
define_range("twine over bar", "plan",
  "A twine's diameter is more than 25 % or less than 0.015 % of the bar length. No known netting is
  like that; a unit may be missing.",
  "twine diameter over bar length", 0.015, 25, "%",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$panels, "panel", function(panel) {
      100 * panel$twine_diameter / (panel$mesh_size / 2)
    })
  },
  "Check the unit: a number without a unit is in metres.", "twine"
)

# Steel wire ropes and chains have 1.3 %, fibre ropes of HMPE 1.8 %, polyamide 20 % or more.
define_range("breaking strain", "plan",
  "The breaking load of a rope over its axial stiffness is below 1.2 % or above 60 %. Steel wire has
  1.3 %.",
  "breaking load over axial stiffness", 1.2, 60, "%",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$ropes, "rope", function(rope) {
      100 * positive_ratio(rope$strength, rope$axial_stiffness)
    })
  },
  "Check the strength, the stiffness or modulus, and their units."
)

# Fresh to very salty water has 990 to 1,050 kg/m3; tests in air have about 1.2.
define_range("water density", "plan",
  "The density of the water is below 950 kg/m3 or above 1,100 kg/m3.",
  "density", 950, 1100, "kg/m3",
  function(gear, state) {
    density <- gear_si(gear)$water$density
    c(water.density = if (density > 2) density else NA_real_)
  },
  "Check the density and its unit."
)

# Ropes and bodies of shipped and published gears have 205 to 11,300 kg/m3.
define_range("density", "plan",
  "The density of a pipe, float line or body (its mass over its volume) is below 30 kg/m3 or above
  13,000 kg/m3. Foam has 100 kg/m3 or more, lead 11,340 kg/m3.",
  "density", 30, 13000, "kg/m3",
  function(gear, state) {
    si <- gear_si(gear)
    c(
      numbers_of_parts(Filter(is_hollow, si$ropes), "rope", rope_density),
      numbers_of_parts(si$pieces, "piece", function(piece) positive_ratio(piece$mass, piece$volume))
    )
  },
  "Check the mass, the dimensions and their units.", "mass_per_length"
)

rope_density <- function(rope) positive_ratio(rope$mass_per_length, rope$volume_per_length)

# TRUE for ropes that may contain air or foam.
is_hollow <- function(rope) rope$strut || rope$role %in% "float_line"

# The lightest material of ropes, polypropylene, has 910 kg/m3.
define_range("rope density", "plan",
  "The density of a rope other than a float line (its mass over its volume) is below 600 kg/m3 or
  above 13,000 kg/m3. Polypropylene has 910 kg/m3, lead 11,340 kg/m3.",
  "density", 600, 13000, "kg/m3",
  function(gear, state) {
    numbers_of_parts(Filter(Negate(is_hollow), gear_si(gear)$ropes), "rope", rope_density)
  },
  "Check the mass, the dimensions and their units.", "mass_per_length"
)

# An all-bar cut on both sides changes the count by two meshes per mesh of depth. The steepest
# panels of published nets, the wings of rope trawls, have five.
define_range("taper", "plan",
  "The mesh counts of a panel's upper and lower edge differ by more than six meshes per mesh of
  depth. All-bar cuts on both sides give two. This check omits the cut around sorting grids.",
  "change of the mesh count per mesh of depth", -Inf, 6, "",
  function(gear, state) {
    si <- gear_si(gear)
    cut <- edge_keys(lapply(si$ropes[ropes_of_role(si, "grid")], `[[`, "along"))
    cut <- sub(" .*", "", cut)
    numbers_of_parts(si$panels[setdiff(names(si$panels), cut)], "panel", function(panel) {
      abs(panel$upper - panel$lower) / panel$deep
    })
  },
  "Check the mesh counts of the panel.", "meshes"
)

define_range("mesh count", "plan",
  "A panel is less than one mesh deep, or has less than one mesh along an edge.",
  "mesh count", 1, Inf, "",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$panels, "panel", function(panel) {
      along <- c(panel$upper, panel$lower)
      # A triangle has no mesh along one edge.
      min(panel$deep, along[along > 0])
    })
  },
  "Check the mesh counts of the panel.", "meshes"
)

# The longest sections of shipped and published nets have 96 m.
define_range("panel depth", "plan",
  "A panel is deeper than 300 m, stretched. The longest sections of nets have about 100 m.",
  "stretched depth", -Inf, 300, "m",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$panels, "panel", function(panel) panel$deep * panel$mesh_size)
  },
  "Check the mesh counts of the panel.", "meshes"
)

# The narrowest panels of shipped and published nets have 0.19.
define_range("narrow panel", "plan",
  "A panel has less than 10 % as many meshes across as it is deep.",
  "meshes across over meshes deep", 0.1, Inf, "",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$panels, "panel", function(panel) {
      max(panel$upper, panel$lower) / panel$deep
    })
  },
  "Check the mesh counts of the panel.", "meshes"
)

# The bridles of shipped and published nets are at most 1.9 times as long as that rope.
define_range("long bridle", "plan",
  "A bridle is more than 20 times as long as the longest rope along the netting.",
  "length of the bridle over that of the rope", -Inf, 20, "",
  function(gear, state) {
    si <- gear_si(gear)
    along <- Filter(function(rope) !is.null(rope$along), si$ropes)
    longest <- max(0, vapply(along, `[[`, 0, "length"))
    bridles <- Filter(function(rope) rope$role %in% "bridle", si$ropes)
    numbers_of_parts(bridles, "rope", function(rope) positive_ratio(rope$length, longest))
  },
  "Check the lengths and their units.", "length"
)

# Branch lines of shipped longlines have 0.3 to 0.8.
define_range("branch lines", "plan",
  "A branch line is more than three times as long as the line between it and the next one, so that
  branch lines tangle.",
  "length over the distance to the next branch line", -Inf, 3, "",
  function(gear, state) {
    si <- gear_si(gear)
    lines <- si$ropes[ropes_of_role(si, "main_line")]
    numbers_of_parts(si$ropes[ropes_of_role(si, "branch_line")], "rope", function(branch) {
      next_to <- Filter(function(line) branch$from %in% c(line$from, line$to), lines)
      if (!length(next_to)) return(NA_real_)
      branch$length / max(vapply(next_to, `[[`, 0, "length"))
    })
  },
  "Shorten the branch lines, or set them farther apart.", "length"
)

# Ropes along netting of shipped and published gears have 1 to 32 times the diameter of the twine.
define_range("rope over twine", "plan",
  "A rope along netting is less than half or more than 60 times as thick as the twine. This check
  omits poles and pipes.",
  "rope diameter over twine diameter", 0.5, 60, "",
  function(gear, state) {
    si <- gear_si(gear)
    ropes <- Filter(function(rope) !rope$strut, si$ropes)
    numbers_of_parts(ropes, "rope", function(rope) {
      panels <- intersect(sub("[.].*", "", unlist(rope$along)), names(si$panels))
      if (!length(panels)) return(NA_real_)
      rope$diameter / max(vapply(si$panels[panels], `[[`, 0, "twine_diameter"))
    })
  },
  "Check the diameter of the rope and of the twine, and their units.", "diameter"
)

# EN 13414-1 requires 20 diameters of plain wire rope between the ends of a sling.
define_range("short rope", "plan",
  "The length of a rope is less than 20 diameters. This check omits poles and pipes.",
  "length over diameter", 20, Inf, "",
  function(gear, state) {
    ropes <- Filter(function(rope) !rope$strut, gear_si(gear)$ropes)
    numbers_of_parts(ropes, "rope", function(rope) rope$length / rope$diameter)
  },
  "Check the length and the diameter of the rope, and their units.", "length"
)

# A sphere has 0.83, boards have 0.03 to 0.2.
define_range("body size", "plan",
  "The volume of a body is too large for its area: its ratio of volume^(2/3) to area is above 5. A
  sphere has 0.83.",
  "volume^(2/3) over area", -Inf, 5, "",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$pieces, "piece", function(piece) {
      positive_ratio(piece$volume^(2 / 3), piece$area)
    })
  },
  "Check the mass, the dimensions and their units.", "diameter"
)

# Bodies of shipped and published gears have up to 15 (boards).
define_range("body drag", "plan",
  "The drag area of a body does not fit its volume: its ratio to volume^(2/3) is below 0.05 or above
  60. A sphere has 0.57, boards have up to 15.",
  "drag area over volume^(2/3)", 0.05, 60, "",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$pieces, "piece", function(piece) {
      positive_ratio(piece$drag_area, piece$volume^(2 / 3))
    })
  },
  "Check the mass, the dimensions and their units.", "drag_area"
)

# A solid round bar has 1. Chains with their outer width have 0.04, discs on a thin rope 3.2.
define_range("rope volume", "plan",
  "The volume of a rope is less than 2 % or more than five times that of a round bar of its
  diameter.",
  "volume over that of a round bar", 0.02, 5, "",
  function(gear, state) {
    numbers_of_parts(gear_si(gear)$ropes, "rope", function(rope) {
      positive_ratio(rope$volume_per_length, pi / 4 * rope$diameter^2)
    })
  },
  "Check the diameter, the mass and their units.", "diameter"
)

# Published coefficients across a rope are 0.9 to 2 (strumming cables), along it 0 to 0.1. Turbulent
# friction of a smooth surface, on the circumference, is at least 0.0016 (Re 1e9): 0.005 here.
coefficient_ranges <- list(normal = c(0.3, 3), tangential = c(0.002, 0.3))
for (along in names(coefficient_ranges)) local({
  name <- along
  ends <- coefficient_ranges[[name]]
  define_range(paste(name, "drag coefficient of ropes"), "plan",
    switch(name,
      normal = "The drag coefficient across a rope is below 0.3 or above 3. Published values are 0.9
        to 2.",
      tangential = "The drag coefficient along a rope is above 0.3 or between 0 and 0.002.
        Published values are 0 or 0.005 to 0.1."),
    "drag coefficient", ends[1L], ends[2L], "",
    function(gear, state) {
      numbers_of_parts(gear_si(gear)$ropes, "rope", function(rope) {
        if (isTRUE(rope$coefficients[[name]] != 0)) rope$coefficients[[name]] else NA_real_
      })
    },
    "Check the coefficient and its reference area.", paste0("coefficients.", name), rank = 2L)
})

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

define_range("weight that floats", "plan",
  "A weight, a lead line or a ground gear floats, or a float sinks.",
  "weight in water over mass", 0, Inf, "",
  function(gear, state) {
    si <- gear_si(gear)
    parts <- loaded_parts(si)
    sinking <- function(part) {
      if (!isTRUE(part$mass > 0)) return(NA_real_)
      way <- unname(sinking_roles[first_of(part$role, "")])
      way * (1 - si$water$density * part$volume / part$mass)
    }
    c(numbers_of_parts(parts$pieces, "piece", sinking),
      numbers_of_parts(parts$ropes, "rope", sinking))
  },
  "Check the mass, the volume or the buoyancy, and their units."
)

# Gathered bosoms of footropes have the smallest ratios, 0.35 in shipped gears. A rope can be longer
# than its netting.
define_range("hanging ratio", "plan",
  "The hanging ratio of a rope (its length over the stretched length of its netting) is below 0.25
  or above 1.15.",
  "hanging ratio", 0.25, 1.15, "",
  function(gear, state) {
    si <- gear_si(gear)
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
  },
  "Check the length of the rope and the mesh count along it.", rank = 2L
)

# Returns the ratio of the largest to the smallest number of the panels at each seam.
ratios_at_seams <- function(si, field) {
  numbers_of_parts(si$seams, "seam", function(seam) {
    panels <- unique(sub("[.].*", "", unlist(seam$edges)))
    found <- vapply(si$panels[intersect(panels, names(si$panels))], `[[`, 0, field)
    if (length(found)) max(found) / min(found) else NA_real_
  })
}

# Adjacent panels of shipped and published nets have ratios up to 2.9.
define_range("twines at a seam", "plan",
  "A seam joins netting whose twines differ in diameter by a factor of more than 6. Shipped and
  published nets have factors up to 2.9.",
  "ratio of twine diameters", -Inf, 6, "",
  function(gear, state) ratios_at_seams(gear_si(gear), "twine_diameter"),
  "Check the twine diameters on both sides of the seam."
)

# The walls of trammel nets have ratios of about 5.
define_range("meshes at a seam", "plan",
  "A seam joins netting whose mesh sizes differ by a factor of more than 10. The walls of trammel
  nets have factors of about 5.",
  "ratio of mesh sizes", -Inf, 10, "",
  function(gear, state) ratios_at_seams(gear_si(gear), "mesh_size"),
  "Check the mesh sizes on both sides of the seam."
)

# The shortest distance between the ends of a free rope of shipped and published gears is 57 % of
# its length (tickler chains), except for purse lines, which run through rings.
define_range("slack rope", "state",
  "The ends of a free rope or of a main line, in the plan or the settled state, are closer together
  than half of its length. This check omits ropes that run through rings, ropes that end where they
  start, and moments of a tow.",
  "distance between the ends over the length", 50, Inf, "%",
  function(gear, state) {
    if (!is.null(state$time)) return(numeric())
    free <- Filter(function(rope) {
      is.null(rope$along) && !rope$strut && !length(rope$through) && rope$from != rope$to
    }, state$si$ropes)
    distance <- function(from, to) {
      points <- state$si$points[c(from, to)]
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
  },
  "Shorten the rope, or check the unit of its length.", "length", rank = 2L
)

# The deepest trawl fisheries work at about 2,000 m. Trawl floats are rated to 1,800 m or less.
define_range("depth", "state",
  "The gear is deeper than 3,000 m. The deepest fisheries work at about 2,000 m.",
  "depth", -Inf, 3000, "m",
  function(gear, state) {
    deepest <- which.min(state$position[3, ])
    setNames(-state$position[3, deepest], describe_node(state$mesh, deepest))
  },
  "Check the depth and the lengths of the ropes, and their units."
)

define_range("mouth blockage", "state",
  "The twine covers more than the whole area of the net mouths across the flow: a net is nearly
  closed, or a mouth is not in `nets`.",
  "twine area over mouth area", -Inf, 100, "%",
  function(gear, state) c(netting = 100 * measure_value(state, "mouth_blockage")),
  "Check the spread and the height of the net mouths, and the ropes in `nets`."
)

# Strain (fraction) at which a rope or twine of unknown strength is assumed to break: polyamide and
# polyethylene break at 20 to 25 %.
assumed_breaking_strain <- 0.2

# Trawl warps are chosen for a third to a fifth. Shipped gears have up to 34 %. The largest tension
# of netting at a point load depends on the mesh.
define_range("load", "state",
  "A rope, or the most loaded tenth of a panel's twine, carries more than 40 % of its breaking load
  (from `strength` or its material; if unknown, its load at 20 % elongation).",
  "tension over breaking load", -Inf, 40, "%",
  function(gear, state) {
    parts <- c(state$si$ropes, state$si$panels)
    table <- tension_table(state)
    strength <- vapply(parts[table$part], function(part) {
      if (is.na(part$strength)) assumed_breaking_strain * part$axial_stiffness else part$strength
    }, 0)
    is_rope <- table$kind == "rope"
    load <- 100 * 1000 * ifelse(is_rope, table$max_kN, table$most_loaded_kN) / strength
    names(load) <- paste(ifelse(is_rope, "rope", "panel"), table$part)
    sort(load, decreasing = TRUE)
  },
  "Use a thicker or stronger rope or twine, or find the cause of the high load.",
  c(rope = "diameter", panel = "twine")
)

# Anchors lie on the bed.
define_range("below the anchors", "state",
  "The gear hangs more than 1 m below its deepest anchor, thus below the sea bed.",
  "depth below the anchors", -Inf, 1, "m",
  function(gear, state) {
    moored <- state$si$ropes[ropes_of_role(state$si, c("mooring", "anchor_line"))]
    held <- Filter(function(point) identical(point$held, "fixed"), state$si$points)
    anchors <- held[intersect(names(held), unlist(lapply(moored, `[`, c("from", "to"))))]
    if (!length(anchors)) return(numeric())
    deepest <- which.min(state$position[3L, ])
    depth <- min(vapply(anchors, function(point) point$position[3L], 0)) -
      state$position[3L, deepest]
    setNames(depth, describe_node(state$mesh, deepest))
  },
  "Check the depth and the lengths of the ropes, and their units."
)

# A wave may lift a float by half a metre.
define_range("out of the water", "state",
  "Nodes of the gear are more than 0.5 m above the water surface. Ropes that end at a point above
  the water are ignored.",
  "height above the surface", -Inf, 0.5, "m",
  function(gear, state) {
    mesh <- state$mesh
    up <- Filter(function(point) isTRUE(point$position[3L] > 0), state$si$points)
    held <- mesh$points[names(up)]
    led <- lapply(mesh$ropes, function(rope) if (any(held %in% rope$node)) rope$node)
    height <- replace(state$position[3L, ], c(held, unlist(led)), -Inf)
    highest <- which.max(height)
    setNames(height[highest], describe_node(mesh, highest))
  },
  "Check the lift of the gear and the length of the warps, or set `water.free_surface`."
)

define_range("bundle", "state",
  "A net hangs as a bundle: its `enclosed_volume` is less than 1 % of a cylinder of the same depth
  whose circumference is the rope's length. This check omits moments of a tow.",
  "volume over that of an open cylinder", 1, Inf, "%",
  function(gear, state) {
    if (!is.null(state$time)) return(numeric())
    asked <- Filter(function(one) identical(one$kind, "enclosed_volume"), state$si$measures)
    numbers_of_parts(setNames(asked, vapply(asked, `[[`, "", "rope")), "rope", function(measure) {
      depth <- -min(state$position[3L, state$mesh$ropes[[measure$rope]]$node])
      open <- state$si$ropes[[measure$rope]]$length^2 / (4 * pi) * depth
      100 * measure_values(state, list(measure)) / open
    })
  },
  "Shape and volume at rest are meaningless: simulate the operation with tow()."
)

define_range("cells finer than meshes", "state",
  "The elements of a panel of `cells` are smaller than half a mesh of the netting. Cells represent
  many meshes each; use `netting: bars` if the meshes are as large as the elements. On the shipped
  midwater trawl, with 32 m front meshes, cells give 3.6 % less drag than bars at any resolution.
  With 0.8 meshes in a cell, drag differs by up to 2.4 % (examples of a dredge and a trammel net).",
  "number of meshes in a cell", 0.5, Inf, "",
  function(gear, state) {
    si <- state$si
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
  },
  "Model this netting mesh by mesh (netting: bars).", rank = 3L
)
