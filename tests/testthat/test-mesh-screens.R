# Hexagonal netting, netting screens and stiff meshes: forces of panels in a known flat shape.

flat_net <- function(..., water = list()) {
  net <- list(
    mesh_size = 0.12, meshes = list(upper = 24, lower = 24, deep = 36), columns = 3, rows = 4,
    twine = list(diameter = 0.002, axial_stiffness = 1e5, mass_per_length = 0.004), knotted = FALSE
  )
  gear_si(as_gear(list(
    codend = 1, name = "Flat net", water = water,
    points = list(nail = list(at = "net.upper_left", position = c(0, 0, 0), held = "fixed")),
    panels = list(net = utils::modifyList(net, list(...)))
  )))
}

# Forces on the flat panel with cells `across` wide and `down` deep (m, of one mesh), at an angle to
# the flow along x (0: along it). `inner` is the offset of the inner nodes, as a fraction of the
# panel's depth.
lay_flat <- function(si, across, down, angle, speed = 0, inner = 0) {
  si$towing$speed <- speed
  mesh <- build_mesh(si)
  grid <- panel_of(mesh, "net")$grid
  cells <- engine_array(mesh, "cells")
  net <- si$panels$net
  s <- (row(grid) - 1) / (nrow(grid) - 1) * net$upper * across
  t <- (col(grid) - 1) / (ncol(grid) - 1) * net$deep * down
  x <- matrix(0, 3L, engine_array(mesh, "nodes"))
  way <- c(cos(angle), 0, -sin(angle))
  x[, grid] <- outer(way, as.vector(t)) + outer(c(0, 1, 0), as.vector(s))
  some <- cells$inner > 0
  corners <- matrix(cells$node, 4L)[, some, drop = FALSE]
  middle <- (x[, corners[1, ]] + x[, corners[2, ]] + x[, corners[3, ]]) / 3
  x[, cells$inner[some]] <- middle + way * inner
  c(list(x = x, mesh = mesh, si = si),
    engine_evaluate(engine_array(mesh), as.vector(x), numeric(length(x))))
}

# Returns the area of cells in twine coordinates (8 per cell: u and v of each corner).
twine_area <- function(twine) {
  at <- matrix(twine, 8L)
  abs((at[5, ] - at[1, ]) * (at[8, ] - at[4, ]) - (at[7, ] - at[3, ]) * (at[6, ] - at[2, ])) / 2
}

test_that("hexagonal netting has the twine, weight and drag of its bars", {
  straight <- 0.02
  oblique <- 0.04
  for (turned in c(FALSE, TRUE)) {
    si <- flat_net(orientation = if (turned) "hexagonal_turned" else "hexagonal",
      straight_bar = straight, coefficients = list(normal = 1.2, tangential = 0.1))
    # Bars at their own lengths: the straight ones down or across, the oblique ones at 30 degrees to
    # them.
    long <- 2 * (straight + oblique * cos(pi / 6))
    wide <- 2 * oblique * sin(pi / 6)
    angle <- 0.6
    flat <- if (turned) lay_flat(si, long, wide, angle, 0.7) else
      lay_flat(si, wide, long, angle, 0.7, inner = straight)
    if (turned) {
      inner <- engine_array(flat, "cells", "inner")
      flat$x[2, inner] <- flat$x[2, inner] + straight
      flat[c("forces", "straight_length", "u_length", "v_length")] <- engine_evaluate(
        engine_array(flat), as.vector(flat$x), numeric(length(flat$x))
      )[c("forces", "straight_length", "u_length", "v_length")]
    }
    expect_equal(range(flat$straight_length), rep(straight, 2), tolerance = 1e-12)
    expect_equal(range(flat$u_length, flat$v_length), rep(oblique, 2), tolerance = 1e-12)
    # 2 cells to a mesh, each with one straight and two oblique bars
    cells <- 24 * 36 * 2
    expect_equal(sum(engine_array(flat, "mass")), cells * 0.1 * 0.004, tolerance = 1e-12)
    down <- c(cos(angle), 0, -sin(angle))
    across <- c(0, 1, 0)
    if (turned) {
      along <- across
      aside <- down
    } else {
      along <- down
      aside <- across
    }
    bar <- function(axis, length) {
      u <- c(0.7, 0, 0)
      u_t <- sum(u * axis) * axis
      u_n <- u - u_t
      0.5 * 1025 * 0.002 * length * (1.2 * sqrt(sum(u_n^2)) * u_n + 0.1 * sqrt(sum(u_t^2)) * u_t)
    }
    wanted <- cells * (bar(along, straight) +
      bar(cos(pi / 6) * along + sin(pi / 6) * aside, oblique) +
      bar(cos(pi / 6) * along - sin(pi / 6) * aside, oblique))
    # the same sum in another order
    expect_equal(rowSums(matrix(flat$forces$cell_drag, 3L)), wanted, tolerance = 1e-11)
  }
})

