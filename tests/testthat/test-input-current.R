# Currents of a made-up file (tools/current-example.R) and of profilers; synthetic tracks.

example_currents <- function() {
  skip_if_not_installed("RNetCDF")
  system.file("extdata", "current_cf.nc", package = "codend")
}

# A copy of the example with changed attributes.
changed_currents <- function(...) {
  file <- tempfile(fileext = ".nc")
  file.copy(example_currents(), file)
  nc <- RNetCDF::open.nc(file, write = TRUE)
  for (change in list(...)) do.call(RNetCDF::att.put.nc, c(list(nc), change))
  RNetCDF::close.nc(nc)
  file
}

refused <- function(said, ...) {
  expect_error(read_currents(...), said, class = "codend_error_file")
}

test_that("read_currents() returns the nearest water interpolated between two hours", {
  found <- read_currents(example_currents(), 5.12, 60.3, "2026-05-03 14:30")
  expect_equal(found$depth, c(0, 10, 25, 50))
  # packed in steps of 1e-4 m/s, with rounding of half a step
  expect_equal(found$eastward, 0.4 * exp(-found$depth / 50) + 0.015, tolerance = 1e-4 / 0.15)
  expect_equal(found$northward, 0.1 - 0.001 * found$depth, tolerance = 1e-3)
  # 5.25 deg is land: the cell at 5 deg, 60.25 deg; one degree is 111.195 km on the sphere
  cell <- attr(found, "cell")
  expect_equal(c(cell$longitude, cell$latitude), c(5, 60.25))
  expect_equal(cell$distance, 111195 * sqrt((0.12 * cospi(60.275 / 180))^2 + 0.05^2),
    tolerance = 1e-4)
  # longitudes from 0 to 360 deg, and a time as POSIXct
  other <- changed_currents()
  nc <- RNetCDF::open.nc(other, write = TRUE)
  RNetCDF::var.put.nc(nc, "lon", c(4.5, 4.75, 5, 5.25) + 360)
  RNetCDF::close.nc(nc)
  again <- read_currents(other, 5.12, 60.3, as.POSIXct("2026-05-03 14:30", tz = "UTC"))
  expect_equal(again, found, ignore_attr = "cell")
})

test_that("read_currents() reads units, depth direction and times by attributes", {
  cm <- changed_currents(
    list("uo", "units", "NC_CHAR", "cm s-1"), list("depth", "positive", "NC_CHAR", "up"),
    list("time", "units", "NC_CHAR", "days since 2026-05-03")
  )
  found <- read_currents(cm, 5, 60.25, "2026-05-04")
  expect_equal(found$depth, c(-50, -25, -10, 0))
  expect_equal(found$eastward[4L], 0.0041, tolerance = 1e-3)
})

test_that("read_currents() counts days by the file's calendar", {
  skip_if_not_installed("CFtime")
  # Hours 13, 14 and 15 of a day, 2026-05-03, in calendars that start on 2026-02-27. The file counts
  # hours. February has 28 days in one calendar and 30 in the other.
  counted <- function(calendar, hours) {
    file <- changed_currents(list("time", "calendar", "NC_CHAR", calendar),
      list("time", "units", "NC_CHAR", "hours since 2026-02-27"))
    nc <- RNetCDF::open.nc(file, write = TRUE)
    RNetCDF::var.put.nc(nc, "time", hours + 13:15)
    RNetCDF::close.nc(nc)
    file
  }
  common <- read_currents(example_currents(), 5.12, 60.3, "2026-05-03 14:30")
  read <- function(calendar, days) {
    read_currents(counted(calendar, 24 * days), 5.12, 60.3, "2026-05-03 14:30")
  }
  # 27 and 28 February, March, April, two days of May
  expect_equal(read("noleap", 2 + 31 + 30 + 2), common)
  # 27 to 30 February, March and April of 30 days
  expect_equal(read("360_day", 4 + 30 + 30 + 2), common)
  expect_equal(read("all_leap", 3 + 31 + 30 + 2), common)
  refused("has times from 2026-05-03 13:00 to 2026-05-03 15:00 UTC, but not 2026-05-04 00:00",
    counted("360_day", 24 * 66), 5, 60, "2026-05-04")
  refused("calendar \"360_day\", in which 2026-05-31 00:00 does not exist",
    counted("360_day", 24 * 66), 5, 60, "2026-05-31")
  refused("calendar \"lunar\"", counted("lunar", 0), 5, 60, "2026-05-03 14:00")
})

