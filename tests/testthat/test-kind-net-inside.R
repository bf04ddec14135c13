two_seam <- function() read_gear(system.file("extdata", "two_seam_trawl.yaml", package = "codend"))

test_that("a window replaces its meshes and is joined along all its edges", {
  window <- list(ahead = 20, rows = 20, across = 40, mesh_size = "100 mm", orientation = "square",
    twine = list(diameter = "4 mm", material = "PE"), meshes = list(front = 40, rear = 40,
      deep = 56))
  trawl <- update(two_seam(), net.upper.body_2.window = window)
  panels <- gear_si(trawl)$panels
  plain <- gear_si(two_seam())$panels$back_body_2
  names <- paste0("back_body_2_", c("ahead", "window_left", "window_right", "behind"))
  meshes <- function(panel) (panel$upper + panel$lower) / 2 * panel$deep
  expect_equal(sum(vapply(panels[names], meshes, 0)), meshes(plain) - 40 * 20)
  expect_identical(panels$back_body_2_window$orientation, "square")
  # the half panels left and right of the window are mirror images
  expect_equal(panels$back_body_2_window_left$lost_left, panels$back_body_2_window_right$lost_right)
  # 40 of 162 meshes ahead and of 142 behind are joined to the window, the rest to its sides
  joints <- seam_joints(gear_si(trawl))
  own <- joints[joints$panel == "back_body_2_window", ]
  part <- function(edge) own$other_to[own$edge == edge] - own$other_from[own$edge == edge]
  expect_equal(c(part("upper"), part("lower")), c(40 / 162, 40 / 142))
  # the drawing has one column for the upper panel, with the window in its hole
  flat <- flat_layout(gear_si(trawl))
  expect_true(all(flat$columns$symmetric))
  expect_length(unique(flat$panels$column[grepl("body_2_window", flat$panels$name)]), 1)
  drawn <- flat$panels[grepl("body_2_window", flat$panels$name), ]
  expect_equal(drawn$depth, rep(20 * 0.1, 3))
  # 40 meshes of 100 mm, in width at a hanging ratio of 0.5
  expect_equal(drawn$upper[drawn$name == "back_body_2_window"], 2)
  cover <- list(mesh_size = "120 mm", twine = window$twine,
    meshes = list(upper = 40, lower = 40, deep = 40))
  expect_refused(update(trawl, net.upper.body_2.covers = list(chafer = cover)),
    "body_2.window` is given; it must be omitted in a piece with `covers`")
  long <- modifyList(window, list(meshes = list(front = 800)))
  expect_refused(update(two_seam(), net.upper.body_2.window = long),
    "window.meshes.front` is 800; it must be .* hole in the piece, 4 m; it is 40 m long")
  covered <- covered_edges(trawl)
  expect_equal(range(covered), c(1, 1))
  expect_no_error(settle(trawl, nodes = 400))
  # a rope around the net behind a divided row follows both panels
  roped <- update(trawl, cross_ropes = list(strap = list(behind = "body_2", length = "12 m",
    diameter = "14 mm", material = "PP")), belly_lines = list(until = "body_2",
    hanging_ratio = 0.95, diameter = "14 mm", material = "PP"))
  panels_of <- function(rope) vapply(gear_si(roped)$ropes[[rope]]$along, `[[`, "", "panel")
  expect_setequal(panels_of("strap"), c("back_body_2_behind", "belly_body_2"))
  expect_identical(rev(panels_of("belly_line_belly_back"))[1], "back_body_2_behind")
  expect_refused(update(two_seam(), net.upper.body_2.window = modifyList(window,
    list(rows = 60))), "body_2.window.rows.*less than 60")
  expect_refused(update(two_seam(), net.upper.body_2.window = modifyList(window,
    list(across = 170))), "window.across")
})

test_that("a separator panel is joined to both side seams from row to row", {
  separator <- list(from = "body_1", to = "body_2", mesh_size = "100 mm",
    meshes = list(upper = 120, lower = 60, deep = 162), twine = list(diameter = "3 mm",
      material = "PE"))
  trawl <- update(two_seam(), separators = list(separator = separator))
  seams <- gear_si(trawl)$seams
  edges <- unlist(unlist(lapply(seams, `[[`, "edges"), recursive = FALSE), recursive = FALSE)
  own <- Filter(function(edge) edge$panel == "separator", edges)
  of <- vapply(own, `[[`, "", "edge")
  part <- vapply(own, function(edge) edge$to - edge$from, 0)
  expect_equal(c(tapply(part, of, sum)), c(left = 1, right = 1))
  # body_1 is 60 rows of 140 mm, body_2 80 rows of 100 mm
  expect_equal(sort(unname(part)), sort(rep(c(8.4, 8) / 16.4, 2)))
  state <- settle(trawl, nodes = 400)
  expect_equal(measures(state)[["warp_tension_port_kN"]],
    measures(state)[["warp_tension_starboard_kN"]], tolerance = 1e-4)
  expect_refused(update(two_seam(), separators = list(a = modifyList(separator,
    list(from = "square")))), "separators.a.from")
  window <- list(ahead = 20, rows = 20, across = 40, mesh_size = "100 mm",
    twine = list(diameter = "4 mm", material = "PE"),
    meshes = list(front = 40, rear = 40, deep = 28))
  expect_refused(update(trawl, net.upper.body_2.window = window),
    "separators.separator.to` is \"body_2\"; it must be a row without a window")
})
