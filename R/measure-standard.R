# The standard measures: those that every gear has where they apply, in the order in which they are
# told. A new one is a new entry here.

# kind: its name without the unit; unit: in which it is shown; sensor: as define_measure() has it;
# computed: the engine's name for it.
standard_measure <- function(kind, unit, definition, sensor = NA_character_, computed = kind) {
  entry <- list(
    kind = kind, unit = unit, definition = one_line(definition), sensor = one_line(sensor),
    computed = computed
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
    measure."
  ),
  standard_measure("tow_power", "kW",
    "Of a towed gear, its total drag times the towing speed."
  ),
  standard_measure("filtered_volume", "m3/h",
    "Of a towed gear with an area `mouth_area` among its measures, the water that flows through the
    ropes around it: that area times the water's speed, past the ropes as they move and at their
    mean depth, across it.",
    sensor = "A flow sensor in the mouth, times the area: it also sees how the net slows the water
    there, which is not counted here."
  ),
  standard_measure("swept_area", "km2/h",
    "Of a towed gear with a spread `wing_end_spread` among its measures, the ground that the lines
    between the wing ends pass over: that spread times their speed over the ground across them, the
    mean over its pairs.",
    sensor = "The spread of wing ends times the speed over the ground by satellite; with that of the
    doors it would be larger."
  ),
  standard_measure("mouth_blockage", "%",
    "Of a gear with an area `mouth_area` among its measures, the area across the flow that all twine
    hides, over that area: twine behind other twine counts once."
  ),
  standard_measure("engine_power", "kW",
    "With a `vessel`, the power that its engine gives to tow the gear at this speed: full power
    times the share of the pull there that the gear takes, to the power 3/2. Above full power the
    vessel cannot tow it so fast.",
    sensor = "A torque meter on the shaft, with the losses between engine and shaft."
  ),
  standard_measure("pull_used", "%",
    "With a `vessel`, the total drag over what it can pull at this speed.",
    sensor = "The engine's load, by the power that it stands for."
  ),
  standard_measure("fuel_rate", "l/h",
    "With a `vessel` whose fuel consumption is given, the fuel that towing takes in an hour.",
    sensor = "A flow meter in the fuel line, less what generators take."
  ),
  standard_measure("fuel_per_swept_area", "l/km2",
    "That fuel over the ground that the lines between the wing ends pass over."
  ),
  standard_measure("fuel_per_filtered_volume", "l/Mm3",
    "That fuel over the water that flows through the mouth, in millions of cubic metres."
  ),
  standard_measure("fuel_per_catch", "l/t",
    "That fuel over the catch, where the `vessel` says how much is caught in an hour.",
    computed = "fuel_per_yield"
  ),
  standard_measure("catch_volume", "m3",
    "With a catch in netting, the volume that the netting behind its front encloses.",
    computed = "bag_volume"
  ),
  standard_measure("catch_surface", "m2",
    "With a catch in netting, the area of the netting behind its front.",
    computed = "bag_surface"
  ),
  standard_measure("catch_front", "meshes",
    "With a catch in netting, how many meshes deep the netting is that its front encloses.",
    sensor = "Catch sensors, each at a count of meshes from the codline, which report when the
    netting there is stretched across.",
    computed = "bag_front"
  ),
  standard_measure("largest_rope_tension", "kN",
    "The largest tension in any rope.",
    sensor = "A load cell, where it sits in that rope."
  ),
  standard_measure("largest_panel_twine_tension", "N",
    "Of the panel whose twine is loaded most, the mean tension of one twine (of both when double)
    over all of its length of twine. A panel is the plan's, so that this closes in on a value as the
    netting is divided further; what pulls at a single mesh, such as at the tip of a wing, it does
    not include."
  ),
  standard_measure("most_loaded_twine_tension", "N",
    "Mean tension of one twine (of both when double) over the tenth of the netting's length of twine
    that is loaded most. Tension runs along few twines from the tips of wings and corners; what the
    single mesh there carries grows as the netting is divided further, this converges."
  ),
  standard_measure("slack_netting", "%",
    "Share of the netting's length of twine that carries no tension."
  ),
  standard_measure("rope_on_ground", "m",
    "With a sea bed, the length of rope, not of poles, that lies on it.",
    sensor = "A bottom contact sensor reports whether its place lies on the ground; bright links and
    shackles show how far."
  ),
  standard_measure("ground_load", "kN",
    "With a sea bed, what the gear presses on it with."
  ),
  standard_measure("ground_friction", "%",
    "With a sea bed, the share of its friction in the total drag."
  ),
  standard_measure("least_depth", "m",
    "Depth of the highest node of the gear.",
    sensor = "A pressure sensor there."
  ),
  standard_measure("greatest_depth", "m",
    "Depth of the lowest node of the gear.",
    sensor = "A pressure sensor there."
  )
)

has_towing <- function(state) state$si$towing$speed != 0
