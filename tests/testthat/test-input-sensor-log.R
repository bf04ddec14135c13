# Sensor logs with artificial spikes.

log_of <- function(lines) {
  file <- tempfile(fileext = ".csv")
  writeLines(lines, file)
  file
}

test_that("read_sensor_log() removes spikes and keeps real changes", {
  n <- 300
  time <- 82800 + 10 * seq_len(n)
  door <- 80 + 3 * sin(seq_len(n) / 40) + 0.3 * sin(seq_len(n) * 1.7)
  height <- 5 + 0.1 * cos(seq_len(n) * 2.3)
  planted <- c(20, 21, 90, 150, 222)
  shown <- replace(door, planted, c(160, 158, 12, 900, 40))
  shown[250] <- NA
  clock <- format(as.POSIXct(time, origin = "1970-01-01", tz = "UTC"), "%H:%M:%S")
  file <- log_of(c("Time;Door;Height (ft)",
    paste(clock, ifelse(is.na(shown), "", sub(".", ",", round(shown, 3), fixed = TRUE)),
      round(height / 0.3048, 3), sep = ";")))
  columns <- tempfile(fileext = ".yaml")
  writeLines(c(
    "time: {column: Time, format: '%H:%M:%S'}",
    "door_spread: {column: Door, unit: m, least: 10, most: 200}",
    "headline_height: {column: Height (ft), unit: ft}"
  ), columns)
  found <- read_sensor_log(file, columns)
  # time continues past midnight
  expect_equal(found$time, 10 * (seq_len(n) - 1))
  expect_identical(which(is.na(found$door_spread)), as.integer(sort(c(planted, 250))))
  expect_identical(attr(found, "removed"), c(door_spread = 5L, headline_height = 0L))
  good <- !is.na(found$door_spread)
  expect_equal(found$door_spread[good], door[good], tolerance = 1e-5)
  expect_equal(found$headline_height, height, tolerance = 1e-3)
  means <- haul_means(found, from = c(0, 1000), to = c(900, 2990))
  expect_equal(means$door_spread[1], stats::median(door[setdiff(1:91, planted)]), tolerance = 1e-4)
  expect_identical(means$haul, 1:2)
})

test_that("is_spike() uses the scatter of neighbouring readings", {
  # quiet, then rough water
  noise <- sin((1:120)^2)
  values <- noise * rep(c(1, 100), c(90, 30))
  values[40] <- 60
  values[105] <- 250
  expect_identical(is_spike(values, 15, 5)[c(40, 105)], c(TRUE, FALSE))
})

test_that("read_sensor_log() reports a wrong log in one error", {
  file <- log_of(c("a,b", "0,1", "x,2"))
  columns <- list(time = list(column = "a"), door = list(column = "b", unit = "m"))
  expect_error(read_sensor_log(file, columns), "\"x\".*row 2", class = "codend_error_file")
  columns$door$column <- "c"
  expect_error(read_sensor_log(file, columns), "\"c\".*a, b", class = "codend_error_file")
  columns$door$unit <- "parsec"
  expect_wrong(read_sensor_log(file, columns), "parsec.*door")
  expect_wrong(read_sensor_log(file, list()), "time")
  expect_wrong(read_sensor_log(file, columns, window = 4), "odd")
})
