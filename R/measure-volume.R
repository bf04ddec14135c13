# Volumes that netting encloses.

define_measure("volume", "m3",
  "Volume within panels that follow each other around an opening, such as a cage's walls and bottom,
  closed by a lid from the rim of the opening to its middle.",
  sensor = "Depth sensors around the bottom ring of a cage, or cameras, show it in part.",
  asks_panels
)

define_measure("volume_share", "%",
  "The volume within panels as a share of a volume `of`.",
  sensor = "As that of the volume.",
  asks_share
)

define_measure("enclosed_volume", "m3",
  "Volume of water that netting hanging from the surface encloses, down to a surface from a rope,
  such as the lead line, to that rope's middle. A gap between the two ends of the net is closed by
  an upright wall. Without netting it is not a number.",
  asks_rope
)
