# The swept area of a tow, compared with the path of a known width.

test_that("two accelerating ropes sweep the distance times their spread", {
  line <- function(from, to) rope(from, to, length = "20 m", diameter = "20 mm", material = "PA")
  pair <- gear("Two ropes", towing = list(speed = "2 knot"),
    port = gear_point(position = c(0, -5, 0), held = "moved"), end_port = gear_point(),
    starboard = gear_point(position = c(0, 5, 0), held = "moved"), end_starboard = gear_point(),
    line_port = line("port", "end_port"), line_starboard = line("starboard", "end_starboard"),
    nets = list(pair = list(wing_ends = c("end_port", "end_starboard"))))
  faster <- data.frame(time = c(0, 60), value = c("2 knot", "4 knot"))
  pair <- tow(pair, until = 60, every = 20, schedule = tow_schedule(speed = faster))
  found <- as.data.frame(pair, what = "swept")
  # The rate is linear in time, so the trapezoidal rule is exact. The ends trail behind their towing
  # points, 10 m apart.
  expect_equal(found$swept_area_m2[4], 10 * found$distance_m[4], tolerance = 0.002)
  expect_equal(found$distance_m[4], 60 * 3 * 1852 / 3600, tolerance = 1e-6)
})
