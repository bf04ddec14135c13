# Measures of a gear in a turn.

# Two weights on two cables, 6 m apart, with ropes between them that form a mouth.
towed_frame <- function() {
  gear("a towed frame", towing = list(speed = "2 m/s"),
    port = gear_point(position = c(0, -3, 0), held = "moved"),
    starboard = gear_point(position = c(0, 3, 0), held = "moved"),
    low_port = gear_point(), low_starboard = gear_point(), high_port = gear_point(),
      high_starboard = gear_point(),
    cable_port = rope("port", "high_port", length = 30, diameter = 0.01, material = "steel_wire",
      role = "warp"),
    cable_starboard = rope("starboard", "high_starboard", length = 30, diameter = 0.01,
      material = "steel_wire", role = "warp"),
    head = rope("high_port", "high_starboard", length = 8, diameter = 0.01, material = "PA"),
    foot = rope("low_port", "low_starboard", length = 8, diameter = 0.01, material = "PA"),
    left = rope("high_port", "low_port", length = 4, diameter = 0.01, material = "PA"),
    right = rope("high_starboard", "low_starboard", length = 4, diameter = 0.01, material = "PA"),
    weight_port = piece(at = "low_port", mass = "60 kg", density = "7850 kg/m3", drag_area = 0.01),
    weight_starboard = piece(at = "low_starboard", mass = "60 kg", density = "7850 kg/m3",
      drag_area = 0.01),
    wing_end_spread = measure(spread = c("high_port", "high_starboard")),
    mouth_area = measure(area = c("head", "right", "foot", "left")),
    nets = list(frame = list(mouth = c("head", "right", "foot", "left"),
      wing_ends = c("high_port", "high_starboard"))),
    cable_divergence = measure(angle = list(cable_port.start = "divergence"))
  )
}

test_that("gear in a steady circle keeps its spread and sweeps less", {
  rate <- 0.05  # rad/s: a circle of 40 m radius on which everything soon moves as one body
  found <- tow(towed_frame(), until = 240, every = 120, accuracy = 1e-4,
    schedule = tow_schedule(
      course = data.frame(time = c(0, 10, 1010), value_rad = c(0, 0, 1000 * rate))))
  state <- state_at(found, 240)
  straight <- measures(settle(towed_frame()))
  turning <- measures(state)
  pair <- nodes_at(state, c("high_port", "high_starboard"))
  line <- apply(state$position[1:2, unlist(pair)], 1, diff)
  # the frame has rotated by about 20 deg relative to the vessel, which does not affect the distance
  expect_gt(abs(line[1] / line[2]), 0.3)
  expect_equal(turning[["wing_end_spread_m"]], sqrt(sum(line^2)))
  expect_lt(abs(turning[["wing_end_spread_m"]] / straight[["wing_end_spread_m"]] - 1), 0.1)
  expect_lt(abs(turning[["mouth_area_m2"]] / straight[["mouth_area_m2"]] - 1), 0.15)

  # For a body that rotates about a centre, the line between two points sweeps rate / 2 times the
  # difference of their squared distances from the centre.
  centre <- c(0, 2 / rate)
  reach <- colSums((state$position[1:2, unlist(pair)] - centre)^2)
  # the motion is steady to 1e-4 m per step of about a second, on 2 m/s
  expect_equal(turning[["swept_area_km2_per_h"]], rate / 2 * abs(diff(reach)) * 0.0036,
    tolerance = 1e-3)
  # the water is at rest, so the flow through the mouth is the volume that it passes over
  nodes <- lapply(c("head", "right", "foot", "left"), function(rope) along_rope(state, rope)$node)
  outline <- nodes[[1L]]
  if (!outline[length(outline)] %in% nodes[[2L]]) outline <- rev(outline)
  for (next_rope in nodes[-1L]) {
    if (next_rope[1L] != outline[length(outline)]) next_rope <- rev(next_rope)
    outline <- c(outline, next_rope)
  }
  x <- state$position[, outline]
  ahead <- c(polygon_area(x[2, ], x[3, ]), polygon_area(x[3, ], x[1, ])) /
    turning[["mouth_area_m2"]]
  middle <- rowMeans(state$position[1:2, unique(unlist(lapply(
    c("head", "right", "foot", "left"), function(rope) along_rope(state, rope)$node)))])
  velocity <- rate * c(centre[2] - middle[2], middle[1])
  expect_equal(
    turning[["filtered_volume_m3_per_h"]],
    turning[["mouth_area_m2"]] * abs(sum(ahead * velocity)) * 3600, tolerance = 1e-3
  )
})

test_that("gear on a new course has the measures of the old one", {
  found <- tow(towed_frame(), until = 200, every = 200, accuracy = 1e-4,
    schedule = tow_schedule(
      course = data.frame(time = c(0, 10, 40), value = c("0 deg", "0 deg", "70 deg"))))
  # the remaining oscillation of a gear of 30 m after 160 s
  expect_equal(measures(state_at(found, 200)), measures(state_at(found, 0)), tolerance = 1e-4)
})
