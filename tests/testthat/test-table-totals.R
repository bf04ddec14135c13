# Totals of all tables against the measures, which the engine computes from other numbers.

small_states <- lapply(setNames(nm = names(shipped_plans())), settled, nodes = 300)

measure_of <- function(state, name) {
  found <- measures(state)
  if (name %in% names(found)) found[[name]] else NA_real_
}

# Expects every sum within the residual of the solver.
expect_sum <- function(found, due, size, info) {
  expect_lte(abs(found - due), 1e-6 * size + 1e-9, label = info)
}

# The forces in a drag table, and the pull of the supports along the same axes (kN).
expect_drag_adds_up <- function(state, info) {
  drag <- as.data.frame(state, what = "drag")
  totals <- summary(state)$drag_totals
  forces <- c("drag_kN", "side_kN", "lift_kN", "weight_in_water_kN")
  sums <- colSums(drag[forces])
  size <- sum(abs(as.matrix(drag[forces])))
  last <- nrow(totals)
  expect_identical(totals$group[last], "total")
  expect_equal(colSums(totals[-last, forces]), sums, info = info)
  expect_equal(unlist(totals[last, forces]), sums, info = info)
  expect_sum(sums[["drag_kN"]], measure_of(state, "total_drag_kN"), size, paste(info, "drag"))
  pull <- drop(colSums(as.data.frame(state, what = "reactions")[c("x_kN", "y_kN", "z_kN")]) %*%
    flow_axes(state$si))
  expect_sum(sums[["drag_kN"]], -pull[1L], size, paste(info, "pull against the flow"))
  expect_sum(sums[["side_kN"]], -pull[2L], size, paste(info, "pull to port"))
  expect_sum(sums[["lift_kN"]] - sums[["weight_in_water_kN"]], -pull[3L], size,
    paste(info, "pull upwards"))
}

test_that("drag of all shipped gears adds up to the pull of supports", {
  for (name in names(small_states)) expect_drag_adds_up(small_states[[name]], name)
})

test_that("drag adds up on slopes, under loads and in inclined currents", {
  trawl <- update(read_gear("poly_noreastern_trawl"),
    seabed.slope = list(angle = "3 deg", toward = "30 deg"))
  expect_drag_adds_up(settle(trawl, nodes = 300), "slope")
  loaded <- update(read_gear("crossing_cables"),
    points.crossing_south_west.load = list("1 kN", "2 kN", "-10 kN"))
  expect_drag_adds_up(settle(loaded), "load")
  expect_drag_adds_up(settle(update(read_gear("cage"), water.current.toward = "40 deg"),
    nodes = 300), "current")
})

test_that("drag adds up while a tow accelerates on the sea bed", {
  faster <- tow_schedule(speed = data.frame(time = c(0, 5), value = c("3 knot", "4 knot")))
  moving <- state_at(tow(small_states$beam_trawl, faster, until = 4, every = 2), 4)
  expect_drag_adds_up(moving, "beam trawl")
  inertia <- as.data.frame(moving, what = "drag")
  inertia <- inertia$drag_kN[inertia$part == "inertia"]
  expect_gt(inertia, 0.01 * measure_of(moving, "total_drag_kN"))
})

test_that("groups of the drag table equal the measures of their parts", {
  for (name in names(small_states)) {
    state <- small_states[[name]]
    totals <- summary(state)$drag_totals
    bed <- totals[totals$group == "sea bed", ]
    friction <- measure_of(state, "ground_friction_percent") / 100
    if (is.na(friction)) friction <- 0
    total <- measure_of(state, "total_drag_kN")
    expect_equal(sum(bed$drag_kN), friction * total, tolerance = 1e-8, info = name)
    # the shipped sea beds are level
    load <- measure_of(state, "ground_load_kN")
    if (!is.na(load)) expect_equal(sum(bed$lift_kN), load, tolerance = 1e-8, info = name)
    expect_equal(summary(state)$tangential$settled, total, info = name)
  }
})

test_that("printed and live tables of drag show the measure as total", {
  for (name in c("poly_noreastern_trawl", "cage", "pair_trawl")) {
    state <- small_states[[name]]
    said <- summary(state)
    columns <- drag_columns(said$drag_totals, said$drag_totals$group)
    parts <- drag_part_columns(said$drag, said$drag_totals, 15)
    number <- function(text) as.double(gsub("[^0-9.-]", "", text))
    for (shown in list(columns, parts)) {
      last <- length(shown[[1L]])
      total <- measure_of(state, "total_drag_kN")
      places <- number(shown[["drag kN"]])
      expect_equal(places[last], total, tolerance = 1e-3, info = name)
      # the printed numbers are rounded
      expect_equal(sum(places[-last]), total, tolerance = 5e-3, info = name)
      expect_equal(sum(number(shown[["share %"]])[-last]), 100, tolerance = 5e-3, info = name)
      for (force in c("side kN", "lift kN", "weight in water kN")) {
        places <- number(shown[[force]])
        expect_equal(sum(places[-last]), places[last], tolerance = 0.01, info = paste(name, force))
      }
    }
    live <- drag_tables(state)[[1L]]$columns
    last <- length(live[[1L]])
    expect_identical(as.character(live[[1L]])[last], "total", info = name)
    expect_equal(c(live[[2L]][last], live[[3L]][last]), c(total, 100), info = name)
  }
})

test_that("weights in water agree before and after settling", {
  for (name in names(small_states)) {
    state <- small_states[[name]]
    own <- summary(state$gear)
    parts <- own$parts
    for (amount in c("mass_kg", "weight_in_water_kN")) {
      last <- nrow(own$totals)
      expect_equal(own$totals[[amount]][last], sum(parts[[amount]]), info = name)
      expect_equal(sum(own$totals[[amount]][-last]), sum(parts[[amount]]), info = name)
      netting <- own$totals[[amount]][own$totals$group == "netting"]
      expect_equal(sum(own$netting[[amount]]), sum(netting), info = name)
    }
    weight <- as.data.frame(state, what = "drag")$weight_in_water_kN
    expect_equal(sum(weight), own$totals$weight_in_water_kN[last], tolerance = 1e-6, info = name)
    # the engine's loads on nodes are weights in water and loads of the plan
    planned <- sum(vapply(state$si$points, function(point) as.double(point$load)[3L], 0))
    of_engine <- sum(matrix(state$mesh$model$load, 3L)[3L, ]) - planned
    expect_equal(-sum(weight), in_unit(of_engine, "kN"), tolerance = 1e-6, info = name)
  }
})

test_that("slack of panels weighted by twine equals the measure", {
  for (name in names(small_states)) {
    slack <- summary(small_states[[name]])$slack
    if (!nrow(slack)) next
    expect_equal(stats::weighted.mean(slack$slack_percent, slack$twine_m),
      measure_of(small_states[[name]], "slack_netting_percent"), tolerance = 1e-8, info = name)
  }
})

test_that("variances of the sources of an uncertainty add up to 100 %", {
  found <- uncertainty(settled("towed_cable"))
  for (k in seq_len(nrow(found$measures))) {
    row <- found$measures[k, ]
    own <- found$sources$percent[found$sources$measure == row$measure]
    rest <- 100 * (row$mesh^2 + row$model^2) / row$error^2
    expect_equal(sum(own) + rest, 100, tolerance = 1e-9, info = row$measure)
  }
  expect_equal(unname(rowSums(group_percent(found$measures))), rep(100, nrow(found$measures)))
})
