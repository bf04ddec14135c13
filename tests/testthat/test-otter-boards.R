# Otter boards as rigid bodies: coefficients, equilibrium of forces and moments, and warnings.

towed_board <- function(...) update(read_gear(test_path("plans", "towed_board.yaml")), ...)

test_that("board_polar() has the published coefficients and plausible ones between", {
  for (name in c("low_aspect_cambered", "krill_cambered")) {
    polar <- board_polar(name)
    engine <- engine_polar(polar)
    expect_equal(polar$attack[which.max(polar$lift)], 30)
    expect_equal(engine$lift[polar$published], polar$lift[polar$published])
    expect_true(all(diff(engine$angle) > 0))
    expect_equal(range(engine$angle), c(-pi, pi))
    expect_true(all(polar$drag > 0))
    # Across the flow a plate has no lift.
    expect_equal(polar$lift[polar$attack == 90], 0, tolerance = 1e-12)
    # Lift grows up to the stall, and then falls to zero along the straight line.
    front <- polar[polar$lift > 0 & polar$attack > 0 & polar$attack <= 30, ]
    expect_true(all(diff(front$lift) > 0))
  }
})

test_that("check rejects a board without two angles or known name", {
  expect_wrong(board_polar("suberkrub"))
  expect_wrong(board_polar(data.frame(attack = 20, lift = 1, drag = 0.3)))
  expect_refused(
    towed_board(otter_boards.otter_board.polar = list(list(attack = "95 deg", lift = 1, drag = 1),
      list(attack = "10 deg", lift = 1, drag = 1)))
  )
  expect_refused(
    towed_board(otter_boards.otter_board.attachments = list(
      board = list(aft = 0.5, up = 0), upper = list(aft = 0.5, up = 1),
      lower = list(aft = 0.5, up = -1)
    )),
    "not in one line"
  )
})

test_that("forces and moments on a board sum to zero", {
  state <- settle(towed_board())
  board <- state$si$otter_boards$otter_board
  x <- state$position[, nodes_at(state, board$points)]
  # Its axes, computed from its three points by least squares (Kabsch), independently of the engine.
  local <- board$attachment - rowMeans(board$attachment)
  turned <- svd((x - rowMeans(x)) %*% t(local))
  rotation <- turned$u %*% diag(c(1, 1, det(turned$u %*% t(turned$v)))) %*% t(turned$v)
  place <- function(p) drop(rotation %*% (p - rowMeans(board$attachment))) + rowMeans(x)
  # 30 kN on struts of 1e8 N/m each: below a millimetre.
  expect_lt(max(abs(rotation %*% local + rowMeans(x) - x)), 1e-3)

  pull <- function(rope, node) {
    bars <- rope_bars(state$mesh, rope)
    ends <- matrix(engine_array(state, "bars", "node")[rbind(2L * bars - 1L, 2L * bars)], 2L)
    k <- which(ends == node, arr.ind = TRUE)
    d <- state$position[, ends[3L - k[1, 1], k[1, 2]]] - state$position[, node]
    bar <- bars[k[1, 2]]
    # its tension, and half of its drag and weight in water
    rest <- engine_array(state, "bars", "rest")[bar]
    line <- state$si$ropes[[rope]]
    weight <- gear_gravity * rest * (line$mass_per_length - 1025 * line$volume_per_length)
    pull <- state$bar_tension[bar] * d / sqrt(sum(d^2))
    pull + state$forces$bar_drag[, bar] / 2 - c(0, 0, weight / 2)
  }
  ropes <- c("warp", "backstrop_upper", "backstrop_lower")
  pulls <- mapply(pull, ropes, nodes_at(state, board$points))
  speed <- 3 * 1852 / 3600
  attack <- state$boards$attack
  flow <- c(1, 0, 0)
  span <- drop(rotation %*% c(0, 0, 1))
  across <- flow - sum(flow * span) * span
  chord <- drop(rotation %*% c(1, 0, 0))
  outward <- drop(rotation %*% c(0, 1, 0))
  expect_equal(attack, atan2(sum(flow * outward), sum(flow * chord)), tolerance = 1e-3)
  polar <- engine_polar(board$polar)
  coefficient <- function(which, slope, at) {
    stats::splinefunH(polar$angle, polar[[which]], polar[[slope]])(at)
  }
  q <- 0.5 * 1025 * board$area * speed^2
  crossing <- function(a, b) c(a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3],
    a[1] * b[2] - a[2] * b[1])
  lift <- q * coefficient("lift", "lift_slope", attack) * sqrt(sum(across^2)) * crossing(span, flow)
  drag <- q * (coefficient("drag", "drag_slope", attack) * sum(across^2) +
    coefficient("drag", "drag_slope", 0) * sum(flow * span)^2) * flow
  forces <- cbind(
    pulls, lift + drag, c(0, 0, -gear_gravity * board$mass),
    c(0, 0, gear_gravity * 1025 * board$volume)
  )
  arms <- cbind(
    x, place(c(board$pressure_centre * board$chord, 0, 0)), place(board$gravity_centre),
    place(board$buoyancy_centre)
  ) - rowMeans(x)
  moments <- sapply(seq_len(ncol(forces)), function(k) crossing(arms[, k], forces[, k]))
  # The deformed struts rotate the axes by about 1e-4; forces of 10 kN.
  expect_lt(max(abs(rowSums(forces))), 1e-3 * max(abs(forces)))
  expect_lt(max(abs(rowSums(moments))), 1e-3 * max(abs(moments)))
})

