# How far the meshes of a net stand open, and what its twine covers of the flow.

# Meshes at every place on the rows of panels, as the netting between rows stands.
#
# With x_i and x_j the derivatives of position by meshes across and by meshes down a panel, a mesh
# of diamonds has the bars (x_j + x_i) / 2 and (x_j - x_i) / 2, one of squares the bars x_i and x_j.
#
# Returns a data frame with a row per place: panel (number), row, s and t (shares of the panel's
# width and depth), x, y and z (m),
# opening (m: |x_i|, how wide a mesh stands across the panel; of squares the distance of its bars),
# depth (m, |x_j|), angle (rad, between the bars of a mesh, 0 where it is closed across the panel;
# NA where a bar has no length), meshes (how many the place stands for, from `port` to `starboard`
# across and from `fore` to `aft` down the panel, in meshes from the place), and for each family of
# bars its vector of one bar: u_x, u_y, u_z, v_x, v_y, v_z (m).
mesh_places <- function(state, names = base::names(state$si$panels)) {
  at <- state$lattice$mesh$frame$meshes
  found <- engine_mesh_places(state$lattice$mesh, as.double(state_points(state)))
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

# Solidity of panels by name as they stand, on the mean of their netting: twine, crossings of
# knotless netting once, and knots, over the area of the netting.
solidity_of_panels <- function(state, names) {
  found <- mesh_places(state, names)
  bar <- function(family) as.matrix(found[paste0(family, c("_x", "_y", "_z"))])
  u <- bar("u")
  v <- bar("v")
  uu <- rowSums(u^2)
  vv <- rowSums(v^2)
  # as twine_shadow() counts bars and area
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
  stats::setNames(twine - overlap * twine^2 + knots, names)
}

#' Meshes along a net
#'
#' How far the meshes are open along every panel: what decides which fish pass through them. Each
#' row is a row of the model across a panel, from its front edge to its rear edge.
#'
#' Of diamond meshes the opening is the distance of the knots across the panel and the angle that
#' between two bars, so that opening = mesh size times sin(angle / 2) where the twine is taut; of
#' square meshes the opening is the distance of the bars. Hexagonal meshes are taken as diamonds of
#' their cells. The edge of a codend that is gathered has opening 0.
#'
#' For a model of selection take the codend's rows: `mesh_openings(state, "codend")` has the mean,
#' the least and the greatest opening by distance from its rear end.
#'
#' @param state A state, from [settle()] or [state_at()].
#' @param parts Names of panels or of parts of the net (`"codend"`, `"section_3"`), or `NULL` for
#'   all. An unknown one is an error of class `codend_error_argument`.
#' @return A data frame of class `codend_mesh_openings` with a row per row of a panel: `panel`,
#'   `part`, `meshes_from_front`, `from_front_m` and `from_rear_m` (along the netting), `x_m`,
#'   `depth_m` (middle of the row), `meshes_across`, `mesh_size_mm`, `mesh_opening_mm` (mean),
#'   `least_opening_mm`, `greatest_opening_mm`, `opening_percent` (mean opening over mesh size, of
#'   square meshes over a bar), `mesh_angle_deg` (mean).
#' @seealso [codend_charts]; [measures()] for the mean of a panel;
#'   [as.data.frame()][as.data.frame.codend_trajectory] of a tow for the water that passed the
#'   mouth.
#' @export
#' @examples
#' state <- settle("t90_codend")
#' head(mesh_openings(state))
mesh_openings <- function(state, parts = NULL) {
  check_given("state")
  check_is_state(state)
  panels <- state$si$panels
  part <- vapply(panels, `[[`, "", "part")
  known <- unique(c(names(panels), part[!is.na(part)]))
  if (!length(panels)) abort_argument("The gear has no netting.")
  parts <- chosen_some(parts, known)
  some <- names(panels)[names(panels) %in% parts | part %in% parts]
  found <- mesh_places(state, some)
  by_row <- split(seq_len(nrow(found)), found$row)
  mean_of <- function(field, weight = found$meshes) {
    vapply(by_row, function(k) {
      good <- !is.na(found[[field]][k])
      # a row at a point has no meshes
      w <- if (sum(weight[k][good]) > 0) weight[k][good] else rep(1, sum(good))
      if (any(good)) sum(found[[field]][k][good] * w) / sum(w) else NA_real_
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
