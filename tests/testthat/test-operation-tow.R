# A short cable with a weight: cheap to tow many times.
short_cable_plan <- list(
  codend = 1, name = "Short cable", towing = list(speed = 2),
  points = list(ship = list(position = c(0, 0, 0), held = "moved"), body = list()),
  ropes = list(cable = list(
    from = "ship", to = "body", length = 60, diameter = 0.012, axial_stiffness = 2e6,
    mass_per_length = 0.4, segments = 12, role = "warp", strength = 5e3
  )),
  pieces = list(weight = list(
    at = "body", mass = 100, volume = 0.02, drag_area = 0.05, role = "catch"
  )),
  measures = list(depth = list(depth = "body"), tension = list(tension = "cable.start"))
)

short_cable <- function(...) {
  plan <- short_cable_plan
  plan$tow <- list(...)
  as_gear(plan)
}

test_that("tow() keeps a settled gear at rest with every scheme", {
  state <- settle(short_cable())
  for (scheme in engine_schemes()$name) {
    found <- tow(state, until = 2, every = 1, scheme = scheme)
    expect_identical(found$time, c(0, 1, 2))
    # settled to 1e-8 of the tension, stiffness of 16 N/m or more at every node: far below 1e-6 m
    moved <- found$position[, , 3] - (state$position - c(2 * 2, 0, 0))
    expect_lt(max(abs(moved)), 1e-6)
    expect_equal(measures(state_at(found, 2)), measures(state), tolerance = 1e-6)
  }
})

test_that("tow() at a new speed ends at its equilibrium", {
  found <- tow(short_cable(), until = 400, every = 400, accuracy = 1e-6, schedule = tow_schedule(
    speed = data.frame(time = c(0, 5, 5), value = c(2, 2, 3))))
  expected <- settle(update(short_cable(), towing.speed = 3))
  # oscillations decay within about 20 s; with an accuracy of 1e-6 m little remains
  expect_equal(measures(state_at(found, 400)), measures(expected), tolerance = 1e-6)
})

test_that("tow() on a new course rotates the gear", {
  found <- tow(short_cable(), until = 300, every = 300,
    schedule = tow_schedule(
      course = data.frame(time = c(0, 20, 60), value = c("0 deg", "0 deg", "90 deg"))),
    accuracy = 1e-6)
  before <- state_at(found, 0)
  after <- state_at(found, 300)
  # steps with an error of 1e-6 m each, several tens within the gear's memory, on 43 m
  expect_equal(after$position, before$position, tolerance = 3e-6)
  expect_equal(found$conditions$speed, c(2, 2))
  # 20 s ahead, a quarter of a circle of 80 m of arc, then 240 s to starboard
  radius <- 80 / (pi / 2)
  expect_equal(found$conditions$x[2], -40 - radius, tolerance = 1e-7)
  expect_equal(found$conditions$y[2], radius + 480, tolerance = 1e-7)
})

test_that("paid-out warp reaches the equilibrium of its new length", {
  found <- tow(short_cable(), until = 400, every = 400,
    schedule = tow_schedule(
      warp_out = data.frame(time = c(0, 100), value = c(60, 90))), accuracy = 1e-6)
  expected <- settle(update(short_cable(), ropes.cable.length = 90))
  expect_equal(measures(state_at(found, 400)), measures(expected), tolerance = 1e-5)
  expect_equal(found$conditions$cable, c(60, 90))
  expect_equal(sum(engine_array(state_at(found, 400), "bars", "rest")), 90)
})

test_that("tow() starts settled at its initial warp and speed", {
  found <- tow(short_cable(), until = 1, every = 1,
    schedule = tow_schedule(speed = 1.5, warp_out = 30))
  expected <- settle(update(short_cable(), towing.speed = 1.5, ropes.cable.length = 30))
  expect_equal(measures(state_at(found, 0)), measures(expected), tolerance = 1e-6)
  expect_equal(measures(state_at(found, 1)), measures(expected), tolerance = 1e-6)
})

