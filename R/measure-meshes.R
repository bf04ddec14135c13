# Opening of meshes and solidity of netting.

# Returns a data frame: one row per sampling point on the rows of each panel, interpolated in the
# deformed netting.
#
# Notation: x_i and x_j are derivatives of position by meshes across and down the panel. The bars of
# a diamond mesh are (x_j + x_i) / 2 and (x_j - x_i) / 2; the bars of a square mesh are x_i and x_j.
#
# `panel`: number of the panel; `row`: number of the row.
# `s`, `t`: fractions of the panel's width and depth. `x`, `y`, `z`: position [m].
# `opening`: |x_i| [m], for square meshes the bar distance. `depth`: |x_j| [m].
# `angle`: between the bars of a mesh [rad]; 0 if closed across, NA if a bar has no length.
# `meshes`: number of meshes that the point represents.
# `port`, `starboard`, `fore`, `aft`: extent of this area, in meshes from the point.
# `u_x` to `v_z`: bar vectors of both families [m].
mesh_places <- function(state, names = base::names(state$si$panels)) {
  at <- state$mesh$model$frame$meshes
  found <- engine_mesh_places(state$mesh$model, as.double(state_points(state)))
  found$angle[is.nan(found$angle)] <- NA
  panel <- at$row_panel[at$row + 1L]
  all <- list2DF(c(
    list(panel = panel, row = at$row + 1L, s = at$s, t = at$row_t[at$row + 1L]),
    found[c("opening", "depth", "angle")], at[c("meshes", "port", "starboard", "fore", "aft")],
    found[c("u_x", "u_y", "u_z", "v_x", "v_y", "v_z", "x", "y", "z")]
  ))
  kept <- panel %in% match(names, base::names(state$si$panels))
  if (all(kept)) all else list2DF(lapply(all, `[`, kept))
}

# Returns the mean solidity of the named panels in the deformed shape. Twine counts crossings of
# knotless netting once; knots are added.
solidity_of_panels <- function(state, names) {
  found <- mesh_places(state, names)
  bar <- function(family) as.matrix(found[paste0(family, c("_x", "_y", "_z"))])
  u <- bar("u")
  v <- bar("v")
  uu <- rowSums(u^2)
  vv <- rowSums(v^2)
  # same count of bars and area as twine_shadow()
  cells <- found$meshes * (2 - is_square(panel_table(state$si$panels))[found$panel])
  sums <- rowsum(
    cbind(
      area = cells * sqrt(pmax(uu * vv - rowSums(u * v)^2, 0)),
      bars = cells * (sqrt(uu) + sqrt(vv)), cells = cells
    ),
    found$panel
  )
  sums <- sums[as.character(match(names, base::names(state$si$panels))), , drop = FALSE]
  panels <- state$si$panels[names]
  of <- function(what) vapply(panels, what, 0)
  twine <- sums[, "bars"] * of(twine_width) / sums[, "area"]
  knots <- sums[, "cells"] * pi / 4 * of(function(panel) panel$knot_diameter^2) / sums[, "area"]
  overlap <- of(crossing_overlap)
  # Closed meshes are solid: the covered fraction does not decrease again.
  twine <- pmin(twine, 0.5 / overlap)
  stats::setNames(pmin(twine - overlap * twine^2 + knots, 1), names)
}

# Returns the table "mesh_openings" of a state; `parts`: panels or parts of the net, or NULL for
# all.
mesh_opening_table <- function(state, parts = NULL) {
  panels <- state$si$panels
  part <- vapply(panels, `[[`, "", "part")
  known <- unique(c(names(panels), part[!is.na(part)]))
  if (!length(panels)) abort_argument("The gear has no netting.")
  parts <- chosen_some(parts, known)
  some <- names(panels)[names(panels) %in% parts | part %in% parts]
  found <- mesh_places(state, some)
  by_row <- split(seq_len(nrow(found)), found$row)
  mean_of <- function(field) {
    vapply(by_row, function(k) {
      k <- k[!is.na(found[[field]][k])]
      # a row that is gathered in a point has no meshes
      weight <- if (sum(found$meshes[k]) > 0) found$meshes[k] else rep(1, length(k))
      if (length(k)) stats::weighted.mean(found[[field]][k], weight) else NA_real_
    }, 0, USE.NAMES = FALSE)
  }
  first <- vapply(by_row, `[`, 0L, 1L, USE.NAMES = FALSE)
  number <- found$panel[first]
  of <- function(field) vapply(panels, `[[`, 0, field, USE.NAMES = FALSE)[number]
  j <- found$t[first] * of("deep")
  depth <- mean_of("depth")
  gap <- (depth + c(0, depth[-length(depth)])) / 2 * c(0, diff(j))
  from_front <- stats::ave(ifelse(c(TRUE, diff(number) != 0), 0, gap), number, FUN = cumsum)
  whole <- stats::ave(from_front, number, FUN = max)
  mesh <- of("mesh_size")
  square <- is_square(panel_table(panels))[number]
  opening <- mean_of("opening")
  mm <- function(x) in_unit(x, "mm")
  structure(
    data.frame(
      panel = names(panels)[number], part = ifelse(is.na(part), "", part)[number],
      meshes_from_front = j, from_front_m = from_front, from_rear_m = whole - from_front,
      x_m = mean_of("x"), depth_m = -mean_of("z"),
      meshes_across = of("upper") + (of("lower") - of("upper")) * found$t[first],
      mesh_size_mm = mm(mesh), mesh_opening_mm = mm(opening),
      least_opening_mm = mm(vapply(by_row, function(k) min(found$opening[k]), 0)),
      greatest_opening_mm = mm(vapply(by_row, function(k) max(found$opening[k]), 0)),
      opening_percent = 100 * opening / (mesh / (1 + square)),
      mesh_angle_deg = in_unit(mean_of("angle"), "deg"), row.names = NULL
    ),
    class = c("codend_mesh_openings", "data.frame"), gear_name = state$gear$plan$name,
    conditions = state_conditions(state)
  )
}
