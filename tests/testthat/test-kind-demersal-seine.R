# The demersal seine: its ropes on the ground, its haul and its measures.

# A rope of 1 kg/m on the seabed, without water, so that only friction acts on it.
dry_rope <- function(...) {
  rope(..., length = "100 m", diameter = "20 mm", mass_per_length = "1 kg/m",
    axial_stiffness = "2 MN", role = "warp")
}
dry_ground <- list(
  water = list(density = 0), seabed = list(depth = "10 m", friction = 0.5),
  towing = list(speed = "1 m/s")
)
friction_of_metre <- 0.5 * gear_gravity

test_that("rope dragged sideways has the catenary of its friction", {
  end <- function(y) gear_point(position = c(0, y, -9.99), held = "moved")
  gear <- do.call("gear", c(list("Dragged rope", port = end(-30), starboard = end(30),
    rope = dry_rope("port", "starboard", segments = 50)), dry_ground))
  state <- settle(gear)
  a <- stats::uniroot(function(a) 2 * a * sinh(30 / a) - 100, c(5, 100))$root
  sag <- a * (cosh(30 / a) - 1)
  # chords of 2 m and the penetration; friction is regularised by 2 parts in 10,000 at 1 m/s
  expect_equal(max(state$position[1, ]), sag, tolerance = 0.005)
  expect_equal(state$bar_tension[1], friction_of_metre * (a + sag), tolerance = 0.02)
})

hauled_rope <- function() {
  do.call("gear", c(list("Hauled rope",
    block = gear_point(position = c(0, 0, -9.99), held = "moved"), end = gear_point(),
    rope = dry_rope("block", "end", segments = 25),
    laid = list(net = c(100, 0), ropes = list(rope = list()))), dry_ground))
}

test_that("laid rope is hauled with the friction of its remaining length", {
  haul <- tow(hauled_rope(), until = 200, every = 20, accuracy = 0.02,
    schedule = tow_schedule(speed = 0, warp_out = data.frame(time = c(0, 200), value = c(100, 40))))
  expect_equal(haul$conditions$rope, seq(100, 40, by = -6), tolerance = 1e-9)
  end <- haul$mesh$places[["end"]]
  for (k in 3:11) {
    out <- haul$conditions$rope[k]
    state <- state_at(haul, haul$time[k])
    # slack from laying, and stretch
    expect_lt(abs(haul$position[1, end, k] - out), 0.1)
    # every metre rubs on the bed, except half of the bar at the block, of 4 m
    pull <- 1000 * measures(state)[["total_drag_kN"]]
    expect_gt(pull, friction_of_metre * (out - 4))
    expect_lt(pull, friction_of_metre * (out + 0.5))
  }
})

test_that("tow() rejects a controlled winch for a laid rope", {
  expect_error(tow(hauled_rope(), until = 10,
    schedule = tow_schedule(winch = list(tension_limit = 100))), "winch",
    class = "codend_error")
})

test_that("haul closes, balances energy and ends at vessel plus winch speed", {
  gear <- update(read_gear("demersal_seine"), warps.segments = 40)
  haul <- tow(gear, nodes = 150, every = 120, accuracy = 0.5)
  table <- as.data.frame(haul, what = "measures")
  series <- function(name) table$value[table$measure == name]
  area <- series("enclosed_area_m2")
  # the kite from the vessel by both corners to the net; bridles and half of the mouth add to it
  expect_equal(area[1], 1140 * 640, tolerance = 0.05)
  # two ropes enclose at most a circle's area, by which Eigaard et al. (2016) estimate a haul's area
  circle <- (2 * 1760)^2 / (4 * pi)
  expect_lt(max(area), circle)
  expect_gt(area[1], 0.6 * circle)
  # the haul ends closed; the vessel's motion ahead bounds its growth
  expect_lt(area[length(area)], 0.01 * area[1])
  speed <- series("net_speed_m_per_s")
  # while the vessel takes up the slack the net is at rest, except for sinking netting
  expect_lt(max(speed[haul$time > 200 & haul$time < 420]), 0.1)
  last <- speed[length(speed)]
  # 1 knot of the vessel and 1 of the winch: 2 knots, the published maximum (Seafood Scotland)
  expect_equal(last, 2 * 1852 / 3600, tolerance = 0.02)
  # The ground gear, of 60 mm, stays on the bed. Floats lift its ends while the ropes are slack.
  node <- haul$mesh$ropes$ground_gear$node
  height <- apply(haul$position[, node, ], 3, height_above_ground, ground = haul$si$ground)
  expect_lt(max(apply(height, 2, stats::median)), 0.06)
  expect_lt(max(height[, haul$time >= 720]), 0.5)
  expect_false("net leaves the bed" %in% findings(haul)$check)
  # wing ends separate first and then close
  wide <- series("wing_end_spread_m")
  expect_gt(max(wide), 0.5 * 36)
  expect_lt(wide[length(wide)], 0.2 * max(wide))
  expect_lt(max(abs(haul$conditions$energy_imbalance)),
    0.02 * max(haul$conditions$energy_put_through))
  # at the end the tow is steady, so inertia is negligible
  state <- state_at(haul, max(haul$time))
  free <- !state$mesh$model$held
  expect_lt(abs(sum(state$force[1, free])), 0.05 * 1000 * measures(state)[["total_drag_kN"]])
})

test_that("findings() reports a seine whose floats lift it off the bed", {
  gear <- update(read_gear("demersal_seine"), warps.segments = 40,
    ground_gear.mass_in_water = "2 kg/m")
  haul <- tow(gear, nodes = 150, until = 180, every = 60, accuracy = 0.5)
  found <- findings(haul)
  found <- found[found$check == "net leaves the bed", ]
  # It rises all the time, so the last saved height is the largest. The sea bed is level.
  node <- haul$mesh$ropes$ground_gear$node
  above <- haul$position[3, node, length(haul$time)] + 80
  expect_equal(found$value, stats::median(above) - 0.03, tolerance = 1e-6)
  expect_match(found$message, "leaves the sea bed at 60.* s; at 180")
  expect_output(print(summary(haul)), "Warnings.*leaves the sea bed")
})
