# The shipped longline without current, with all floats fixed; `...` changes fields.
still_longline <- function(...) {
  fields <- list(floats.held = "all", end_lines = NULL, tow = NULL, water.current = NULL, ...)
  do.call(update, c(list(read_gear("longline")), fields))
}

sheared <- function(speed) {
  list(
    list(depth = "0 m", speed = 0, toward = "90 deg"),
    list(depth = "400 m", speed = speed, toward = "90 deg")
  )
}

# Depth (m) of hook j of n in a basket of main line of length L (m) by the catenary of T. Yoshihara
# (Bulletin of the Japanese Society of Scientific Fisheries 16:370, 1951, and 19:1012, 1954). The
# shortening ratio is k; lengths of the float line and branch line are in m.
yoshihara <- function(j, n, L, k, float_line, branch_line) {
  # k = cot(p) asinh(tan(p)), p the angle of the main line at the float line
  p <- uniroot(function(p) asinh(tan(p)) / tan(p) - k, c(1e-6, pi / 2 - 1e-6), tol = 1e-14)$root
  cot2 <- 1 / tan(p)^2
  float_line + branch_line + L / 2 * (sqrt(1 + cot2) - sqrt((1 - 2 * j / (n + 1))^2 + cot2))
}

# Depth (m) below its ends of an elastic line of n + 1 stretches of length s (m), weight w (N/m) and
# stiffness EA (N). A weight P (N) hangs between every two stretches, and the ends are `apart` (m).
# Elastic catenaries join end to end; V is the vertical force at the start of each.
hung_line <- function(n, s, w, ea, load, apart) {
  v <- ((n + 1) * s * w + n * load) / 2 - (0:n) * (s * w + load)
  step <- function(h) {
    h / w * (asinh(v / h) - asinh((v - w * s) / h)) + h * s / ea
  }
  h <- uniroot(function(h) sum(step(h)) - apart, c(0.01, 1e3), tol = 1e-13)$root
  drop <- (sqrt(h^2 + v^2) - sqrt(h^2 + (v - w * s)^2)) / w + (v^2 - (v - w * s)^2) / (2 * ea * w)
  cumsum(drop)[seq_len(n)]
}

# The same for the hooks (m below the surface) of a basket of a settled still_longline().
hung_longline <- function(state) {
  si <- state$si
  main <- si$ropes$main_line_2_1
  branch <- si$ropes$branch_line_2_1
  hook <- si$pieces$hook_2_1
  weight <- function(mass, volume) 9.81 * (mass - 1025 * volume)
  load <- weight(hook$mass, hook$volume) +
    15 * weight(branch$mass_per_length, branch$volume_per_length)
  joins <- state$position[, nodes_at(state, c("join_2", "join_3"))]
  hung <- hung_line(15, 50, weight(main$mass_per_length, main$volume_per_length),
    main$axial_stiffness, load, joins[1, 2] - joins[1, 1])
  hung - joins[3, 1] + 15
}

test_that("longline hooks without current follow the catenary of Yoshihara", {
  line <- still_longline()
  state <- settle(line)
  found <- measures(state)[sprintf("hook_%d_depth_m", 1:15)]
  expect_equal(unname(found), rev(unname(found)), tolerance = 1e-6)

  # Elastic catenaries between the hook loads. The mesh has straight elements of at most s = 6 m.
  # Their sag w s^2 / (8 H) is 0.02 m where the line is least taut (w = 0.011 N/m, H = 2.4 N). The
  # tolerance is twice the sag relative to the mean depth of 200 m.
  expect_equal(unname(found), hung_longline(state), tolerance = 0.02 / 100)

  # Yoshihara's line is inextensible with uniform weight. Ours stretches by T/EA, at most 5e-4, and
  # has 36 % of its weight at 15 points. As a polygon of 16 sides it is deeper by a fraction of 36 %
  # of 1/16^2. Float lines stretch by 0.2 m. All three together are less than 0.3 % of the depth.
  expect_equal(unname(found), yoshihara(1:15, 15, 800, 0.65, 25, 15), tolerance = 0.003)

  hooks <- as.data.frame(state, what = "pieces")
  expect_identical(sum(hooks$role == "hook"), 45L)
  expect_equal(hooks$depth_m[hooks$part == "hook_2_3"], found[["hook_3_depth_m"]])
})

test_that("sheared current lifts the hooks, the deepest most", {
  depth <- vapply(c(0, 0.1, 0.25, 0.5), function(speed) {
    state <- settle(still_longline(water = list(current = sheared(speed))), nodes = 600)
    measures(state)[c("hook_1_depth_m", "hook_8_depth_m")]
  }, c(0, 0))
  share <- depth[, -1] / depth[, 1]
  expect_true(all(apply(cbind(1, share), 1, diff) < 0))
  expect_true(all(share["hook_8_depth_m", ] < share["hook_1_depth_m", ]))
})

test_that("short longline is shallower and accepts even numbers of branch lines", {
  deep <- measures(settle(still_longline(shortening_ratio = 0.5), nodes = 300))
  flat <- measures(settle(still_longline(shortening_ratio = 0.9), nodes = 300))
  expect_lt(flat[["main_line_depth_m"]], deep[["main_line_depth_m"]])
  one <- settle(still_longline(baskets = 1, branch_lines.number = 4), nodes = 300)
  expect_equal(measures(one)[["hook_2_depth_m"]], measures(one)[["hook_3_depth_m"]],
    tolerance = 1e-6)
})

test_that("longlines of many baskets settle with floats at the surface", {
  for (baskets in c("14", "16", "20", "30")) {
    state <- settle(new_plan("longline", baskets = baskets), nodes = 250)
    floats <- as.data.frame(state, what = "pieces")
    floats <- floats[floats$role == "float", ]
    expect_true(all(abs(floats$depth_m) < 0.18), label = paste(baskets, "baskets"))
  }
})

test_that("longline with free floats swims, and drifts together when released", {
  line <- read_gear("longline")
  state <- settle(line, nodes = 500)
  # end lines run outwards from the position of the first float
  out <- state$si$ropes$end_line_first$length
  expect_equal(state$position[1, nodes_at(state, "end_first")], -out)
  floats <- as.data.frame(state, what = "pieces")
  floats <- floats[floats$role == "float", ]
  expect_true(all(abs(floats$depth_m) < 0.18))
  drift <- tow(state, until = 1200, every = 600, schedule = tow_schedule(breaking = list(
    list(rope = "end_line_first", time = 60, position = "start"),
    list(rope = "end_line_last", time = 60, position = "start")
  )))
  after <- state_at(drift, 1200)
  expect_lt(measures(after)[["float_distance_m"]], measures(state)[["float_distance_m"]])
  moved <- (after$position - state$position)[2, nodes_at(state, "surface_2")]
  # The water between the surface and the deepest hook moves it.
  expect_gt(moved, 0)
  expect_lt(moved, 1140 * 0.2)
  expect_gt(measures(after)[["hook_8_depth_m"]], measures(state)[["hook_8_depth_m"]])
})