test_that("stretched hexagonal netting carries a load along its bars", {
  # Gathered at both ends, all bars are parallel. Each of 12 straight bars across carries 1/12 of
  # the load, and each oblique bar 1/24. In air, without weight.
  plan <- list(
    codend = 1, name = "Bundle", water = list(density = 0),
    points = list(nail = list(position = c(0, 0, 0), held = "fixed"),
      load = list(load = c(0, 0, -1200))),
    panels = list(net = list(
      mesh_size = 0.12, meshes = list(upper = 12, lower = 12, deep = 20), columns = 2, rows = 4,
      orientation = "hexagonal", straight_bar = 0.02,
      twine = list(diameter = 0.002, axial_stiffness = 1e4, mass_per_length = 1e-9)
    )),
    seams = list(
      top = list(edges = list("net.upper"), gathered_at = "nail"),
      bottom = list(edges = list("net.lower"), gathered_at = "load")
    )
  )
  state <- settle(as_gear(plan))
  # the solver's tolerance of 1e-8, and the netting's weight of 1e-7 of the load
  expect_equal(range(state$straight_tension), c(100, 100), tolerance = 1e-6)
  expect_equal(range(state$u_tension, state$v_tension), c(50, 50), tolerance = 1e-6)
  stretched <- 20 * 2 * (0.02 * (1 + 100 / 1e4) + 0.04 * (1 + 50 / 1e4))
  expect_equal(-state$position[3, nodes_at(state, "load")], stretched, tolerance = 1e-7)
})

test_that("panel as a screen follows the formula at its real solidity", {
  ratio <- 0.5
  across <- 0.12 * ratio
  down <- 0.12 * sqrt(1 - ratio^2)
  area <- 24 * across * 36 * down
  for (knot in c(0, 0.006)) {
    knots <- if (knot > 0) list(knotted = TRUE, knot_diameter = knot) else list()
    twine <- 24 * 36 * (4 * 0.06 * 0.002 + 2 * pi / 4 * knot^2)
    # each of the 2 x 24 x 36 crossings without a knot hides a rhombus of the twine's width
    between <- 2 * asin(ratio)
    crossings <- if (knot > 0) 0 else 24 * 36 * 2 * 0.002^2 / sin(between)
    sn <- (twine - crossings) / area
    theta <- 1.1
    wanted <- list(
      # G. Loland (1991); J. V. Aarsnes et al. (1990)
      loland = c(0.04 + (-0.04 + 0.33 * sn + 6.54 * sn^2 - 4.88 * sn^3) * cos(theta),
        (-0.05 * sn + 2.3 * sn^2 - 1.76 * sn^3) * sin(2 * theta)),
      aarsnes = c(0.04 + (-0.04 + sn - 1.24 * sn^2 + 13.7 * sn^3) * cos(theta),
        (0.57 * sn - 3.54 * sn^2 + 10.1 * sn^3) * sin(2 * theta))
    )
    # below a solidity of 0.1 in proportion to it
    if (sn < 0.1) {
      s <- 0.1
      wanted$loland <- sn / s *
        c(0.04 + (-0.04 + 0.33 * s + 6.54 * s^2 - 4.88 * s^3) * cos(theta),
          (-0.05 * s + 2.3 * s^2 - 1.76 * s^3) * sin(2 * theta))
      wanted$aarsnes <- sn / s *
        c(0.04 + (-0.04 + s - 1.24 * s^2 + 13.7 * s^3) * cos(theta),
          (0.57 * s - 3.54 * s^2 + 10.1 * s^3) * sin(2 * theta))
    }
    for (law in names(wanted)) {
      si <- do.call(flat_net, c(list(netting_drag = law), knots))
      flat <- lay_flat(si, across, down, pi / 2 - theta, 0.7)
      expect_equal(sum(abs(flat$forces$cell_drag)) + sum(abs(flat$forces$sphere_drag)), 0)
      force <- rowSums(matrix(flat$forces$screen_force, 3L)) / (0.5 * 1025 * area * 0.7^2)
      # the normal that faces downstream points along x and up, so lift acts upwards
      expect_equal(force, c(wanted[[law]][1], 0, wanted[[law]][2]), tolerance = 1e-10)
    }
  }
})

