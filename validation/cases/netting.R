# Codends compared with another program, and netting and bodies compared with published
# coefficients.

use_tests("helper-measures")
use_tests("test-validation-codend")
use_tests("test-validation-panels")
use_tests("test-coefficient-table")

case_axicodend_50 <- function() axicodend(50)
case_axicodend_51 <- function() axicodend(51)
axicodend <- function(blocked) {
  state <- settle_codend(list(blocked_meshes = blocked))
  wanted <- codend_reference("metrics")
  wanted <- wanted[wanted$meshes_blocked == blocked, ]
  shape <- codend_shape(state)
  found <- measures(state)
  rbind(
    compared("place", c("length", "largest radius", "thickness of the catch"),
      c(wanted$length, wanted$max_radius, wanted$catch_thickness),
      c(max(shape$x), max(shape$r), max(shape$x) - shape$x[101 - blocked])),
    compared("volume", "catch", wanted$catch_volume, found[["catch_volume_m3"]]),
    compared("drag", "catch", wanted$catch_drag, 1000 * found[["total_drag_kN"]])
  )
}

# Coefficients of the engine's forces, compared with another program with the same formulas. Rows
# near zero are omitted because ratios are meaningless.
published_rows <- function(table, force, laws) {
  rows <- beside_published(table, force)
  rows <- rows[rows$law %in% laws & abs(rows$value_published) > 0.001, ]
  compared(rows$coefficient, sprintf("%s, %g degrees, solidity %g", rows$law, rows$angle_deg,
    rows$solidity), rows$value_published, rows$value)
}

case_twine_coefficients <- function() {
  table <- computed()
  rows <- published_rows(table[table$by == "angle", ], "twine", c("hoerner", "bessonneau_marichal"))
  rows$at <- sub(", solidity NA", "", rows$at)
  rows
}

case_screen_coefficients <- function() {
  solidity <- c(0.1, 0.2, 0.3)
  rbind(
    published_rows(computed(solidity = solidity), "netting", c("loland", "aarsnes")),
    do.call(rbind, lapply(solidity, function(sn) {
      # their model uses the speed between the twines: Re (1 - Sn) = 1000
      published_rows(computed(reynolds = 1000 * (1 - sn), solidity = sn), "netting",
        "kristiansen_faltinsen")
    }))
  )
}

case_sphere_coefficients <- function() {
  rows <- utils::read.csv(system.file("extdata", "published-coefficients.csv", package = "codend"))
  # knots have Reynolds numbers of 100 to 20,000
  rows <- rows[rows$force == "sphere" & rows$law == "measured" & rows$reynolds > 100 &
    rows$reynolds < 2e4, ]
  compared("drag", sprintf("Reynolds number %g", rows$reynolds), rows$value,
    sphere_specimens(rows$reynolds)$drag)
}

# A square-mesh panel of solidity 0.2 across the flow and at an angle, by the screen formula on its
# area. The formula is implemented independently here (Loland 1991 as in S2 of H. Cheng's
# hydromodel). Returns the force of the flow on the rigid panel (N).
panel_screen <- function(gear, incidence, speed) {
  si <- gear_si(gear)
  si$towing$speed <- speed
  mesh <- build_mesh(si, nodes = 300)
  x <- flat_position(mesh, si, 0.4, incidence)
  found <- engine_evaluate(engine_array(mesh), as.vector(x), numeric(length(x)))
  rowSums(matrix(found$forces$screen_force, 3L))
}

case_screen_panel <- function() {
  angle <- c(90, 60, 45, 30)
  d <- 0.05 * (1 - sqrt(0.8))
  sn <- 0.2
  area <- 24 * 36 * 0.05^2
  normal <- (90 - angle) * pi / 180
  drag <- 0.04 + (-0.04 + 0.33 * sn + 6.54 * sn^2 - 4.88 * sn^3) * cos(normal)
  lift <- (-0.05 * sn + 2.3 * sn^2 - 1.76 * sn^3) * sin(2 * normal)
  plan <- update(flat_panel("square", columns = 6), netting_drag = "loland",
    panels.net.twine.diameter = d)
  force <- vapply(angle, function(a) panel_screen(plan, a * pi / 180, 0.6), numeric(3))
  q <- 0.5 * 1025 * 0.6^2 * area
  rbind(
    compared("drag", paste(angle, "degrees to the flow"), drag, force[1, ] / q),
    compared("lift", paste(angle[-1], "degrees to the flow"), lift[-1], abs(force[3, -1]) / q)
  )
}

case_twine_panel <- function() {
  do.call(rbind, lapply(c("hoerner", "bessonneau_marichal", "choo_casarella"), function(law) {
    do.call(rbind, lapply(c(90, 45, 15), function(angle) {
      plan <- flat_panel("diamond", law, columns = 4)
      exact <- summed_force(law, "diamond", 0.4, angle * pi / 180, 0.6)
      found <- panel_force(plan, 0.4, angle * pi / 180, 0.6)$twine
      rbind(
        compared("drag", paste(law, angle, "degrees"), exact[1], found[1]),
        if (angle < 90) compared("lift", paste(law, angle, "degrees"), exact[3], found[3])
      )
    }))
  }))
}
