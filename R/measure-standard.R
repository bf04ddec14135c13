# The standard measures: those that every gear has where they apply, in the order in which they are
# told. A new one is a new entry here.

# The sums over a whole gear that several measures take, each made once and only if it is asked for.
measured_once <- function(state) {
  delayedAssign("drag", total_drag(state))
  delayedAssign("lines", measured_lines(state))
  delayedAssign("ground", ground_forces(state))
  environment()
}

# State lines, those of ropes and those of netting: list(ropes, netting).
measured_lines <- function(state) {
  lines <- state_lines(state)
  netting <- state$lattice$parts$kind[lines$part] == "netting"
  some <- function(which) list2DF(lapply(lines, `[`, which))
  list(ropes = some(!netting), netting = some(netting))
}

# kind: its name without the unit; unit: in which it is shown; value(state, found): the measure, SI,
# or NULL where it does not apply, where `found` is as measured_once() gives it; sensor: as
# define_measure() has it.
standard_measure <- function(kind, unit, definition, value, sensor = NA_character_) {
  entry <- list(
    kind = kind, unit = unit, definition = one_line(definition), sensor = one_line(sensor),
    value = value
  )
  setNames(list(entry), kind)
}

standard_measures <- c(
  standard_measure("total_drag", "kN",
    "Pull of all supports on the gear against the flow. The flow runs along x past a towed gear,
    which is along the vessel's course, in a turn too; else along the fastest current, else along
    x.",
    sensor = "Load cells in all warps, each reading times the cosines of the warp's declination and
    divergence at the block; the flow is that past the gear, which a log on the vessel does not
    tell.",
    function(state, found) found$drag
  ),
  standard_measure("tow_power", "kW",
    "Of a towed gear, its total drag times the towing speed.",
    function(state, found) if (has_towing(state)) found$drag * state$si$towing$speed
  ),
  standard_measure("filtered_volume", "m3/h",
    "Of a towed gear with an area `mouth_area` among its measures, the water that flows through the
    ropes around it: that area times the water's speed, past the ropes as they move and at their
    mean depth, across it.",
    sensor = "A flow sensor in the mouth, times the area: it also sees how the net slows the water
    there, which is not counted here.",
    function(state, found) filtered_volume(state)
  ),
  standard_measure("swept_area", "km2/h",
    "Of a towed gear with a spread `wing_end_spread` among its measures, the ground that the lines
    between the wing ends pass over: that spread times their speed over the ground across them, the
    mean over its pairs.",
    sensor = "The spread of wing ends times the speed over the ground by satellite; with that of the
    doors it would be larger.",
    function(state, found) swept_area(state)
  ),
  standard_measure("mouth_blockage", "%",
    "Of a gear with an area `mouth_area` among its measures, the area across the flow that all twine
    hides, over that area: twine behind other twine counts once.",
    function(state, found) {
      mouth <- state$si$measures$mouth_area
      if (identical(mouth$kind, "area") && length(state$si$panels)) {
        twine_shadow(state) / measure_kinds$area$value(state, mouth)
      }
    }
  ),
  standard_measure("engine_power", "kW",
    "With a `vessel`, the power that its engine gives to tow the gear at this speed: full power
    times the share of the pull there that the gear takes, to the power 3/2. Above full power the
    vessel cannot tow it so fast.",
    sensor = "A torque meter on the shaft, with the losses between engine and shaft.",
    function(state, found) engine_need(state, found$drag)$power
  ),
  standard_measure("pull_used", "%",
    "With a `vessel`, the total drag over what it can pull at this speed.",
    sensor = "The engine's load, by the power that it stands for.",
    function(state, found) engine_need(state, found$drag)$pull_share
  ),
  standard_measure("fuel_rate", "l/h",
    "With a `vessel` whose fuel consumption is given, the fuel that towing takes in an hour.",
    sensor = "A flow meter in the fuel line, less what generators take.",
    function(state, found) engine_need(state, found$drag)$fuel
  ),
  standard_measure("fuel_per_swept_area", "l/km2",
    "That fuel over the ground that the lines between the wing ends pass over.",
    function(state, found) per(engine_need(state, found$drag)$fuel, swept_area(state))
  ),
  standard_measure("fuel_per_filtered_volume", "l/Mm3",
    "That fuel over the water that flows through the mouth, in millions of cubic metres.",
    function(state, found) per(engine_need(state, found$drag)$fuel, filtered_volume(state))
  ),
  standard_measure("fuel_per_catch", "l/t",
    "That fuel over the catch, where the `vessel` says how much is caught in an hour.",
    function(state, found) {
      per(engine_need(state, found$drag)$fuel, state$si$vessel$catch_per_hour / 3600)
    }
  ),
  standard_measure("catch_volume", "m3",
    "With a catch in netting, the volume that the netting behind its front encloses.",
    function(state, found) {
      if (!is.null(state$si$catch)) catch_volume(state$lattice, state$position)
    }
  ),
  standard_measure("catch_surface", "m2",
    "With a catch in netting, the area of the netting behind its front.",
    function(state, found) {
      if (!is.null(state$si$catch)) catch_surface(state$lattice, state$position)
    }
  ),
  standard_measure("catch_front", "meshes",
    "With a catch in netting, how many meshes deep the netting is that its front encloses.",
    sensor = "Catch sensors, each at a count of meshes from the codline, which tell when the netting
    there is stretched across.",
    function(state, found) if (!is.null(state$si$catch)) state$lattice$catch$blocked
  ),
  standard_measure("largest_rope_tension", "kN",
    "The largest tension in any rope.",
    sensor = "A load cell, where it sits in that rope.",
    function(state, found) {
      if (nrow(found$lines$ropes)) max(end_tensions(state, found$lines$ropes$element))
    }
  ),
  standard_measure("largest_panel_twine_tension", "N",
    "Of the panel whose twine is loaded most, the mean tension of one twine (of both when double)
    over all of its length of twine. A panel is the plan's, so that this closes in on a value as the
    netting is divided further; what pulls at a single mesh, such as at the tip of a wing, it does
    not tell.",
    function(state, found) {
      twine <- found$lines$netting
      if (nrow(twine)) max(mean_by_part(twine$tension, twine$lines * twine$rest, twine$part))
    }
  ),
  standard_measure("most_loaded_twine_tension", "N",
    "Mean tension of one twine (of both when double) over the tenth of the netting's length of twine
    that is loaded most. Tension runs along few twines from the tips of wings and corners; what the
    single mesh there carries grows as the netting is divided further, this converges.",
    function(state, found) {
      twine <- found$lines$netting
      if (nrow(twine)) most_loaded_tension(twine$tension, twine$lines * twine$rest)
    }
  ),
  standard_measure("slack_netting", "%",
    "Share of the netting's length of twine that carries no tension.",
    function(state, found) {
      twine <- found$lines$netting
      long <- twine$lines * twine$rest
      if (nrow(twine)) sum(long[twine$tension == 0]) / sum(long)
    }
  ),
  standard_measure("rope_on_ground", "m",
    "With a sea bed, the length of rope, not of poles, that lies on it.",
    sensor = "A bottom contact sensor tells whether its place lies on the ground; bright links and
    shackles tell how far.",
    function(state, found) if (has_ground(state)) found$ground$length
  ),
  standard_measure("ground_load", "kN",
    "With a sea bed, what the gear presses on it with.",
    function(state, found) if (has_ground(state)) found$ground$normal
  ),
  standard_measure("ground_friction", "%",
    "With a sea bed, the share of its friction in the total drag.",
    function(state, found) {
      # gear at rest in still water has no drag
      if (has_ground(state) && found$drag != 0) found$ground$along_flow / found$drag
    }
  ),
  standard_measure("least_depth", "m",
    "Depth of the highest node of the gear.",
    sensor = "A pressure sensor there.",
    # adding 0 turns the -0 of a node at the surface into 0
    function(state, found) -max(state$position[3, ]) + 0
  ),
  standard_measure("greatest_depth", "m",
    "Depth of the lowest node of the gear.",
    sensor = "A pressure sensor there.",
    function(state, found) -min(state$position[3, ]) + 0
  )
)

