# Returns the plan with a copy of the part `like` at `path`, after the part `after` (NULL: last).
copied_part <- function(plan, path, like, after = NULL) {
  steps <- path_steps(path)
  name <- steps[length(steps)]
  map <- at_path(plan, steps[-length(steps)])
  if (name %in% names(map)) abort_field(path, name, "a new name; another part has this name")
  plan <- set_plan_field(plan, path, at_path(plan, path_steps(like)))
  if (is.null(after)) return(plan)
  others <- names(map)
  ordered_parts(plan, steps[-length(steps)], append(others, name, match(after, others,
    nomatch = length(others))))
}

# Returns the plan with a part renamed, including all references to it.
renamed_part <- function(plan, path, name) {
  steps <- path_steps(path)
  old <- steps[length(steps)]
  if (identical(old, name)) return(plan)
  parent <- steps[-length(steps)]
  map <- at_path(plan, parent)
  if (name %in% names(map)) abort_field(path, name, "a new name; another part has this name")
  names(map)[match(old, names(map))] <- name
  plan <- put_parts(plan, parent, map)
  whole <- paste0("(?<![A-Za-z0-9_])", old, "(?![A-Za-z0-9_])")
  leaves <- plan_leaves(plan)
  for (k in seq_along(leaves$path)) {
    value <- leaves$value[[k]]
    first <- path_steps(leaves$path[k])
    own <- first[1] %in% c("name", "notes", "sources") || first[length(first)] == "material"
    if (own || !is.character(value) || !any(grepl(whole, value, perl = TRUE))) next
    if (!is.null(path_node(plan, leaves$path[k])$enum)) next
    plan <- set_plan_field(plan, leaves$path[k], gsub(whole, name, value, perl = TRUE))
  }
  if (!is.null(plan$uncertain)) {
    names(plan$uncertain) <- sub(paste0("^\\Q", path, "\\E(?=[.]|$)"),
      paste(c(parent, name), collapse = "."), names(plan$uncertain), perl = TRUE)
  }
  plan
}

# Returns the plan with a part moved by `by` positions within its group (by < 0: towards the front).
moved_part <- function(plan, path, by) {
  steps <- path_steps(path)
  parent <- steps[-length(steps)]
  names <- names(at_path(plan, parent))
  here <- match(steps[length(steps)], names)
  there <- min(max(here + by, 1L), length(names))
  ordered_parts(plan, parent, append(names[-here], names[here], there - 1L))
}

ordered_parts <- function(plan, parent, names) put_parts(plan, parent, at_path(plan, parent)[names])

put_parts <- function(plan, parent, map) {
  if (!length(parent)) return(map)
  set_plan_field(plan, paste(parent, collapse = "."), map)
}
