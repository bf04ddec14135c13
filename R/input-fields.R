# Default input fields of studies and the flume tank: the fields that users change most.

# Usual fields of short forms: paths with their labels, in display order.
usual_fields <- c(
  towing.speed = "Towing speed", water.current.speed = "Current",
  warps.length = "Warp out", otter_boards.area = "Otter board area",
  otter_boards.chord = "Otter board chord", otter_boards.span = "Otter board span",
  hammers.mass = "Hammer mass", canvas.area = "Canvas area",
  floats.number = "Number of floats", floats.buoyancy = "Buoyancy of a float",
  sinkers.mass = "Mass of a sinker", purse_wire.length = "Purse wire",
  shortening_ratio = "Shortening ratio", branch_lines.length = "Branch lines"
)

# Usual fields of the parts of an assembly, by role.
usual_parts <- data.frame(
  group = c("ropes", "pieces", "pieces", "pieces", "pieces", "pieces"),
  role = c("warp", "otter_board", "hammer", "canvas", "float", "float"),
  field = c("length", "area", "mass", "area", "number", "buoyancy"),
  label = c("Warp out", "Otter board area", "Hammer mass", "Canvas area", "Number of floats",
    "Buoyancy of a float")
)

# Returns the usual fields of a plan: lists of label and paths (fields that change together).
usual_of_plan <- function(plan) c(usual_fields_given(plan), usual_part_fields(plan))

# Returns the usual fields that the plan contains. A layered current has one field per layer.
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

# Parts with the same role and value change together. Other parts get one entry each.
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

# Returns the paths of all single values in a plan, except descriptions and the tow.
given_paths <- function(plan) {
  beside <- c("codend", "kind", "name", "notes", "sources", "tow", "uncertain", "multipliers")
  leaves <- plan_leaves(plan[setdiff(names(plan), beside)])
  leaves$path[lengths(leaves$value) == 1L]
}
