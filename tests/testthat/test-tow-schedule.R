# The schedule of a tow as given by users.

# All inputs that a plan holds, in text with units, numbers and integers.
full_schedule <- function() {
  tow_schedule(
    speed = data.frame(time = c(0L, 45L, 270L, 1800L),
      value = c("4 knot", "6 knot", "4 knot", "2 m/s")),
    course = data.frame(time = c("13 min", "21 min"), value_deg = c(0, 90)),
    warp_out = list(port = data.frame(time = c(0, 100), value = c(600L, 500L)),
      starboard = "600 m"),
    winch = list(speed_limit = "1.5 m/s", tension_limit = 2e5),
    current = list(list(speed = "1 knot", toward = "40 deg"), list(speed = 0.2)),
    heave = list(amplitude = "0.5 m", period = 8L), catch = 0.5,
    vessel_motion = list(at = list(-12L, 0, "1 m"), rising = "10 s", response = data.frame(
      period = c(4, 12), heave = c(0.1, 1), pitch_deg = c(1, 3))),
    breaking = list(list(rope = "warp_port", time = 1200L, position = "start"),
      list(rope = "headline"))
  )
}

test_that("tow_schedule() prints its changes", {
  expect_snapshot({
    tow_schedule()
    tow_schedule(
      speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot")), warp_out = "200 m",
      winch = list(speed_limit = "0.5 m/s"), heave = function(time) sin(time),
      control = function(measures, time) 0
    )
    full_schedule()
    tow_schedule(plan = "midwater_trawl")
  })
  expect_lte(length(capture.output(print(full_schedule()))), 15L)
})

test_that("tow_schedule(plan = ) reads the identical schedule from plan files", {
  gear <- update(read_gear("midwater_trawl"), tow = full_schedule())
  for (extension in c(".yaml", ".json")) {
    file <- tempfile(fileext = extension)
    write_gear(gear, file)
    expect_identical(tow_schedule(plan = file), full_schedule())
  }
  # the plan keeps the fields that are no inputs
  expect_identical(gear$plan$tow$until, read_gear("midwater_trawl")$plan$tow$until)
  shipped <- tow_schedule(plan = "midwater_trawl")
  again <- update(read_gear("midwater_trawl"), tow = shipped)
  expect_identical(tow_schedule(plan = again), shipped)
  seine <- tow_schedule(plan = "purse_seine")
  expect_equal(seine$warp_out$purse_wire$value[1],
    gear_si(read_gear("purse_seine"))$ropes$purse_wire$length)
  record <- tow_schedule(vessel_motion = list(record = data.frame(time = c(0, 10), roll_deg = 0:1)))
  expect_identical(tow_schedule(plan = update(read_gear("towed_cable"), tow = record)), record)
})

test_that("tow() moves the same by a schedule and by its plan", {
  schedule <- tow_schedule(speed = data.frame(time = c(0, 4), value = c("4 knot", "5 knot")),
    heave = list(amplitude = "0.5 m", period = "8 s"))
  gear <- read_gear("towed_cable")
  by_schedule <- tow(gear, schedule, until = 4, every = 2, nodes = 20)
  by_plan <- tow(update(gear, tow = schedule), until = 4, every = 2, nodes = 20)
  expect_identical(by_plan$position, by_schedule$position)
  # a quarter of the period after the start
  expect_equal(by_plan$conditions$heave[2], 0.5)
  # a swell in numbers survives a file, a function does not
  skip_if_not_installed("RNetCDF")
  file <- tempfile(fileext = ".nc")
  write_result(by_plan, file)
  expect_equal(tow(read_result(file), until = 6)$conditions$heave[4], -0.5)
})

test_that("update() and c() change and combine schedules", {
  faster <- tow_schedule(speed = "5 knot")
  turning <- tow_schedule(course = data.frame(time = c(0, 60), value = c("0 deg", "90 deg")))
  both <- c(faster, turning)
  expect_identical(both, tow_schedule(speed = "5 knot", course = turning$course))
  expect_identical(update(both, course = NULL), faster)
  expect_identical(update(faster, speed = "3 knot")$speed, "3 knot")
})

