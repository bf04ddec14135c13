# Mesh counts, cutting rates and twines as drawings have them: what a plan leaves out because the
# rest of the drawing gives it.

# The groups of a plan that its counts are found from.
count_groups <- c("panels", "wings", "square", "sections", "materials")

# A plan with its counts and twines complete. fields: checked, in SI; plan: as given; twines:
# whether it may have some by weight, as what a short form stands for has not.
# Returns list(fields, plan, derived), both trees with the same numbers put in; derived: these by
# path.
complete_counts <- function(fields, plan, twines = TRUE) {
  done <- list(fields = fields, plan = plan, derived = numeric())
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
      # another rate leaves another width behind
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

# The tree with a value at a path, given step by step.
put_in <- function(tree, path, value) {
  if (!length(path)) return(value)
  tree <- as.list(tree)
  tree[[path[1]]] <- put_in(tree[[path[1]]], path[-1], value)
  tree
}

# What a net maker's rounding may do: a mesh at each edge that is cut.
rounded_meshes <- 1

# The counts that a panel's cutting rate gives, by name: none, or the one that is left out.
# given: checked fields of the panel, with `meshes`, `cutting` and `tapered`. The narrow edge is the
# one that is found where it is not known which of the two is.
complete_meshes <- function(given, path, narrow = "upper", wide = "lower") {
  meshes <- given$meshes
  counts <- c(narrow, wide, "deep")
  missing <- setdiff(counts, names(meshes))
  if (is.null(given$cutting)) {
    if (!length(missing)) return(NULL)
    abort_field(paste0(path, ".meshes.", missing[1]), NULL,
      "given, or found by `cutting` from the other two counts", "is missing")
  }
  slopes <- cutting_slopes(given, path, one_edge = narrow == "tip")
  loss <- sum(slopes)
  if (length(missing) > 1L) {
    abort_field(paste0(path, ".meshes.", missing[1]), NULL,
      "given: `cutting` finds one count from the other two", "is missing")
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
          "a rate that takes off %s meshes in %s deep, within a mesh at each edge, such as %s; it",
          "takes off %s"
        ),
        shown_count(lost), shown_count(meshes$deep), fits, shown_count(due)
      ), is = paste("is", rate))
    }
    return(NULL)
  }
  if (missing == "deep") {
    if (loss == 0) {
      abort_field(paste0(path, ".meshes.deep"), NULL,
        sprintf("given where the edges are cut %s", rate), "is missing")
    }
    deep <- abs(meshes[[wide]] - meshes[[narrow]]) / loss
    if (deep == 0) {
      abort_field(paste0(path, ".meshes"), meshes,
        "of unlike widths, or `cutting` finds no depth from them")
    }
    return(list(deep = deep))
  }
  # of a wing the base is the wider edge; of other panels the one that is left out is the narrower
  value <- if (missing == "base") {
    meshes$tip + loss * meshes$deep
  } else {
    other <- setdiff(c(narrow, wide), missing)
    meshes[[other]] - loss * meshes$deep
  }
  if (value < -1e-9) {
    abort_field(paste0(path, ".cutting"), rate, sprintf(
      "a rate that leaves meshes at the other edge: in %s deep it takes off %s of %s",
      shown_count(meshes$deep), shown_count(loss * meshes$deep),
      shown_count(meshes[[setdiff(c(narrow, wide), missing)]])
    ), is = paste("is", rate))
  }
  stats::setNames(list(max(0, value)), missing)
}

given_orientation <- function(given) first_of(given$orientation, "diamond")

shown_count <- function(x) shortest_decimal(round(x, 2))

show_cutting <- function(cutting) {
  if (is_text(cutting)) return(cutting)
  paste(names(cutting), unlist(cutting), collapse = ", ")
}

# Meshes across that a panel's left and right edge lose in a mesh down.
cutting_slopes <- function(given, path, one_edge = FALSE) {
  path <- paste0(path, ".cutting")
  orientation <- given_orientation(given)
  slope <- function(rate, at) cutting_slope(rate, at, orientation)
  if (is_map(given$cutting)) {
    if (one_edge) abort_field(path, given$cutting, "one rate, of the inner edge of the wing")
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

# Share of the difference between upper and lower edge that the left one takes.
left_taper <- function(panel, path) {
  if (!is_map(panel$cutting)) return(switch(panel$tapered, both = 0.5, left = 1, right = 0))
  slopes <- cutting_slopes(panel, path)
  if (sum(slopes) == 0) 0.5 else slopes[["left"]] / sum(slopes)
}

# take_up "2:3": two meshes of the section ahead to three of this one.
# before: meshes of the section ahead across its rear edge, NULL of the first.
taken_up <- function(section, before, path) {
  path <- paste0(path, ".take_up")
  if (is.null(before)) abort_field(path, section$take_up, "left out of the first section")
  ratio <- as.double(strsplit(section$take_up, ":", fixed = TRUE)[[1]])
  due <- before * ratio[2] / ratio[1]
  given <- section$meshes$upper
  if (!is.null(given) && abs(given - due) > rounded_meshes) {
    abort_field(path, section$take_up, sprintf(
      "such that %s meshes are joined to the %s of the section ahead; it needs %s",
      shown_count(given), shown_count(before), shown_count(due)
    ), is = paste("is", section$take_up))
  }
  if (is.null(given)) section$meshes$upper <- due
  section
}

# Whether a tree has a field of this name anywhere. All fields of one depth are looked through
# together.
has_field <- function(tree, name) {
  while (length(tree)) {
    if (name %in% names(tree)) return(TRUE)
    tree <- unlist(unname(tree[vapply(tree, is.list, NA)]), recursive = FALSE)
  }
  FALSE
}

# Every twine with its Rtex as mass per length, and with the diameter that its material has at that
# mass where it has none.
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
    abort_plan(
      sprintf("Plan field `%s` has both `rtex` and `mass_per_length`; it must have one of them.",
        path),
      join(path, "rtex"), twine$rtex
    )
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
