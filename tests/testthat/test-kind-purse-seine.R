# The purse seine: its assembly, its operation and its measures.

test_that("short form of a purse seine keeps the plan's lengths and weights", {
  gear <- read_gear("purse_seine")
  si <- codend:::gear_si(gear)
  expect_equal(si$ropes$float_line$length, 300)
  expect_equal(si$ropes$lead_line$length, 315)
  # 315 kg of lead, 300 m of floats at 26 N/m
  expect_equal(si$pieces$sinkers$number * si$pieces$sinkers$mass, 320)
  lift <- codend:::gear_gravity * (1025 * si$pieces$floats$volume - si$pieces$floats$mass)
  expect_equal(si$pieces$floats$number * lift, 7800, tolerance = 1e-9)
  # the stretched meshes of the selvedges are as long as the meshes they join
  strip <- si$panels$selvedge_lower_body
  expect_equal(strip$upper * strip$mesh_size, si$panels$body$lower * si$panels$body$mesh_size)
  expect_length(si$ropes$purse_wire$through, 40)
  # the vessel's length closes the circle
  gap <- sqrt(sum((si$points$stern$position - si$points$bow$position)^2))
  radius <- 300 / (345 * pi / 180)
  expect_equal(gap, 2 * radius * sin(15 / 2 * pi / 180))
})

test_that("line without a length is hung by ratio on all panels", {
  panel <- function(upper, lower, mesh_size) {
    list(meshes = list(upper = upper, lower = lower), mesh_size = mesh_size)
  }
  fields <- list(panels = list(panel(1000, 900, 0.1), panel(500, 400, 0.2)),
    float_line = list(hanging_ratio = 0.7), lead_line = list(hanging_ratio = 0.8))
  expect_equal(codend:::seine_line_length(fields, "float_line"), 0.7 * (100 + 100))
  expect_equal(codend:::seine_line_length(fields, "lead_line"), 0.8 * (90 + 80))
})

test_that("enclosed volume equals the volume of an inclined circular wall", {
  gear <- read_gear("purse_seine")
  si <- codend:::gear_si(gear)
  # netting of bars has a coarser mesh inside its edges
  for (nodes in c(cells = 300, bars = 3000)) {
    netting <- if (nodes == 300) "cells" else "bars"
    mesh <- codend:::build_mesh(si, nodes, netting)
    lead <- along_rope(mesh, "lead_line")$node
    # The netting's ends meet: upright walls close the gap between them, without inclination.
    angle <- 2 * pi * codend:::shot_reach(si, mesh) / 300
    angle[along_rope(mesh, "side_line_first")$node] <- 0
    angle[along_rope(mesh, "side_line_last")$node] <- 2 * pi
    deep <- -hung_shape(mesh)[3, ]
    deep <- deep * 30 / max(deep[lead])
    deep[lead] <- 30
    # half as wide at 30 m as at the surface
    radius <- 48 * (1 - deep / 60)
    state <- codend:::new_state(gear, si, mesh,
      as.vector(rbind(radius * cos(angle), radius * sin(angle), -deep)), list(converged = TRUE))
    area <- sum(48^2 * sin(diff(c(angle[lead], 2 * pi))) / 2)
    asked <- list(list(kind = "enclosed_volume", rope = "lead_line"))
    found <- codend:::measure_values(state, asked)
    # Corners of the netting are up to half a column, about 1/40 of the circle, from the lead line's
    # corners. Polygons of 40 corners are 4e-3 smaller than the circle.
    expect_equal(found, area * 30 * (1 + 1 / 2 + 1 / 4) / 3, tolerance = 4e-3, label = netting)
  }
})