test_that("as.data.frame() lists a schedule by time in its units", {
  table <- as.data.frame(full_schedule())
  expect_named(table, c("time_s", "input", "value", "unit"))
  speed <- table[table$input == "speed", ]
  expect_identical(speed$time_s, c(0, 45, 270, 1800))
  expect_equal(speed$value, c(4, 6, 4, 2 / plan_units$speed[["knot"]]))
  expect_identical(unique(speed$unit), "knot")
  course <- table[table$input == "course", ]
  expect_equal(course$time_s, c(780, 1260))
  expect_equal(course$value, c(0, 90))
  # the numbers that tow() uses
  heave <- table[table$input == "heave", ]
  expect_equal(heave$value, 0.5 * sin(2 * pi * heave$time_s / 8))
  expect_equal(max(heave$time_s), 1800)
  expect_identical(table$value[table$input == "warp_out.starboard"], 600)
  expect_identical(table$unit[table$input == "warp_out.port"], c("m", "m"))
  expect_identical(nrow(as.data.frame(tow_schedule())), 0L)
  expect_equal(max(as.data.frame(tow_schedule(heave = sin), until = "2 min")$time_s), 120)
})

test_that("autoplot() draws a panel per input of a schedule", {
  skip_if_not_installed("ggplot2")
  chart <- ggplot2::autoplot(full_schedule())
  data <- chart$data
  expect_setequal(as.character(unique(data$panel)), c("speed (knot)", "course (deg)", "catch",
    "heave (m)", "warp out port (m)", "warp out starboard (m)", "current 1 speed (knot)",
    "current 1 toward (deg)", "current 2 speed (m/s)", "winch speed limit (m/s)",
    "winch tension limit (N)"))
  # inputs stay constant after their last time, in minutes
  expect_true(all(tapply(data$at, data$panel, max) == 30))
  expect_equal(data$value[data$panel == "course (deg)" & data$at == 30], 90)
  file <- tempfile(fileext = ".png")
  plot(full_schedule(), file = file)
  expect_gt(file.size(file), 5000)
  expect_wrong(ggplot2::autoplot(tow_schedule()), "no input over time")
})

test_that("unscheduled_section() replaces the plan's schedule and keeps the hauling of a seine", {
  trawl <- read_gear("midwater_trawl")
  faster <- tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot")))
  expect_identical(unscheduled_section(trawl, tow_schedule()), tow_section(trawl))
  expect_identical(unscheduled_section(trawl, faster), list(until = 30, every = "10 s"))
  expect_identical(unscheduled_section(trawl, tow_schedule(catch = 0.5)),
    list(until = "40 min", every = "10 s"))
  breaking <- tow_schedule(breaking = list(list(rope = "warp_port", time = "20 min")))
  expect_identical(unscheduled_section(trawl, breaking)$until, 1200)
  seine <- update(read_gear("purse_seine"), tow.speed = "3 knot")
  hauled <- tow_section(seine)
  found <- unscheduled_section(seine, tow_schedule(heave = list(amplitude = 1, period = 8)))
  expect_identical(found$warp_out, hauled$warp_out)
  expect_null(found$speed)
  expect_equal(found$until, max(hauled$warp_out$purse_wire$time))
})

test_that("tow() with a speed keeps the warps of the plan", {
  slower <- tow_schedule(speed = data.frame(time = c(0, 20), value = c("4 knot", "3 knot")))
  found <- tow("midwater_trawl", slower, nodes = 200)
  expect_identical(max(found$time), 20)
  expect_equal(range(found$conditions$speed), c(3, 4) * 1852 / 3600)
  # the plan's own tow starts with 50 m of warp, and its net at the surface
  settled <- measures(settle(update(read_gear("midwater_trawl"), towing.speed = "4 knot"),
    nodes = 200))
  expect_equal(measures(state_at(found, 0))[["headline_depth_m"]], settled[["headline_depth_m"]],
    tolerance = 1e-3)
})
