# Finds the plan field behind a part of an expanded short form, for errors.

# Returns the leaves of a plan: list(path, value) of equal length.
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

# TRUE if a plan's value equals a checked value, which may be in SI.
same_value <- function(written, checked) {
  if (identical(written, checked)) return(TRUE)
  si <- written_si(written)
  is.numeric(checked) && length(checked) == 1L && !is.na(si) && abs(si - checked) <= 1e-9 * abs(si)
}

# Returns the SI number of a plan's quantity, or NA.
written_si <- function(written) {
  if (is.numeric(written) && length(written) == 1L) return(as.double(written))
  if (!is_text(written)) return(NA_real_)
  dimension <- quantity_dimension(written)
  if (is.na(dimension)) NA_real_ else quantity_si(written, dimension)
}

# Returns the words of a path, to compare parts with fields: the part back_wing_left matches the
# field wings.upper, warp_port matches warps.
part_text <- function(path) {
  words <- sub("s$", "", strsplit(path, "[._]")[[1]])
  if ("wing" %in% words) words <- c(words, c(back = "upper", belly = "lower")[words])
  words[!is.na(words)]
}

# Returns the path of the plan field that produced a part's field, or NULL if no field is similar.
# `plan`: as written; `path`, `value`: of the part's field, `value` is NULL if it is missing;
# `leaves`: the plan's.
written_path <- function(plan, path, value, leaves = plan_leaves(plan)) {
  path <- dotted_path(path)
  steps <- path_steps(path)
  found <- first_of(net_path(plan, steps), section_path(plan, steps))
  if (!is.null(found)) return(found)
  last <- sub("^.*[.]", "", leaves$path)
  fits <- last == steps[length(steps)]
  if (!is.null(value)) fits[fits] <- vapply(leaves$value[fits], same_value, NA, value)
  candidates <- leaves$path[fits]
  if (!length(candidates) || is.null(value)) {
    # The map that would contain the missing field.
    maps <- unique(sub("[.]?[^.]*$", "", leaves$path))
    maps <- maps[nzchar(maps)]
    whole <- paste(steps[-length(steps)], collapse = ".")
    score <- vapply(maps, function(map) likeness(map, whole), 0)
    if (!length(score) || max(score) < 2) return(NULL)
    return(paste(maps[which.max(score)], steps[length(steps)], sep = "."))
  }
  candidates[which.max(vapply(candidates, likeness, 0, whole = path))]
}

# Panels of the field `net` by the start of the names of their panels in the assembly.
net_names <- c(back = "upper", belly = "lower", side_starboard = "side", side_port = "side",
  upper_side_starboard = "upper_side", upper_side_port = "upper_side",
  lower_side_starboard = "lower_side", lower_side_port = "lower_side")

# Returns the path in the field `net` of a panel's field in the assembly, or NULL. A piece may take
# the field from the piece of the same name in the upper panel.
net_path <- function(plan, steps) {
  if (is.null(plan$net) || length(steps) < 2L || steps[1L] != "panels") return(NULL)
  rest <- c(upper = "front", lower = "rear")[steps]
  rest <- ifelse(is.na(rest) | !"meshes" %in% steps, steps, rest)[-(1:2)]
  # The rates of wings are inner and outer, those of panels left and right.
  if ("cutting" %in% rest) rest <- "cutting"
  for (start in names(net_names)[startsWith(steps[2L], paste0(names(net_names), "_"))]) {
    row <- substring(steps[2L], nchar(start) + 2L)
    of <- plan$net[[net_names[[start]]]]
    whole <- sub("(_(ahead|behind|window))?(_(left|right))?$", "", row)
    inside <- endsWith(row, "_window") && !row %in% names(of)
    row <- intersect(c(row, sub("_(left|right)$", "", row), whole), names(of))[1L]
    if (is.na(row)) next
    if (inside) return(paste(c("net", net_names[[start]], row, "window", rest), collapse = "."))
    paths <- lapply(c(net_names[[start]], "upper"), function(panel) c("net", panel, row, rest))
    paths <- vapply(paths, paste, "", collapse = ".")
    return(first_of(Find(function(path) !is.null(plan_field(plan, path)$value), paths), paths[1L]))
  }
  NULL
}

# Returns the path in the sections of a line of a rope's field in the assembly, or NULL.
section_path <- function(plan, steps) {
  if (length(steps) < 2L || steps[1L] != "ropes") return(NULL)
  lines <- names(plan)[vapply(plan, function(part) is_map(part) && length(part$sections), NA)]
  for (line in lines) {
    role <- sub("s$", "", line)
    if (!grepl(paste0("^", role, "(_|$)"), steps[2L])) next
    k <- sub(paste0("^", role, "_([0-9]+)(_.*)?$"), "\\1", steps[2L])
    if (k == steps[2L]) k <- "1"
    return(paste(c(line, "sections", k, steps[-(1:2)]), collapse = "."))
  }
  NULL
}

# Returns the number of words in common with a part's path, minus 0.1 for each other word.
likeness <- function(written, whole) {
  words <- part_text(written)
  known <- words %in% part_text(whole)
  sum(known) - 0.1 * sum(!known)
}

# Replaces the part's field in a message by the user's field.
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

# Replaces a checked value and limits in SI in a message by the text and the unit of the plan:
# "is 88.26; it must be at most 42.12 N" becomes "is 9 kgf; it must be at most 4.295 kgf".
# `written`: value in the plan; `value`: of the error, in SI.
in_written_unit <- function(said, written, value) {
  if (!is_text(written) || is.na(quantity_dimension(written))) return(said)
  si <- written_si(value)
  if (is.na(si) || !same_value(written, si)) return(said)
  unit <- plain_unit(split_quantity(written)[2L])
  dimension <- quantity_dimension(written)
  of_si <- names(plan_units[[dimension]])[1L]
  if (unit == of_si) return(said)
  said <- sub(paste0(" is ", show_value(value), ";"), paste0(" is ", written, ";"), said,
    fixed = TRUE)
  si_limit <- paste0("(?<= )-?[0-9][0-9.e+-]* \\Q", of_si, "\\E(?![\\w/])")
  limit <- gregexpr(si_limit, said, perl = TRUE)
  regmatches(said, limit) <- lapply(regmatches(said, limit), function(found) {
    vapply(found, function(one) {
      format_like(as.double(split_quantity(one)[1L]), dimension, written)
    }, "", USE.NAMES = FALSE)
  })
  said
}

# Mesh sizes (m) above this limit are nearly always millimetres without a unit.
doubtful_bare_mesh <- 20

# Rethrows an error about a plan's parts with the field names of the plan.
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
  field <- if (nzchar(known)) plan_field(plan, dotted_path(path))
  said <- in_written_unit(said, field$value, e$value)
  leaves <- plan_leaves(plan)
  meshes <- grepl("(^|[.])mesh_size$", leaves$path)
  leaves <- lapply(leaves, `[`, meshes)
  if (length(e$mesh_sizes) > 1L) {
    found <- unique(unlist(Map(function(panel, size) {
      written_path(plan, paste0("panels.", panel, ".mesh_size"), size)
    }, names(e$mesh_sizes), e$mesh_sizes)))
    if (length(found)) {
      values <- vapply(leaves$value[match(found, leaves$path)], show_value, "")
      said <- paste0(said, " Mesh sizes: ",
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
    said <- sprintf("%s Note: `%s` is %s without a unit, which means %s m. Is it %s mm?", said,
      leaves$path[k], size, size, size)
    path <- leaves$path[k]
  }
  abort_plan(said, path, e$value)
}
