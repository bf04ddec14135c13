# Which field of a plan the drawing shows where: from a field of the assembly that is drawn to that
# of the short form that somebody wrote.

# A function that gives the path in a gear's plan of a field of its assembly, "" where no field of
# the plan is that one.
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

# Fields that a wing's panel has by other names in its short form.
wing_fields <- c(upper = "tip", lower = "base")

drawn_path <- function(ref, plan, tree, leaves) {
  steps <- path_steps(ref)
  if (steps[1] == "panels" && steps[length(steps)] == "cutting") {
    # a rate need not be given to be asked for
    part <- drawn_path(sub("cutting$", "mesh_size", ref), plan, tree, leaves)
    path <- sub("mesh_size$", "cutting", part)
    return(if (nzchar(part) && !is.null(path_node(plan, path))) path else "")
  }
  has <- function(path) !is.null(path) && !is.null(plan_field(plan, path))
  if (has(ref)) return(ref)
  value <- tryCatch(tree[[steps]], error = function(e) NULL)
  # of a part as a whole, what the first of its fields belongs to
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

# The fields by which a part is found in a short form, those that tell it best first.
part_marks <- c("mesh_size", "diameter", "mass", "area", "buoyancy", "length", "material",
  "mass_per_length", "drag_area", "volume")