test_that("undisturbed seine hangs straight down from its floats", {
  state <- settle("purse_seine")
  # Transferred from the coarsest level; a crude layout as fine as this takes over a hundred
  # iterations.
  expect_lt(state$report$iterations, 100)
  mesh <- state$mesh
  float <- state$position[3, nodes_at(mesh, "float_line.middle")]
  # Slack across, the netting hangs to its full stretched depth: 2000 meshes of 25.4 mm and
  # selvedges of 60 of 30 mm. Lead of 1 kg/m stretches it by less than 0.1 %.
  expect_equal(measures(state)[["lead_line_depth_middle_m"]] + float, 2000 * 0.0254 + 60 * 0.03,
    tolerance = 1e-3)

  # No part waits to be shot again when pursing starts from this state.
  pursed <- tow(state, until = 4, every = 4, accuracy = 0.3,
    schedule = tow_schedule(warp_out = data.frame(time = c(0, 4), value = c(450, 446))))
  moved <- pursed$position[, , 2] - pursed$position[, , 1]
  wire <- along_rope(state, "purse_wire")$node
  expect_true(all(colSums(moved[, setdiff(wire, which(engine_array(mesh, "held")))]^2) > 0))
})

test_that("seine settles to the state after sinking, or reports failure", {
  gear <- update(
    read_gear("purse_seine"), rings.number = 12, shooting.speed = "30 m/s",
    water = list(current = list(speed = "0.2 m/s", toward = "0 deg"))
  )
  state <- settle(gear, nodes = 300)
  si <- codend:::gear_si(gear)
  # a quarter of an hour in the current, then settled, without a crude layout
  start <- codend:::shot_trajectory(gear, si, list(), 900, 150, "cells")
  method <- codend:::tow_method("tr_bdf2", 0.5, NULL)
  sunk <- codend:::last_shape(codend:::integrate_trajectory(start, 900, 900, method))
  found <- codend:::settle_numbers(si, 300, NULL, sunk, through_levels = FALSE)
  expect_true(found$report$converged)
  sunk <- codend:::new_state(gear, si, found$mesh, found$position, found$report)
  tight <- c("lead_line_depth_middle_m", "enclosed_volume_m3", "end_rope_first_tension_kN")
  # settled to 1e-8 of the largest tension; slack netting has little stiffness
  expect_equal(measures(sunk)[tight], measures(state)[tight], tolerance = 1e-4)

  # both methods are tried, with too few iterations for either
  expect_error(with_settle_iterations(3L, settle(gear, 150)), "did not settle: after 3 iterations",
    class = "codend_error_not_converged")
})

test_that("seine sinks and its wire closes it with one tension", {
  gear <- update(
    read_gear("purse_seine"), rings.number = 12, shooting.speed = "30 m/s", pursing.wait = "20 s",
    pursing.speed = "10 m/s", pursing.until = "150 m"
  )
  seine <- tow(gear, every = 10, nodes = 150, accuracy = 0.3)
  expect_equal(seine$end, "reached")
  table <- as.data.frame(seine, what = "measures")
  value <- function(measure) table$value[table$measure == measure]
  expect_gt(min(diff(value("lead_line_depth_middle_m")[1:4])), 1)
  # the seine is released gradually: the end that is shot first is deepest
  expect_gt(value("lead_line_depth_quarter_m")[2], value("lead_line_depth_three_quarters_m")[2])
  last <- length(seine$time)
  state <- state_at(seine, seine$time[last])
  wire <- codend:::rope_bars(state$mesh, "purse_wire")
  expect_true(all(state$bar_tension[wire] == state$bar_tension[wire[1]]))
  expect_gt(state$bar_tension[wire[1]], 0)
  # the wire has the length that the winch paid out, except stretch and at most 0.02 m per ring
  stretched <- 150 * (1 + state$bar_tension[wire[1]] / state$si$ropes$purse_wire$axial_stiffness)
  expect_lt(abs(sum(state$bar_length[wire]) - stretched), 12 * 0.02)
  expect_lt(value("enclosed_volume_m3")[last], 0.7 * max(value("enclosed_volume_m3")))
  # the davit carries the wire's tension
  pull <- -state$force[, nodes_at(state, "davit_first")]
  expect_equal(sqrt(sum(pull^2)), state$bar_tension[wire[1]], tolerance = 0.02)
})