test_that("warp attachment on the board sets its angle of attack", {
  at <- c(0.5, 0.6, 0.7)
  attack <- vapply(at, function(aft) {
    state <- settle(towed_board(otter_boards.otter_board.attachments.board.aft = aft))
    measures(state)[["attack_deg"]]
  }, 0)
  expect_true(all(diff(attack) > 1))
})

test_that("board to port is the mirror image of one to starboard", {
  starboard <- settle(towed_board())
  port <- settle(towed_board(otter_boards.otter_board.lift_direction = "port"))
  # Both are solved to 1e-8 of the largest tension, and so are the angles.
  expect_equal(port$position * c(1, -1, 1), starboard$position, tolerance = 1e-6)
  expect_equal(port$boards$heel, starboard$boards$heel, tolerance = 1e-5)
})

# Hides the second warning of a stalled board: its falling lift drives oscillations.
without_flutter <- function(code) {
  muffle <- function(w) invokeRestart("muffleWarning")
  withCallingHandlers(code, codend_warning_board_flutter = muffle)
}

# Returns a board that stalls and warns because its warp is attached far aft.
stalled_board <- function(aft) {
  gear <- towed_board(otter_boards.otter_board.attachments.board.aft = aft)
  expect_warning(state <- without_flutter(settle(gear)), class = "codend_warning_board_stalled")
  state
}

test_that("board swings with the published period and decays within seconds", {
  state <- settle(towed_board())
  modes <- as.data.frame(state, what = "board_modes")
  # Y.-H. Kim, J. Korean Soc. Fish. Ocean Technol. 53, 2017: the tilt of a bottom trawl's boards
  # oscillates with a period of 5 +- 2 s on average.
  swings <- modes[modes$condition == "swings" & modes$damping < 0.7, ]
  expect_true(any(swings$period_s > 3 & swings$period_s < 7))
  expect_true(all(swings$decay_s < 7))
  expect_true(all(modes$growth_per_s < 0))
  # Over a quarter of a second the speed rises by 7 %. The oscillation has decayed after 7 s: the
  # remaining change is monotonic.
  towed <- tow(state, until = 20, every = 0.5,
    schedule = tow_schedule(
      speed = data.frame(time = c(0, 0.25, 20), value = c(1.5433, 1.65, 1.65))))
  shown <- as.data.frame(towed)
  attack <- shown$value[shown$measure == "attack_deg" & shown$time_s >= 7]
  expect_lt(diff(range(attack)), 0.1)
  expect_equal(length(attack), 27L)
})

