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
  # its label has its own line
  sheet <- gear_sheet(trawl, "A3")
  texts <- unlist(lapply(sheet$items, `[[`, "text"))
  expect_true("R7680 PE square" %in% texts)
  expect_identical(overlaps(sheet), character())
  # 40 meshes of 100 mm, in width at a hanging ratio of 0.5
  expect_equal(drawn$upper[drawn$name == "back_body_2_window"], 2)
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
})

test_that("windows and separators fit together", {
  window <- list(ahead = 20, rows = 20, across = 40, mesh_size = "100 mm",
    twine = list(diameter = "4 mm", material = "PE"),
    meshes = list(front = 40, rear = 40, deep = 20))
  separator <- list(from = "body_1", to = "body_2", mesh_size = "100 mm",
    meshes = list(upper = 120, lower = 60, deep = 162), twine = list(diameter = "3 mm",
      material = "PE"))
  # both panels have a window, at different depths
  trawl <- update(two_seam(), separators = list(separator = separator),
    net.upper.body_2.window = window,
    net.lower.body_2.window = modifyList(window, list(ahead = 45)))
  # the front and rear edge of the separator are free
  expect_equal(range(covered_edges(trawl), na.rm = TRUE), c(1, 1))
  edges <- lapply(gear_si(trawl)$seams$body_2_back_belly$edges, vapply, function(edge) {
    paste0(edge$panel, ".", edge$edge)
  }, "")
  expect_identical(edges, list(
    paste0("back_body_2_", c("ahead", "window_right", "behind"), ".right"),
    paste0("belly_body_2_", c("ahead", "window_left", "behind"), ".left"), "separator.right"))
  found <- measures(settle(trawl, nodes = 400))
  expect_equal(found[["warp_tension_port_kN"]], found[["warp_tension_starboard_kN"]],
    tolerance = 1e-4)
  cover <- list(mesh_size = "120 mm", twine = window$twine,
    meshes = list(upper = 150, lower = 90, deep = 66))
  expect_refused(update(trawl, net.upper.body_2.covers = list(chafer = cover)),
    "body_2.window` is given; it must be omitted in a piece with `covers`")
  expect_refused(update(two_seam(), net.upper.square.covers = list(flapper = cover)),
    "net.upper.square.covers` is given; it must be omitted in a piece that the panel `lower`")
})

test_that("side panels may end at a row with a window", {
  trawl <- assembly(read_gear("poly_noreastern_trawl"), only = "net")
  rows <- names(trawl$plan$net$side)
  until <- rows[length(rows) - 1L]
  whole <- trawl$plan$net$upper[[until]]
  window <- list(ahead = 5, rows = 5, across = 8, mesh_size = whole$mesh_size, twine = whole$twine,
    meshes = list(front = 8, rear = 8, deep = 5))
  trawl <- update(trawl, net.side = trawl$plan$net$side[seq_len(length(rows) - 1L)])
  plan <- trawl$plan
  plan$net$upper[[until]]$window <- window
  gear <- as_gear(unclass(plan))
  expect_equal(range(covered_edges(gear)), c(1, 1))
})
