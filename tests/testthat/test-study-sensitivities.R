# Derivatives compared with analytical solutions and differences of settled shapes; artificial
# kinks.

towed_sphere <- towed_sphere_plan(ropes = list(line = list(axial_stiffness = "12 MN")))

# A weight of 1000 N on two parallel lines of 1 MN. One line may be slack.
two_lines <- function(second) {
  line <- list(from = "nail", to = "ring", length = 10, diameter = 0.01, axial_stiffness = 1e6,
    mass_per_length = 0, segments = 1)
  as_gear(list(
    codend = 1, name = "Two lines", water = list(density = 0),
    points = list(nail = list(position = c(0, 0, 0), held = "fixed"),
      ring = list(load = c(0, 0, -1000))),
    ropes = list(first = line, second = utils::modifyList(line, list(length = second))),
    measures = list(depth = list(depth = "ring"), pull = list(tension = "first.start"))
  ))
}

# A weight on a line above a bed at 10 m.
above_bed <- function(length) {
  as_gear(list(
    codend = 1, name = "Weight above the bed", seabed = list(depth = "10 m"),
    points = list(nail = list(position = c(0, 0, 0), held = "fixed"), ring = c(a = 1)[0]),
    ropes = list(line = list(from = "nail", to = "ring", length = length, diameter = 0.01,
      axial_stiffness = 1e6, mass_per_length = 0.1, segments = 4)),
    pieces = list(weight = list(at = "ring", mass = 100, volume = 0.01, diameter = 0.2)),
    measures = list(depth = list(depth = "ring"), pull = list(tension = "line.start"))
  ))
}

slope_of <- function(found, measure, field) {
  found[found$measure == measure & found$field == field, ]
}

test_that("sensitivities() of a towed sphere equal the analytical derivatives", {
  state <- settle(as_gear(towed_sphere))
  found <- sensitivities(state,
    fields = c("towing.speed", "ropes.line.length", "pieces.sphere.mass"))
  drag <- 0.47 * pi / 16 * 1025 * 2^2 / 2
  weight <- 9.81 * (200 - 0.01 * 1025)
  pull <- sqrt(drag^2 + weight^2)
  # A line of 12 MN stretches by 1.6e-4 of its length. The analytical solution omits this in the
  # angle, but not in the forces, which depend only on the sphere.
  of <- function(measure, field) slope_of(found, measure, field)$derivative
  expect_equal(of("total_drag_kN", "towing.speed"), drag / 1000, tolerance = 1e-8)
  expect_equal(of("pull_kN", "towing.speed"), drag^2 / pull / 1000, tolerance = 1e-6)
  expect_equal(of("pull_kN", "pieces.sphere.mass"), 9.81 * weight / pull / 1000, tolerance = 1e-6)
  expect_equal(of("depth_m", "ropes.line.length"), weight / pull * (1 + pull / 12e6),
    tolerance = 1e-8)
  # powers of the speed
  expect_equal(slope_of(found, "total_drag_kN", "towing.speed")$elasticity, 2, tolerance = 1e-8)
  expect_equal(slope_of(found, "tow_power_kW", "towing.speed")$elasticity, 3, tolerance = 1e-8)
  expect_true(all(found$smooth))
  expect_identical(unique(found$unit), c("m/s", "m", "kg"))
  expect_identical(slope_of(found, "depth_m", "towing.speed")$derivative_unit, "m per m/s")
  # secants of v^2 for 1 % less and more
  secants <- unlist(slope_of(found, "total_drag_kN", "towing.speed")[
    c("secant_below", "secant_above")])
  expect_equal(unname(secants), drag / 1000 * c(1.99, 2.01) / 2, tolerance = 1e-5)
})

