# The fields of a plan that studies and the flume tank begin with: those that people change first.

# Usual fields of short forms: paths with their labels, in the order shown.
usual_fields <- c(
  towing.speed = "Towing speed", water.current.speed = "Current",
  warps.length = "Warp out", otter_boards.area = "Otter board area",
  otter_boards.chord = "Otter board chord", otter_boards.span = "Otter board span",
  hammers.mass = "Hammer mass", canvas.area = "Canvas area",
  floats.number = "Number of floats", floats.buoyancy = "Buoyancy of a float",
  sinkers.mass = "Mass of a sinker", purse_wire.length = "Purse wire",
  shortening_ratio = "Shortening ratio", branch_lines.length = "Branch lines"
)

# ... and of parts of an assembly, by their role.
usual_parts <- data.frame(
  group = c("ropes", "pieces", "pieces", "pieces", "pieces", "pieces"),
  role = c("warp", "otter_board", "hammer", "canvas", "float", "float"),
  field = c("length", "area", "mass", "area", "number", "buoyancy"),
  label = c("Warp out", "Otter board area", "Hammer mass", "Canvas area", "Number of floats",
    "Buoyancy of a float")
)

# The usual fields of a plan: lists of label and paths (fields that change together).
usual_of_plan <- function(plan) c(usual_fields_given(plan), usual_part_fields(plan))

# Of those that the plan gives; a current by layers has one each.
usual_fields_given <- function(plan) {
  given <- Filter(function(path) isTRUE(plan_field(plan, path)$given), names(usual_fields))
  layers <- plan$water$current
  layers <- if (is.null(names(layers))) seq_along(layers)
  c(
    Map(function(path, label) list(label = label, paths = path), given, usual_fields[given]),
    lapply(layers, function(k) {
      depth <- plan$water$current[[k]]$depth
      list(
        label = paste("Current at", if (is.numeric(depth)) format_si(depth, "length") else depth),
        paths = sprintf("water.current.%d.speed", k)
      )
    })
  )
}

# Parts of one role with one value change together, others one by one.
usual_part_fields <- function(plan) {
  unlist(lapply(seq_len(nrow(usual_parts)), function(k) {
    usual <- usual_parts[k, ]
    parts <- plan[[usual$group]]
    alike <- names(Filter(function(part) {
      is.list(part) && identical(part$role, usual$role) && !is.null(part[[usual$field]])
    }, parts))
    if (!length(alike)) return(NULL)
    paths <- paste(usual$group, alike, usual$field, sep = ".")
    values <- unique(lapply(parts[alike], `[[`, usual$field))
    if (length(values) == 1L) return(list(list(label = usual$label, paths = paths)))
    unname(Map(function(path, part) {
      list(label = paste0(usual$label, ", ", gsub("_", " ", part)), paths = path)
    }, paths, alike))
  }), recursive = FALSE)
}

# Paths of all single values that a plan gives, beside what only describes it or a tow.
given_paths <- function(plan) {
  beside <- c("codend", "kind", "name", "notes", "sources", "tow", "uncertain", "multipliers")
  leaves <- plan_leaves(plan[setdiff(names(plan), beside)])
  leaves$path[lengths(leaves$value) == 1L]
}
