# Measures of shape that a plan may ask for.

define_measure("spread", "m",
  "Horizontal distance between two places, as an acoustic sensor reports it, or the mean over
  several pairs. In a straight tow that is the distance across it; in a turn, where one door runs
  ahead of the other, it stays that of the doors from each other.",
  sensor = "Acoustic sensors on both doors or wing ends report the slant distance between them from
  where they are fastened, which is some decimetres from the place named here; it wavers as the
  doors swing.",
  asks_pairs
)

define_measure("height", "m",
  "Height of the first place above the second, negative where it lies below. The height of a net's
  mouth is that of the head line's centre above the footrope's.",
  sensor = "A trawl eye or scanner on the head line reports the distance straight down to the
  footrope, or to the sea bed where its beam meets that first.",
  asks_pair
)

define_measure("length", "m", "Straight distance between two places.",
  asks_pair
)

define_measure("depth", "m", "Depth of a place below the water surface, or the mean over several.",
  sensor = "A pressure sensor, its zero set at the surface.",
  asks_places
)

define_measure("sinking_speed", "m/s", "Downward speed of a place; 0 in a settled state.",
  sensor = "The change of a depth sensor's reading in time.",
  asks_place
)

define_measure("clearance", "m", "Height of a place above the sea bed, across it.",
  sensor = "A height sensor on the head line, looking down; it is the distance to the first echo,
  which may be the footrope.",
  asks_place_over_ground
)

define_measure("area", "m2",
  "Area enclosed by ropes end to end, seen level and from right ahead of them: along x in a straight
  tow, along the net's own heading in a turn. A gap between two ropes is closed by a straight
  line.",
  sensor = "A scanning sonar on the head line shows the outline; from height and spread alone it is
  mostly overestimated, as the outline is no rectangle.",
  asks_ropes
)

define_measure("enclosed_area", "m2",
  "Area enclosed by ropes end to end, seen from above, such as the ground between the ropes of a
  demersal seine. A gap between two ropes is closed by a straight line.",
  sensor = "The vessel's track while it lays the ropes, at the start of a haul alone.",
  asks_ropes
)

define_measure("ground_speed", "m/s", "Speed of a place over the ground, along the level.",
  sensor = "The positions of an acoustic sensor on the net in time.",
  asks_place
)

define_measure("angle", "deg",
  "Direction of a rope's bar at a place, from start to end: below the horizontal (declination,
  negative when it rises) or, in plan view, out of the vessel's centre line (divergence, 0 to 180),
  in a turn too.",
  sensor = "Declination: an inclinometer on the warp near the block, which the warp's own weight
  makes steeper than farther down. Divergence: the distance of the warps apart at the blocks and a
  metre or two behind them.",
  asks_rope_angle
)