test_that("read_currents() reports each missing item in one error", {
  file <- example_currents()
  refused("has times from 2026-05-03 13:00 to 2026-05-03 15:00 UTC", file, 5, 60, "2026-05-04")
  refused("no cell within 20 km", file, 9, 60, "2026-05-03 14:00")
  refused("no water within 5 km", file, 5.25, 60, "2026-05-03 14:00", farthest = 5000)
  refused("in \"furlong\"",
    changed_currents(list("uo", "units", "NC_CHAR", "furlong")), 5, 60, "2026-05-03 14:00")
  refused("rotated grid",
    changed_currents(list("uo", "standard_name", "NC_CHAR", "sea_water_x_velocity")), 5, 60,
    "2026-05-03 14:00")
  text <- tempfile(fileext = ".nc")
  writeLines("no file of NetCDF", text)
  refused("is not a NetCDF file", text, 5, 60, "2026-05-03 14:00")
  refused("does not exist", "nowhere.nc", 5, 60, "2026-05-03 14:00")
  expect_wrong(read_currents(file, 5, 95, "2026-05-03"), "latitude")
  expect_wrong(read_currents(file, 5, 60, "soon"), "one moment")
})

test_that("current_profile() rotates a profile into the gear's axes", {
  # the vessel heads west and the water flows north-east: from astern to starboard
  measured <- data.frame(depth = c(30, 0), eastward = c(0.3, 0.1), northward = c(0.4, 0))
  found <- current_profile(measured, course = "270 deg")
  expect_identical(found, list(
    list(depth = "0 m", speed = "0.1 m/s", toward = "0 deg"),
    list(depth = "30 m", speed = "0.5 m/s", toward = "53.13 deg")
  ))
  # by speed and bearing: the same
  polar <- data.frame(depth = c(30, 0), speed = c(0.5, 0.1), toward = c(atan2(0.3, 0.4), pi / 2))
  expect_identical(current_profile(polar, course = 1.5 * pi), found)
  # a current against the vessel is towards 0 deg at any bearing
  for (bearing in c(0, 40, 135, 300)) {
    toward <- (bearing + 180) * pi / 180
    ahead <- data.frame(depth = 0, eastward = sin(toward), northward = cos(toward))
    said <- current_profile(ahead, course = paste(bearing, "deg"))[[1L]]
    expect_identical(said[c("speed", "toward")], list(speed = "1 m/s", toward = "0 deg"))
  }
})

test_that("current_profile() averages readings as vectors and drops sparse depths", {
  log <- data.frame(depth = c(10, 10, 10, 20, 20, NA), eastward = c(0.2, 0.4, NA, 1, 1, 1),
    northward = c(0.1, -0.1, 0, 0, 0, 0))
  found <- current_profile(log, course = "180 deg", least = 2)
  expect_identical(vapply(found, `[[`, "", "speed"), c("0.3 m/s", "1 m/s"))
  expect_identical(vapply(found, `[[`, "", "toward"), c("-90 deg", "-90 deg"))
  expect_wrong(current_profile(log, least = 3), "no depth with at least 3")
  fast <- data.frame(depth = 10, eastward = 30, northward = 0)
  expect_wrong(current_profile(fast), "Row 1 of `table` has 30.00 m/s")
  expect_wrong(current_profile(log[c("depth", "eastward")]), "northward")
  expect_wrong(current_profile(log, course = "3 knot"), "must be an angle")
})

test_that("gear accepts the current of a file", {
  profile <- current_profile(read_currents(example_currents(), 5, 60.25, "2026-05-03 13:00"),
    course = "270 deg")
  cage <- update(read_gear("cage"), water.current = profile)
  expect_length(cage$plan$water$current, 4L)
  expect_identical(cage$plan$water$current[[3L]]$depth, "25 m")
})

