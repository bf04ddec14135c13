layout_of <- function(plan) {
  flat_layout(gear_si(if (is.character(plan)) read_gear(plan) else as_gear(plan)))
}

test_that("drawing shows a trawl's panels in columns and identical ones once", {
  layout <- layout_of("midwater_trawl")
  expect_identical(layout$columns$heading, c("back", "side", "belly"))
  expect_identical(layout$columns$alike, c("", "2 off: starboard, port", ""))
  expect_identical(layout$columns$count, c(1L, 2L, 1L))
  expect_true(all(layout$columns$symmetric))
  back <- layout$panels[layout$panels$column == 1, ]
  at <- function(name) back[back$name == paste0("back_", name), ]
  # 16 meshes of 32 m, half of their stretched width; two meshes deep, behind wings of three meshes
  expect_equal(at("section_1")$upper, 16 * 32 / 2)
  expect_equal(at("section_1")$depth, 2 * 32)
  # the wings precede the first section, the sections follow each other
  expect_equal(at("wing_left")$y, 0)
  expect_equal(at("section_1")$y, 3 * 32)
  expect_equal(at("section_2")$y, (3 + 2) * 32)
  expect_equal(at("codend")$y + at("codend")$depth, sum(back$depth) - 3 * 32)
  # each wing above its end of the first section's front edge
  expect_equal(at("wing_left")$x + at("wing_left")$shift, at("section_1")$x)
  expect_equal(
    with(at("wing_right"), x + shift + lower), with(at("section_1"), x + upper)
  )
})

test_that("drawing shows panels as wide as their ropes or bars", {
  panel <- layout_of("flat_panel")$panels
  # 200 meshes of 100 mm; only the lower edge has a rope of known hanging ratio
  expect_equal(c(panel$upper, panel$lower, panel$depth), c(10, 10, 11.5))
  hung <- panel_in_current_plan
  expect_equal(layout_of(hung)$panels$upper, 2.2)
  expect_equal(layout_of(hung_panel_plan)$panels$upper, 40 * 0.05)
  expect_equal(layout_of(hung_panel_plan)$panels$depth, 60 * 0.05)
})

wall_plan <- function(names, closed = FALSE, deep = 100) {
  panel <- list(mesh_size = 0.02, meshes = list(upper = 50, lower = 50, deep = deep),
    twine = list(diameter = 0.001, material = "PA"))
  onward <- seq_along(names) %% length(names) + 1L
  pairs <- seq_len(length(names) - !closed)
  seams <- lapply(pairs, function(k) {
    list(edges = list(paste0(names[k], ".right"), paste0(names[onward[k]], ".left")))
  })
  list(
    codend = 1, name = "Wall", points = list(),
    panels = setNames(rep(list(panel), length(names)), names),
    seams = c(
      setNames(seams, paste0("seam_", pairs)),
      list(hung = list(edges = list(paste0(names[1], ".upper")), gathered_at = "nail"))
    )
  )
}

test_that("drawing joins straight panels to a wall and equal rings to one", {
  add_nail <- function(plan) {
    plan$points <- list(nail = list(position = c(0, 0, 0), held = "fixed"))
    plan
  }
  wall <- layout_of(add_nail(wall_plan(c("wing", "body", "bunt"))))
  expect_identical(nrow(wall$columns), 1L)
  expect_identical(wall$panels$name[order(wall$panels$x)], c("wing", "body", "bunt"))
  expect_equal(sort(wall$panels$x), c(0, 0.5, 1))
  ring <- layout_of(add_nail(wall_plan(paste0("side_", 1:4), closed = TRUE)))
  expect_identical(ring$columns$heading, "side")
  expect_identical(ring$columns$alike, "4 off")
  expect_identical(ring$columns$count, 4L)
})

test_that("drawing places panels of a column without overlap", {
  for (name in gears()$name) {
    si <- gear_si(read_gear(name))
    if (!length(si$panels)) next
    panels <- flat_layout(si)$panels
    for (column in unique(panels$column)) {
      mine <- panels[panels$column == column, ]
      for (k in seq_len(nrow(mine) - 1L)) {
        expect_false(any_overlap(mine[k, ], mine[seq(k + 1L, nrow(mine)), ]))
      }
    }
  }
})

