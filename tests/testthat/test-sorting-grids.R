# Rigid sorting grids: shape, drag by the formula of a bar rack, and angle.

grid_trawl <- function(...) {
  file <- system.file("examples", "sorting_grid.yaml", package = "codend")
  update(read_gear(file), ...)
}

bar_names <- paste0("nordmore_bar_", 1:5)

# Force (N) on a grid by the help page `sorting_grids`, written independently of the package.
rack_force <- function(angle, speed, height = 1.3, width = 1, diameter = 0.012, spacing = 0.019) {
  k <- 1.79 * (diameter / spacing)^(4 / 3) * sin(angle)
  1025 / 2 * speed^2 * pi * height * width / 4 * k / (1 + k / 4)^2
}

test_that("grid settles as a flat oval of its size with its weight in water", {
  state <- settle(grid_trawl(), nodes = 1500)
  frame <- state$position[, state$mesh$ropes$nordmore$node]
  # Polyamide rods bend: 4 % of the height is the largest deviation in example plans.
  expect_lt(svd(frame - rowMeans(frame))$d[3] / sqrt(ncol(frame)), 0.04 * 1.3)
  middle <- state$position[, state$mesh$ropes$nordmore_bar_3$node]
  expect_equal(sqrt(sum((middle[, 1] - middle[, 2])^2)), 1.3, tolerance = 0.01)
  expect_equal(diff(range(frame[2, ])), 1, tolerance = 0.02)
  table <- as.data.frame(state, what = "drag")
  rods <- table$part %in% c("nordmore", bar_names)
  expect_equal(sum(table$weight_in_water_kN[rods]), 25 * (1 - 1025 / 2700) * 9.81 / 1000,
    tolerance = 1e-3)
})

test_that("grid leans aft towards its outlet", {
  top_aft <- function(outlet) {
    state <- settle(grid_trawl(grids.nordmore.outlet = outlet), nodes = 800)
    bar <- state$position[1, state$mesh$ropes$nordmore_bar_3$node]
    bar[1] - bar[2]
  }
  expect_gt(top_aft("top"), 0.5)
  expect_lt(top_aft("bottom"), -0.5)
  angle <- function(degrees) {
    state <- settle(grid_trawl(grids.nordmore.angle = paste(degrees, "deg")), nodes = 800)
    measures(state)[["nordmore_angle_deg"]]
  }
  # The pressure and the weight of the grid close meshes: up to 3 degrees in these plans.
  expect_lt(abs(angle(90) - 90), 4)
  expect_lt(abs(angle(70) - 70), 4)
  # Netting lengthens under load, so flatter grids settle steeper (see the help page).
  expect_true(angle(48) > 48 && angle(48) < 60)
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

test_that("grid without space to lean throws an error that names the section", {
  expect_refused(grid_trawl(sections.ahead_of_grid.meshes.deep = 5), "more than 11 meshes")
  expect_refused(grid_trawl(grids.nordmore.behind = "codend"), "ahead of another section")
  expect_refused(grid_trawl(grids.nordmore.behind = "body"), "straight sides")
  expect_refused(grid_trawl(grids.nordmore.height = "4 m"), "circumference")
})