test_that("sensitivities() flags all artificial kinks", {
  # The second line becomes taut at 0.3 % more of the first; from there each carries half of the
  # load.
  near <- sensitivities(settle(two_lines(10.03)), of = c("depth_m", "pull_kN"),
    fields = "ropes.first.length")
  expect_false(any(near$smooth))
  expect_equal(near$derivative[1], 1 + 1e-3, tolerance = 1e-6)
  expect_equal(near$secant_below[1], 1 + 1e-3, tolerance = 1e-6)
  # Then both follow the second line, which is not paid out.
  expect_equal(near$secant_above[1], 0.3003, tolerance = 1e-3)
  # Both taut: one becomes slack at 0.1 % to either side, with equal secant errors above and below.
  both <- sensitivities(settle(two_lines(10)), of = "depth_m", fields = "ropes.first.length")
  expect_equal(both$derivative, 0.5, tolerance = 1e-3)
  expect_false(both$smooth)
  # No kink nearby: smooth, and a slack line has no effect.
  far <- sensitivities(settle(two_lines(10.3)), of = "depth_m",
    fields = c("ropes.first.length", "ropes.second.length"))
  expect_true(all(far$smooth))
  expect_equal(far$derivative, c(1 + 1e-3, 0), tolerance = 1e-6)
  # The bed, 0.5 % below the weight, and 4 %.
  expect_identical(
    sensitivities(settle(above_bed(9.85)), of = c("depth_m", "pull_kN"),
      fields = "ropes.line.length")$smooth, c(FALSE, FALSE)
  )
  expect_true(all(sensitivities(settle(above_bed(9.5)), of = c("depth_m", "pull_kN"),
    fields = "ropes.line.length")$smooth))
})

test_that("sensitivities() of a trawl equal differences with few factorisations", {
  gear <- read_gear("midwater_trawl")
  state <- settle(gear, nodes = 1500)
  # Central differences with two step sizes combine to fourth order. Small steps suit curved
  # measures, and larger steps suit measures with small changes, where rounding matters.
  shares <- list(
    warps.length = 1e-3, otter_boards.area = 1e-3,
    # much netting is nearly slack: lines change within 0.1 %
    towing.speed = 2e-4, hand_ropes.upper.length = 2e-4,
    otter_boards.mass = 4e-3, floats.buoyancy = 4e-3, sections.section_5.twine.diameter = 4e-3
  )
  of <- c("door_spread_m", "net_mouth_height_m", "total_drag_kN", "warp_tension_port_kN",
    "door_depth_m")
  found <- sensitivities(state, of = of, fields = names(shares), secants = FALSE)
  # One for all fields, and at most three for each side of a field.
  expect_lt(attr(found, "factorisations"), state$report$factorisations)
  expect_true(all(is.na(found$secant_above)))

  quiet <- function(iteration, residual) NULL
  work <- tangent_work(state)
  shape <- state_shape(state)
  tightly <- function(gear) {
    si <- gear_si(gear)
    near <- settle_numbers(si, 1500, NULL, shape, FALSE, quiet)
    tight <- engine_settle(near$mesh$model, as.double(near$position), "settled",
      as.double(near$strain), integer(), 1e-13, 200L, quiet)
    codend:::values_at(work, gear, si, near$mesh, tight$position)[of]
  }
  for (field in sensitivity_fields(gear, names(shares))) {
    difference <- function(share) {
      at <- function(share) tightly(scaled_gear(gear, field, share))
      (at(share) - at(-share)) / (2 * share)
    }
    share <- shares[[field$name]]
    wanted <- (4 * difference(share) - difference(2 * share)) / 3
    rows <- found[found$field == field$name, ]
    # relative to an elasticity of at least 0.01
    scale <- pmax(abs(wanted), 0.01 * abs(work$values[of]))
    off <- abs(rows$derivative * rows$value - wanted) / scale
    label <- paste(field$name, paste(signif(off, 2), collapse = " "))
    # Rounding leaves 1e-11 of a measure, which small steps and derivatives magnify.
    expect_lt(max(off), 1e-5, label = label)
  }
})

test_that("sensitivities() include the wake's dependence on its netting", {
  state <- suppressWarnings(settle("cage", nodes = 400))
  work <- tangent_work(state)
  expect_gt(length(state$mesh$model$wake), 0)
  field <- sensitivity_fields(state$gear, "water.current.speed")[[1]]
  slope <- tangent_derivatives(work, field)$slope
  # Wakes converge to 1e-5 of the free flow's speed, divided by twice 0.2 %: 0.3 %.
  sides <- secant_derivatives(work, field, 2e-3)
  drag <- "total_drag_kN"
  expect_equal(slope[[drag]], (sides$below[[drag]] + sides$above[[drag]]) / 2, tolerance = 3e-3)
})