test_that("lists contain every rope and piece once with a count", {
  si <- gear_si(read_gear("midwater_trawl"))
  ropes <- rope_items(si)
  expect_equal(sum(ropes$count), length(si$ropes))
  warp <- ropes[ropes$name == "warp", ]
  expect_equal(c(warp$count, warp$length, warp$diameter), c(2, 600, 0.032))
  expect_identical(warp$material, "steel wire")
  headline <- ropes[ropes$name == "headline", ]
  # along two wings' inner edges, 7 meshes of 32 m each; the wings use all 16 meshes of the front
  expect_equal(headline$hanging, 222 / (2 * 7 * 32))
  pieces <- piece_items(si)
  expect_setequal(unlist(pieces$parts), names(si$pieces))
  expect_equal(pieces$count[pieces$name == "hammer"], 2)
  # 6000 kg of steel less the displaced water
  expect_match(pieces$words[pieces$name == "hammer"], "6000 kg, in water 5220 kgf", fixed = TRUE)
  expect_equal(6000 * (1 - 1025 / 7850), 5220, tolerance = 1e-3)
})

test_that("rigging shows one side from the towing points to the netting", {
  figure <- plan_figure(read_gear("midwater_trawl"))
  nodes <- figure$riggings[[1L]]$nodes
  ropes <- figure$riggings[[1L]]$ropes
  named <- figure$ropes$name[ropes$item]
  expect_setequal(named, c("warp", "upper hand rope", "lower hand rope"))
  layers <- cbind(nodes$layer[ropes$from], nodes$layer[ropes$to])
  expect_equal(sort(layers[named == "warp", ]), c(0, 1))
  expect_equal(sort(layers[named == "upper hand rope", ]), c(1, 2))
  expect_equal(ropes$length[named == "warp"], 600)
  letter <- function(name) figure$pieces$item[figure$pieces$name == name]
  expect_equal(nodes$layer[nodes$letters == letter("otter board")], 1)
})

test_that("rigging of a rig shows each net with its joints, and one net of each kind", {
  figure <- plan_figure(example_gear("quad_rig"))
  between <- figure$riggings[[1L]]
  nodes <- between$nodes
  joints <- between$ropes[between$ropes$joint, ]
  expect_identical(nodes$net[nzchar(nodes$net)], c("one", "two", "three", "four"))
  # Pieces at both ends of each net, from port to starboard.
  masses <- lapply(which(nzchar(nodes$net)), function(net) {
    sort(nodes$letters[joints$from[joints$to == net]])
  })
  expect_identical(masses, list(c("B", "D"), c("C", "D"), c("C", "D"), c("B", "D")))
  expect_identical(sum(nodes$held), 3L)
  expect_length(figure$riggings, 2L)
  expect_identical(figure$riggings[[2L]]$of, c("one", "two", "three", "four"))
  # All four nets have equal netting, so it is drawn once.
  expect_identical(unique(figure$layout$columns$alike), "4 off")
  # The net in the middle differs from the others only by its name.
  expect_identical(unique(plan_figure(example_gear("triple_rig"))$layout$columns$count), 3L)
})

test_that("rigging of a farm merges equal cages", {
  farm <- plan_figure(example_gear("cage_farm"))$riggings
  expect_identical(setdiff(farm[[1L]]$nodes$net, ""), "net, 4 off")
  expect_identical(farm[[2L]]$of, paste0("cage_", 1:4))
})

test_that("rigging draws ropes between identical parts with an open end", {
  rigging <- plan_figure(read_gear("beam_trawl"))$riggings[[1L]]
  ropes <- rigging$ropes
  # three tickler chains from shoe to shoe; the two halves of the beam are identical
  expect_identical(sum(ropes$from == ropes$to), 3L)
  expect_identical(sum(ropes$length %in% 4), 1L)
  beam <- ropes[ropes$length %in% 4, ]
  middle <- ropes[ropes$length %in% 5.9, ]
  expect_length(intersect(c(beam$from, beam$to), c(middle$from, middle$to)), 1L)
  # a shoe's three edges; every position is connected
  expect_identical(sum(is.na(ropes$item)), 3L)
  expect_setequal(c(ropes$from, ropes$to), seq_len(nrow(rigging$nodes)))
  texts <- unlist(lapply(gear_sheet(read_gear("beam_trawl"), "A4")$items, `[[`, "text"))
  expect_true(all(c("5 m to the next", "6 m to the next", "7 m to the next") %in% texts))
})

