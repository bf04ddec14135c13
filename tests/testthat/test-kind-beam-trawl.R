test_that("beam trawl keeps its frame's width and height at every resolution", {
  trawl <- read_gear("beam_trawl")
  found <- lapply(c(200, 1500), function(nodes) settle(trawl, nodes = nodes))
  slow <- settle(update(trawl, towing.speed = "2 knot"), nodes = 1500)
  found <- c(found, list(slow, settle(update(trawl, towing.speed = "5 knot"), nodes = 400)))
  frame <- found[[1]]$si$ropes
  for (state in found) {
    # 10 kN on a strut of 100 MN and 4 m stretch it by less than 1 mm
    expect_equal(measures(state)[["wing_end_spread_m"]], 4, tolerance = 1e-3 / 4)
    corner <- function(name) state$position[, nodes_at(state, name)]
    for (rope in names(frame)[vapply(frame, `[[`, "", "role") %in% "frame"]) {
      ends <- vapply(frame[[rope]][c("from", "to")], corner, numeric(3))
      expect_equal(sqrt(sum((ends[, 1] - ends[, 2])^2)), frame[[rope]]$length, tolerance = 1e-3,
        label = rope)
    }
    # at most one end of the shoes is lifted; upside down the beam would be below them
    beam <- corner("beam_middle")[3]
    expect_gt(beam - max(corner("toe_port")[3], corner("lower_port")[3]), 0.2)
    expect_equal(corner("upper_port")[3], corner("upper_starboard")[3], tolerance = 1e-6)
  }
  found <- measures(slow)
  # at 2 knot the shoes remain on the seabed, with a penetration of less than 20 mm
  expect_lt(found[["beam_height_m"]], 0.6)
  expect_gt(found[["beam_height_m"]], 0.58)
  # the net hangs from the beam's ends: the headline sags slightly between them (with 400 nodes it
  # is 10 % too high, with 5,000 at 0.598 m)
  expect_equal(found[["headline_height_m"]], found[["beam_height_m"]], tolerance = 0.05)
})

test_that("beam trawl starts on the seabed with the beam at shoe height", {
  gear <- read_gear("beam_trawl")
  fields <- gear_checked(gear)$fields
  z <- vapply(beam_trawl_start(fields), `[`, 0, 3)
  bed <- -fields$seabed$depth
  expect_equal(z[["upper_port"]], bed + fields$shoes$height)
  # a shoe on the seabed has its middle within its height
  expect_true(z[["toe_port"]] > bed && z[["toe_port"]] < bed + fields$shoes$height / 2)
})

test_that("beam trawl's ground load is its weight less the warp's lift", {
  trawl <- update(read_gear("beam_trawl"), towing.speed = "3 knot")
  found <- lapply(c("300 kg", "250 kg"), function(mass) {
    measures(settle(update(trawl, shoes.mass = mass), nodes = 400))
  })
  for (m in found) {
    # Coulomb: all contacts slide; the friction model is smooth only near standstill
    friction <- m[["ground_friction_percent"]] / 100 * m[["total_drag_kN"]]
    expect_equal(friction, 0.5 * m[["ground_load_kN"]], tolerance = 1e-3)
  }
  # Reference: lighter shoes, of steel of 7850 kg/m3, weigh less in water. This weight reduces the
  # ground load or the warp's lift.
  weight <- 9.81e-3 * 100 * (1 - 1025 / 7850)
  pressed_or_lifted <- vapply(found, function(m) {
    m[["ground_load_kN"]] + m[["warp_tension_kN"]] * sin(m[["warp_declination_deg"]] * pi / 180)
  }, 0)
  # drag lifts the net and the warp slightly less or more as they rotate
  expect_equal(pressed_or_lifted[1] - pressed_or_lifted[2], weight, tolerance = 0.01)
})

test_that("beam trawl has the plan's ticklers and settles on a slope", {
  trawl <- read_gear("beam_trawl")
  bare <- settle(update(trawl, ticklers = NULL, bridles.middle = NULL), nodes = 400)
  expect_false(any(c("tickler_1_tension_kN", "bridle_middle_tension_kN") %in%
    names(measures(bare))))
  ropes <- assembly(trawl)$plan$ropes
  expect_identical(ropes$tickler_3[c("from", "to")], list(from = "toe_port", to = "toe_starboard"))
  expect_identical(ropes$headline$along, "back_square.upper")
  # net makers do not read the struts
  expect_false("frame" %in% plan_figure(trawl)$ropes$name)
  expect_identical(settle(assembly(trawl), nodes = 400)$position,
    settle(trawl, nodes = 400)$position)
  on_slope <- settle(update(trawl, seabed.slope = list(angle = "5 deg", toward = "90 deg")),
    nodes = 400)
  heel <- vapply(c("lower_port", "lower_starboard"), function(point) {
    on_slope$position[3, nodes_at(on_slope, point)]
  }, 0)
  # 4 m across the slope, with both shoes on the bed
  expect_equal(unname(heel[1] - heel[2]), 4 * sin(5 * pi / 180), tolerance = 0.02)
})

test_that("beam trawl that slows down ends as it settles there", {
  trawl <- read_gear("beam_trawl")
  slowed <- tow(settle(trawl, nodes = 400), until = 60, every = 60,
    schedule = tow_schedule(speed = data.frame(time = c(0, 10), value = c(2.058, 1.5))))
  found <- measures(state_at(slowed, 60))
  expected <- measures(settle(update(trawl, towing.speed = 1.5), nodes = 400))
  same <- c("beam_height_m", "wing_end_spread_m", "warp_tension_kN", "ground_load_kN")
  # steps are accurate to about 1 mm of position, and most of the change decays within a minute
  expect_equal(found[same], expected[same], tolerance = 0.01)
})
