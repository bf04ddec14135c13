# Rigs: plans with whole gears as parts (`gears`), which expand into one assembly.

# Fields of each part that refer to other parts of the gear, by group.
part_references <- list(
  points = "at", ropes = c("from", "to", "through", "along"),
  panels = character(), seams = c("edges", "gathered_at", "held_between"),
  pieces = c("at", "along"), otter_boards = "attachments", kites = "attachments",
  nets = c("mouth", "wing_ends"), measures = NULL
)

# Expands a rig. `fields`, `plan`: its checked fields and the plan as given; `last`: the gears of
# another result of this function, or NULL.
#
# Returns list(expanded, gears): the assembly, and by name of each gear list(plan, checked, parts,
# joined): its plan as if it were alone, the result of its check, the names of its parts by group,
# and those of its joined points.
expand_rig <- function(fields, plan, last = NULL) {
  rig <- plan[setdiff(names(plan), c("gears", "uncertain", "kind"))]
  groups <- names(part_references)
  own <- rig[intersect(groups, names(rig))]
  rig[groups] <- rep(list(list()), length(groups))
  copies <- rig_copies(fields, plan)
  gears <- list()
  for (copy in copies) {
    alone <- plan_of_part(copy, plan)
    # Copies of a gear are checked once.
    known <- c(last[copy$name], gears)
    same <- Find(function(one) identical(one$plan, alone), known)
    checked <- if (!is.null(same)) same$checked else {
      withCallingHandlers(
        check_whole(alone, last[[copy$name]]$checked, joined = FALSE),
        codend_error_plan = function(e) abort_as_part(e, plan$gears, copy$of, names(alone))
      )
    }
    part <- part_tree(checked, copy, is.null(plan$netting_drag))
    rig <- with_part(rig, part, copy)
    parts <- lapply(part[groups], names)
    joined <- paste0(copy$name, "_", names(copy$tree$joined), recycle0 = TRUE)
    gears[[copy$name]] <- list(plan = alone, checked = checked, parts = parts, joined = joined)
  }
  for (group in groups) {
    twice <- intersect(names(rig[[group]]), names(own[[group]]))
    if (length(twice)) {
      abort_field(paste0(group, ".", twice[1L]), NULL, "another name",
        "has the same name as a part of a gear")
    }
    rig[[group]] <- c(rig[[group]], own[[group]])
  }
  for (copy in copies) {
    rig <- with_joints(rig, copy, gears[[copy$name]]$parts$points, plan$gears)
  }
  list(rig[lengths(rig) > 0L], gears)
}

# Returns every gear of a rig: list(name, of, tree, moved): its name, the name in the plan, its
# fields as given, and its displacement (m).
rig_copies <- function(fields, plan) {
  copies <- list()
  for (of in names(plan$gears)) {
    tree <- gear_like(plan$gears, of)
    si <- gear_like(fields$gears, of)
    number <- first_of(si$number, 1)
    for (k in seq_len(number)) {
      moved <- first_of(si$moved, c(0, 0, 0)) + (k - 1) * first_of(si$apart, c(0, 0, 0))
      name <- if (number > 1) paste0(of, "_", k) else of
      tree$joined <- lapply(si$joined, function(place) gsub("#", k, place, fixed = TRUE))
      copies[[name]] <- list(name = name, of = of, tree = tree, moved = moved)
    }
  }
  copies
}

# Returns the plan of a gear in a rig as if it were alone, in the conditions of the rig's plan.
plan_of_part <- function(copy, plan) {
  kind <- first_of(copy$tree$kind, plan_kinds[1L])
  allowed <- names(kind_node(kind)$properties)
  alone <- c("notes", "sources", "uncertain", "tow", "shooting", "laid")
  shared <- setdiff(whole_plan_fields, alone)
  own <- copy$tree[setdiff(names(copy$tree), c(part_fields_of_gears, "kind"))]
  materials <- plan$materials
  materials[names(own$materials)] <- own$materials
  own$materials <- NULL
  c(plan[intersect(intersect(shared, allowed), names(plan))], list(kind = kind), own,
    if (length(materials)) list(materials = materials))
}

# Returns the path at which a field of a gear is written. The field is in the gear itself or in a
# gear that it is like.
gear_field_path <- function(gears, name, path) {
  steps <- path_steps(dotted_path(path))
  for (k in rev(seq_along(steps))) {
    at <- name
    while (!is.null(at)) {
      if (!is.null(at_path(gears[[at]], steps[seq_len(k)]))) {
        return(paste0("gears.", at, ".", path))
      }
      at <- gears[[at]]$like
    }
  }
  paste0("gears.", name, ".", path)
}