test_that("sensitivities() accept single, joint and default fields", {
  state <- settle("towed_cable")
  found <- sensitivities(state, of = "total_drag_kN", secants = FALSE)
  expect_identical(found$field, c("towing.speed", "ropes.cable.length", "pieces.sphere.mass"))
  expect_s3_class(found, "codend_sensitivities")
  expect_named(found, c("measure", "field", "value", "unit", "derivative", "derivative_unit",
    "elasticity",
    "secant_below", "secant_above", "smooth"))
  expect_output(print(found), "pieces.sphere.mass +[+]1[.]03")
  expect_output(print(found[1:2]), "total_drag_kN")
  every <- sensitivities(state, of = "total_drag_kN", fields = "all", secants = FALSE)
  expect_true(all(c("ropes.cable.diameter", "pieces.sphere.volume") %in% every$field))
  expect_false("ropes.cable.segments" %in% every$field)
  of_trawl <- vapply(sensitivity_fields(read_gear("midwater_trawl"), "all"), `[[`, "", "name")
  expect_true(all(c("sections.codend.twine.diameter", "floats.number") %in% of_trawl))
  expect_false(any(grepl("meshes", of_trawl)))
  # The relative sensitivity to two joint fields is the sum of both.
  gear <- update(state$gear, pieces.sphere.drag_coefficient = 1.5,
    ropes.cable.coefficients.normal = 1.5)
  state <- settle(gear)
  paths <- c("pieces.sphere.drag_coefficient", "ropes.cable.coefficients.normal")
  both <- sensitivities(state, of = "total_drag_kN", fields = list(paths), secants = FALSE)
  each <- sensitivities(state, of = "total_drag_kN", fields = paths, secants = FALSE)
  expect_identical(both$field, paste(paths, collapse = " + "))
  expect_equal(both$elasticity, sum(each$elasticity), tolerance = 1e-7)
})

test_that("sensitivities() change an integer field by one", {
  state <- settle("midwater_trawl", nodes = 300)
  found <- sensitivities(state, of = "net_mouth_height_m", fields = "floats.number")
  more <- settle(update(state$gear, floats.number = 31), nodes = 300, from = state)
  change <- measures(more)[["net_mouth_height_m"]] - measures(state)[["net_mouth_height_m"]]
  expect_equal(found$secant_above, change, tolerance = 1e-6)
  expect_true(found$smooth)
})

test_that("sensitivities() return NA for a field that changes the parts", {
  state <- settle("longline", nodes = 200)
  found <- sensitivities(state, of = "total_drag_kN",
    fields = c("branch_lines.number", "floats.buoyancy"))
  expect_identical(is.na(found$derivative), c(TRUE, FALSE))
  expect_identical(found$smooth, c(FALSE, TRUE))
})

test_that("tornado plot is written atomically", {
  found <- sensitivities(settle(as_gear(towed_sphere)), secants = FALSE)
  expect_picture(found)
  expect_wrong(plot(found, measures = "none"))
})

test_that("default plot has tornados of one field for all measures", {
  found <- sensitivities(settle("midwater_trawl", nodes = 60), fields = "towing.speed",
    secants = FALSE)
  expect_picture(found)
})

test_that("process forked after sensitivities() terminates", {
  skip_on_os("windows")
  # large enough for two threads
  state <- settle("poly_noreastern_trawl", nodes = 6000)
  found <- sensitivities(state, of = "total_drag_kN", fields = "towing.speed", secants = FALSE)
  # the child frees its copy of the factorisation
  child <- parallel::mcparallel({
    rm(state, found)
    gc()
    1
  })
  on.exit(tools::pskill(child$pid, tools::SIGKILL))
  came <- NULL
  for (k in 1:300) {
    came <- parallel::mccollect(child, wait = FALSE, timeout = 0.1)
    if (!is.null(came)) break
  }
  expect_identical(came[[1]], 1)
})

test_that("sensitivities() name fields without effect", {
  cable <- update(read_gear("towed_cable"), ropes.cable.strength = "200 kN")
  found <- sensitivities(settle(cable), of = c("total_drag_kN", "body_depth_m"),
    fields = c("towing.speed", "ropes.cable.strength"))
  expect_output(print(found), "Below 0.01 % per %: fields ropes.cable.strength", fixed = TRUE)
  # no such line if every field has an effect
  moved <- found[found$field == "towing.speed" & found$measure == "body_depth_m", ]
  expect_no_match(capture.output(print(moved)), "Below")
})

test_that("sensitivities() accepts names of measures without unit", {
  state <- settle("towed_cable", nodes = 20)
  short <- sensitivities(state, of = "total_drag", fields = "towing.speed")
  expect_identical(short, sensitivities(state, of = "total_drag_kN", fields = "towing.speed"))
})
