# A rigid flat panel of netting compared with the drag of its twines summed by hand, and the content
# of a mesh compared with its plan. Both cover both nettings and several groupings of meshes.

flat_panel <- function(orientation = "diamond", coefficients = "hoerner", knotted = FALSE,
                       netting = "cells", columns = 4, rows = 6, bar_segments = 2) {
  net <- list(
    mesh_size = 0.1, meshes = list(upper = 24, lower = 24, deep = 36), orientation = orientation,
    twine = list(diameter = 0.002, axial_stiffness = 1e5, mass_per_length = 0.004),
    knotted = knotted, columns = columns, bar_segments = bar_segments
  )
  if (knotted) net$knot_diameter <- 0.005
  if (netting == "cells") net$rows <- rows
  as_gear(list(
    codend = 1, name = "Flat panel", netting = netting, coefficients = coefficients,
    points = list(nail = list(at = "net.upper_left", position = c(0, 0, 0), held = "fixed")),
    panels = list(net = net)
  ))
}

# Node positions of a panel that hangs open at a ratio (bars of diamond meshes at their own length).
# The plane contains y and a direction at `incidence` to the flow (90 deg: across it).
flat_position <- function(mesh, si, ratio, incidence) {
  net <- si$panels$net
  drawn <- panel_of(mesh, "net")
  at <- matrix(NA_real_, engine_array(mesh, "nodes"), 2L)
  if (drawn$netting == "cells") {
    grid <- drawn$grid
    at[as.vector(grid), 1] <- (row(grid) - 1) / (nrow(grid) - 1) * net$upper
    at[as.vector(grid), 2] <- (col(grid) - 1) / (ncol(grid) - 1) * net$deep
  } else {
    at[drawn$node, ] <- cbind(drawn$i, drawn$j)
  }
  size <- if (net$orientation == "square") c(0.5, 0.5) else c(ratio, sqrt(1 - ratio^2))
  across <- at[, 1] * net$mesh_size * size[1]
  down <- at[, 2] * net$mesh_size * size[2]
  rbind(down * cos(incidence), across, -down * sin(incidence))
}

# Force of one metre of twine (N) from its unit vector, by the published forms:
#
# Hoerner 1965; Bessonneau and Marichal 1998; Wan et al. 2002; Takagi et al. 2004; Choo and
# Casarella 1971, its branch 30 < Re < 2.33e5; Cifuentes and Kim 2017.
twine_force <- function(law, axis, speed, d, solidity) {
  u <- c(speed, 0, 0)
  u_t <- sum(u * axis) * axis
  u_n <- u - u_t
  q_n <- sqrt(sum(u_n^2))
  q_t <- sqrt(sum(u_t^2))
  re <- q_n * d / 1.19e-6
  tangential <- function(c_t) c_t * q_t * u_t
  sum_up <- function(normal, along, skin = 0) normal * q_n * u_n + along + skin * speed * u
  0.5 * 1025 * d * switch(law,
    hoerner = sum_up(1.1, 0, 0.02),
    bessonneau_marichal = sum_up(1.2, tangential(0.1)),
    wan = sum_up(1.3, 0),
    takagi = sum_up(1.2, tangential(0.1)),
    choo_casarella = sum_up(
      1.1 + 4 / sqrt(re),
      2 * pi * 1.19e-6 / d * (0.55 * sqrt(re) + 0.084 * re^(2 / 3)) * u_t
    ),
    cifuentes_kim = {
      x <- re * solidity^2
      sum_up(-3.2891e-5 * x^2 + 0.00068 * x + 1.4253, 0)
    }
  )
}

# Force of the flow on the whole rigid panel (N).
panel_force <- function(gear, ratio, incidence, speed) {
  si <- gear_si(gear)
  si$towing$speed <- speed
  mesh <- build_mesh(si, nodes = 300)
  x <- flat_position(mesh, si, ratio, incidence)
  stopifnot(!anyNA(x))
  found <- engine_evaluate(engine_array(mesh), as.vector(x), numeric(length(x)))
  list(
    twine = rowSums(matrix(c(found$forces$bar_drag, found$forces$cell_drag), 3L)),
    knots = rowSums(matrix(found$forces$sphere_drag, 3L))
  )
}

summed_force <- function(law, orientation, ratio, incidence, speed) {
  deep <- c(cos(incidence), 0, -sin(incidence))
  across <- c(0, 1, 0)
  # 24 x 36 meshes of 2 bars of 50 mm in either direction; squares are counted in bars
  metres <- 24 * 36 * 2 * 0.05 / (if (orientation == "square") 2 else 1)
  axes <- if (orientation == "square") {
    list(across, deep)
  } else {
    e <- sqrt(1 - ratio^2)
    list(ratio * across + e * deep, ratio * across - e * deep)
  }
  solidity <- if (orientation == "square") {
    2 * 0.002 / 0.05 - (0.002 / 0.05)^2
  } else {
    0.002 / (0.05 * 0.3 * sqrt(1 - 0.3^2))  # netting at its usual hanging ratio
  }
  metres * rowSums(vapply(axes, function(axis) twine_force(law, axis, speed, 0.002, solidity),
    numeric(3)))
}

