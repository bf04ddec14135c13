# From a part that a short form stands for back to the field that somebody wrote: an error about the
# part is told of that field.

# The leaves of a plan: list(path, value), of the same length.
plan_leaves <- function(plan) {
  paths <- character()
  values <- list()
  walk <- function(value, path) {
    if (is_map(value) && length(value)) {
      for (name in names(value)) walk(value[[name]], join(path, name))
      return(invisible())
    }
    if (is.list(value) && length(value)) {
      for (k in seq_along(value)) walk(value[[k]], join(path, k))
      return(invisible())
    }
    paths[length(paths) + 1L] <<- path
    values[length(values) + 1L] <<- list(value)
  }
  walk(plan, "")
  list(path = paths, value = values)
}

# Whether what a plan has and what a check speaks of, which may be in SI, are one value.
same_value <- function(written, checked) {
  if (identical(written, checked)) return(TRUE)
  si <- written_si(written)
  is.numeric(checked) && length(checked) == 1L && !is.na(si) && abs(si - checked) <= 1e-9 * abs(si)
}

# The SI number of a plan's quantity, NA where it is none.
written_si <- function(written) {
  if (is.numeric(written) && length(written) == 1L) return(as.double(written))
  if (!is_text(written)) return(NA_real_)
  dimension <- quantity_dimension(written)
  if (is.na(dimension)) NA_real_ else quantity_si(written, dimension)
}

# The words of a path, as those of parts and of fields may be compared: a part back_wing_left is of
# the field wings.upper, warp_port of warps.
part_words <- function(path) {
  words <- sub("s$", "", strsplit(path, "[._]")[[1]])
  if ("wing" %in% words) words <- c(words, c(back = "upper", belly = "lower")[words])
  words[!is.na(words)]
}

# The path of the field that became the field of a part, or NULL where none is like it. plan: as
# written; path, value: of the part's field; value NULL where it is missing; leaves: the plan's.
written_path <- function(plan, path, value, leaves = plan_leaves(plan)) {
  path <- dotted_path(path)
  steps <- path_steps(path)
  last <- sub("^.*[.]", "", leaves$path)
  fits <- last == steps[length(steps)]
  if (!is.null(value)) fits[fits] <- vapply(leaves$value[fits], same_value, NA, value)
  candidates <- leaves$path[fits]
  if (!length(candidates) || is.null(value)) {
    # the map that it would stand in
    maps <- unique(sub("[.]?[^.]*$", "", leaves$path))
    maps <- maps[nzchar(maps)]
    whole <- paste(steps[-length(steps)], collapse = ".")
    score <- vapply(maps, function(map) likeness(map, whole), 0)
    if (!length(score) || max(score) < 2) return(NULL)
    return(paste(maps[which.max(score)], steps[length(steps)], sep = "."))
  }
  candidates[which.max(vapply(candidates, likeness, 0, whole = path))]
}

# How many words of a written path a part's path has, less a little for each that it has not.
likeness <- function(written, whole) {
  words <- part_words(written)
  known <- words %in% part_words(whole)
  sum(known) - 0.1 * sum(!known)
}

# A message about a part's field, of the field that was written instead.
reworded <- function(message, path, written) {
  old <- path_steps(dotted_path(path))
  new <- path_steps(written)
  while (length(old) > 1L && length(new) > 1L && old[length(old)] == new[length(new)]) {
    old <- old[-length(old)]
    new <- new[-length(new)]
  }
  old <- paste(old, collapse = ".")
  new <- paste(new, collapse = ".")
  message <- gsub(paste0("`", path), paste0("`", written), message, fixed = TRUE)
  gsub(paste0("`", old, "."), paste0("`", new, "."), message, fixed = TRUE)
}

# Larger meshes than this (m) are nearly always millimetres without their unit.
doubtful_bare_mesh <- 20

# Rethrows an error about a plan's parts in the words of the plan.
abort_as_written <- function(e, plan) {
  said <- e$said
  path <- e$path
  known <- dotted_path(first_of(path, ""))
  if (nzchar(known) && is.null(path_node(plan, known))) {
    written <- written_path(plan, path, e$value)
    if (!is.null(written) && !is.null(path_node(plan, written))) {
      said <- reworded(said, path, written)
      path <- written
    }
  }
  leaves <- plan_leaves(plan)
  meshes <- grepl("(^|[.])mesh_size$", leaves$path)
  leaves <- lapply(leaves, `[`, meshes)
  if (length(e$mesh_sizes) > 1L) {
    found <- unique(unlist(Map(function(panel, size) {
      written_path(plan, paste0("panels.", panel, ".mesh_size"), size)
    }, names(e$mesh_sizes), e$mesh_sizes)))
    if (length(found)) {
      values <- vapply(leaves$value[match(found, leaves$path)], show_value, "")
      said <- paste0(said, " Meshes are of ",
        paste0("`", found, "`, ", values, collapse = ", and "), ".")
      path <- found[length(found)]
    }
  }
  bare <- vapply(leaves$value, function(value) {
    is.numeric(value) && value >= doubtful_bare_mesh
  }, NA)
  if (any(bare)) {
    k <- which(bare)[1]
    size <- format(leaves$value[[k]])
    said <- sprintf("%s Note that `%s` is %s without a unit, which is %s m; is it %s mm?", said,
      leaves$path[k], size, size, size)
    path <- leaves$path[k]
  }
  abort_plan(said, path, e$value)
}
