test_that("drawn lines end in points of the state with their part's tension", {
  for (netting in c("cells", "bars")) {
    state <- unsettled(sheets_plan, nodes = 300, netting = netting)
    points <- state_points(state)
    drawing <- state_drawing(state)
    for (lines in drawing[c("ropes", "netting")]) {
      expect_true(all(are_among(lines$from, points)))
      expect_true(all(are_among(lines$to, points)))
      expect_equal(ncol(lines$from), length(lines$tension))
      expect_equal(length(lines$part), length(lines$tension))
    }
    names <- parts_of(state)$name
    expect_setequal(names[unique(drawing$ropes$part)], names(sheets_plan$ropes))
    expect_setequal(names[unique(drawing$netting$part)], names(sheets_plan$panels))
  }
})

test_that("ropes and netting of bars are drawn bar by bar", {
  state <- unsettled(sheets_plan, netting = "bars")
  drawing <- state_drawing(state)
  ropes <- parts_of(state)$kind[part_of(state, "bar")] == "rope"
  expect_equal(drawing$ropes$tension, state$bar_tension[ropes])
  # the seams between the panels follow the bars
  expect_equal(
    sort(utils::head(drawing$netting$tension, sum(!ropes))), sort(state$bar_tension[!ropes])
  )
  length <- sqrt(colSums((drawing$ropes$to - drawing$ropes$from)^2))
  # Both are lengths from the same coordinates, except for rounding.
  expect_equal(length, state$bar_length[ropes], tolerance = 1e-12)
})

test_that("drawn twines of bars end on seams if mesh sizes change", {
  state <- unsettled("midwater_trawl", nodes = 1500, netting = "bars")
  drawing <- state_drawing(state)
  from <- cbind(drawing$netting$from, drawing$ropes$from)
  to <- cbind(drawing$netting$to, drawing$ropes$to)
  along <- to - from
  # Tied points between nodes are the ends of twines on seams and ropes.
  tied <- state_points(state)[, -seq_len(engine_array(state, "nodes"))]
  inside <- apply(tied, 2, function(place) {
    share <- colSums((place - from) * along) / colSums(along^2)
    beside <- colSums((place - from - rep(share, each = 3) * along)^2)
    any(share > 1e-3 & share < 1 - 1e-3 & beside < 1e-12)
  })
  expect_gt(length(inside), 500)
  expect_true(all(inside))
})

test_that("drawn cells are in the panel's grid between their nodes", {
  state <- unsettled(sheets_plan, nodes = 300)
  mesh <- state$mesh
  for (name in names(panels_of(mesh))) {
    mine <- elements_of(mesh, "cell", name)
    grid <- panel_of(mesh, name)$grid
    cell <- panel_of(mesh, name)$cell
    expect_length(cell, length(mine))
    column <- row(grid)[cell]
    row <- col(grid)[cell]
    expect_equal(range(column), c(1, nrow(grid) - 1))
    expect_equal(range(row), c(1, ncol(grid) - 1))
    node <- matrix(engine_array(mesh, "cells", "node"), 4L)[, mine, drop = FALSE]
    inside <- vapply(seq_along(mine), function(k) {
      all(node[, k] %in% grid[column[k] + 0:1, row[k] + 0:1])
    }, NA)
    expect_true(all(inside))
  }
})

test_that("drawn lines of a cell have the cell's tensions", {
  state <- unsettled(sheets_plan, nodes = 300)
  # Artificial tensions that identify the row of the panel: the mean depth of the cell in mesh
  # coordinates.
  twine <- matrix(engine_array(state, "cells", "twine"), 8L)
  state$u_tension <- colMeans(twine[c(1, 3, 5, 7), ] + twine[c(2, 4, 6, 8), ]) / 2
  state$v_tension <- state$u_tension + 1000
  part <- which(parts_of(state)$name == "top")
  lines <- panel_cell_lines(state, state_points(state), "top", part, 1)
  grid <- panel_of(state, "top")$grid
  cells <- prod(dim(grid) - 1)
  expect_length(lines$tension, 2 * cells)
  # The middle of a row, except for the taper.
  row <- rep(seq_len(ncol(grid) - 1), each = nrow(grid) - 1)
  deep <- state$si$panels$top$deep
  expect_equal(lines$tension[seq_len(cells)], (row - 0.5) * deep / max(row), tolerance = 0.02)
  expect_equal(lines$tension[cells + seq_len(cells)], lines$tension[seq_len(cells)] + 1000)
})

test_that("drawn twines run along square cells and across diamond cells", {
  state <- unsettled(sheets_plan, nodes = 300)
  lines <- function(name) {
    panel_cell_lines(state, state_points(state), name, which(parts_of(state)$name == name), 1)
  }
  cells <- function(name) dim(panel_of(state, name)$grid) - 1
  square <- cells("middle")
  expect_length(lines("middle")$tension, square[1] * (square[2] + 1) + square[2] * (square[1] + 1))
  expect_length(lines("top")$tension, 2 * prod(cells("top")))
})