test_that("rigging orders ropes between layers with the fewest crossings", {
  layer <- c(0, 1, 1, 2, 2)
  edges <- data.frame(from = c(1, 1, 2, 3), to = c(2, 3, 5, 4))
  order <- c(0, -0.5, 0.5, -0.5, 0.5)
  expect_identical(crossings(order, layer, edges), 1)
  expect_identical(crossings(uncrossed_layer(order, 4:5, layer, edges), layer, edges), 0)
  # two of each side, each joined to both: one crossing in any order
  all <- data.frame(from = c(2, 2, 3, 3), to = c(4, 5, 4, 5))
  expect_identical(uncrossed_layer(order, 4:5, layer, all), order)
})

test_that("drawing labels an inner liner once when both panels use it", {
  columns <- net_columns(plan_figure(example_gear("eastern_trawl", "extdata")))
  expect_identical(vapply(columns, `[[`, "", "heading"),
    c("upper panel", "lower panel", "codend liner"))
  expect_identical(columns[[3]]$remark, "2 off: upper, lower")
  codend <- columns[[1]]$panels[columns[[1]]$panels$name == "back_codend", ]
  expect_equal(columns[[3]]$panels$y, codend$y)
})

test_that("drawing distinguishes a wing from its jib", {
  columns <- net_columns(plan_figure(read_gear("poly_noreastern_trawl")))
  side <- columns[[match("side panel", vapply(columns, `[[`, "", "heading"))]]
  expect_setequal(side$words["part", ], c("jib", "wing", "body", "intermediate", "codend"))
  expect_true("wings" %in% columns[[1]]$words["part", ])
})

test_that("labels keep their distance and stay near their positions", {
  y <- c(5, 4.99, 4.98, 1)
  spread <- spread_labels(y, 0.1, 0, 10)
  expect_true(all(-diff(spread) > 0.1 - 1e-6))
  expect_equal(spread[4], 1)
  expect_equal(mean(spread[1:3]), mean(y[1:3]), tolerance = 1e-6)
  # at the top they move down by the minimum
  expect_equal(spread_labels(c(5, 4.99, 1), 0.1, 0, 5), c(5, 4.9, 1))
})

test_that("lines_cross_box() detects only lines through a box", {
  box <- c(0, 0, 2, 1)
  lines <- rbind(c(-1, 0.5, 3, 0.5), c(1, -1, 1, 3), c(-1, 0, 3, 4), c(0.5, 0.5, 1, 0.6),
    c(-1, 2, 3, 2), c(2.5, -1, 2.5, 3), c(0, 1, 2, 1), c(-2, 0.5, -1, 0.5))
  expect_identical(lines_cross_box(lines, box), c(TRUE, TRUE, FALSE, TRUE, rep(FALSE, 4)))
  # one line and many boxes
  boxes <- rbind(box, box + 3, c(-0.9, 0.4, -0.1, 0.6), deparse.level = 0)
  expect_identical(lines_cross_box(lines[1, , drop = FALSE], boxes), c(TRUE, FALSE, TRUE))
})

test_that("drawings of shipped gears have no overlap and ISO 3098 letters", {
  nets <- c("eastern_trawl", "four_seam_trawl", "myctophid_trawl", "penaeid_trawl", "survey_trawl",
    "two_seam_trawl")
  random <- lapply(c(80009, 80016, 80020), random_net)
  gears <- c(lapply(gears()$name, read_gear), lapply(nets, example_gear, "extdata"), random)
  for (k in seq_along(gears)) {
    gear <- gears[[k]]
    # the smallest page, and for every third gear a larger one
    for (page in c("A4", if (k %% 3 == 0) c("A3", "A2", "A1")[(k / 3) %% 3 + 1])) {
      sheet <- gear_sheet(gear, page)
      told <- paste(gear$plan$name, page)
      expect_identical(overlaps(sheet), character(), label = told)
      sizes <- vapply(Filter(function(item) item$kind == "text", sheet$items), `[[`, 0, "size")
      expect_gte(min(sizes), c(A4 = 1.8, A3 = 1.8, A2 = 2.5, A1 = 2.5)[[page]], label = told)
      expect_setequal(sheet$page, sheet_sizes[[page]])
      said <- as.character(unlist(lapply(sheet$items, function(item) {
        if (item$component == "piece") item$text
      })))
      expect_false(any(endsWith(said, "...")), label = told)
    }
  }
})