test_that("rigid panel has the summed drag of its twines at any grouping", {
  laws <- c("hoerner", "bessonneau_marichal", "wan", "takagi", "choo_casarella", "cifuentes_kim")
  divisions <- list(
    list(netting = "cells", columns = 1, rows = 1), list(netting = "cells", columns = 5,
      rows = 7), list(netting = "bars", columns = 4, bar_segments = 1),
    list(netting = "bars", columns = 8, bar_segments = 3)
  )
  for (law in laws) {
    for (orientation in c("diamond", "square")) {
      for (incidence in c(90, 45, 15) * pi / 180) {
        wanted <- summed_force(law, orientation, 0.4, incidence, 0.6)
        for (division in divisions) {
          plan <- do.call(flat_panel, c(list(orientation, law), division))
          # the same sums in another order: rounding, and the Reynolds number's floor of 0.01 in
          # about 1000, which changes C_n by 1e-10
          expect_equal(panel_force(plan, 0.4, incidence, 0.6)$twine, wanted, tolerance = 1e-9)
        }
      }
    }
  }
})

test_that("rigid panel has the drag of two spherical knots per mesh", {
  # C_D = 24 / Re + 6 / (1 + sqrt(Re)) + 0.4 (White)
  re <- 0.6 * 0.005 / 1.19e-6
  each <- 0.5 * 1025 * 0.6^2 * pi / 4 * 0.005^2 * (24 / re + 6 / (1 + sqrt(re)) + 0.4)
  for (netting in c("cells", "bars")) {
    for (columns in c(2, 6)) {
      plan <- flat_panel(knotted = TRUE, netting = netting, columns = columns)
      expect_equal(panel_force(plan, 0.4, 1, 0.6)$knots, c(2 * 24 * 36 * each, 0, 0),
        tolerance = 1e-12)
    }
  }
})

test_that("mesh contains the mass, weight, twine and knots of its plan", {
  plans <- list(
    rectangle = list(meshes = c(30, 30, 40)),
    both = list(meshes = c(40, 21, 30)),
    left = list(meshes = c(40, 21, 30), tapered = "left"),
    right = list(meshes = c(17, 44, 30), tapered = "right"),
    fractional = list(meshes = c(12.5, 7.25, 9.5)),
    pointed = list(meshes = c(24, 0, 24)),
    opening = list(meshes = c(0, 24, 30), tapered = "left"),
    square = list(meshes = c(30, 30, 40), orientation = "square"),
    square_tapered = list(meshes = c(40, 20, 30), orientation = "square")
  )
  for (name in names(plans)) {
    of <- plans[[name]]
    square <- identical(of$orientation, "square")
    net <- list(
      mesh_size = 0.08, meshes = stats::setNames(as.list(of$meshes), c("upper", "lower", "deep")),
      twine = list(diameter = 0.003, material = "PE", double = TRUE), knot_diameter = 0.007
    )
    net <- c(net, of[setdiff(names(of), "meshes")])
    nail <- if (of$meshes[1] > 0) "net.upper_left" else "net.lower_left"
    gear <- as_gear(list(
      codend = 1, name = name, panels = list(net = net),
      points = list(nail = list(at = nail, position = c(0, 0, 0), held = "fixed"))
    ))
    si <- gear_si(gear)
    meshes <- (of$meshes[1] + of$meshes[2]) / 2 * of$meshes[3]
    twine <- meshes * 0.08 * (if (square) 1 else 2)
    knots <- meshes * (if (square) 1 else 2)
    # double twine of polyethylene: 480 kg/m3 on its diameter squared, solid of 950 kg/m3; each knot
    # contains 16 diameters of twine
    mass <- (twine + knots * 16 * 0.003) * 2 * 480 * 0.003^2
    for (netting in c("cells", "bars")) {
      for (nodes in c(40, 200, 800)) {
        mesh <- build_mesh(si, nodes, netting)
        array <- function(...) engine_array(mesh, ...)
        label <- paste(name, netting, nodes)
        t <- matrix(array("cells", "twine"), 8L)
        d <- abs((t[5, ] - t[1, ]) * (t[8, ] - t[4, ]) - (t[7, ] - t[3, ]) * (t[6, ] - t[2, ]))
        held <- sum(array("bars", "rest") * array("bars", "multiplicity")) +
          sum(d * array("cells", "rest") * array("cells", "multiplicity"))
        # sums of some hundred terms in another order
        expect_equal(held, twine, tolerance = 1e-12, label = paste(label, "twine"))
        expect_equal(sum(array("mass")), mass, tolerance = 1e-12, label = paste(label, "mass"))
        expect_equal(sum(array("load")), -9.81 * mass * (1 - 1025 / 950), tolerance = 1e-11,
          label = paste(label, "weight"))
        expect_equal(sum(array("spheres", "drag_area")), knots * pi / 4 * 0.007^2,
          tolerance = 1e-12, label = paste(label, "knots"))
        # half of the water that the spheres displace
        expect_equal(sum(array("spheres", "added_mass")), knots * pi / 12 * 0.007^3,
          tolerance = 1e-12, label = paste(label, "added mass"))
        expect_equal(array("materials", "diameter"), 0.006)
      }
    }
  }
})
