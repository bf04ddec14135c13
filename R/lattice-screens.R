# What netting of triangles carries besides its twines: drag as a screen, and stiffness of its
# meshes.

# The laws of netting whose drag is a screen's.
screen_laws <- function() c("loland", "aarsnes", "kristiansen_faltinsen")

# Netting that must be of triangles: as a screen, with an opening stiffness, or around a catch.
# bars: which panels are of bars.
check_triangles_needed <- function(si, bars) {
  of_bars <- names(si$panels)[bars]
  needed <- function(names, why) {
    wrong <- intersect(names, of_bars)
    if (!length(wrong)) return(invisible())
    abort_plan(
      paste0("Panel `", wrong[1], "` is of bars; ", why, " needs triangles as its `netting`."),
      paste0("panels.", wrong[1], ".netting"), "bars"
    )
  }
  screens <- vapply(si$panels, function(p) p$netting_drag != "twines", NA)
  stiff <- vapply(si$panels, function(p) !is.null(p$opening_stiffness), NA)
  needed(names(si$panels)[screens], "its `netting_drag`")
  needed(names(si$panels)[stiff], "its `opening_stiffness`")
  needed(si$catch$panels, "the catch")
}

# The panel of every triangle, by its number in si$panels.
triangle_panel <- function(si, lattice) lattice$triangle_part - length(si$ropes)

# The lattice's triangles whose `netting_drag` is one of these.
triangles_with_drag <- function(si, lattice, drag) {
  which((vapply(si$panels, `[[`, "", "netting_drag") %in% drag)[triangle_panel(si, lattice)])
}

# As NettingScreens.
screen_elements <- function(si, lattice) {
  triangles <- lattice$engine$triangles
  some <- lattice$on_triangle$screens
  panel <- triangle_panel(si, lattice)[some]
  number <- function(field) vapply(si$panels, `[[`, 0, field, USE.NAMES = FALSE)[panel]
  cells <- triangle_bars(triangles, some)
  width <- vapply(si$panels, twine_width, 0, USE.NAMES = FALSE)[panel]
  twine <- cells * (number("mesh_size") - number("straight_bar")) * width
  knots <- cells * (1 + (number("straight_bar") > 0))
  list(
    node = triangles$node[corners_of(some)],
    twine_area = twine + knots * pi / 4 * number("knot_diameter")^2,
    # of hexagonal netting bars meet and do not cross
    overlap = crossing_overlap(si$panels)[panel],
    # The law's Reynolds number is of one cylinder, also where two run side by side.
    diameter = number("twine_diameter"), height = triangles$height[some],
    multiplicity = triangles$multiplicity[some],
    law = vapply(si$panels, `[[`, "", "netting_drag", USE.NAMES = FALSE)[panel]
  )
}

# How much of its twine's share of the area each of some panels (a list) loses where its twines
# cross without a knot, over that share squared (see netting_screen.hpp). Bars of hexagons meet and
# do not cross.
crossing_overlap <- function(panels) {
  0.25 * vapply(panels, function(p) p$knot_diameter == 0 && p$straight_bar == 0, NA,
    USE.NAMES = FALSE)
}

# As BlendedNetting.
blended_elements <- function(si, lattice) {
  triangles <- lattice$engine$triangles
  panel <- triangle_panel(si, lattice)
  some <- lattice$on_triangle$blended
  panels <- if (length(some)) si$panels
  list(
    node = triangles$node[corners_of(some)],
    twine = triangles$twine[rep(6L * (some - 1L), each = 6L) + seq_len(6L)],
    rest = triangles$rest[some], multiplicity = triangles$multiplicity[some],
    height = triangles$height[some], overlap = crossing_overlap(si$panels)[panel[some]],
    material = as.integer(panel[some]), materials = twine_materials(panels, alone = FALSE)
  )
}

# list(node, twine, couple, angle, multiplicity), as MeshOpenings: twine coordinates in m.
opening_elements <- function(si, lattice) {
  triangles <- lattice$engine$triangles
  panel <- triangle_panel(si, lattice)
  stiffness <- lapply(si$panels, `[[`, "opening_stiffness")
  stiff <- !vapply(stiffness, is.null, NA)
  some <- which(stiff[panel])
  number <- function(field) {
    of <- numeric(length(stiff))
    of[stiff] <- vapply(stiffness[stiff], `[[`, 0, field, USE.NAMES = FALSE)
    of[panel[some]]
  }
  turned <- vapply(si$panels, `[[`, "", "orientation")[panel[some]] == "turned"
  angle <- number("angle")
  angle[turned] <- pi - angle[turned]
  list(
    node = triangles$node[corners_of(some)],
    twine = triangles$twine[rep(6L * (some - 1L), each = 6L) + seq_len(6L)] *
      rep(triangles$rest[some], each = 6L),
    couple = number("couple"), angle = angle,
    multiplicity = triangles$multiplicity[some] / triangles$rest[some]^2
  )
}

# Places of the corners of triangles in an array of three each.
corners_of <- function(triangle) rep(3L * (triangle - 1L), each = 3L) + seq_len(3L)

# The start with the inner nodes of hexagonal triangles where their bars would lie if all were
# stretched alike: from the triangle's middle along the mean of its two base vectors.
place_inner_nodes <- function(lattice) {
  start <- lattice$start
  triangles <- lattice$engine$triangles
  some <- which(triangles$inner > 0L)
  if (!length(some)) return(start)
  at <- 6L * (some - 1L)
  twine <- function(k) triangles$twine[at + k]
  corner <- function(k) start[, triangles$node[3L * (some - 1L) + k], drop = FALSE]
  u2 <- twine(3L) - twine(1L)
  v2 <- twine(4L) - twine(2L)
  u3 <- twine(5L) - twine(1L)
  v3 <- twine(6L) - twine(2L)
  d <- u2 * v3 - u3 * v2
  second <- corner(2L) - corner(1L)
  third <- corner(3L) - corner(1L)
  # e_u + e_v
  both <- second * rep((v3 - u3) / d, each = 3L) + third * rep((u2 - v2) / d, each = 3L)
  share <- triangles$straight[some] / (triangles$straight + triangles$rest)[some] / 2
  middle <- (corner(1L) + corner(2L) + corner(3L)) / 3
  start[, triangles$inner[some]] <- middle + both * rep(share, each = 3L)
  start
}