# Rethrows an error in the plan of a gear with the path of the field in the rig's plan.
abort_as_part <- function(e, gears, name, known) {
  path <- first_of(e$path, "")
  if (path_steps(paste0(dotted_path(path), "."))[1L] %in% whole_plan_fields) return(invisible())
  written <- if (nzchar(path)) gear_field_path(gears, name, path) else paste0("gears.", name)
  said <- if (nzchar(path)) {
    gsub(paste0("`", path), paste0("`", written), e$said, fixed = TRUE)
  } else {
    e$said
  }
  abort_plan(said, written, e$value)
}

# Returns the assembly of a checked gear with the names and positions that it has in the rig.
# `own_drag`: TRUE if each gear keeps the drag model of netting of its kind.
part_tree <- function(checked, copy, own_drag) {
  tree <- first_of(checked$tree, checked$counted$plan)
  wrong <- intersect(c("shooting", "laid", "catch"), names(tree))
  if (length(wrong)) {
    abort_field(paste0("gears.", copy$of, ".", wrong[1L]), "given", "omitted in a gear of a rig")
  }
  prefix <- paste0(copy$name, "_")
  for (group in intersect(names(part_references), names(tree))) {
    parts <- tree[[group]]
    # A gear with one net has the name of the gear.
    names(parts) <- if (group == "nets" && length(parts) == 1L) copy$name else {
      paste0(prefix, names(parts))
    }
    tree[[group]] <- lapply(parts, function(part) {
      for (field in intersect(first_of(part_references[[group]], names(part)), names(part))) {
        part[[field]] <- prefixed_reference(part[[field]], prefix)
      }
      part
    })
  }
  if (any(copy$moved != 0)) tree$points <- lapply(tree$points, moved_point, copy$moved)
  if (own_drag) {
    tree$panels <- lapply(tree$panels, function(panel) {
      if (is.null(panel$netting_drag)) panel$netting_drag <- checked$assembly$netting_drag
      panel
    })
  }
  tree
}

# Returns a reference to a part with a prefix before the part's name. A map refers by its names, or
# by its field `panels`.
prefixed_reference <- function(value, prefix) {
  if (is.character(value)) return(sub("^(-?)", paste0("\\1", prefix), value))
  if (!is.list(value)) return(value)
  if (is.null(names(value))) return(lapply(value, prefixed_reference, prefix))
  if (!"panels" %in% names(value)) return(stats::setNames(value, paste0(prefix, names(value))))
  value$panels <- prefixed_reference(value$panels, prefix)
  value
}

moved_point <- function(point, by) {
  for (field in intersect(c("position", "near"), names(point))) {
    point[[field]] <- vapply(as.list(point[[field]]), quantity_si, 0, "length") + by
  }
  point
}

# Adds the parts, materials and free surface of a gear to a rig.
with_part <- function(rig, part, copy) {
  for (group in names(part_references)) rig[[group]] <- c(rig[[group]], part[[group]])
  for (name in names(part$materials)) {
    other <- rig$materials[[name]]
    if (!is.null(other) && !identical(other, part$materials[[name]])) {
      abort_field(sprintf("gears.%s.materials.%s", copy$of, name), NULL, "the same in all gears",
        "differs from the material of that name in the plan")
    }
    rig$materials[[name]] <- part$materials[[name]]
  }
  if (isTRUE(part$water$free_surface)) rig$water$free_surface <- TRUE
  rig
}

# Joins points of a gear, of all its `points`, to locations of the rig.
with_joints <- function(rig, copy, points, gears) {
  known <- list(points = names(rig$points), ropes = names(rig$ropes), panels = rig$panels)
  for (point in names(copy$tree$joined)) {
    path <- gear_field_path(gears, copy$of, paste0("joined.", point))
    inner <- paste0(copy$name, "_", point)
    if (!inner %in% points) {
      known_here <- substring(points, nchar(copy$name) + 2L)
      abort_reference(point, point, known_here, "point of this gear", path)
    }
    place <- find_place(copy$tree$joined[[point]], path, known)
    given <- rig$points[[inner]]
    if (is.null(given$at)) {
      free <- given[setdiff(names(given), c("position", "held"))]
      rig$points[[inner]] <- c(list(at = place), free)
    } else if (place %in% names(rig$points) && is.null(rig$points[[place]]$at)) {
      rig$points[[place]]$at <- inner
    } else {
      abort_field(path, place, sprintf(
        "a point of this plan without `at`: `%s` is itself on netting or a rope", point
      ))
    }
  }
  rig
}
