# Bars and cells converge to each other under refinement. Cases: a tapered cone of four panels towed
# behind a frame with a catch at its end, and a sheet of netting between two ropes.

soft_twine <- list(diameter = 0.002, axial_stiffness = 200, mass_per_length = 0.003)

# The number of columns defines the mesh of a panel in both nettings; cells need rows as well.
resolved <- function(panel, netting, columns, rows) {
  panel$columns <- columns
  if (netting == "cells") panel$rows <- rows
  panel
}

cone <- function(netting, columns) {
  sides <- c("top", "starboard", "bottom", "port")
  corner <- list(c(0, -0.8, 0.8), c(0, 0.8, 0.8), c(0, 0.8, -0.8), c(0, -0.8, -0.8))
  of_sides <- function(f, prefix = "") stats::setNames(lapply(1:4, f), paste0(prefix, sides))
  as_gear(list(
    codend = 1, name = "Cone", netting = netting,
    water = list(current = list(speed = 1, toward = 0)),
    points = of_sides(function(k) {
      list(at = paste0(sides[k], ".upper_left"), position = corner[[k]], held = "fixed")
    }),
    # stretched by 2 %, so that each is a bar of a nearly rigid frame
    ropes = of_sides(function(k) {
      list(along = list(paste0(sides[k], ".upper")), length = 1.6 * 0.98, diameter = 0.01,
        axial_stiffness = 3e5, mass_per_length = 0.1)
    }, "frame_"),
    panels = of_sides(function(k) {
      resolved(list(
        mesh_size = 0.05, meshes = list(upper = 96, lower = 48, deep = 96), twine = soft_twine
      ), netting, columns, 2 * columns)
    }),
    seams = of_sides(function(k) {
      list(edges = list(paste0(sides[k], ".right"), paste0(sides[k %% 4 + 1], ".left")))
    }, "side_"),
    pieces = list(catch = list(along = as.list(paste0(sides, ".lower")), drag_area = 1))
  ))
}

sheet <- function(netting, columns) {
  held <- function(at, y, z) list(at = at, position = c(0, y, z), held = "fixed")
  lace <- function(edge) {
    list(along = list(edge), length = 2.2, diameter = 0.01, axial_stiffness = 1e5,
      mass_per_length = 0.1)
  }
  as_gear(list(
    codend = 1, name = "Sheet", netting = netting,
    water = list(current = list(speed = 0.5, toward = 0)),
    points = list(
      a = held("net.upper_left", -1, -1), b = held("net.upper_right", 1, -1),
      c = held("net.lower_left", -1, -3), d = held("net.lower_right", 1, -3)
    ),
    ropes = list(upper = lace("net.upper"), lower = lace("net.lower")),
    panels = list(net = resolved(list(
      mesh_size = 0.05, meshes = list(upper = 96, lower = 96, deep = 48), twine = soft_twine,
      bar_segments = 1
    ), netting, columns, columns / 2))
  ))
}

# Difference of the two nettings at every resolution: relative drag of the netting, relative largest
# rope tension, and the position of one node (m).
differences <- function(build, columns, place) {
  found <- lapply(columns, function(n) {
    each <- lapply(c("cells", "bars"), function(netting) {
      state <- settle(build(netting, n))
      drag <- as.data.frame(state, what = "drag")
      tension <- summary(state)$tensions
      list(
        drag = sum(drag$drag_kN[drag$kind == "netting"]),
        tension = max(tension$max_kN[tension$kind == "rope"]),
        place = rowMeans(vapply(place, function(p) {
          state$position[, nodes_at(state, p)] * c(1, 0, 0)
        }, numeric(3)))
      )
    })
    a <- each[[1]]
    b <- each[[2]]
    c(
      drag = abs(a$drag / b$drag - 1), tension = abs(a$tension / b$tension - 1),
      place = sqrt(sum((a$place - b$place)^2))
    )
  })
  do.call(cbind, found)
}

# Slope of log difference over log columns, over all resolutions.
slope <- function(difference, columns) {
  -stats::coef(stats::lm(log(difference) ~ log(columns)))[[2]]
}

test_that("cells and bars converge to each other on a tapered cone", {
  columns <- c(8, 16, 24)
  found <- differences(cone, columns, c("top.lower_left", "bottom.lower_left"))
  # both are first order in the mesh size; 0.8 allows for discrete grouping
  expect_gt(slope(found["drag", ], columns), 0.8)
  expect_gt(slope(found["place", ], columns), 0.8)
  # a quarter of a percent of drag on either side of the limit, and less than a quarter percent of
  # 4.6 m of length
  expect_lt(found["drag", 3], 0.005)
  expect_lt(found["place", 3], 0.003)
  # the frame's own stretch causes nearly all of its tension
  expect_lt(found["tension", 3], 5e-4)
})

test_that("bars end on slanted sides at the ends of their twines", {
  # Distance of bars from their twines in position and length, in equivalent bars, for a panel with
  # this shape and twine.
  misfit <- function(upper, lower, deep, columns, orientation = "diamond") {
    si <- gear_si(as_gear(list(
      codend = 1, name = "Slanted panel", netting = "bars",
      points = list(nail = list(at = "net.upper_left", position = c(0, 0, 0), held = "fixed")),
      panels = list(net = list(
        mesh_size = 0.1, meshes = list(upper = upper, lower = lower, deep = deep),
        columns = columns, orientation = orientation, knotted = FALSE,
        twine = list(diameter = 0.002, axial_stiffness = 1e3, mass_per_length = 0.01)
      ))
    )))
    mesh <- build_mesh(si)
    net <- panel_of(mesh, "net")
    bars <- engine_array(mesh, "bars")
    # knots by their numbers among all points; several knots tied to one node cannot be
    # distinguished
    node <- point_number(net$node, engine_array(mesh, "nodes"))
    end <- matrix(match(bars$node, node), 2L)
    shared <- matrix(bars$node %in% node[duplicated(node)], 2L)
    known <- !is.na(colSums(end)) & !colSums(shared)
    end <- end[, known, drop = FALSE]
    i <- net$i[end[2L, ]] - net$i[end[1L, ]]
    j <- net$j[end[2L, ]] - net$j[end[1L, ]]
    along <- if (orientation == "square") abs(rbind(i, j)) else abs(rbind(i + j, j - i))
    longest <- pmax(along[1L, ], along[2L, ])
    pmax(longest - bars$rest[known] / 0.05, pmin(along[1L, ], along[2L, ])) / net$lambda
  }
  # whole meshes, sides between meshes, steep sides
  for (case in list(c(4, 4, 4, 4), c(40, 40, 30, 7), c(40, 10, 15, 9), c(60, 0, 30, 12))) {
    expect_lt(max(misfit(case[1], case[2], case[3], case[4])), 1e-12)
  }
  expect_lt(max(misfit(40, 40, 30, 7, "square")), 1e-12)
  # A twine nearly parallel to its side ends at a knot that was moved onto the side: few twines do.
  slanted <- misfit(60, 15, 120, 23)
  expect_lt(mean(slanted > 1e-12), 0.02)
})

test_that("cells and bars converge to each other on a partly slack sheet", {
  found <- differences(sheet, c(8, 16, 32), c("upper.middle", "lower.middle"))
  expect_true(all(diff(found["place", ]) < 0))
  expect_lt(found["place", 3], 0.01)
  # On the coarsest mesh, slack bars resist twist more than slack cells.
  expect_lt(found["drag", 1], 0.04)
  expect_lt(max(found["drag", -1]), 0.01)
})
