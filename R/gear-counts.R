# Completes mesh counts, cutting rates and twines that follow from other fields of a plan.

# Plan groups that determine the mesh counts.
count_groups <- c("panels", "net", "separators", "wings", "square", "sections", "materials")

# Completes the counts and twines of a plan. `fields`: checked fields in SI; `plan`: the plan as
# given; `twines`: FALSE for expanded short forms, which have no twine given by weight.
#
# Returns list(fields, plan, derived): both trees with the computed counts; the counts by path.
complete_counts <- function(fields, plan, twines = TRUE) {
  done <- list(fields = fields, plan = plan, derived = numeric())
  if (!is.null(fields$net)) done <- complete_net(fields, plan)
  fields <- done$fields
  put <- function(path, value) {
    done$fields <<- put_in(done$fields, path, value)
    done$plan <<- put_in(done$plan, path, value)
  }
  complete <- function(path, given, ...) {
    found <- complete_meshes(given, paste(path, collapse = "."), ...)
    for (name in names(found)) {
      put(c(path, "meshes", name), found[[name]])
      done$derived[[paste(c(path, "meshes", name), collapse = ".")]] <<- found[[name]]
    }
  }
  if (twines && has_field(fields, "rtex")) {
    done$fields <- twines_by_weight(done$fields, fields$materials, "")
    done$plan <- twines_by_weight(done$plan, fields$materials, "")
  }
  if (is_map(fields$panels)) {
    for (name in names(fields$panels)) complete(c("panels", name), fields$panels[[name]])
  }
  if (!is.null(fields$wings$meshes)) {
    complete("wings", fields$wings, narrow = "tip", wide = "base")
  }
  for (tier in intersect(c("upper", "lower"), names(fields$wings))) {
    complete(c("wings", tier), fields$wings[[tier]], narrow = "tip", wide = "base")
  }
  if (!is.null(fields$wings$side)) complete(c("wings", "side"), fields$wings$side)
  if (!is.null(fields$square)) complete("square", fields$square)
  for (name in names(fields$separators)) complete(c("separators", name), fields$separators[[name]])
  before <- NULL
  for (name in names(fields$sections)) {
    path <- c("sections", name)
    section <- fields$sections[[name]]
    if (!is.null(section$take_up)) {
      section <- taken_up(section, before, paste(path, collapse = "."))
      if (is.null(fields$sections[[name]]$meshes$upper)) {
        put(c(path, "meshes", "upper"), section$meshes$upper)
        done$derived[paste0("sections.", name, ".meshes.upper")] <- section$meshes$upper
      }
    }
    complete(path, section)
    whole <- done$fields$sections[[name]]
    for (side in intersect(c("back", "belly", "side"), names(section))) {
      own <- section[[side]]
      if (is.null(own$meshes) && is.null(own$cutting)) next
      both <- section_panel(whole, side)
      # A panel's own cutting rate gives another rear width.
      if (is.null(own$meshes)) both$meshes$lower <- NULL
      complete(c(path, side), both)
      if (is.null(own$meshes)) {
        for (count in c("upper", "deep")) put(c(path, side, "meshes", count), both$meshes[[count]])
      }
    }
    before <- whole$meshes$lower
  }
  done
}

put_in <- function(tree, path, value) {
  if (!length(path)) return(value)
  tree <- as.list(tree)
  tree[[path[1]]] <- put_in(tree[[path[1]]], path[-1], value)
  tree
}

# Allowed rounding of net makers: one mesh at each edge that is cut.
rounded_meshes <- 1

# Returns the one count that the cutting rate gives (named list), or NULL if all counts are given.
# `given`: checked fields of the panel with `meshes`, `cutting` and `tapered`.
# `narrow`, `wide`: names of the two width counts.
complete_meshes <- function(given, path, narrow = "upper", wide = "lower") {
  meshes <- given$meshes
  counts <- c(narrow, wide, "deep")
  missing <- setdiff(counts, names(meshes))
  # A plan that gives the lost meshes of each edge states the cutting rate for drawings only.
  if (is.null(given$cutting) || !is.null(given$lost)) {
    if (!length(missing)) return(NULL)
    abort_field(paste0(path, ".meshes.", missing[1]), NULL,
      "given, or computed from the other two counts and a `cutting` rate", "is missing")
  }
  slopes <- cutting_slopes(given, path, one_edge = narrow == "tip")
  loss <- sum(slopes)
  if (length(missing) > 1L) {
    abort_field(paste0(path, ".meshes.", missing[1]), NULL,
      "given: two of the three counts are needed with `cutting`", "is missing")
  }
  rate <- show_cutting(given$cutting)
  if (!length(missing)) {
    lost <- abs(meshes[[wide]] - meshes[[narrow]])
    due <- loss * meshes$deep
    allowed <- rounded_meshes * max(1, sum(slopes > 0))
    if (abs(lost - due) > allowed + 1e-9) {
      fits <- cutting_rate(lost / max(1, sum(slopes > 0)), meshes$deep, given_orientation(given))
      abort_field(paste0(path, ".cutting"), rate, sprintf(
        paste(
          "a rate that removes %s meshes over %s rows (from `%s` %s to `%s` %s), such as %s; this",
          "rate removes %s. The tolerance is one mesh at each edge"
        ),
        displayed_count(lost), displayed_count(meshes$deep), narrow,
        displayed_count(meshes[[narrow]]), wide, displayed_count(meshes[[wide]]), fits,
        displayed_count(due)
      ), is = paste("is", rate))
    }
    return(NULL)
  }
  if (missing == "deep") {
    if (loss == 0) {
      abort_field(paste0(path, ".meshes.deep"), NULL,
        sprintf("given if the edges are cut %s, without loss of meshes", rate), "is missing")
    }
    deep <- abs(meshes[[wide]] - meshes[[narrow]]) / loss
    if (deep == 0) {
      abort_field(paste0(path, ".meshes"), meshes,
        "different at both edges, so that `cutting` determines the depth")
    }
    return(list(deep = deep))
  }
  # The base is the wider edge of a wing. In other panels the omitted edge is the narrower one.
  value <- if (missing == "base") {
    meshes$tip + loss * meshes$deep
  } else {
    other <- setdiff(c(narrow, wide), missing)
    meshes[[other]] - loss * meshes$deep
  }
  if (value < -1e-9) {
    abort_field(paste0(path, ".cutting"), rate, sprintf(
      "a smaller rate, so that meshes remain at the other edge: over %s rows it removes %s from %s",
      displayed_count(meshes$deep), displayed_count(loss * meshes$deep),
      displayed_count(meshes[[setdiff(c(narrow, wide), missing)]])
    ), is = paste("is", rate))
  }
  stats::setNames(list(max(0, value)), missing)
}

