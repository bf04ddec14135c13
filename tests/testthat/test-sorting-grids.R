# Rigid sorting grids: shape, drag by the formula of a bar rack, and angle.

grid_trawl <- function(...) {
  update(example_gear("sorting_grid"), ...)
}

bar_names <- paste0("nordmore_bar_", 1:5)

# Force (N) on a grid by the help page `sorting_grids`, written independently of the package.
rack_force <- function(angle, speed, height = 1.3, width = 1, diameter = 0.012, spacing = 0.019) {
  k <- 1.79 * (diameter / spacing)^(4 / 3) * sin(angle)
  1025 / 2 * speed^2 * pi * height * width / 4 * k / (1 + k / 4)^2
}

# Returns list(flatness, length, width, angle, roll) of the settled grid: distance of the frame from
# its plane, size (m), and angles (degrees). `angle` is above 90 if the top is forward.
grid_shape <- function(state) {
  frame <- state$position[, state$mesh$ropes$nordmore$node]
  bars <- lapply(bar_names, function(name) state$position[, state$mesh$ropes[[name]]$node])
  middle <- bars[[3]][, 1] - bars[[3]][, 2]
  across <- bars[[5]][, 1] - bars[[1]][, 1]
  list(flatness = svd(frame - rowMeans(frame))$d[3] / sqrt(ncol(frame)),
    length = sqrt(sum(middle^2)), width = diff(range(frame[2, ])),
    angle = atan2(middle[3], middle[1]) * 180 / pi,
    roll = atan(across[3] / across[2]) * 180 / pi)
}

test_that("grid settles as a flat oval at its angle without roll", {
  for (nodes in c(600, 1500)) {
    state <- settle(grid_trawl(), nodes = nodes)
    shape <- grid_shape(state)
    expect_lt(shape$flatness, 0.005 * 1.3)
    # The oval has five model bars, so its width changes a little.
    expect_equal(shape$length, 1.3, tolerance = 0.01)
    expect_equal(shape$width, 1, tolerance = 0.05)
    expect_lt(abs(shape$angle - 48), 3)
    expect_lt(abs(shape$roll), 1)
    expect_equal(measures(state)[["nordmore_angle_deg"]], shape$angle, tolerance = 0.01)
  }
  table <- as.data.frame(state, what = "drag")
  rods <- table$part %in% c("nordmore", bar_names)
  expect_equal(sum(table$weight_in_water_kN[rods]), 25 * (1 - 1025 / 2700) * 9.81 / 1000,
    tolerance = 1e-3)
})

test_that("grid with an outlet in the belly leans aft at its bottom", {
  # The flow lifts this grid, so that it needs fewer floats.
  bottom <- grid_trawl(grids.nordmore.outlet = "bottom", grids.nordmore.floats.number = 2)
  shape <- grid_shape(settle(bottom, nodes = 600))
  expect_lt(abs(180 - shape$angle - 48), 3)
  expect_lt(abs(shape$roll), 1)
})

test_that("grid keeps other angles within 3 degrees", {
  for (degrees in c(35, 60)) {
    angle <- paste(degrees, "deg")
    shape <- grid_shape(settle(grid_trawl(grids.nordmore.angle = angle), nodes = 600))
    expect_lt(abs(shape$angle - degrees), 3)
  }
})

test_that("hinged grid has the drag of a bar rack and the angle of its moments", {
  # The bars of the plan, hinged at their lower ends, with a lift at their upper ends.
  angle <- 60 * pi / 180
  speed <- 1.1
  parts <- assembly(grid_trawl(grids.nordmore.angle = "60 deg"))$plan$ropes[bar_names]
  total <- sum(vapply(parts, `[[`, 0, "length"))
  force <- rack_force(angle, speed)
  weight <- sum(vapply(parts, function(bar) {
    bar$length * (bar$mass_per_length - 1025 * bar$volume_per_length) * 9.81
  }, 0))
  # Moment about the hinge: the rack's force is spread over the bars like their lengths.
  arm <- sum(vapply(parts, function(bar) bar$length^2, 0)) / 2 / total
  lift <- arm * (force / cos(angle) + weight) / 1.3
  points <- ropes <- list()
  for (k in 1:5) {
    long <- parts[[k]]$length
    own <- setdiff(names(parts[[k]]), c("from", "to", "length"))
    ropes[[bar_names[k]]] <- c(list(from = paste0("foot_", k), to = paste0("head_", k),
      length = long), parts[[k]][own])
    points[[paste0("foot_", k)]] <- list(position = list(0, k, -50), held = "moved")
    # Each bar stands alone: its lift has the same moment as its share of the force and weight.
    points[[paste0("head_", k)]] <- list(load = list(0, 0, lift * 1.3 / arm / total * long / 2))
  }
  gear <- as_gear(list(codend = 1, name = "Hinged grid", towing = list(speed = speed),
    points = points, ropes = ropes,
    measures = list(angle = list(angle = list(nordmore_bar_3.start = "declination")),
      drag = list(drag = as.list(bar_names)))))
  found <- measures(settle(gear))
  # Poles of polyamide shorten by less than 1e-4.
  expect_equal(-found[["angle_deg"]], 60, tolerance = 1e-3)
  expect_equal(found[["drag_kN"]], force * sin(angle) / 1000, tolerance = 1e-3)
})

test_that("a sorting grid is listed on the drawing and has no finding of its own", {
  gear <- example_gear("sorting_grid")
  figure <- plan_figure(gear)
  listed <- figure$pieces[figure$pieces$name == "sorting grid", ]
  expect_match(listed$words, "^1[.]3 m by 1 m, 48 deg, behind ahead of grid")
  # The netting is symmetric, as without the grid.
  expect_true(all(figure$layout$columns$symmetric))
  expect_length(findings(gear)$check, 0L)
})
