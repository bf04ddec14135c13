# The form of the flume tank: every field that a plan gives, in the order of a net drawing, and what
# may be added to it. All of it is made from the schema.

# The form's groups: their titles, and the fields of a plan's first level that each holds.
form_rooms <- list(
  Netting = c(
    "panels", "wings", "square", "sections", "wall", "bottom", "shape", "diameter", "depth",
    "length", "mouth", "selvedges", "seams", "grids", "catch"
  ),
  Ropes = c(
    "head_line", "head_line_extensions", "footrope", "footrope_extensions", "side_lines",
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
    "warps", "warp", "sweeps", "bridles", "hand_ropes", "moorings", "end_lines", "end_ropes",
    "lift_line", "anchor_line", "anchor_depth", "rings", "purse_wire", "davit_height", "points",
    "vessel", "vessels"
  ),
  `Tow and water` = c("towing", "tow", "water", "seabed", "shooting", "pursing", "laying",
    "hauling", "laid"),
  `Name and method` = c(
    "name", "materials", "method", "netting", "coefficients", "netting_drag", "slack_twine",
    "shielding", "multipliers", "measures"
  )
)

# Fields of a plan that the form leaves to the plan's text.
form_leaves <- c("codend", "kind", "notes", "sources", "uncertain")

# The form of a plan: a list of groups of list(title, words (the title as the page says it), parts,
# open, absent), a part list(path, title, help, fields (controls), picks, open (whether the schema
# allows fields that it lacks), absent (their paths), named (whether it is one of several that are
# told by their names), required).
plan_form <- function(plan, say = new_say()) {
  node <- plan_node(plan)
  lapply(names(form_rooms), function(title) {
    names <- intersect(names(plan), form_rooms[[title]])
    single <- Filter(function(name) !is_part(plan[[name]]), names)
    fields <- form_fields(plan[single], node, "", "", say)
    own <- if (length(fields)) list(list(path = "", title = title, fields = fields))
    parts <- lapply(setdiff(names, single), function(name) {
      form_parts(plan[[name]], child_node(node, name), name, name %in% node$required, say = say)
    })
    absent <- setdiff(intersect(form_rooms[[title]], names(node$properties)), names(plan))
    list(
      title = title, words = say(paste0("room.", title)),
      parts = unname(c(own, do.call(c, parts))), open = length(absent) > 0L, absent = I(absent)
    )
  })
}

# A map whose fields have paths; a name with a point in it would be two steps of one.
is_part <- function(value) {
  is_map(value) && length(value) > 0L && !any(grepl(".", names(value), fixed = TRUE))
}

# A map's part, and those of the maps in it that have parts or fields of their own.
form_parts <- function(value, node, path, required, is_named = FALSE, say) {
  node <- meant_node(value, node)
  if (is.null(node)) return(list())
  named <- !is.null(node$additionalProperties)
  steps <- length(path_steps(path))
  inner <- Filter(is_part, value)
  apart <- if (steps == 1L) names(inner) else character()
  fields <- form_fields(value[setdiff(names(value), apart)], node, path, "", say)
  part <- list(list(
    path = path, title = said_path(say, path), help = first_of(node$description, ""),
    fields = fields,
    picks = part_picks(value, node, path),
    absent = I(as.character(absent_fields(value, node, path))),
    open = length(setdiff(names(node$properties), names(value))) > 0L,
    named = is_named, required = required
  ))
  others <- lapply(apart, function(name) {
    form_parts(value[[name]], child_node(node, name), join(path, name), name %in% node$required,
      named && is.null(node$properties[[name]]), say)
  })
  c(part, do.call(c, others))
}

# Paths of the fields that a part and the maps in it could have and have not.
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

# What of a part can be picked from the catalogue, its twine as well: list(path, classes).
part_picks <- function(value, node, path) {
  nodes <- list(node, if (is_map(value$twine)) meant_node(value$twine, child_node(node, "twine")))
  picks <- Map(function(node, path) {
    classes <- picked_classes(node)
    if (length(classes)) list(path = path, classes = I(classes))
  }, nodes, c(path, join(path, "twine")))
  Filter(Negate(is.null), picks)
}

# The controls of a map's fields; those of maps in it by both their names.
form_fields <- function(value, node, path, ahead, say) {
  found <- lapply(names(value), function(name) {
    at <- join(path, name)
    inner <- meant_node(value[[name]], child_node(node, name))
    label <- paste0(ahead, said_field(say, name))
    if (is.null(inner)) return(NULL)
    if (is_part(value[[name]])) {
      return(form_fields(value[[name]], inner, at, paste0(label, ": "), say))
    }
    field <- list(node = inner, value = value[[name]])
    list(new_control(capital(label), at, field, name %in% node$required))
  })
  do.call(c, found)
}

# Controls of the fields that a part of a plan (of a group, where `path` is empty) could have and
# has not; their values are what holds without them, where the schema says so.
form_offers <- function(plan, path, title, say = new_say()) {
  node <- plan_node(plan)
  given <- plan
  if (nzchar(path)) {
    field <- plan_field(plan, path)
    if (is.null(field$node)) abort_argument("The plan has no {.val {path}}.")
    node <- field$node
    given <- field$value
  }
  absent <- setdiff(names(node$properties), names(given))
  if (!nzchar(path)) absent <- intersect(form_rooms[[title]], absent)
  lapply(setdiff(absent, form_leaves), function(name) {
    inner <- node$properties[[name]]
    # of several ways to write it a number is the one that is changed most
    if (identical(inner$shape, "any")) {
      number <- Filter(is_number_node, inner$choices)
      if (length(number)) inner <- utils::modifyList(number[[1]], inner["description"])
    }
    plain <- is.atomic(inner$default) && length(inner$default) == 1L
    new_control(
      capital(said_field(say, name)), join(path, name),
      list(node = inner, value = if (plain) inner$default), FALSE
    )
  })
}

# What a page is sent to lay out its controls. turn: of the gear that was opened last.
form_message <- function(plan, marked, turn, say = new_say()) {
  list(
    turn = turn, kind = first_of(plan$kind, "assembly"),
    quick = plan_controls(plan, marked, say),
    groups = plan_form(plan, say), units = offered_units()
  )
}