test_that("drawing thins a fine net to the requested number of lines", {
  for (netting in c("cells", "bars")) {
    state <- unsettled(sheets_plan, nodes = 3000, netting = netting)
    points <- state_points(state)
    whole <- state_drawing(state)
    for (limit in c(200, 1000)) {
      thin <- state_drawing(state, limit)
      # Edges of square meshes and unequal twines may add a fifth.
      expect_lt(length(thin$netting$tension), 1.2 * limit)
      expect_gt(length(thin$netting$tension), limit / 5)
      expect_true(all(are_among(cbind(thin$netting$from, thin$netting$to), points)))
      expect_setequal(unique(thin$netting$part), unique(whole$netting$part))
      # Thinning removes lines, but not along the sides of the net.
      expect_equal(
        apply(cbind(thin$netting$from, thin$netting$to), 1, range),
        apply(cbind(whole$netting$from, whole$netting$to), 1, range), tolerance = 0.1
      )
    }
  }
})

test_that("thinned panel of bars shows whole, evenly spaced twines", {
  state <- unsettled(sheets_plan, nodes = 3000, netting = "bars")
  state$bar_tension[] <- 7
  part <- which(parts_of(state)$name == "top")
  drawn <- panel_of(state, "top")
  # in mesh coordinates a twine is a straight line of constant i + j or j - i
  node <- ifelse(drawn$node < 0, engine_array(state, "nodes") - drawn$node, drawn$node)
  points <- matrix(NA_real_, 3, max(node))
  points[, node] <- rbind(drawn$i, drawn$j, 0)
  bar <- 0.05 * drawn$lambda
  lines <- panel_bar_lines(state, points, "top", part, 4 * bar)
  expect_equal(lines$tension, rep(7, length(lines$tension)))
  u <- rbind(lines$from[1, ] + lines$from[2, ], lines$to[1, ] + lines$to[2, ]) / drawn$lambda
  v <- rbind(lines$from[2, ] - lines$from[1, ], lines$to[2, ] - lines$to[1, ]) / drawn$lambda
  along_u <- abs(u[2, ] - u[1, ]) > abs(v[2, ] - v[1, ])
  across <- ifelse(along_u, colMeans(v), colMeans(u))
  along <- ifelse(along_u, u[2, ] - u[1, ], v[2, ] - v[1, ])
  # knots near a side are moved onto it by up to a quarter of an equivalent bar
  expect_lt(max(abs(ifelse(along_u, v[2, ] - v[1, ], u[2, ] - u[1, ]))), 0.5 + 1e-6)
  apart <- unlist(tapply(across, along_u, function(x) {
    whole <- x[abs(x - stats::median(x)) %% 4 < 0.3 | abs(x - stats::median(x)) %% 4 > 3.7]
    length(whole) / length(x)
  }))
  expect_equal(as.vector(apart), c(1, 1))
  # the drawn length equals the length of every fourth twine, and each line has up to four bars
  expect_lte(max(abs(along)), 4 + 0.5)
  all_bars <- panel_bar_lines(state, points, "top", part, 0)
  expect_equal(sum(abs(along)), sum(part_of(state, "bar") == part) / drawn$segments / 4,
    tolerance = 0.1)
  expect_lt(length(lines$tension), length(all_bars$tension) / 10)
})

test_that("rope with many bars is drawn whole through fewer nodes", {
  state <- unsettled("towed_cable")
  lines <- state_drawing(state, limit = 30)$ropes
  n <- length(lines$tension)
  expect_lte(n, 30)
  expect_equal(lines$from[, -1], lines$to[, -n])
  nodes <- along_rope(state, "cable")$node
  expect_equal(lines$from[, 1], state$position[, nodes[1]])
  expect_equal(lines$to[, n], state$position[, nodes[length(nodes)]])
})

test_that("pieces and fixed points are marked at their positions", {
  state <- unsettled(sheets_plan)
  marks <- state_drawing(state)$marks
  expect_setequal(marks$role, c("float", "otter_board", "other", "moved"))
  at <- function(row) unlist(marks[row, c("x", "y", "z")], use.names = FALSE)
  expect_equal(at(which(marks$part == "starboard")), c(0, 2, 0))
  expect_equal(
    at(which(marks$part == "sinker")), state$position[, nodes_at(state, "tip.lower_left")]
  )
  floats <- t(as.matrix(marks[marks$role == "float", c("x", "y", "z")]))
  on_rope <- state$position[, along_rope(state, "headline")$node]
  expect_true(all(are_among(floats, on_rope)))
  expect_lte(ncol(floats), marks_of_piece)
})

test_that("flow_past() adds towing and current and is zero in air", {
  plan <- sheets_plan
  plan$water <- list(current = list(speed = 0.5, toward = "90 deg"))
  expect_equal(flow_past(unsettled(plan)), c(1, 0.5))
  expect_equal(flow_past(unsettled("crossing_cables")), c(0, 0))
})
