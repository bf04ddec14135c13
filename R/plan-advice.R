# Terms of net makers that are not plan fields, with advice: the field to use, or the reason why
# plans do not support the part. An error about an unknown field includes the advice for its name.

plan_advice <- c(
  "lifting_?bag|strengthening|chafer|chafing|second_layer|double_codend|cow_?hide" =
    "use `covers` of a section for netting over it.",
  "bobbin|rockhopper|rock_hopper|roller|cookie|disc" =
    "use `discs` of the `ground_gear`, with number or spacing, diameter and width.",
  "round_?strap|strap|girdle" =
    "use `cross_ropes` for ropes around the net (one per section).",
  "lastridge|selvedge_rope|rib_?line|laceage" = "use `belly_lines` for ropes along the seams.",
  "grid|grate" = "use `grids` for a sorting grid, and name the section ahead of the grid.",
  "window|square_mesh_panel" =
    "cut the section in two, and give the `back` of one part its own `orientation` and mesh size.",
  "gusset|gore|wedge" = paste(
    "plans of this kind have no gussets. Use `codend expand` to get the assembly, and add a panel",
    "with 0 meshes at `upper` or `lower`."
  ),
  "flapper|liner|separator" =
    "codend does not model netting inside the net. Use `covers` for its weight and drag.",
  "dropper|toggle" =
    "codend does not model dropper chains: the ground gear is attached directly to the footrope.",
  "danleno|butterfly|dan_leno|delta_?plate|triangle" =
    "use `danlenos` for the mass and drag of danlenos, butterflies and delta plates.",
  "set_?back|settings|adjust" =
    "use `setback` of a bridle for the setback of its wing end.",
  "(wing|toe|clump)_?(end_?)?(weight|chain|clump)" =
    "use `wing_end_weights` for weights at the lower wing ends.",
  "half_?mesh" = "write half meshes as counts such as 60.5."
)

# Returns the advice on an unknown field, or NULL.
advice_on <- function(name) {
  found <- which(vapply(names(plan_advice), grepl, NA, x = tolower(name), perl = TRUE))
  if (length(found)) plan_advice[[found[1L]]]
}
