test_that("tensions along a rope begin at its start and go over its whole length", {
  state <- settled("crossing_cables")
  x <- tensions_along(state)
  rows <- as.data.frame(state)
  rope <- "south_1"
  mine <- x[x$rope == rope, ]
  table <- rows[rows$part == rope, ]
  expect_equal(mine$tension_kN, table$tension_kN)
  expect_equal(mine$x_m, table$x_m)
  expect_equal(mine$along_m, cumsum(table$length_m) - table$length_m / 2)
  expect_setequal(x$rope, rows$part)
  ends <- rope_series(x)
  expect_equal(max(ends$along_m[ends$line == rope]), sum(table$length_m))
  expect_equal(min(ends$along_m[ends$line == rope]), 0)
})

test_that("a rope's hanging weight shows along it", {
  # in air, straight down: the tension is the weight below
  plan <- list(
    codend = 1, name = "Hung rope", water = list(density = 0),
    points = list(nail = list(position = c(0, 0, 0), held = "fixed"), free = list()),
    ropes = list(rope = list(from = "nail", to = "free", length = 10, diameter = 0.01,
      axial_stiffness = 1e8, mass_per_length = 2, segments = 20))
  )
  x <- tensions_along(settle(as_gear(plan)))
  # half a bar's weight sits at each of its nodes, so the middle carries just what is below it; the
  # rope is stretched by 2e-6
  expect_equal(x$tension_kN, 2 * gear_gravity * (10 - x$along_m) / 1000, tolerance = 1e-5)
})

test_that("ropes are chosen by name and by role, and both sides are neighbours", {
  state <- settled("midwater_trawl", nodes = 500)
  warps <- tensions_along(state, "warp")
  expect_identical(unique(warps$rope), c("warp_port", "warp_starboard"))
  some <- tensions_along(state, c("warp_port", "hand_rope"))
  expect_identical(unique(some$role), c("warp", "hand_rope"))
  drawn <- rope_series(some)
  expect_identical(unique(drawn$heading), c("warp", "hand rope"))
  lines <- unique(drawn[drawn$heading == "hand rope", c("group", "line")])
  expect_identical(sub("hand_rope_", "", lines$line[order(lines$group)]),
    c("upper_port", "upper_starboard", "lower_port", "lower_starboard"))
  expect_picture(some)
})

test_that("ropes of one role that follow each other are one line", {
  state <- settled("longline")
  x <- tensions_along(state, c("main_line", "branch_line"))
  main <- x[x$role == "main_line", ]
  expect_length(unique(main$line), 1)
  # distances grow along the line, by the bars' lengths
  expect_equal(diff(main$along_m), (main$length_m[-1] + main$length_m[-nrow(main)]) / 2)
  expect_gt(length(unique(main$rope)), 40)
  # at a branch line the tension changes by less than what hangs there, 1 N or so
  branch <- x[x$role == "branch_line", ]
  expect_identical(branch$line, branch$rope)
})

test_that("lines end where they part, and rings begin where the plan begins them", {
  lattice <- function(nodes, role) {
    sketched_lattice(ropes = nodes,
      parts = data.frame(name = names(nodes), kind = "rope", role = role))
  }
  fork <- list(a = 1:3, b = 3:5, c = c(3L, 7L), d = c(7L, 9L))
  expect_identical(rope_lines_end_to_end(lattice(fork, "bridle"), 1:4), c(1L, 2L, 3L, 3L))
  expect_identical(rope_lines_end_to_end(lattice(fork, NA), 1:4), 1:4)
  ring <- list(b = 2:3, a = 1:2, c = c(3L, 1L), loop = c(8L, 9L, 8L))
  expect_identical(rope_lines_end_to_end(lattice(ring, "ring"), 1:4), c(1L, 1L, 1L, 4L))
})