test_that("winch respects its speed limit and slips at its tension limit", {
  slow <- tow(short_cable(), until = 100, every = 10,
    schedule = tow_schedule(
      winch = list(speed_limit = 0.2), warp_out = data.frame(time = c(0, 10), value = c(60, 70))))
  expect_equal(slow$conditions$cable, c(60, 62, 64, 66, 68, rep(70, 6)), tolerance = 1e-6)

  # the weight pulls with 0.92 kN; at the limit the winch pays out until the weight is nearly free
  free <- tow(short_cable(), until = 30, every = 5,
    schedule = tow_schedule(winch = list(speed_limit = 3, tension_limit = 800)))
  expect_true(all(diff(free$conditions$cable) > 0))
  tension <- as.data.frame(free)
  tension <- tension$value[tension$measure == "tension_kN"]
  expect_gt(tension[1], 0.88)
  # it slips at full speed at 10 % above its limit at the vessel; its speed changes every 0.05 s
  expect_lt(max(tension[-1]), 0.88 * 1.002)
  # slower, by the formula of the brake; between two choices the deviation is 1 % at most
  speed <- diff(free$conditions$cable) / 5
  expect_gt(max(tension[-1]), 0.8 * (1 + 0.1 * min(speed) / 3) * 0.99)
})

test_that("control function keeps a weight at its depth by the warp", {
  found <- tow(short_cable(), until = 600, every = 600,
    schedule = tow_schedule(winch = list(speed_limit = 0.5),
      control = function(measures, time) 0.05 * (60 - measures[["depth_m"]])))
  expect_equal(measures(state_at(found, 600))[["depth_m"]], 60, tolerance = 1e-3)
  expect_wrong(tow(short_cable(), until = 20,
    schedule = tow_schedule(control = function(measures, time) NA)))
  # a continued tow keeps the time between calls, or uses another one
  asked <- numeric()
  counted <- tow_schedule(control_every = 5, control = function(measures, time) {
    asked <<- c(asked, time)
    0
  })
  half <- tow(short_cable(), counted, until = 20, every = 10)
  whole <- tow(tow(half, until = 30), tow_schedule(control_every = 10), until = 50)
  expect_equal(asked, c(5, 10, 15, 20, 25, 30, 40, 50))
})

test_that("broken cable lets the weight sink freely", {
  found <- tow(short_cable(), until = 60, every = 10,
    schedule = tow_schedule(breaking = list(list(rope = "cable", time = 10, position = "end"))))
  expect_true(all(found$broken[1, found$time < 10] == 0))
  expect_true(all(found$broken[1, found$time >= 10] == 12))
  body <- nodes_at(found, "body")
  # weight in water over drag, including the half bar attached to the weight
  bar <- 60 / 12 / 2
  weight <- 9.81 * (100 - 1025 * 0.02 + bar * (0.4 - 1025 * pi / 4 * 0.012^2))
  expect_equal(-found$velocity[3, body, 7], sqrt(weight / (0.5 * 1025 * 0.05)), tolerance = 1e-4)
  expect_equal(found$bar_tension[12, 7], 0)

  # 5 kN of breaking load and 0.8 kN of tension: a heave of 20 m in 2 s breaks it
  snatched <- tow(short_cable(), until = 5, every = 1,
    schedule = tow_schedule(breaking = list(list(rope = "cable")),
      heave = data.frame(time = c(0, 1, 2), value = c(0, 0, 20))))
  expect_gt(max(snatched$broken), 0)
  whole <- tow(short_cable(), until = 5,
    schedule = tow_schedule(breaking = list(list(rope = "cable"))))
  expect_identical(max(whole$broken), 0)
})

test_that("catch scales weight and drag by its fraction", {
  found <- tow(short_cable(), until = 300, every = 300,
    schedule = tow_schedule(catch = data.frame(time = c(0, 100), value = c(1, 0.5))))
  expected <- settle(update(short_cable(), pieces.weight.mass = 50, pieces.weight.volume = 0.01,
    pieces.weight.drag_area = 0.025))
  expect_equal(measures(state_at(found, 300))[["tension_kN"]], measures(expected)[["tension_kN"]],
    tolerance = 1e-5)
})