# Whether a gear's drag is negligible next to its weights in water. found: of measured_once().
is_drag_light <- function(state, found) {
  abs(found$drag) < light_drag * sum(abs(state$lattice$engine$load))
}

has_towing <- function(state) state$si$towing$speed != 0

has_ground <- function(state) !is.null(state$si$ground)

# N.
total_drag <- function(state) {
  -sum(rowSums(support_forces(state)) * flow_axes(state$si)[, "flow"])
}

# Water (m3/s) that flows horizontally through the ropes around a towed gear's mouth, end to end, as
# they move; NULL of other gears.
filtered_volume <- function(state) {
  mouth <- state$si$measures$mouth_area
  if (!has_towing(state) || !identical(mouth$kind, "area")) return()
  ropes <- mouth$ropes
  node <- unique(unlist(lapply(ropes, function(rope) state$lattice$ropes[[rope]]$node)))
  outline <- rope_outline(state, ropes)
  past <- water_velocity(state, -mean(outline[3, ])) -
    rowMeans(state$velocity[1:2, node, drop = FALSE])
  abs(sum(outline_area(outline) * past))
}

# Ground (m2/s) that the straight line between a towed gear's wing ends passes over, the mean over
# their pairs; NULL of gears without.
swept_area <- function(state) {
  wings <- state$si$measures$wing_end_spread
  if (!has_towing(state) || !identical(wings$kind, "spread")) return()
  # the vessel goes towards -x
  over_ground <- state$velocity - c(state$si$towing$speed, 0, 0)
  mean(vapply(wings$pairs, function(pair) {
    across <- apart(state, pair)
    ends <- vapply(pair, state$lattice$place, 0L)
    v <- rowMeans(over_ground[, ends])
    abs(across[1] * v[2] - across[2] * v[1])
  }, 0))
}
