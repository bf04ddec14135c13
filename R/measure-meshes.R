# How far the meshes of a net stand open, and what its twine covers of the flow.

# Meshes at every place on the rows of panels (panel_rows()), as the netting between rows stands.
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
  lattice <- state$lattice
  frame <- if (lattice$nodes > most_remembered_nodes) mesh_frame else mesh_frame_again
  at <- frame(
    panel_table(state$si$panels)[panel_shape_fields], match(names, base::names(state$si$panels)),
    lattice[c("nodes", "division", "panels")]
  )
  all <- between_places(state_points(state), at$rows)
  x <- all[, at$kept, drop = FALSE]
  step <- function(from, to) x[, to, drop = FALSE] - x[, from, drop = FALSE]
  long <- function(x) sqrt(x[1L, ]^2 + x[2L, ]^2 + x[3L, ]^2)
  each <- function(x) rep(x, each = 3L)

  # Along a row: to the neighbours on both sides.
  opening <- (long(step(at$before, at$place)) + long(step(at$place, at$after))) * at$per_mesh
  x_i <- step(at$before, at$after) * each(at$per_mesh)
  # Where the row bends the bars follow it.
  straight <- long(x_i)
  bent <- opening / pmax(straight, 1e-300)
  bent[straight == 0] <- 1
  x_i <- x_i * each(bent)

  # Between rows: from the one above to the one below, at the same share of the width. Down a column
  # i changes with j where the panel tapers.
  x_t <- (values_on_rows(all, at$below) - values_on_rows(all, at$above)) * each(at$per_row)
  x_j <- x_t - x_i * each(at$slant)

  u <- (x_j * each(!at$square) + x_i) * each(at$half)
  v <- (x_j - x_i * each(!at$square)) * each(at$half)
  # Of diamonds u leans one way and v the other; of squares they are across and down.
  cosine <- (u[1L, ] * v[1L, ] + u[2L, ] * v[2L, ] + u[3L, ] * v[3L, ]) / (long(u) * long(v))
  angle <- acos(pmin(pmax(cosine, -1), 1))
  angle[at$turned] <- pi - angle[at$turned]
  angle[!is.finite(cosine)] <- NA
  list2DF(c(
    at[c("panel", "row", "s", "t")], list(opening = opening, depth = long(x_j), angle = angle),
    at[c("meshes", "port", "starboard", "fore", "aft")],
    list(
      u_x = u[1, ], u_y = u[2, ], u_z = u[3, ], v_x = v[1, ], v_y = v[2, ], v_z = v[3, ],
      x = x[1, ], y = x[2, ], z = x[3, ]
    )
  ))
}

# What mesh_places() needs of a lattice (list(nodes, division, panels)) whatever its shape. panels:
# the table of all, no more of it than where their meshes lie; numbers: of those asked for.
mesh_frame <- function(panels, numbers, lattice) {
  rows <- row_places(panels, lattice)
  kept <- which(rows$panel[rows$row] %in% numbers)
  row <- rows$row[kept]
  s <- rows$s[kept]
  panel <- rows$panel[row]
  own <- pick_panels(panels, panel)
  t <- rows$t[row]
  across <- own$upper + (own$lower - own$upper) * t

  place <- seq_along(row)
  before <- pmax(place - 1L, 1L)
  before[row[before] != row] <- place[row[before] != row]
  after <- pmin(place + 1L, length(row))
  after[row[after] != row] <- place[row[after] != row]
  lost <- s[after] - s[before]

  count <- length(rows$panel)
  number <- seq_len(count)
  above <- pmax(number - 1L, 1L)
  above[rows$panel[above] != rows$panel] <- number[rows$panel[above] != rows$panel]
  below <- pmin(number + 1L, count)
  below[rows$panel[below] != rows$panel] <- number[rows$panel[below] != rows$panel]
  at <- function(other) rows_at(list(panel = panel, s = s, t = rows$t[other][row]), rows)
  deep <- (rows$t[below] - rows$t[above])[row] * own$deep
  # Each place stands for half the way to its neighbours.
  fore <- ((rows$t[above] - rows$t) / 2)[row] * own$deep
  aft <- ((rows$t[below] - rows$t) / 2)[row] * own$deep
  square <- is_square(own)
  list(
    rows = rows[c("from", "to", "share")], kept = kept,
    panel = panel, row = row, s = s, t = t, place = place, before = before, after = after,
    per_mesh = 1 / pmax(lost * across, 1e-12), above = at(above), below = at(below),
    per_row = 1 / pmax(deep, 1e-12),
    slant = panel_left(own, 1) + s * (panel_right(own, 1) - panel_left(own, 1) -
      (panel_right(own, 0) - panel_left(own, 0))),
    square = square, half = ifelse(square, 1, 0.5), turned = own$orientation == "turned",
    meshes = lost / 2 * across * (aft - fore), port = (s[before] - s) / 2 * across,
    starboard = (s[after] - s) / 2 * across, fore = fore, aft = aft
  )
}