given_orientation <- function(given) first_of(given$orientation, "diamond")

show_cutting <- function(cutting) {
  if (is_text(cutting)) return(cutting)
  paste(names(cutting), unlist(cutting), collapse = ", ")
}

# Returns the meshes across that the left and right edge each lose per mesh of depth.
cutting_slopes <- function(given, path, one_edge = FALSE) {
  path <- paste0(path, ".cutting")
  orientation <- given_orientation(given)
  slope <- function(rate, at) cutting_slope(rate, at, orientation)
  if (is_map(given$cutting)) {
    if (one_edge) abort_field(path, given$cutting, "one rate, for the inner edge of the wing")
    return(c(
      left = slope(first_of(given$cutting$left, "AN"), paste0(path, ".left")),
      right = slope(first_of(given$cutting$right, "AN"), paste0(path, ".right"))
    ))
  }
  each <- slope(given$cutting, path)
  if (one_edge) return(c(left = each, right = 0))
  switch(first_of(given$tapered, "both"),
    both = c(left = each, right = each), left = c(left = each, right = 0),
    right = c(left = 0, right = each)
  )
}

# Returns the meshes that a panel loses along its left and right edges (negative: gains).
edge_losses <- function(panel, path) {
  loss <- panel$meshes$upper - panel$meshes$lower
  if (!is.null(panel$lost)) {
    lost <- c(left = panel$lost$left, right = panel$lost$right)
    if (abs(sum(lost) - loss) > 1e-6) {
      abort_field(paste0(path, ".lost"), sum(lost),
        paste("in total the difference of the upper and the lower count,", displayed_count(loss)))
    }
    return(lost)
  }
  left <- if (!is_map(panel$cutting)) {
    switch(panel$tapered, both = 0.5, left = 1, right = 0)
  } else {
    slopes <- cutting_slopes(panel, path)
    if (sum(slopes) == 0) 0.5 else slopes[["left"]] / sum(slopes)
  }
  loss * c(left = left, right = 1 - left)
}

# Applies a take-up ratio: "2:3" joins two meshes of the section ahead to three of this section.
# `before`: meshes across the rear edge of the section ahead, NULL for the first section.
taken_up <- function(section, before, path) {
  path <- paste0(path, ".take_up")
  if (is.null(before)) abort_field(path, section$take_up, "omitted in the first section")
  ratio <- as.double(strsplit(section$take_up, ":", fixed = TRUE)[[1]])
  due <- before * ratio[2] / ratio[1]
  given <- section$meshes$upper
  if (!is.null(given) && abs(given - due) > rounded_meshes) {
    abort_field(path, section$take_up, sprintf(
      "a ratio that joins %s meshes to the %s meshes of the section ahead; this one needs %s",
      displayed_count(given), displayed_count(before), displayed_count(due)
    ), is = paste("is", section$take_up))
  }
  if (is.null(given)) section$meshes$upper <- due
  section
}

# TRUE if a tree has a field of this name at any depth. The search is breadth-first.
has_field <- function(tree, name) {
  while (length(tree)) {
    if (name %in% names(tree)) return(TRUE)
    tree <- unlist(unname(tree[vapply(tree, is.list, NA)]), recursive = FALSE)
  }
  FALSE
}

# Replaces `rtex` of each twine by its mass per length. A twine without a diameter gets the diameter
# that its material has at this mass.
twines_by_weight <- function(tree, own, path) {
  if (!is.list(tree)) return(tree)
  if (!is.null(tree$rtex) && is.null(tree$twine)) return(twine_by_weight(tree, own, path))
  keys <- if (is.null(names(tree))) seq_along(tree) else names(tree)
  for (k in seq_along(tree)) {
    if (is.list(tree[[k]])) tree[[k]] <- twines_by_weight(tree[[k]], own, join(path, keys[k]))
  }
  tree
}

twine_by_weight <- function(twine, own, path) {
  if (!is.null(twine$mass_per_length)) {
    abort_both(path, "rtex", "mass_per_length", twine$rtex, join(path, "rtex"))
  }
  # tex is g/km
  mass <- twine$rtex * 1e-6
  if (is.null(twine$diameter)) {
    if (is.null(twine$material)) {
      abort_field(join(path, "diameter"), NULL, "given, or `rtex` with a `material`", "is missing")
    }
    material <- find_material(twine$material, own, join(path, "material"))
    twine$diameter <- sqrt(mass / material[["mass"]])
  }
  twine$mass_per_length <- mass
  twine[names(twine) != "rtex"]
}