test_that("state_at() returns the state after a jump", {
  jump <- function(...) data.frame(time = c(0, 10, 10), value = c(...))
  found <- tow(short_cable(), until = 20, every = 10,
    schedule = tow_schedule(catch = jump(1, 1, 0.5), heave = jump(0, 0, 0.2)))
  state <- state_at(found, 10)
  # values of the engine: position of the towing point, and mass of the motion
  expect_equal(found$conditions$heave[2], found$position[3, 1, 2], tolerance = 1e-12)
  expect_equal(state$position[3, 1], 0.2, tolerance = 1e-12)
  spheres <- function(state) state$mesh$model$spheres$drag_area
  expect_equal(spheres(state), 0.5 * spheres(state_at(found, 0)), tolerance = 1e-12)
  expect_identical(spheres(state), spheres(state_at(found, 20)))
  mass <- function(state) sum(state$mesh$model$mass)
  expect_equal(mass(state_at(found, 0)) - mass(state), 50, tolerance = 1e-12)
})

test_that("current that turns instantly exerts no acceleration force", {
  # a weight without drag on a line, which only accelerating water can move
  ball <- as_gear(list(
    codend = 1, name = "A ball in a current",
    water = list(current = list(speed = 0.5, toward = 0)),
    points = list(nail = list(position = c(0, 0, 0), held = "fixed"), end = c(a = 1)[0]),
    ropes = list(line = list(from = "nail", to = "end", length = 10, diameter = 0.001,
      axial_stiffness = 1e5, mass_per_length = 0, volume_per_length = 0, segments = 1,
      coefficients = list(normal = 0, tangential = 0, skin = 0))),
    pieces = list(ball = list(at = "end", mass = 200, volume = 0.1, diameter = 0.5,
      drag_coefficient = 1e-6))
  ))
  moved <- function(...) {
    found <- tow(ball, until = 4, every = 2, schedule = tow_schedule(current = list(...)))
    end <- found$position[, nodes_at(found, "end"), ]
    max(abs(end[, 3] - end[, 1]))
  }
  jump <- function(to) data.frame(time = c(0, 2, 2), value = c(0, 0, to))
  expect_lt(moved(speed = 0.5, toward = jump("90 deg")), 1e-4)
  expect_lt(moved(speed = 0.5, toward = function(t) if (t < 2.03) 0 else pi / 2), 1e-4)
  expect_lt(moved(speed = function(t) if (t < 2.03) 0.5 else -0.3), 1e-4)
  # water that turns within a second does move it
  slowly <- data.frame(time = c(0, 2, 3), value = c(0, 0, pi / 2))
  expect_gt(moved(speed = 0.5, toward = slowly), 0.1)
})

test_that("function_curve() is smooth except at the function's jumps", {
  curve <- function_curve(function(t) sin(t) + (t >= 1.234) - 3 * (t >= 2), "speed", "speed", 4)
  expect_equal(curve_breaks(curve, FALSE), c(1.234, 2), tolerance = 1e-7)
  expect_equal(curve_at(curve, c(1, 1.234, 1.9)), c(sin(1), sin(1.234), 1 + sin(1.9)),
    tolerance = 1e-3)
  expect_equal(curve_at(curve, c(1.2341, 2.05, 4)), c(1, -2, -2) + sin(c(1.2341, 2.05, 4)),
    tolerance = 1e-3)
  # a steep change is not a jump
  steep <- function_curve(function(t) tanh((t - 2) / 0.01), "speed", "speed", 4)
  expect_length(curve_breaks(steep, FALSE), 0)
})

test_that("curve_at() agrees with the engine on both sides of jumps", {
  # value = 1 + t up to 1 s, then Hermite's cubic from 5 at rate 0 to 6 at rate 1.5: (5 + 6) / 2 - 2
  # * 1.5 / 8 in its middle
  curve <- list(time = c(0, 1, 3), begin = c(1, 5), end = c(2, 6), begin_rate = c(1, 0),
    end_rate = c(1, 1.5))
  expect_equal(curve_at(curve, c(-1, 0, 0.5, 1, 3, 9)), c(1, 1, 1.5, 2, 6, 6))
  expect_equal(curve_at(curve, c(0, 1, 2, 3), after = TRUE), c(1, 5, 5.5 - 0.375, 6))
})

