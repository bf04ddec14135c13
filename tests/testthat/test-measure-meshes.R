# Panels in a known flat shape: diamonds and squares at a given opening. layers: number of panels,
# all in the same position.
flat_state <- function(orientation, netting, across, down, shear = 0, upper = 12, lower = 12,
                       layers = 1) {
  deep <- 10
  nets <- c("net", paste0("net_", seq_len(layers))[-1])
  gear <- as_gear(list(
    codend = 1, name = "Flat net", water = list(current = list(speed = 1, toward = 0)),
    points = stats::setNames(lapply(nets, function(net) {
      list(at = paste0(net, ".upper_left"), position = c(0, 0, 0), held = "fixed")
    }), paste0("nail_", nets)),
    panels = stats::setNames(rep(list(list(
      mesh_size = 0.1, meshes = list(upper = upper, lower = lower, deep = deep),
      orientation = orientation, part = "codend", columns = 4,
      twine = list(diameter = 0.002, material = "polyethylene")
    )), layers), nets)
  ))
  si <- gear_si(gear)
  mesh <- build_mesh(si, 150, netting)
  panels <- panel_table(si$panels)
  place <- panel_places(panels, mesh$division, mesh$panels)
  j <- place$t * deep
  left <- panel_left(panels, j)
  i <- left + place$s * (panel_right(panels, j) - left)
  x <- matrix(0, 3L, mesh$nodes)
  x[2, place$node] <- i * across + shear * j
  x[3, place$node] <- -j * down
  list(state = new_state(gear, si, mesh, as.vector(x), list(converged = TRUE)), across = across,
    down = down)
}

test_that("table of openings has opening and angle of flat netting", {
  for (netting in c("cells", "bars")) {
    for (lower in c(12, 6)) {
      flat <- flat_state("diamond", netting, 0.03, 0.09, lower = lower)
      found <- as.data.frame(flat$state, what = "mesh_openings", parts = "codend")
      # exact on linear shapes, except for rounding
      expect_equal(found$mesh_opening_mm, rep(30, nrow(found)), tolerance = 1e-9)
      expect_equal(found$mesh_angle_deg, rep(2 * atan2(3, 9) * 180 / pi, nrow(found)),
        tolerance = 1e-9)
      expect_equal(found$opening_percent, rep(30, nrow(found)), tolerance = 1e-9)
      expect_equal(max(found$from_front_m), 10 * 0.09, tolerance = 1e-9)
      asked <- list(list(kind = "mesh_opening", panels = "net"))
      expect_equal(measure_values(flat$state, asked), 0.03, tolerance = 1e-9)
    }
    square <- flat_state("square", netting, 0.05, 0.05, shear = 0.01)
    angle <- acos(0.01 / sqrt(0.01^2 + 0.05^2)) * 180 / pi
    found <- as.data.frame(square$state, what = "mesh_openings")
    expect_equal(found$opening_percent, rep(100, nrow(found)), tolerance = 1e-9)
    expect_equal(range(found$mesh_angle_deg), c(angle, angle), tolerance = 1e-9)
  }
  expect_wrong(as.data.frame(square$state, what = "mesh_openings", parts = "wing"), "codend")
})

test_that("table of openings of a codend has valid values and pictures", {
  state <- settled("t90_codend")
  found <- as.data.frame(state, what = "mesh_openings")
  # twine is taut or slack, so the opening is at most the mesh size, plus slight stretch
  expect_true(all(found$greatest_opening_mm <= 1.05 * found$mesh_size_mm))
  expect_gt(max(found$mesh_opening_mm), 0)
  expect_picture(found)
  lines <- coloured_drawing(state, "mesh_opening")
  value <- lines$drawing$netting$tension
  expect_length(value, length(state_drawing(state)$netting$tension))
  expect_true(all(value > 0 & value < 105))
  expect_wrong(plot(state, colour = "red"), "mesh_angle")
})
