# Optima compared with analytical solutions and exhaustive search; artificial conditions and kinks.

skip_if_not_installed("nloptr")

# Its depth is 10 m W / sqrt(W^2 + D^2).
towed_sphere <- function(...) as_gear(towed_sphere_plan(...))
drag_by_speed <- 0.47 * pi / 16 * 1025 / 2

test_that("optimise_gear() finds the analytical optimum of a towed sphere", {
  # At a depth of at least 9.5 m the slope of the line is at most k = D / W. The pull is then c v^2
  # sqrt(1 + 1 / k^2). With 4000 / v added it has its minimum at v^3 = 2000 / (c sqrt(1 + 1 / k^2)).
  found <- optimise_gear(towed_sphere(), ~ pull + 4000 / towing.speed, ~ depth >= "9.5 m", list(
    towing.speed = c("1 m/s", "3 m/s"), pieces.sphere.mass = c("50 kg", "300 kg")
  ))
  k <- sqrt(1 / 0.95^2 - 1)
  c <- drag_by_speed * sqrt(1 + 1 / k^2)
  speed <- (2000 / c)^(1 / 3)
  mass <- drag_by_speed * speed^2 / k / 9.81 + 0.01 * 1025
  # The objective is flat: an error of 1e-6 in its value is an error of 1e-3 in the speed.
  expect_equal(found$objective$value, c * speed^2 + 4000 / speed, tolerance = 1e-5)
  expect_equal(found$fields$value, c(speed, mass), tolerance = 5e-3)
  expect_equal(found$keep$right, 9.5)
  expect_equal(found$keep$left, 9.5, tolerance = 1e-4)
  expect_true(found$optimal && found$smooth && found$keep$active && found$keep$holds)
  # The price of depth, by differences of the analytical solution.
  best <- function(share) {
    c <- drag_by_speed * sqrt(1 + 1 / (1 / share^2 - 1))
    speed <- (2000 / c)^(1 / 3)
    c * speed^2 + 4000 / speed
  }
  price <- (best(0.95 * 1.0001) - best(0.95 * 0.9999)) / 2e-4 / best(0.95)
  begun <- found$objective$begun
  expect_equal(found$keep$price, price * best(0.95) / begun, tolerance = 0.02)
  expect_identical(found$gear$plan$towing$speed, found$state$gear$plan$towing$speed)
  expect_equal(measures(found$state)[["depth_m"]], found$keep$left, tolerance = 1e-8)
  expect_equal(found$objective$saving, 1 - found$objective$value / begun)
})

test_that("optimise_gear() beats a grid from every start", {
  objective <- ~ (total_drag + 500) / towing.speed
  change <- list(towing.speed = c("1 m/s", "3 m/s"), ropes.line.length = value_range("8 m", "12 m"))
  found <- optimise_gear(towed_sphere(), objective, ~ depth >= 9, change, starts = 3)
  grid <- vary(towed_sphere(), towing.speed = seq(1, 3, by = 0.1),
    ropes.line.length = c(8, 9.6, 10.8, 12))
  kept <- grid[grid$depth_m >= 9, ]
  values <- (kept$total_drag_kN * 1000 + 500) / kept[["towing.speed_m_per_s"]]
  expect_lte(found$objective$value, min(values) * (1 + 1e-6))
  # Between two steps of the grid, 0.1 m/s, 500 / v + c v differs by 0.1 %; depth explains the
  # remaining difference.
  expect_gt(found$objective$value, min(values) * 0.995)
  expect_identical(nrow(found$starts), 3L)
  expect_equal(found$starts$objective, rep(found$objective$value, 3), tolerance = 1e-4)
})

# Five spheres on five lines, one below the other.
chain_of_spheres <- function() {
  places <- paste0("p", 1:5)
  as_gear(list(
    codend = 1, name = "Five spheres", towing = list(speed = "1.5 m/s"),
    points = c(list(ship = list(position = c(0, 0, 0), held = "moved")),
      setNames(rep(list(c(a = 1)[0]), 5), places)),
    ropes = setNames(lapply(1:5, function(k) {
      list(from = c("ship", places)[k], to = places[k], length = "25 m", diameter = "10 mm",
        axial_stiffness = "1 MN", mass_per_length = 0.3, segments = 3)
    }), paste0("line", 1:5)),
    pieces = setNames(lapply(1:5, function(k) {
      list(at = places[k], mass = "150 kg", diameter = "0.4 m", volume = "0.02 m3")
    }), paste0("sphere", 1:5)),
    measures = setNames(lapply(places, function(place) list(depth = place)),
      paste0("depth_", places))
  ))
}

