# Words of net makers that are no fields of a plan: how a plan says them instead, or that it cannot.
# An unknown field whose name holds one of these words is answered with its advice.

plan_advice <- c(
  "lifting_?bag|strengthening|chafer|chafing|second_layer|double_codend|cow_?hide" =
    "netting over a section is said by its `covers`.",
  "bobbin|rockhopper|rock_hopper|roller|cookie|disc" =
    "they are said by `discs` of the `ground_gear`, by number or spacing, diameter and width.",
  "round_?strap|strap|girdle" =
    "ropes around the net are said by `cross_ropes`, one behind each section.",
  "lastridge|selvedge_rope|rib_?line|laceage" = "ropes along the seams are said by `belly_lines`.",
  "grid|grate" = "a sorting grid is said by `grids`, with the section behind which it is.",
  "window|square_mesh_panel" =
    "cut the section in two, and give the `back` of one its own `orientation` and mesh size.",
  "gusset|gore|wedge" = paste(
    "a plan of this kind cannot say it: `codend expand` gives the assembly, where a panel with",
    "`upper` or `lower` of 0 meshes is one."
  ),
  "flapper|liner|separator" =
    "netting within the net cannot be said; as `covers` it has its weight and drag.",
  "dropper|toggle" =
    "a plan cannot say it: the ground gear is on the same edge of netting as the footrope.",
  "danleno|butterfly|dan_leno|delta_?plate|triangle" =
    "danlenos, butterflies and delta plates are described by `danlenos`: their mass and drag.",
  "set_?back|settings|adjust" =
    "what sets a wing end back is described by the `setback` of its bridle.",
  "(wing|toe|clump)_?(end_?)?(weight|chain|clump)" =
    "weights at the lower wing ends are described by `wing_end_weights`.",
  "half_?mesh" = "half meshes are written as counts such as 60.5."
)

# Advice on an unknown field, or NULL.
advice_on <- function(name) {
  found <- which(vapply(names(plan_advice), grepl, NA, x = tolower(name), perl = TRUE))
  if (length(found)) plan_advice[[found[1L]]]
}