test_that("settle() warns about a fluttering board, and tow() confirms it", {
  gear <- towed_board(otter_boards.otter_board.attachments.board.aft = "0.75 m")
  expect_warning(
    expect_warning(state <- settle(gear), class = "codend_warning_board_flutter"),
    class = "codend_warning_board_stalled"
  )
  mode <- as.data.frame(state, what = "board_modes")[1L, ]
  expect_identical(mode$condition, "flutters")
  expect_identical(mode$board, "otter_board")
  expect_true(any(findings(state)$check == "flutter"))
  # A change of its speed by 0.1 % makes it leave its position.
  towed <- tow(state, until = 15, every = 0.5,
    schedule = tow_schedule(
      speed = data.frame(time = c(0, 0.25, 15), value = c(1.5433, 1.5448, 1.5448))))
  shown <- as.data.frame(towed)
  attack <- shown$value[shown$measure == "attack_deg"]
  expect_gt(diff(range(attack[shown$time_s[shown$measure == "attack_deg"] > 10])), 1)
})

test_that("stalled board keeps the heel of a neighbouring design", {
  state <- stalled_board("0.82 m")
  expect_false(state$report$unstable)
  expect_lt(abs(state$boards$heel - stalled_board("0.75 m")$boards$heel) * 180 / pi, 5)
})

test_that("settle() warns about stalled and fallen boards", {
  state <- stalled_board("0.75 m")
  table <- board_table(state)
  expect_equal(table$condition, "stalled")
  expect_gt(table$attack_deg, table$stall_deg)
  expect_match(paste(format(summary(state)), collapse = " "), "stalled")
  expect_warning(state <- without_flutter(settle(towed_board(towing.speed = "1 knot"))),
    class = "codend_warning_board_fallen_over"
  )
  expect_gt(abs(board_table(state)$heel_deg), 45)
})

free_boards <- function() {
  list(
    attitude = "free", chord = "2.45 m", span = "4.9 m", mass = "4 tonne", density = "7850 kg/m3",
    polar = "krill_cambered", centre_of_gravity = list(aft = "1.2 m", up = "-0.5 m"),
    warp_at = list(aft = "0.9 m", up = "0 m", inward = "0.6 m"),
    upper_backstrop_at = list(aft = "2.2 m", up = "1.2 m", inward = "0.1 m"),
    lower_backstrop_at = list(aft = "2.2 m", up = "-1.2 m", inward = "0.1 m")
  )
}

test_that("trawl boards swing with equal periods on different meshes", {
  gear <- update(read_gear("midwater_trawl"), otter_boards = free_boards())
  period <- vapply(c(500, 1500), function(nodes) {
    modes <- as.data.frame(settle(gear, nodes = nodes), what = "board_modes")
    expect_true(all(modes$growth_per_s < 0))
    # The two boards together and in opposition, in the 5 +- 2 s of Kim (2017) as above. Modes with
    # more damping belong to the whole net.
    own <- modes$period_s[modes$damping < 0.4 & modes$period_s > 3 & modes$period_s < 7]
    expect_length(own, 2L)
    expect_equal(own[1L], own[2L], tolerance = 0.05)
    mean(own)
  }, 0)
  expect_equal(period[1L], period[2L], tolerance = 0.1)
})

# Coefficients of a fixed board with the force of free ones: sideways, up, along.
fixed_coefficients <- function(state) {
  force <- state$forces$plate_force
  speed <- state$si$towing$speed
  per <- 0.5 * state$si$water$density * state$si$otter_boards[[1L]]$area * speed^2
  list(
    lift_coefficient = mean(abs(force[2, ])) / per,
    vertical_lift_coefficient = mean(force[3, ]) / per,
    drag_coefficient = mean(force[1, ]) / per
  )
}

