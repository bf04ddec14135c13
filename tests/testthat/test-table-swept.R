# What a tow has swept, against the way that a known width went.

test_that("two ropes side by side sweep the distance times their spread while they speed up", {
  line <- function(from, to) rope(from, to, length = "20 m", diameter = "20 mm", material = "PA")
  pair <- gear("Two ropes", towing = list(speed = "2 knot"),
    port = gear_point(position = c(0, -5, 0), held = "moved"), end_port = gear_point(),
    starboard = gear_point(position = c(0, 5, 0), held = "moved"), end_starboard = gear_point(),
    line_port = line("port", "end_port"), line_starboard = line("starboard", "end_starboard"),
    wing_end_spread = measure(spread = c("end_port", "end_starboard")))
  faster <- data.frame(time = c(0, 60), value = c("2 knot", "4 knot"))
  pair <- tow(pair, until = 60, every = 20, schedule = tow_schedule(speed = faster))
  found <- as.data.frame(pair, what = "swept")
  # the rate is linear in time, which the trapezoid rule takes exactly; the ends trail behind the
  # points that tow them, 10 m apart
  expect_equal(found$swept_area_m2[4], 10 * found$distance_m[4], tolerance = 0.002)
  expect_equal(found$distance_m[4], 60 * 3 * 1852 / 3600, tolerance = 1e-6)
})