test_that("overlaps() detects labels over labels, lines and the frame", {
  sheet <- new_sheet(c(100, 50))
  sheet_text(sheet, 30, 25, "one", 2)
  expect_identical(overlaps(sheet), character())
  sheet_text(sheet, 32, 26, "two", 2)
  expect_identical(overlaps(sheet), "one / two")
  on_sheet(sheet, component = "leader", draw = sheet_line(sheet, c(25, 40), c(24.9, 24.9)))
  expect_identical(overlaps(sheet)[2], "one is crossed by a leader")
  sheet_text(sheet, 5, 40, "out", 2)
  expect_identical(overlaps(sheet)[2], "out leaves the frame")
})

test_that("drawing uses a round scale for netting", {
  gear <- read_gear("pair_trawl")
  sheet <- gear_sheet(gear, "A3")
  expect_true(any(abs(sheet$scale / 10^(0:4) / rep(scale_steps, each = 5) - 1) < 1e-9))
  codend <- Filter(function(i) i$component == "panel" && i$ref == "panels.back_codend" &&
    i$kind == "polygon", sheet$items)[[1]]
  panel <- gear_si(gear)$panels$back_codend
  # stretched depth of the panel, on the sheet in millimetres
  expect_equal(diff(range(codend$y)), panel$deep * panel$mesh_size * 1000 / sheet$scale)
})

test_that("drawing joins half panels at a centre line, upper left, lower right", {
  columns <- net_columns(plan_figure(read_gear("pair_trawl")))
  expect_identical(vapply(columns, `[[`, "", "heading"), c("upper panel", "lower panel"))
  expect_identical(vapply(columns, `[[`, "", "half"), c("left", "right"))
  expect_lte(max(columns[[1]]$panels$ur), 1e-9)
  expect_gte(min(columns[[2]]$panels$ul), -1e-9)
})

test_that("drawing keeps fractional mesh counts", {
  expect_identical(mesh_number(c(78.75, 62.5, 120, 0.25, 65.44)),
    c("78\u00be", "62\u00bd", "120", "\u00bc", "65.4"))
})

test_that("cutting rates come from the plan or are the simplest match", {
  expect_identical(simple_cutting_rate(21, 25), "1N10B")
  expect_identical(simple_cutting_rate(50, 100), "1N2B")
  expect_identical(simple_cutting_rate(0, 100), "AN")
  expect_identical(simple_cutting_rate(0, 100, "turned"), "AT")
  for (lost in c(3, 7.5, 31, 72, 107)) {
    for (deep in c(40, 75, 110)) {
      rate <- simple_cutting_rate(lost, deep)
      # meshes removed by the rule of plans; the points reduce a cut of all bars
      off <- if (startsWith(rate, "AB+")) deep - as.double(gsub("[^0-9]", "", rate)) else {
        cutting_slope(rate, "cutting") * deep
      }
      expect_lte(abs(off - lost), 1 + 1e-9, label = rate)
      expect_lte(nchar(rate), nchar(cutting_rate(lost, deep)), label = rate)
    }
  }
  # all bars except four points, where alternating 1N58B and 1N59B end at the counts
  expect_identical(cutting_rate(117, 121), "1(1N58B)+1(1N59B)")
  expect_identical(simple_cutting_rate(117, 121), "AB+4N")
  expect_identical(simple_cutting_rate(121, 117), "AB+4T")
  gear <- read_gear("pair_trawl")
  panel <- gear_si(gear)$panels$back_body
  expect_identical(drawn_rates(panel, list(cutting = "2N3B"))[["right"]], "2N3B")
})

straight_rope <- function(figure, name) {
  Find(function(rope) rope$items$name[1] == name, straight_ropes(figure))
}