test_that("optimise_gear() of ten fields settles at most 60 gears", {
  change <- c(
    setNames(rep(list(c("30 kg", "300 kg")), 5), paste0("pieces.sphere", 1:5, ".mass")),
    setNames(rep(list(c("15 m", "40 m")), 5), paste0("ropes.line", 1:5, ".length"))
  )
  keep <- ~ depth_p1 >= "20 m" & depth_p2 >= "40 m" & depth_p3 >= "60 m" & depth_p4 >= "80 m" &
    depth_p5 >= "100 m"
  found <- optimise_gear(chain_of_spheres(), "total_drag_kN", keep, change)
  expect_lte(found$n_solves, 60)
  expect_true(found$optimal)
  expect_true(all(found$keep$holds))
  expect_gt(found$objective$saving, 0.01)
  # A change of a single field by 1 % of its range within the conditions cannot improve the
  # objective by more than the remaining derivatives and the tolerance of the conditions.
  better <- vapply(seq_len(nrow(found$fields)), function(k) {
    field <- found$fields[k, ]
    max(vapply(c(-0.01, 0.01), function(share) {
      value <- field$value + share * (field$upper - field$lower)
      if (value < field$lower || value > field$upper) return(0)
      at <- measures(settle(do.call(update, c(list(found$gear), setNames(
        list(paste(value, field$unit)), field$field)))))
      if (any(at[paste0("depth_p", 1:5, "_m")] < c(20, 40, 60, 80, 100))) return(0)
      1 - at[["total_drag_kN"]] / found$objective$value
    }, 0))
  }, 0)
  expect_lt(max(better), 0.01 * 2e-3 + 1e-4)
})

test_that("optimise_gear() rounds integers, settles and checks again", {
  # 1234 N over 60 N is 20.6: 21 floats.
  found <- optimise_gear(buoyed_line(), ~ pieces.floats.number, ~ pull >= "1234 N",
    list(pieces.floats.number = c(5, 60)))
  expect_identical(found$fields$value, 21)
  expect_true(found$keep$holds)
  expect_equal(found$gear$plan$pieces$floats$number, 21)
})

test_that("optimise_gear() warns about infeasible conditions and returns the nearest gear", {
  expect_warning(
    found <- optimise_gear(towed_sphere(), ~ total_drag, ~ depth >= "9.99 m",
      list(towing.speed = c("1.5 m/s", "3 m/s"))),
    class = "codend_warning_conditions_not_kept"
  )
  expect_false(found$optimal)
  expect_identical(found$fields$at, "lower")
  expect_output(print(found), "NOT MET")
})

test_that("optimise_gear() satisfies equality conditions", {
  power <- "1 kW"
  found <- optimise_gear(towed_sphere(), ~ total_drag, ~ tow_power == power,
    list(towing.speed = c("1 m/s", "3 m/s"), pieces.sphere.mass = c("100 kg", "300 kg")))
  # c v^3 = 1000 W
  expect_equal(found$fields$value[1], (1000 / drag_by_speed)^(1 / 3), tolerance = 1e-4)
})

test_that("optimise_gear() with few nodes and an accuracy gives an optimum valid with many", {
  plan <- towed_sphere_plan()
  plan$ropes$line <- list(from = "ship", to = "end", length = "100 m", diameter = "20 mm",
    axial_stiffness = "10 MN", mass_per_length = 1)
  optimum <- function(...) {
    optimise_gear(as_gear(plan), ~ (total_drag + 2000) / towing.speed, ~ depth >= "50 m", list(
      ropes.line.length = c("60 m", "200 m"), towing.speed = c("1 m/s", "3 m/s")
    ), nodes = 4, ...)
  }
  depth <- function(found) measures(settle(found$gear, nodes = 400))[["depth_m"]]
  found <- optimum(accuracy = "0.05 %")
  # four elements leave an error of some percent in the depth, which the last mesh removes
  expect_gt(found$nodes, 10)
  expect_lt(found$accuracy, 0.01)
  expect_true(found$optimal && found$keep$holds && !found$keep$sure)
  expect_lt(abs(depth(found) - 50), 2 * found$keep$error)
  expect_output(print(found), "within its error.*nodes, with an error of")
  # with four elements alone it reports the error
  coarse <- optimum()
  expect_lt(coarse$nodes, 10)
  expect_gt(abs(depth(coarse) - 50), 0.5)
  expect_lt(abs(depth(coarse) - 50), 2 * coarse$keep$error)
})