# A track on a circle of 2 km at 1.5 m/s, with position errors of some metres.
circling <- function(error) {
  time <- seq(0, 3600, 5)
  angle <- 1.5 * time / 2000
  east <- 2000 * sin(angle)
  north <- 2000 * (1 - cos(angle))
  # reproducible noise in metres
  noise <- error * cbind(sin(time^2), cos(time^2))
  latitude <- 1.05 + (north + noise[, 1L]) / 6371008.8
  data.frame(
    time = time, latitude = latitude,
    longitude = pi - 1e-4 + (east + noise[, 2L]) / (6371008.8 * cos(1.05))
  )
}

test_that("track_schedule() returns speed, turn and distance of a circle", {
  log <- circling(3)
  # across the date line
  log$longitude <- (log$longitude + pi) %% (2 * pi) - pi
  found <- track_schedule(log, from = 300, to = 2100, every = 60)
  expect_identical(names(found), c("schedule", "bearing", "until", "distance"))
  speed <- found$schedule$speed
  course <- subset(as.data.frame(found$schedule), input == "course")
  expect_identical(speed$time, seq(0, 1800, 60))
  # errors of 3 m at both ends of a chord of 120 s, 60 s at the ends of the tow
  inner <- 2:30
  expect_lt(max(abs(speed$value[inner] - 1.5)), 6 / 120 + 0.005)
  expect_lt(max(abs(speed$value - 1.5)), 6 / 60 + 0.005)
  # it turns to port by 1.5 / 2000 rad/s; the first chord is 30 s ahead of its middle
  turn <- course$value - course$value[2L]
  expect_lt(max(abs(turn[inner] + 1.5 / 2000 * (speed$time[inner] - 60))), 12 / 180)
  expect_equal(found$distance, 2700, tolerance = 0.01)
  expect_lt(abs(found$bearing - (pi / 2 - 1.5 * 330 / 2000)), 6 / 90)
})

test_that("track_schedule() fits the seabed as a plane of depths", {
  time <- seq(0, 1200, 10)
  log <- data.frame(time = time, longitude = 0.08, latitude = 1.05 + 2 * time / 6371008.8,
    depth = 100 + 2 * time * 0.01)
  found <- track_schedule(log, 0, 1200)
  expect_identical(found$seabed, list(depth = "100 m",
    slope = list(angle = "0.573 deg", toward = "180 deg")))
  expect_lt(found$bed_misfit, 1e-6)
  log$depth <- rev(log$depth) + 5 * (time == 600)
  found <- track_schedule(log, 0, 1200)
  expect_identical(found$seabed$slope$toward, "0 deg")
  expect_gt(found$bed_misfit, 4.9)
  trawl <- update(read_gear("poly_noreastern_trawl"), seabed.depth = found$seabed$depth,
    seabed.slope = found$seabed$slope)
  expect_identical(trawl$plan$seabed$slope$toward, "0 deg")
})

test_that("track_schedule() rejects a log without positions or in degrees", {
  log <- circling(0)
  refused <- function(said, ...) {
    expect_wrong(track_schedule(...), said)
  }
  refused("longitude", log["time"], 0, 60)
  refused("0 positions", log, 9000, 9600)
  refused("latitude\\[1\\]` is 60; .* \"60 deg\"", transform(log, latitude = 60), 0, 600)
  refused("impossible latitude", transform(log, latitude = 2), 0, 600)
  refused("to", log, 600, 0)
})

test_that("read_currents() throws an error for a damaged file", {
  good <- readBin(example_currents(), "raw", 1e6)
  file <- tempfile(fileext = ".nc")
  set.seed(4)
  for (k in 1:6) {
    changed <- good
    # damage in headers is the most dangerous for the library
    at <- sample(min(2000L, length(good)), 40L)
    changed[at] <- as.raw(sample(0:255, 40L, replace = TRUE))
    writeBin(changed, file)
    found <- tryCatch(read_currents(file, 5.12, 60.3, "2026-05-03 14:30"),
      codend_error_file = function(e) NULL)
    expect_true(is.null(found) || is.data.frame(found))
  }
})
