test_that("the table of rope tensions starts at a rope's start and covers its length", {
  state <- settled("crossing_cables")
  x <- as.data.frame(state, what = "rope_tensions")
  rows <- as.data.frame(state, what = "tensions")
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

test_that("the table of rope tensions shows the hanging weight of a rope", {
  # in air, straight down: the tension is the weight below
  plan <- list(
    codend = 1, name = "Hung rope", water = list(density = 0),
    points = list(nail = list(position = c(0, 0, 0), held = "fixed"), free = list()),
    ropes = list(rope = list(from = "nail", to = "free", length = 10, diameter = 0.01,
      axial_stiffness = 1e8, mass_per_length = 2, segments = 20))
  )
  x <- as.data.frame(settle(as_gear(plan)), what = "rope_tensions")
  # Each node has half a bar's weight, so the middle of a bar carries exactly the weight below it.
  # The rope is stretched by 2e-6.
  expect_equal(x$tension_kN, 2 * gear_gravity * (10 - x$along_m) / 1000, tolerance = 1e-5)
})

test_that("the table of rope tensions selects ropes by name and role in order", {
  state <- settled("midwater_trawl", nodes = 500)
  warps <- as.data.frame(state, what = "rope_tensions", parts = "warp")
  expect_identical(unique(warps$rope), c("warp_port", "warp_starboard"))
  some <- as.data.frame(state, what = "rope_tensions", parts = c("warp_port", "hand_rope"))
  expect_identical(unique(some$role), c("warp", "hand_rope"))
  drawn <- rope_series(some)
  expect_identical(unique(drawn$heading), c("warp", "hand rope"))
  lines <- unique(drawn[drawn$heading == "hand rope", c("group", "line")])
  expect_identical(sub("hand_rope_", "", lines$line[order(lines$group)]),
    c("upper_port", "upper_starboard", "lower_port", "lower_starboard"))
  expect_picture(some)
})

test_that("the table of rope tensions joins consecutive ropes of one role to a line", {
  state <- settled("longline")
  x <- as.data.frame(state, what = "rope_tensions", parts = c("main_line", "branch_line"))
  main <- x[x$role == "main_line", ]
  expect_length(unique(main$line), 1)
  # distances grow along the line, by the bars' lengths
  expect_equal(diff(main$along_m), (main$length_m[-1] + main$length_m[-nrow(main)]) / 2)
  expect_gt(length(unique(main$rope)), 40)
  # at a branch line the tension changes by less than the branch load, about 1 N
  branch <- x[x$role == "branch_line", ]
  expect_identical(branch$line, branch$rope)
})

test_that("rope lines end at branches and rings start at the plan's start", {
  mesh <- function(nodes, role) {
    sketched_mesh(ropes = nodes,
      parts = data.frame(name = names(nodes), kind = "rope", role = role))
  }
  fork <- list(a = 1:3, b = 3:5, c = c(3L, 7L), d = c(7L, 9L))
  expect_identical(rope_lines_end_to_end(mesh(fork, "bridle"), 1:4), c(1L, 2L, 3L, 3L))
  expect_identical(rope_lines_end_to_end(mesh(fork, NA), 1:4), 1:4)
  ring <- list(b = 2:3, a = 1:2, c = c(3L, 1L), loop = c(8L, 9L, 8L))
  expect_identical(rope_lines_end_to_end(mesh(ring, "ring"), 1:4), c(1L, 1L, 1L, 4L))
})