test_that("current by time moves the gear in both coordinate frames", {
  found <- tow(short_cable(), until = 400, every = 400,
    schedule = tow_schedule(
      current = list(speed = data.frame(time = c(0, 50), value = c(0, 0.7)), toward = "90 deg")))
  plan <- short_cable_plan
  plan$water <- list(current = list(speed = 0.7, toward = pi / 2))
  expect_equal(state_at(found, 400)$position, settle(as_gear(plan))$position, tolerance = 1e-5)
})

test_that("towing points follow the heave", {
  found <- tow(short_cable(), until = 10, every = 1,
    schedule = tow_schedule(heave = function(t) 0.5 * sin(t)))
  ship <- nodes_at(found, "ship")
  # cubics through values 0.1 s apart, with rates by central differences: h^2/6 of the rate
  expect_equal(found$position[3, ship, ], 0.5 * sin(found$time), tolerance = 1e-4)
  expect_equal(found$velocity[3, ship, -1], 0.5 * cos(found$time[-1]), tolerance = 5e-3)
})

test_that("tow() does not depend on its interval or on interruptions", {
  gear <- short_cable(until = 40, every = 5, course = list(list(time = 0, value = 0),
    list(time = 30, value = 1)), warp_out = list(list(time = 0, value = 60),
    list(time = 20, value = 70)), winch = list(tension_limit = 2000))
  whole <- tow(gear)
  expect_identical(tow(gear)$position, whole$position)
  often <- tow(gear, every = 0.7)
  expect_identical(often$memory, whole$memory)
  expect_identical(often$report$steps, whole$report$steps)
  # the state at 3.5 s is within a step; its solutions agree to far less than the accuracy of 0.01 m
  expect_equal(tow(gear, every = 3.5)$position[, , 2], often$position[, , 6], tolerance = 1e-6)
  # continued
  half <- tow(tow(gear, until = 18), until = 40)
  expect_identical(half$time, sort(c(whole$time, 18)))
  # several errors of steps of 0.01 m
  expect_lt(max(abs(half$position[, , 10] - whole$position[, , 9])), 0.1)
  expect_equal(half$winch_length[, 10], whole$winch_length[, 9], tolerance = 1e-3)
})

test_that("shipped trawl is shot from the surface by its plan", {
  found <- tow("midwater_trawl", until = 90, every = 45, nodes = 300)
  expect_equal(found$conditions$warp_port, c(50, 50, 140))
  expect_equal(found$conditions$speed / 0.514444, c(4, 6, 6), tolerance = 1e-5)
  start <- settle(update(read_gear("midwater_trawl"), warps.length = 50), nodes = 300)
  # they differ by 1e-8 of the largest tension; the net is slack at the surface
  expect_equal(measures(state_at(found, 0)), measures(start), tolerance = 1e-4)
  sinking <- vapply(found$time, function(t) measures(state_at(found, t))[["door_depth_m"]], 0)
  expect_gt(sinking[3], 2 * sinking[2])
})

test_that("tow() of a turning trawl rejects few steps", {
  trawl <- settle("midwater_trawl", nodes = 400)
  found <- tow(trawl, until = 480, every = 20,
    schedule = tow_schedule(course = data.frame(time = c(0, 480), value = c("0 deg", "90 deg"))))
  report <- found$report
  rejected <- report$repeated + report$not_found + report$unbalanced
  # 18 % of the attempts are rejected, because lines become slack and taut
  expect_lt(rejected / (rejected + report$steps), 0.2)
})

test_that("tow() ignores the plan's schedule if it contradicts the state", {
  gear <- short_cable(until = 40, every = 5, warp_out = list(list(time = 0, value = 30),
    list(time = 20, value = 60)), speed = 3)
  found <- tow(settle(gear), until = 10, every = 10)
  expect_equal(found$conditions$speed, c(2, 2))
  expect_equal(measures(state_at(found, 10)), measures(settle(gear)), tolerance = 1e-6)
  expect_wrong(tow(settle(gear)), "`state` differs in cable from")
  expect_wrong(tow(settle(short_cable())), "`until`")
})