test_that("blended drag changes from twines to the screen model and back", {
  force <- function(law, ratio, theta, diameter = 0.002) {
    si <- flat_net(netting_drag = law, twine = list(diameter = diameter),
      coefficients = "choo_casarella")
    flat <- lay_flat(si, 0.12 * ratio, 0.12 * sqrt(1 - ratio^2), pi / 2 - theta, 0.7)
    rowSums(matrix(unlist(flat$forces[c("cell_drag", "screen_force", "blended_force")]), 3L))
  }
  degrees <- pi / 180
  # the same sums in another order
  for (theta in c(0, 40, 59)) {
    expect_equal(force("blended", 0.4, theta * degrees), force("morison", 0.4, theta * degrees),
      tolerance = 1e-11)
  }
  for (theta in c(81, 88)) {
    expect_equal(force("blended", 0.4, theta * degrees),
      force("kristiansen_faltinsen", 0.4, theta * degrees), tolerance = 1e-11)
  }
  # a solidity of 4 / 3
  expect_equal(force("blended", 0.025, 85 * degrees), force("morison", 0.025, 85 * degrees),
    tolerance = 1e-11)
  between <- force("blended", 0.4, 70 * degrees)[1]
  ends <- c(force("morison", 0.4, 70 * degrees)[1],
    force("kristiansen_faltinsen", 0.4, 70 * degrees)[1])
  expect_gt(between, min(ends))
  expect_lt(between, max(ends))
  # Netting of a solidity of 0.025, d / (a h sqrt(1 - h^2)) with bars a and hanging ratio h, is half
  # a screen: the middle of a point-symmetric ramp.
  thin <- 0.025 * 0.06 * 0.4 * sqrt(1 - 0.4^2)
  expect_equal(force("blended", 0.4, 85 * degrees, thin),
    (force("morison", 0.4, 85 * degrees, thin) +
      force("kristiansen_faltinsen", 0.4, 85 * degrees, thin)) / 2, tolerance = 1e-11)
})

test_that("netting along the flow has the skin friction of its twine", {
  force <- function(law, ...) {
    flat <- lay_flat(flat_net(netting_drag = law, ...), 0.048, 0.11, 0, 0.7)
    rowSums(matrix(unlist(flat$forces[c("cell_drag", "screen_force", "blended_force")]), 3L))
  }
  # 24 x 36 meshes of 4 bars of 60 mm; twine of 2 mm
  area <- 24 * 36 * 4 * 0.06 * 0.002
  friction <- function(coefficient) c(0.5 * 1025 * 0.7^2 * coefficient * area, 0, 0)
  for (law in c("blended", "kristiansen_faltinsen")) {
    # rounding of sums over cells
    expect_equal(force(law, coefficients = "takagi"), friction(0.02), tolerance = 1e-10)
    expect_equal(force(law, coefficients = list(normal = 1, skin = 0.05)), friction(0.05),
      tolerance = 1e-10)
  }
})

test_that("opening force of stiff meshes is the derivative of their energy", {
  for (orientation in c("diamond", "turned")) {
    net <- function(...) flat_net(orientation = orientation, water = list(density = 0), ...)
    plain <- net()
    si <- net(opening_stiffness = list(couple = 2e-3, angle = 1.2))
    # Work of the forces during widening of the panel, compared with the change of energy,
    # 1/2 H (b - b0)^2 per knot. The angle b between twines opens with the width (in turned netting
    # it closes).
    width <- 0.055
    depth <- 0.11
    energy <- function(width) {
      b <- 2 * atan2(width, depth)
      if (orientation == "turned") b <- pi - b
      2 * 24 * 36 * 0.5 * 2e-3 * (b - 1.2)^2
    }
    flat <- lay_flat(si, width, depth, 1)
    wider <- lay_flat(si, width + 1e-3, depth, 1)$x - flat$x
    # the bars are taut at 123 mm on 120 mm; without the couples only their tension acts
    couples <- flat$force - lay_flat(plain, width, depth, 1)$force
    work <- sum(couples * wider) / 1e-3
    h <- 1e-5
    # second order at h: 1e-8; sin b smoothed by 0.02 at 1 changes the couple by about 0.02^2 / 2
    expect_equal(work, -(energy(width + h) - energy(width - h)) / (2 * h), tolerance = 2e-3)
  }
})