test_that("optimise_gear() reports a kink at the optimum", {
  # 1000 N on two parallel lines of 1 MN; both carry load if they are equally long.
  line <- list(from = "nail", to = "ring", length = 10, diameter = 0.01, axial_stiffness = 1e6,
    mass_per_length = 0, segments = 1)
  gear <- as_gear(list(
    codend = 1, name = "Two lines", water = list(density = 0),
    points = list(nail = list(position = c(0, 0, 0), held = "fixed"),
      ring = list(load = c(0, 0, -1000))),
    ropes = list(first = line, second = utils::modifyList(line, list(length = 10.03))),
    measures = list(pull = list(tension = "first.start"), depth = list(depth = "ring"))
  ))
  # The first line carries all load until it is 10.02 m long, then less. From there its pull falls
  # with its length, and depth grows more slowly.
  found <- optimise_gear(gear, ~ (depth - 10.0301)^2 + 1e-4 * pull, NULL,
    list(ropes.first.length = c(10, 10.08)))
  expect_s3_class(found, "codend_optimum")
  expect_true(all(c("measure", "field") %in% names(found$kinks)))
  # Depth grows by 1 m per m of the first line before and by 0.5 m after. The minimum is where
  # both start to carry load, 10.02 m. Derivatives from one side point away from it.
  found <- optimise_gear(gear, ~ 0.75 * ropes.first.length - depth, NULL,
    list(ropes.first.length = c(9.99, 10.08)))
  # a thousandth of the range, and of the change over it
  expect_equal(found$fields$value, 10.02, tolerance = 1e-5)
  depth <- function(first) max(first * 1.001, (first + 10.03 + 0.01) / 2)
  expect_lte(found$objective$value, 0.75 * 10.02 - depth(10.02) + 2e-5)
  expect_identical(nrow(found$starts), 3L)
})

test_that("optima have a print, a summary and plots", {
  found <- optimise_gear(towed_sphere(), ~ total_drag / towing.speed, ~ depth <= "9.9 m",
    list(towing.speed = c("1 m/s", "3 m/s")))
  expect_output(print(found), "total_drag/towing.speed: 94.59 before")
  expect_output(print(summary(found)), "Drag by component")
  expect_picture(found)
  expect_error(plot(found, file = "a.txt"), class = "codend_error_file")
})

test_that("trade_off() follows the analytical curve", {
  # For a sphere that is towed fast and deep, the largest mass is best at every speed. Its depth is
  # L W / sqrt(W^2 + D^2). Speed alone leaves the mass undetermined. Ends may deviate by 0.1 %.
  gear <- update(towed_sphere(), pieces.sphere.mass = "80 kg")
  found <- trade_off(gear, list(speed = ~ -towing.speed, depth = ~ -depth), points = 4,
    change = list(towing.speed = c("1 m/s", "3 m/s"), pieces.sphere.mass = c("60 kg", "100 kg")))
  weight <- 9.81 * (100 - 0.01 * 1025)
  curve <- 10 * weight / sqrt(weight^2 + (drag_by_speed * found$speed^2)^2)
  expect_equal(found[["pieces.sphere.mass_kg"]], rep(100, 4), tolerance = 5e-3)
  expect_equal(-found$depth, curve, tolerance = 2e-3)
  expect_equal(found$speed[1], -3, tolerance = 1.1e-3)
  expect_equal(-found$depth[4], 10 * weight / sqrt(weight^2 + drag_by_speed^2), tolerance = 1.1e-3)
  expect_true(all(diff(found$depth) < 0) && all(found$kept))
  expect_output(print(found), "-towing.speed and -depth")
  expect_picture(found)
  expect_wrong(trade_off(towed_sphere(), ~depth, change = list()), "two objectives")
})

test_that("short prawn trawls save the published drag per swept width", {
  # Broadhurst, Sterling and Millar (2012), Fisheries Research 134-136:73: bodies cut 1N5B spread
  # 4.7 to 5.6 % wider than bodies cut 1N2B with up to 4.3 % less drag. So drag per width is 4.5 to
  # 9.4 % less. Twine and boards are not published.
  prawn <- example_gear("penaeid_trawl", "extdata")
  found <- optimise_gear(prawn, ~ total_drag / wing_end_spread,
    change = list(sections.body.meshes.deep = c(112, 160)), nodes = 400)
  expect_equal(found$fields$value, 112)
  expect_identical(found$fields$at, "lower")
  expect_gt(found$objective$saving, 0.045)
  expect_lt(found$objective$saving, 0.094)
  # the boards are tuned to the published spread
  expect_equal(measures(settle(prawn, nodes = 400))[["wing_end_spread_m"]], 4.33, tolerance = 0.01)
})
