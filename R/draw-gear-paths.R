# Returns a function that maps a field of the assembly to its path in the plan, "" if the plan has
# no such field.
path_finder <- function(gear) {
  plan <- gear$plan
  tree <- first_of(gear_checked(gear)$tree, plan)
  leaves <- plan_leaves(plan)
  known <- new.env(parent = emptyenv())
  function(ref) {
    if (is.null(known[[ref]])) known[[ref]] <- drawn_path(ref, plan, tree, leaves)
    known[[ref]]
  }
}

# Names of a wing panel's fields in the short form.
wing_fields <- c(upper = "tip", lower = "base")

drawn_path <- function(ref, plan, tree, leaves) {
  steps <- path_steps(ref)
  has <- function(path) !is.null(path) && !is.null(plan_field(plan, path))
  found <- net_path(plan, steps)
  if (!is.null(found)) return(if (has(found)) found else "")
  if (steps[1] == "panels" && steps[length(steps)] == "cutting") {
    # The plan may omit the cutting rate, so its path is derived from the mesh size of the panel.
    part <- drawn_path(sub("cutting$", "mesh_size", ref), plan, tree, leaves)
    path <- sub("mesh_size$", "cutting", part)
    return(if (nzchar(part) && !is.null(path_node(plan, path))) path else "")
  }
  if (has(ref)) return(ref)
  value <- tryCatch(tree[[steps]], error = function(e) NULL)
  # A whole part maps to the plan group that contains its first known field.
  if (is.list(value) || is.null(value) && length(steps) == 2L) {
    for (name in intersect(part_marks, names(value))) {
      path <- drawn_path(paste(ref, name, sep = "."), plan, tree, leaves)
      if (nzchar(path) && grepl(".", path, fixed = TRUE)) return(sub("[.][^.]*$", "", path))
    }
    return("")
  }
  if (is.null(value)) return("")
  path <- written_path(plan, ref, value, leaves)
  if (has(path)) return(path)
  last <- steps[length(steps)]
  if (last %in% names(wing_fields)) {
    steps[length(steps)] <- wing_fields[[last]]
    path <- written_path(plan, paste(steps, collapse = "."), value, leaves)
    if (has(path)) return(path)
  }
  if (endsWith(ref, "twine.diameter")) {
    part <- drawn_path(sub("twine.diameter$", "mesh_size", ref), plan, tree, leaves)
    path <- sub("mesh_size$", "twine.rtex", part)
    if (nzchar(part) && has(path)) return(path)
  }
  ""
}

# Fields that identify a part in a short form, most distinctive first.
part_marks <- c("mesh_size", "diameter", "mass", "area", "buoyancy", "length", "material",
  "mass_per_length", "drag_area", "volume")