test_that("sheets between bars include the couples of all stiff knots", {
  si <- flat_net(opening_stiffness = list(couple = 1, angle = 1))
  mesh <- build_mesh(si, netting = "bars")
  cells <- build_mesh(si, netting = "cells")
  # area of the triangles in twine coordinates (m) times their multiplicity: knots, as in cells
  knots <- function(mesh) {
    openings <- mesh$model$openings
    sum(twine_area(openings$twine) * openings$multiplicity)
  }
  expect_equal(knots(mesh), knots(cells), tolerance = 1e-9)
})

test_that("hexagonal netting always uses cells", {
  si <- flat_net(orientation = "hexagonal")
  expect_identical(build_mesh(si, netting = "bars")$panels$net$netting, "cells")
  expect_equal(si$panels$net$straight_bar, 0.03)
})

test_that("turned netting of plain twine settles as diamonds do", {
  plan <- panel_in_current_plan
  plan$panels$net$orientation <- "turned"
  expect_identical(settle(as_gear(plan), nodes = 1500)$position,
    settled("panel_in_current")$position)
})

test_that("hexagonal netting in a blended plan uses twine-by-twine drag", {
  plan <- function(panel, whole = "blended") {
    text <- spoil("twine: {", paste0("orientation: hexagonal", panel, "\n    twine: {"))
    gear_si(update(read_text(text), netting_drag = whole))$panels$net$netting_drag
  }
  expect_identical(plan(""), "morison")
  expect_identical(plan("", "loland"), "loland")
  expect_refused(plan("\n    netting_drag: blended"), "netting_drag")
})

test_that("sheets between bars cover their panel and match cells' drag", {
  shapes <- list(
    rectangle = list(), tapered = list(meshes = list(upper = 24, lower = 11, deep = 36)),
    pointed = list(meshes = list(upper = 24, lower = 0, deep = 36)),
    square = list(orientation = "square")
  )
  for (name in names(shapes)) {
    for (law in c("aarsnes", "blended")) {
      si <- do.call(flat_net, c(list(netting_drag = law), shapes[[name]]))
      net <- si$panels$net
      meshes <- (net$upper + net$lower) / 2 * net$deep
      size <- if (name == "square") c(0.06, 0.06) else 0.12 * c(0.45, sqrt(1 - 0.45^2))
      theta <- 1.25
      way <- c(cos(pi / 2 - theta), 0, -sin(pi / 2 - theta))
      force <- lapply(c("cells", "bars"), function(netting) {
        si$towing$speed <- 0.7
        mesh <- build_mesh(si, nodes = 150, netting = netting)
        drawn <- panel_of(mesh, "net")
        x <- matrix(0, 3L, engine_array(mesh, "nodes"))
        put <- function(node, i, j) {
          inside <- node <= ncol(x) & node > 0
          x[, node[inside]] <<- outer(way, j[inside] * size[2]) +
            outer(c(0, 1, 0), i[inside] * size[1])
        }
        # all nodes are on the panel's edges or are knots
        division <- division_of(mesh)
        edge <- rep(1:4, division$count)
        f <- division$fraction
        j <- c(0, net$deep, NA, NA)[edge]
        j[edge > 2] <- f[edge > 2] * net$deep
        left <- panel_left(net, j)
        right <- panel_right(net, j)
        i <- ifelse(edge <= 2, left + f * (right - left), ifelse(edge == 3, left, right))
        put(division$edge_node, i, j)
        if (netting == "bars") {
          put(drawn$node, drawn$i, drawn$j)
        } else {
          s <- (row(drawn$grid) - 1) / (nrow(drawn$grid) - 1)
          j <- (col(drawn$grid) - 1) / (ncol(drawn$grid) - 1) * net$deep
          i <- panel_left(net, j) + s * (panel_right(net, j) - panel_left(net, j))
          put(as.vector(drawn$grid), as.vector(i), as.vector(j))
        }
        found <- engine_evaluate(engine_array(mesh), as.vector(x), numeric(length(x)))
        area <- if (law == "aarsnes") sum(engine_array(mesh, "screens", "twine_area")) else {
          sum(twine_area(engine_array(mesh, "blended", "twine")))
        }
        # exactly the panel's twine
        expect_equal(area, meshes * if (law == "aarsnes") {
          0.12 * (if (name == "square") 1 else 2) * 0.002
        } else if (name == "square") 1 else 2, tolerance = 1e-9, label = paste(name, netting))
        of <- c("bar_drag", "cell_drag", "screen_force", "blended_force")
        rowSums(matrix(unlist(found$forces[of]), 3L))
      })
      # the same flat panel with another mesh: sums of some hundred terms in another order
      expect_equal(force[[2]], force[[1]], tolerance = 1e-9, label = paste(name, law))
    }
  }
})