test_that("tow() follows the plan's schedule if it starts with the state", {
  gear <- short_cable(until = 4, every = 2, speed = list(
    list(time = 0, value = 2), list(time = 4, value = 2.5)
  ))
  found <- tow(settle(gear))
  whole <- tow(gear)
  expect_equal(found$conditions$speed, c(2, 2.25, 2.5))
  expect_identical(found$position, whole$position)
  # arguments take precedence over the plan
  expect_equal(tow(settle(gear), schedule = tow_schedule(speed = 2))$conditions$speed, c(2, 2, 2))
})

test_that("tow() rejects saved motion that does not fit its mesh", {
  trajectory <- tow("towed_cable", until = 2, every = 1, nodes = 30)
  for (field in c("position", "velocity", "acceleration")) {
    for (motion in c("now", "before")) {
      forged <- trajectory
      forged$memory[[motion]][[field]] <- forged$memory[[motion]][[field]][-1]
      expect_error(tow(forged, until = 3), field, class = "codend_error_engine")
    }
  }
  trajectory$energy <- trajectory$energy[1:3, ]
  expect_error(tow(trajectory, until = 3), "energy", class = "codend_error_engine")
})

test_that("trajectory has tables, a print and a summary", {
  found <- tow(short_cable(), until = 4, every = 2)
  expect_identical(nrow(as.data.frame(found, what = "nodes")), 13L * 3L)
  measured <- as.data.frame(found)
  expect_identical(unique(measured$time_s), c(0, 2, 4))
  expect_identical(measured$value[measured$time_s == 2], unname(measures(state_at(found, "2 s"))))
  tension <- as.data.frame(found, what = "tensions")
  # at the end node, as the measure
  largest <- measures(state_at(found, 0))[["largest_rope_tension_kN"]]
  expect_equal(tension$max_kN[1], largest)
  expect_output(print(found), "4 s, 3 states")
  expect_output(print(found),
    "tr bdf2, error per step at most 0.01 m of position; no error control of tensions")
  judged <- tow(short_cable(), until = 1, every = 1, accuracy = list(tension = 0.05))
  expect_output(print(judged), "0.01 m of position and 5 % of the largest tension")
  expect_output(print(tow(short_cable(), until = 1, every = 1, step = 0.5)), "fixed steps")
  expect_output(print(summary(found)), "depth +m")
})

test_that("jump at time 0 acts like any other jump", {
  at_once <- tow(short_cable(), until = 10, every = 10,
    schedule = tow_schedule(speed = data.frame(time = c(0, 0), value = c(2, 3))))
  later <- tow(short_cable(), until = 12, every = 6,
    schedule = tow_schedule(speed = data.frame(time = c(0, 2, 2), value = c(2, 2, 3))))
  expect_equal(state_at(at_once, 0)$position, settle(short_cable())$position, tolerance = 1e-6)
  # the same motion, in other steps with an error of 0.01 m each
  shifted <- state_at(later, 12)$position - state_at(at_once, 10)$position
  expect_lt(max(abs(shifted)), 0.03)
  # and differs from a cable that settled at the new speed
  settled <- settle(update(short_cable(), towing.speed = 3))
  moved <- tow(short_cable(), until = 1, every = 1,
    schedule = tow_schedule(speed = data.frame(time = c(0, 0), value = c(2, 3))))
  expect_gt(max(abs(state_at(moved, 1)$position - settled$position)), 1)
})

test_that("tow() rejects an interval longer than the tow", {
  expect_wrong(tow("towed_cable", until = "10 s", every = "20 s"),
    "`every` is 20 s; it must be at most `until`, 10 s")
  # the interval of the plan does not limit a shorter tow
  gear <- short_cable(until = 40, every = 20)
  expect_identical(tow(gear, until = 5)$time, c(0, 5))
})
