# Plans that a plan includes as its gears.

# Returns a tree with the fields of each plan instead of its name (`gears.*.plan`).
# `file`: path of the plan's own file, or NULL if only shipped plans are allowed. `within`: files
# that include this one.
with_included_plans <- function(tree, file, within = NULL) {
  if (!is_map(tree) || !is_map(tree[["gears"]])) return(tree)
  for (name in names(tree$gears)) {
    given <- with_included_plans(tree$gears[[name]], file, within)
    tree$gears[[name]] <- given
    if (!is_map(given) || is.null(given[["plan"]])) next
    path <- paste0("gears.", name, ".plan")
    from <- included_file(given$plan, file, path)
    if (from %in% within) abort_field(path, given$plan, "a plan that does not include itself")
    whole <- join_uncertain(with_included_plans(read_plan(from), from, c(within, from)))
    kept <- whole[setdiff(names(whole), whole_plan_fields)]
    tree$gears[[name]] <- merged_fields(kept, given[names(given) != "plan"])
  }
  tree
}

included_file <- function(plan, file, path) {
  shipped <- shipped_plans()
  if (!is_text(plan)) abort_field(path, plan, "the name of a plan")
  if (plan %in% names(shipped)) return(shipped[[plan]])
  # Only files in the same folder, so that a plan cannot make codend open other files.
  from <- if (!is.null(file) && plan == basename(plan)) file.path(dirname(file), plan)
  if (is.null(from) || !file.exists(from)) {
    abort_field(path, plan, paste0(
      "a shipped plan or a file in the folder of this plan file; shipped: ",
      word_list(names(shipped))
    ), hint = nearest(plan, names(shipped)))
  }
  normalizePath(from)
}
