# Gears with an exactly known shape and tension, from cables.R, square-net.R and the tests.

use_tests("test-validation-cells")

case_elastic_catenary <- function() {
  state <- hanging_catenary(128)
  low <- reaction(state, "low")
  x <- state$position[, along_rope(state, "chain")$node]
  k <- which.min(x[3, ])
  fit <- stats::lm(z ~ x + I(x^2), data.frame(x = x[1, k + (-1:1)], z = x[3, k + (-1:1)]))
  b <- unname(stats::coef(fit))
  at <- -b[2] / (2 * b[3])
  exact <- function(quantity) benchmark("elastic_catenary", quantity)
  rbind(
    compared("tension", c("horizontal", "vertical, lower end", "upper end"),
      c(exact("horizontal_tension"), exact("lower_vertical_tension"), exact("largest_tension")),
      c(-low[1], -low[3], sqrt(sum(reaction(state, "high")^2)))),
    compared("place", c("lowest point, x", "lowest point, z"),
      c(exact("lowest_x"), exact("lowest_z")), c(at, b[1] + b[2] * at + b[3] * at^2))
  )
}

case_isolated_cable <- function() {
  moved <- isolated_cable(35586) - c(121.92, 0, -29.276)
  compared("place", c("along", "down"), c(
    benchmark("isolated_cable", "displacement_x"), benchmark("isolated_cable", "displacement_z")
  ), moved[c(1, 3)])
}

case_critical_angle <- function() {
  compared("angle", sprintf("%.1f mm, %.2f N/m, %.2f m/s", 1000 * critical_cables$d,
    critical_cables$w, critical_cables$speed),
    vapply(1:3, function(k) benchmark(paste0("critical_angle_", k), "angle"), 0),
    vapply(1:3, function(k) mean(critical_angles(critical_cables[k, ])), 0))
}

case_towed_body <- function() {
  exact <- vapply(c("layback", "depth", "top_tension", "top_angle"),
    function(quantity) benchmark("towed_cable_body", quantity), 0)
  found <- towed_body(100)
  rbind(
    compared("place", c("layback", "depth"), exact[1:2], found[1:2]),
    compared("tension", "at the ship", exact[3], found[3]),
    compared("angle", "at the ship", exact[4], found[4])
  )
}

case_towed_warp <- function() {
  exact <- towed_warp_exact()
  found <- towed_warp(200)
  rbind(
    compared("place", c("along", "down"), exact[1:2], found[1:2]),
    compared("tension", "upper end", exact[3], found[3])
  )
}

case_sheared_cable <- function() {
  exact <- sheared_cable_exact()
  state <- sheared_cable(100)
  rbind(
    compared("place", c("along", "across", "down"), exact$body, node_at(state, "body")),
    compared("tension", "at the ship", sqrt(sum(exact$tension^2)),
      sqrt(sum(reaction(state, "ship")^2)))
  )
}

case_neutral_cable <- function() {
  exact <- neutral_catenary()
  found <- neutral_cable(80)
  rbind(
    compared("tension", c("least", "largest"), exact$tension, range(found$tension)),
    compared("place", "depth of the bight", exact$bight, found$bight)
  )
}

case_hanging_sphere <- function() {
  pull <- reaction(hanging_sphere(), "buoy")
  of <- hanging_sphere_forces
  compared("tension", c("drag", "weight"), c(of$drag, of$weight),
    c(sqrt(sum(pull[1:2]^2)), pull[3]))
}

case_kite_line <- function() {
  compared("angle", "at the winch", benchmark("kite_line", "angle"), kite_line())
}

case_square_net <- function() {
  found <- knots_of(settle(square_net(8)))
  exact <- solve_square_net(8)
  compared("place", c("foot, along", "foot, down"), c(mean(exact[57:64, 1]), mean(exact[57:64, 3])),
    c(mean(found[57:64, 1]), mean(found[57:64, 3])))
}

case_dragged_chain <- function() {
  use_tests("test-seabed")
  exact <- hung_chain()
  state <- settle(dragged_chain(), nodes = 400)
  pull <- summary(state)$reactions
  rbind(
    compared("tension", c("along", "vertical"), exact[c("along", "vertical")],
      1000 * c(-pull$x_kN, pull$z_kN)),
    compared("force", "weight on the ground", exact[["ground"]],
      1000 * measures(state)[["ground_load_kN"]])
  )
}

# A closed tube of inextensible diamond netting under the pressure of a catch. The angle f of the
# bars to its axis has tan(f)^2 = 2, so r = N m sin(f) / (2 pi). A bar of length a carries p r a /
# sqrt(2): axial and hoop tension p r / 2 and p r in two families of bars.
case_pressure_tube <- function() {
  around <- 24
  size <- 0.1
  radius <- around * size * sqrt(2 / 3) / (2 * pi)
  state <- settle(full_tube(around, 40, 32, 1.5, size, radius))
  lines <- as.data.frame(state, what = "tensions")
  x <- range(state$position[1, ])
  # well behind the front of the catch and before the closed end
  middle <- function(at) at > x[1] + 0.45 * diff(x) & at < x[1] + 0.65 * diff(x)
  bars <- 1000 * lines$tension_kN[lines$kind == "netting" & middle(lines$x_m)]
  wall <- state$position[, middle(state$position[1, ])]
  rbind(
    compared("place", "radius", radius, mean(sqrt(wall[2, ]^2 + (wall[3, ] + 10)^2))),
    compared("tension", c("mean of the bars", "5 % have less", "5 % have more"),
      0.5 * 1.4 * 1025 * 1.5^2 * radius * size / 2 / sqrt(2),
      c(mean(bars), stats::quantile(bars, c(0.05, 0.95))))
  )
}

case_hanging_panel <- function() {
  found <- measures(settle(hung_diamonds(3000), nodes = 3000))
  rbind(
    compared("place", "width of the foot", 3.372, found[["foot_width_m"]]),
    compared("drag", "netting", 0.4716, found[["net_drag_kN"]])
  )
}