test_that("fixed and free boards agree at rest", {
  # One board. The tension at the warp's end is the sum of the forces on the board and the gear
  # behind it, at any point of action. So the warp must have the same shape and tension.
  free <- settle(towed_board())
  board <- free$si$otter_boards$otter_board
  plan <- yaml::read_yaml(test_path("plans", "towed_board.yaml"))
  plan[c("otter_boards", "measures")] <- NULL
  plan$points[c("upper", "lower")] <- NULL
  for (rope in c("backstrop_upper", "backstrop_lower")) plan$ropes[[rope]]$from <- "board"
  plan$pieces$fixed <- c(fixed_coefficients(free), list(at = "board", area = board$area,
    lift_direction = "starboard", mass = board$mass, volume = board$volume))
  fixed <- settle(as_gear(plan))
  end <- function(state) state$position[, state$mesh$points[["board"]]]
  # Only the backstrops, 0.63 m aside in 6 m on the free board, have another angle to the flow. The
  # change of their drag is quadratic: 2 x 0.014 m x 6 m x 1.2 x 1.22 kPa x 0.1^2 / 2 = 1.2 N of 12
  # kN.
  expect_lt(max(abs(end(fixed) - end(free))), 1e-4 * sqrt(sum(end(free)^2)))
  expect_equal(fixed$bar_tension[1L], free$bar_tension[1L], tolerance = 1e-4)
  # A whole trawl: the ends of the hand ropes are 2.4 m apart on free boards and at one point on
  # fixed ones. The difference is 1.7 % of the net's height of 143 m.
  trawl <- read_gear("midwater_trawl")
  free <- settle(update(trawl, otter_boards = free_boards()), nodes = 400)
  board <- free$si$otter_boards[[1L]]
  fixed <- settle(nodes = 400, update(trawl, otter_boards = c(
    fixed_coefficients(free), list(area = board$area, mass = board$mass, volume = board$volume)
  )))
  with_free <- measures(free)
  with_fixed <- measures(fixed)
  for (name in c("door_spread_m", "door_depth_m", "warp_tension_port_kN", "total_drag_kN")) {
    expect_equal(with_fixed[[name]], with_free[[name]], tolerance = 2e-3)
  }
  for (name in c("wing_end_spread_m", "net_mouth_height_m")) {
    expect_equal(with_fixed[[name]], with_free[[name]], tolerance = 0.017)
  }
})

test_that("trawl accepts free boards and requires their attachments", {
  trawl <- read_gear("midwater_trawl")
  boards <- free_boards()
  free <- update(trawl, otter_boards = boards)
  expect_named(assembly(free)$plan$otter_boards, c("otter_board_port", "otter_board_starboard"))
  boards$warp_at <- NULL
  expect_refused(update(trawl, otter_boards = boards))
  expect_refused(
    update(trawl, otter_boards.polar = "krill_cambered"), "omitted with the attitude fixed"
  )
})

test_that("views show a free board at its position", {
  state <- settle(towed_board())
  marks <- board_marks(state)
  expect_equal(nrow(marks), 1L)
  points <- state$position[, nodes_at(state, c("board", "upper", "lower"))]
  expect_equal(unlist(marks[c("x", "y", "z")], use.names = FALSE), rowMeans(points))
  file <- tempfile(fileext = ".png")
  on.exit(unlink(file))
  grDevices::png(file)
  plot(state)
  grDevices::dev.off()
  expect_gt(file.size(file), 1000)
})

test_that("friction keeps a board on the seabed in place", {
  # towed along the bed, then left while the current and its warp still pull
  left <- function(sticking, ...) {
    found <- tow(towed_board(towing.speed = "1 knot",
      water = list(current = list(speed = "0.15 m/s", toward = "90 deg")),
      seabed = list(depth = "40 m", friction = 0.6, sticking = sticking), ...
    ), until = 160, every = 20, nodes = 60,
    schedule = tow_schedule(speed = data.frame(time = c(0, 20, 30), value = c(0.514, 0.514, 0))))
    found$position[, nodes_at(found, "board"), ]
  }
  moves <- function(place) max(abs(place[, 9] - place[, 6]))
  held <- left(TRUE)
  # less than the elastic friction displacement, 10 mm; without sticking the warp drags it along
  expect_lt(moves(held), 0.01)
  expect_gt(moves(left(FALSE)), 0.5)
  same <- list(otter_boards.otter_board.shoe_friction = list(along = 0.6, across = 0.6))
  expect_equal(do.call(left, c(TRUE, same)), held, tolerance = 1e-6)
})

test_that("board counts as fallen over from 45 degrees of heel", {
  state <- without_flutter(settle(towed_board()))
  expect_identical(nrow(board_table(state)), 1L)
  for (heel in c(44.9, 45.1, -44.9, -45.1)) {
    state$boards$heel[] <- heel * pi / 180
    fallen <- board_table(state)$condition == "fallen over"
    expect_true(all(fallen == (abs(heel) > 45)))
  }
})