# Settled shapes of one lattice have it in common.
mesh_frame_again <- remembered(mesh_frame)

# Mean over the meshes of panels, SI.
mean_of_meshes <- function(state, panels, field) {
  found <- mesh_places(state, panels)
  known <- !is.na(found[[field]]) & found$meshes > 0
  sum((found[[field]] * found$meshes)[known]) / sum(found$meshes[known])
}

define_measure("mesh_opening", "mm",
  "How wide the meshes of panels stand across them, the mean over their meshes: of diamonds from
  knot to knot, 0 where they are closed; of square meshes the distance of their bars.",
  sensor = "A camera in the net, with a scale.",
  asks_panels, function(state, measure) mean_of_meshes(state, measure$panels, "opening")
)

define_measure("mesh_angle", "deg",
  "Angle between the bars of the meshes of panels, the mean over their meshes: 0 where diamonds are
  closed across the panel, 90 deg in square meshes; of turned meshes it is measured across the
  panel.",
  sensor = "A camera in the net.",
  asks_panels, function(state, measure) mean_of_meshes(state, measure$panels, "angle")
)

# Area (m2) across the flow that the twine of a net hides: twine behind other twine counts once.
#
# A piece of netting that casts a shadow of the area A lets the share (1 - a_u / A) (1 - a_v / A) of
# it through, a_u and a_v the areas that its two families of bars show, and never less than a
# hundredth. Pieces one behind another let through the product of their shares: seen along the flow,
# twines of different pieces lie anyhow to each other. That is summed up over a grid across the flow
# whose cells are as large as the shadow of a place on the mean; each place is cut into 16 parts or
# so.
twine_shadow <- function(state) {
  found <- mesh_places(state)
  kept <- which(found$meshes > 0)
  if (!length(kept)) return(0)
  of <- function(field) found[[field]][kept]
  panels <- state$si$panels
  number <- of("panel")
  width <- vapply(panels, twine_width, 0)[number]
  square <- is_square(panel_table(panels))[number]
  # rows: across the flow, up
  seen <- t(flow_axes(state$si)[, c("across", "up")])
  seen_along <- function(fields) seen %*% rbind(of(fields[1]), of(fields[2]), of(fields[3]))
  u <- seen_along(c("u_x", "u_y", "u_z"))
  v <- seen_along(c("v_x", "v_y", "v_z"))
  # a mesh of diamonds is the parallelogram of two bars of each family, one of squares of one
  bars <- of("meshes") * (2 - square)
  area <- bars * abs(u[1L, ] * v[2L, ] - u[2L, ] * v[1L, ])
  through <- function(bar) {
    hidden <- bars * width * sqrt(bar[1L, ]^2 + bar[2L, ]^2) / pmax(area, 1e-12)
    hidden[hidden > 1] <- 1
    1 - hidden
  }
  depth <- -log(pmax(through(u) * through(v), 0.01)) * area

  # derivatives of the place by meshes across and down
  both <- rep(square, each = 2L)
  by_i <- u - v * !both
  by_j <- u * (!both) + v
  # parts as long across as they are deep, on the mean
  long <- function(by) sqrt(by[1L, ]^2 + by[2L, ]^2)
  reach <- rbind(of("port"), of("starboard"), of("fore"), of("aft"))
  wide <- mean(long(by_i) * (reach[2L, ] - reach[1L, ]))
  deep <- mean(long(by_j) * (reach[4L, ] - reach[3L, ]))
  ways <- max(1, min(16, round(4 * sqrt(wide / max(deep, 1e-9)))))
  shadow_area(seen_along(c("x", "y", "z")), by_i, by_j, reach, depth, as.integer(ways),
    as.integer(round(16 / ways)), sqrt(sum(area) / length(kept)))
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
#' row is a row of the lattice across a panel, from its front edge to its rear edge.
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
#' @seealso [plot.codend_mesh_openings()]; [measures()] for the mean of a panel; [swept()] for the
#'   water that passed the mouth.
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
  if (!is.null(parts) && !(is.character(parts) && length(parts) && all(parts %in% known))) {
    abort_argument("{.arg parts} is {.val {parts}}; it must be any of {.val {known}}.")
  }
  some <- names(panels)[is.null(parts) | names(panels) %in% parts | part %in% parts]
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
