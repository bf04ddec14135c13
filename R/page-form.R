# The form of the flume tank, generated from the schema: the fields of a plan in the order of a net
# drawing, and fields that can be added.

# The top-level plan fields in each group of the form, by title.
form_sections <- list(
  Netting = c(
    "panels", "net", "separators", "wings", "square", "sections", "wall", "bottom", "shape",
    "diameter", "depth", "length", "mouth", "selvedges", "seams", "grids", "catch"
  ),
  Ropes = c(
    "headline", "headline_extensions", "footrope", "footrope_extensions", "side_lines",
    "belly_lines", "cross_ropes", "float_line", "lead_line", "collar", "frame", "bottom_rope",
    "side_ropes", "ropes",
    "main_line", "branch_lines", "float_lines", "shortening_ratio", "baskets", "hooks"
  ),
  Floats = c("floats", "canvas", "kites", "pieces"),
  `Ground gear and weights` = c(
    "ground_gear", "ticklers", "weights", "sinkers", "hammers", "danlenos",
    "wing_end_weights", "centre_weight", "anchors"
  ),
  `Boards and beams` = c(
    "otter_boards", "backstrops", "towing_points", "beam", "shoes", "upper_beam", "lower_beam"
  ),
  Rig = c(
    "gears", "warps", "lower_warps", "warp", "sweeps", "bridles", "hand_ropes", "moorings",
    "end_lines", "end_ropes", "lift_line", "anchor_line", "anchor_depth", "rings", "purse_wire",
    "davit_height", "points", "vessel", "vessels"
  ),
  `Tow and water` = c("towing", "tow", "water", "seabed", "shooting", "pursing", "laying",
    "hauling", "laid"),
  `Name and method` = c(
    "name", "materials", "method", "netting", "coefficients", "netting_drag", "slack_twine",
    "shielding", "multipliers", "nets", "measures"
  )
)

# Users edit these fields in the plan text.
form_leaves <- c("codend", "kind", "notes", "sources", "uncertain")

# Returns a list of groups, each list(title, parts, open, absent). A part is list(path, help, fields
# (controls), picks, absent, open, named, required). `absent` lists fields that can be added; `open`
# is TRUE if there are any. `named` parts have names from the plan.
plan_form <- function(plan) {
  node <- plan_node(plan)
  lapply(names(form_sections), function(title) {
    names <- intersect(names(plan), form_sections[[title]])
    single <- Filter(function(name) !is_part(plan[[name]]), names)
    fields <- form_fields(plan[single], node, "")
    own <- if (length(fields)) list(list(path = "", fields = fields))
    parts <- lapply(setdiff(names, single), function(name) {
      form_parts(plan[[name]], child_node(node, name), name, name %in% node$required)
    })
    absent <- setdiff(intersect(form_sections[[title]], names(node$properties)), names(plan))
    list(
      title = title, parts = unname(c(own, do.call(c, parts))), open = length(absent) > 0L,
      absent = I(absent)
    )
  })
}

# A field name with a point would be two steps of a path.
is_part <- function(value) {
  is_map(value) && length(value) > 0L && !any(grepl(".", names(value), fixed = TRUE))
}

# Maps within a top-level map, and within a gear of a rig, are parts of their own. Fields of deeper
# maps belong to their part.
form_parts <- function(value, node, path, required, is_named = FALSE) {
  node <- meant_node(value, node)
  if (is.null(node)) return(list())
  named <- !is.null(node$additionalProperties)
  steps <- length(path_steps(path))
  inner <- Filter(is_part, value)
  apart <- if (steps == 1L || steps == 2L && startsWith(path, "gears.")) names(inner)
  part <- list(list(
    path = path, help = first_of(schema_description(node$description), ""),
    fields = form_fields(value[setdiff(names(value), apart)], node, path),
    picks = part_picks(value, node, path),
    absent = I(as.character(absent_fields(value, node, path))),
    open = length(setdiff(names(node$properties), names(value))) > 0L,
    named = is_named, required = required
  ))
  others <- lapply(apart, function(name) {
    form_parts(value[[name]], child_node(node, name), join(path, name), name %in% node$required,
      named && is.null(node$properties[[name]]))
  })
  c(part, do.call(c, others))
}

# Returns the paths of fields that can be added to a part and to the maps in it.
absent_fields <- function(value, node, path) {
  own <- setdiff(names(node$properties), names(value))
  if (length(own)) own <- paste0(join(path, ""), own)
  inner <- Filter(function(name) is_part(value[[name]]) && name %in% names(node$properties),
    names(value))
  c(own, unlist(lapply(inner, function(name) {
    absent_fields(value[[name]], meant_node(value[[name]], child_node(node, name)),
      join(path, name))
  })))
}

# Returns list(path, classes) if the catalogue has rows for a part or its twine.
part_picks <- function(value, node, path) {
  nodes <- list(node, if (is_map(value$twine)) meant_node(value$twine, child_node(node, "twine")))
  picks <- Map(function(node, path) {
    classes <- picked_classes(node)
    if (length(classes)) list(path = path, classes = I(classes))
  }, nodes, c(path, join(path, "twine")))
  Filter(Negate(is.null), picks)
}

form_fields <- function(value, node, path) {
  found <- lapply(names(value), function(name) {
    at <- join(path, name)
    inner <- meant_node(value[[name]], child_node(node, name))
    if (is.null(inner)) return(NULL)
    if (is_part(value[[name]])) return(form_fields(value[[name]], inner, at))
    list(new_control(at, list(node = inner, value = value[[name]]), name %in% node$required))
  })
  do.call(c, found)
}

# Returns controls for fields that can be added to a part, or to the group `title` if `path` is
# empty. Their values are defaults of the schema.
form_offers <- function(plan, path, title) {
  node <- plan_node(plan)
  given <- plan
  if (nzchar(path)) {
    field <- plan_field(plan, path)
    if (is.null(field$node)) abort_argument("The plan has no field {.val {path}}.")
    node <- field$node
    given <- field$value
  }
  absent <- setdiff(names(node$properties), names(given))
  if (!nzchar(path)) absent <- intersect(form_sections[[title]], absent)
  lapply(setdiff(absent, form_leaves), function(name) {
    inner <- node$properties[[name]]
    # if a field accepts several types, offer the number, which users change most
    if (identical(inner$shape, "any")) {
      number <- Filter(is_number_node, inner$choices)
      if (length(number)) inner <- utils::modifyList(number[[1]], inner["description"])
    }
    plain <- is.atomic(inner$default) && length(inner$default) == 1L
    new_control(join(path, name), list(node = inner, value = if (plain) inner$default), FALSE)
  })
}

# Returns the data from which a page builds its controls. turn: number of the last opened gear.
form_message <- function(plan, marked, turn) {
  list(
    turn = turn, kind = first_of(plan$kind, "assembly"), quick = plan_controls(plan, marked),
    groups = plan_form(plan)
  )
}

# Returns the catalogue classes that fit a part, from the fields in its schema.
picked_classes <- function(node) {
  has <- function(...) all(c(...) %in% names(node$properties))
  if (has("lift_coefficient", "area", "mass")) return("board")
  if (has("buoyancy", "diameter")) return("float")
  if (has("rtex")) return("twine")
  if (has("mass_per_length", "material", "strength")) return(c("rope", "wire", "chain"))
  character()
}