test_that("straight rope shows wing, bosom, wing and its floats", {
  figure <- plan_figure(read_gear("poly_noreastern_trawl"))
  headline <- straight_rope(figure, "headline")
  given <- figure$si$ropes$headline
  expect_identical(headline$parts$words, c("wing", "bosom", "wing"))
  expect_equal(sum(headline$parts$length), given$length)
  expect_equal(headline$parts$length, given$length * given$shares)
  expect_true(all(headline$pieces$name == "float"))
  floats <- figure$pieces[figure$pieces$name == "float", ]
  expect_equal(sum(headline$pieces$number), sum(floats$count))
})

test_that("straight rope joins the sections of a line and their pieces", {
  gear <- example_gear("two_seam_trawl", "extdata")
  figure <- plan_figure(gear)
  headline <- straight_rope(figure, "headline")
  expect_equal(headline$parts$length, c(8, 4, 6, 4, 8))
  expect_equal(headline$pieces$number, c(11, 9, 20, 9, 11))
  expect_equal(headline$pieces$high, rep(0.2, 5))
  # symmetric, each float in the middle of its own stretch
  last <- with(headline$pieces, at + apart * (number - 1))
  expect_equal(headline$pieces$at[1], 8 / 11 / 2)
  expect_equal(headline$pieces$at, 30 - rev(last))
  ground <- straight_rope(figure, "ground gear")
  expect_equal(ground$parts$length, c(10, 5, 6, 5, 10))
  expect_equal(ground$pieces$high, c(0.2, 0.3, 0.2))
  expect_equal(ground$pieces$wide, c(0.08, 0.1, 0.08))
  # every float on the sheet has the same size
  circles <- Filter(function(i) i$kind == "circle" && grepl("floats", i$ref),
    gear_sheet(gear, "A4")$items)
  expect_length(circles, 60)
  expect_length(unique(vapply(circles, `[[`, 0, "radius")), 1)
})

test_that("drawing shows discs of the ground gear in proportion", {
  gear <- example_gear("four_seam_trawl", "extdata")
  figure <- plan_figure(gear)
  rope <- straight_rope(figure, "ground gear")
  expect_equal(rope$pieces$high, c(0.406, 0.356, 0.356))
  expect_equal(rope$pieces$wide, rep(0.076, 3))
  given <- figure$si$pieces[paste0("discs_", 1:3)]
  expect_equal(rope$pieces$number, unname(vapply(given, `[[`, 0, "number")))
  sheet <- gear_sheet(gear, "A3")
  texts <- unlist(lapply(sheet$items, `[[`, "text"))
  # 0.4 and 0.5 m apart, as in the plan
  expect_true(any(grepl("disc \u00d8406, 21 off, 0.4 m apart", texts, fixed = TRUE)))
  # as many bars as discs, the bosom's bars higher; letters are in squares
  bars <- Filter(function(i) {
    i$kind == "polygon" && i$component == "piece" && grepl("discs_", i$ref) &&
      diff(range(i$x)) < 0.5 * diff(range(i$y))
  }, sheet$items)
  of <- vapply(bars, `[[`, "", "ref")
  high <- vapply(bars, function(i) diff(range(i$y)), 0)
  expect_equal(as.vector(table(of)), rope$pieces$number)
  expect_equal(unique(high[of == "pieces.discs_2"]) / unique(high[of == "pieces.discs_1"]),
    356 / 406)
})

test_that("DXF has no break and one scale", {
  wall <- gear_sheet(read_gear("gillnet"), "A1", true_size = TRUE)
  panel <- Filter(function(i) i$component == "panel" && i$kind == "polygon", wall$items)[[1]]
  flat <- flat_layout(gear_si(read_gear("gillnet")))$panels
  expect_equal(diff(range(panel$x)) / diff(range(panel$y)), flat$upper[1] / flat$depth[1])
})

test_that("plot() of a plan restores the device settings", {
  grDevices::pdf(NULL, 11.69, 8.27)
  device <- grDevices::dev.cur()
  on.exit(grDevices::dev.off(device))
  before <- graphics::par("mai", "cex")
  for (name in c("towed_cable", "pair_trawl", "cage")) {
    gear <- read_gear(name)
    expect_identical(withVisible(plot(gear)), list(value = gear, visible = FALSE))
  }
  expect_equal(grDevices::dev.cur(), device)
  expect_equal(graphics::par("mai", "cex"), before)
})
