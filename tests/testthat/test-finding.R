# Warnings about plans: each check reports a plan with its mistake, with the number and the
# location, and no shipped gear.

quiet <- function(gear, ...) suppressWarnings(settle(gear, ...))

# Expects one finding of a check at a location; returns list(check, location, value, ...).
expect_finding <- function(x, check, place) {
  found <- findings(x)
  mine <- found[found$check == check, ]
  expect_gte(nrow(mine), 1L)
  expect_true(place %in% mine$location, info = paste(mine$location, collapse = ", "))
  expect_true(all(nzchar(mine$advice)))
  as.list(mine[match(place, mine$location), ])
}

test_that("findings() reports no false alarm for shipped gears", {
  for (name in gears()$name) {
    # a seine at rest in still water does hang as a bundle
    known <- if (name == "purse_seine") "bundle" else character()
    nodes <- if (name == "purse_seine") 300 else 1500
    state <- suppressWarnings(settled(name, nodes = nodes))
    expect_identical(findings(state)$check, known, info = name)
  }
})

test_that("panels of one section with the same twine give one finding", {
  # the belly has its own twine
  thick <- update(read_gear("poly_noreastern_trawl"), sections.body.twine.diameter = "25 mm")
  expect_equal(sum(findings(thick)$check == "twine"), 1)
})

test_that("findings() reports numbers that no gear has", {
  # each row: shipped plan, changed field, its value, the check and location of the warning, and the
  # reported number
  cases <- list(
    list("towed_cable", "ropes.cable.diameter", 17.3, "rope diameter", "rope cable", 17300),
    list("poly_noreastern_trawl", "sections.body.twine.diameter", "25 mm", "twine",
      "panel back_body", 25),
    list("poly_noreastern_trawl", "towing.speed", "7 knot", "towing speed", "towing.speed", 7),
    list("poly_noreastern_trawl", "otter_boards.lift_coefficient", 11, "lift coefficient",
      "piece otter_board_port", 11),
    list("poly_noreastern_trawl", "otter_boards.drag_coefficient", 5, "drag coefficient",
      "piece otter_board_port", 5),
    list("poly_noreastern_trawl", "ground_gear.mass_in_water", "40 kg/m", "ground gear weight",
      "ground_gear", 40),
    list("poly_noreastern_trawl", "otter_boards.mass", "100 kg", "board weight over area",
      "otter_boards.mass", 100 / 4.86),
    # kinds without a specific range
    list("towed_cable", "towing.speed", "40 knot", "speed", "towing.speed", 40),
    list("gillnet", "water.current.speed", "15 m/s", "current", "water.current", 15),
    list("towed_cable", "ropes.cable.mass_per_length", "48 kg/m", "rope density", "rope cable"),
    list("towed_cable", "ropes.cable.mass_per_length", "70 g/m", "rope density", "rope cable"),
    list("cage", "collar.mass_per_length", "6 kg/m", "density", "rope collar"),
    list("towed_cable", "towing.speed", "0.1 m/s", "speed", "towing.speed"),
    list("pair_trawl", "sections.extension.meshes.deep", 2, "taper", "panel back_extension"),
    list("longline", "branch_lines.length", "1.5 km", "branch lines", "rope branch_line_1_1"),
    list("longline", "float_lines.length", "500 m", "length for its role", NULL),
    list("longline", "branch_lines.diameter", "20 mm", "diameter for its role",
      "rope branch_line_1_1"),
    list("beam_trawl", "shoes.mass", "9 kg", "mass for its role", NULL),
    list("purse_seine", "selvedges.upper.mesh_size", "1.3 m", "meshes at a seam", NULL),
    list("model_cage", "side_ropes.diameter", "11 cm", "rope over twine", "rope side_rope_1"),
    list("towed_cable", "ropes.cable.coefficients.tangential", 0.0005,
      "tangential drag coefficient of ropes", "rope cable"),
    list("towed_cable", "pieces.sphere.mass", "11 kg", "density", "piece sphere"),
    list("poly_noreastern_trawl", "sections.codend.meshes.deep", 0.3, "mesh count",
      "panel back_codend"),
    list("poly_noreastern_trawl", "sections.codend.meshes.deep", 12000, "panel depth",
      "panel back_codend"),
    list("cage", "side_ropes.diameter", "0.4 mm", "rope over twine", "rope side_rope_1"),
    list("dip_net", "lift_line.length", "14 cm", "short rope", "rope lift_line"),
    list("towed_cable", "pieces.sphere.diameter", "24 mm", "body size", "piece sphere"),
    list("longline", "hooks.drag_area", "2 m2", "body drag", "piece hook_1_1"),
    list("towed_cable", "ropes.cable.diameter", "1.7 mm", "rope volume", "rope cable"),
    list("towed_cable", "ropes.cable.coefficients.normal", 15,
      "normal drag coefficient of ropes", "rope cable"),
    list("towed_cable", "ropes.cable.coefficients.tangential", 3,
      "tangential drag coefficient of ropes", "rope cable"),
    list("pair_trawl", "sections.codend.twine.diameter", "0.2 mm", "twines at a seam", NULL),
    list("midwater_trawl", "canvas.drag_coefficient", 0.002, "drag coefficient", NULL),
    list("longline", "hooks.drag_area", "0.1 cm2", "body drag", "piece hook_1_1"),
    list("longline", "hooks.volume", "1 litre", "weight that floats", "piece hook_1_1"),
    list("purse_seine", "sinkers.mass", "0.4 g", "weight that floats", "rope lead_line"),
    list("longline", "materials.monofilament.modulus", "0.1 GPa", "breaking strain", NULL),
    list("longline", "materials.monofilament.modulus", "60 GPa", "breaking strain", NULL),
    list("purse_seine", "panels.bunt.meshes", list(upper = 7, lower = 7, deep = 2000),
      "narrow panel", "panel bunt"),
    list("stow_net", "bridles.length", "12 km", "long bridle", NULL),
    list("model_cage", "water.density", "30 kg/m3", "water density", "water.density")
  )
  for (case in cases) {
    gear <- do.call(update, c(list(read_gear(case[[1]])), setNames(case[3], case[[2]])))
    found <- findings(gear)
    expect_true(case[[4]] %in% found$check, info = case[[4]])
    expect_false(case[[4]] %in% findings(read_gear(case[[1]]))$check, info = case[[4]])
    if (is.null(case[[5]])) next
    found <- expect_finding(gear, case[[4]], case[[5]])
    if (length(case) > 5) expect_equal(found$value, case[[6]])
  }
})

test_that("findings() reports overloaded twines and ropes, slack ropes and great depths", {
  # 1,135 t on a cable of 12.7 MN: Hooke's law, with the weight in water of the sphere
  heavy <- quiet(update(read_gear("towed_cable"), pieces.sphere.mass = "1135 t"))
  found <- expect_finding(heavy, "load", "rope cable")
  sphere <- heavy$si$pieces$sphere
  pull <- 9.81 * (sphere$mass - heavy$si$water$density * sphere$volume)
  # The cable has no strength: its load at 20 % elongation counts.
  expect_equal(found$value, 100 * pull / (0.2 * heavy$si$ropes$cable$axial_stiffness),
    tolerance = 0.02)
  deep <- quiet(update(read_gear("towed_cable"), ropes.cable.length = "9 km",
    towing.speed = "1 knot"))
  found <- expect_finding(deep, "depth", findings(deep)$location[findings(deep)$check == "depth"])
  expect_equal(found$value, -min(deep$position[3, ]))
  # The weight hangs on the apex of the netting.
  cage <- quiet(update(read_gear("cage"), centre_weight.mass = "100 t"), nodes = 500)
  most <- subset(tension_table(cage), kind == "netting")
  most <- most[which.max(most$most_loaded_kN), ]
  found <- expect_finding(cage, "load", paste("panel", most$part))
  # polyamide of 2.5 mm, 207 MPa x d^2
  expect_equal(found$value, 100 * most$most_loaded_kN * 1000 / (207e6 * 0.0025^2))
  loose <- quiet(update(read_gear("beam_trawl"), ticklers.tickler_2.length = "123 m"), nodes = 500)
  found <- findings(loose)
  expect_true("slack rope" %in% found$check)
  expect_match(found$location[found$check == "slack rope"], "tickler", all = FALSE)
})

test_that("findings() reports a main line that hangs double", {
  slack <- quiet(update(read_gear("longline"), shortening_ratio = 0.05), nodes = 300)
  main <- Filter(function(rope) identical(rope$role, "main_line"), slack$si$ropes)
  first <- slack$mesh$ropes[[names(main)[1]]]$node[1]
  last <- rev(slack$mesh$ropes[[names(main)[length(main)]]]$node)[1]
  distance <- sqrt(sum((slack$position[, last] - slack$position[, first])^2))
  found <- expect_finding(slack, "slack rope", paste("rope", names(main)[1]))
  # three baskets of 800 m
  expect_equal(found$value, 100 * distance / 2400)
})

test_that("findings() reports gear below its anchors", {
  shallow <- quiet(update(read_gear("cage"), moorings.anchor_depth = "10 cm"), nodes = 500)
  found <- findings(shallow)
  found <- found[found$check == "below the anchors", ]
  expect_equal(found$value, -min(shallow$position[3, ]) - 0.1)
})

test_that("findings() reports an omitted number of panels", {
  gear <- read_gear("midwater_trawl")
  found <- expect_finding(update(gear, panels = NULL), "number of panels", "panels")
  # the number that the plan expands to
  expect_equal(found$value, length(panels_by_number[["4"]]))
})

test_that("findings() reports seam edges that do not fit", {
  plan <- spoil("seams:", "  mat:
    mesh_size: 100 mm
    meshes: {upper: 12, lower: 12, deep: 60}
    twine: {diameter: 2 mm, material: PE}
seams:
  side: {edges: [net.right, mat.left]}", plan = spoil("deep: 10", "deep: 75"))
  found <- expect_finding(read_text(plan), "seam", "seam side")
  expect_equal(found$value, 75 / 60)
  three <- spoil("net.right, mat.left", "net.right, mat.left, mat.right", plan = plan)
  expect_equal(expect_finding(read_text(three), "seam", "seam side")$value, 75 / 60)
  even <- read_text(spoil("deep: 60", "deep: 70", plan = plan))
  expect_false("seam" %in% findings(even)$check)
  hung <- spoil("panels:",
    "  line: {along: net.lower, hanging_ratio: 0.1, diameter: 10 mm, material: PP}\npanels:")
  expect_equal(expect_finding(read_text(hung), "hanging ratio", "rope line")$value, 0.1)
})

test_that("findings() reports cells finer than meshes", {
  # meshes of 32 m in the wings and the first section
  state <- settle("midwater_trawl", nodes = 1500, netting = "cells")
  found <- expect_finding(state, "cells finer than meshes", "panel back_wing_left")
  # A wing that widens from 1 to 8 meshes, 3 deep. Half of its cells contain less than the mean.
  counts <- matrix(state$mesh$division$count, 4L) - 1L
  wing <- match("back_wing_left", names(state$si$panels))
  mean <- (1 + 8) / 2 * 3 / (counts[1L, wing] * counts[3L, wing])
  expect_equal(found$value, mean, tolerance = 0.25)
})

test_that("findings() reports a bottom trawl off the seabed", {
  gear <- update(read_gear("poly_noreastern_trawl"), warps.length = "50 m", seabed.depth = "60 m")
  state <- quiet(gear)
  found <- expect_finding(state, "net off the bed", "rope ground_gear")
  height <- measures(state)[["footrope_height_m"]]
  # median height of the rope less half its thickness, compared with the height of its middle
  expect_equal(found$value, height, tolerance = 0.1)
})

test_that("findings() reports a beam trawl's footrope off the seabed", {
  gear <- read_gear("beam_trawl")
  expect_false("net off the bed" %in% findings(quiet(gear, nodes = 500))$check)
  state <- quiet(update(gear, towing.speed = "7 knot"), nodes = 500)
  found <- expect_finding(state, "net off the bed", "rope ground_gear")
  # height of its middle less half its thickness; the shoes are on the seabed and hold the ends down
  expect_gt(found$value,
    measures(state)[["footrope_height_m"]] - state$si$ropes$ground_gear$diameter)
  expect_gt(measures(state)[["footrope_height_m"]], 0.1)
})

test_that("findings() reports a bridle that carries hardly any load", {
  state <- quiet(update(read_gear("pair_trawl"), bridles.upper.length = "21.5 m"), nodes = 500)
  found <- expect_finding(state, "bridles", "rope bridle_upper_port")
  pull <- measures(state)[c("bridle_upper_tension_kN", "bridle_lower_tension_kN")]
  # mean along the bridle compared with the tension at its end
  expect_equal(found$value, 100 * pull[[1]] / sum(pull), tolerance = 0.15)
})

test_that("findings() reports an unusual spread and hanging netting", {
  gear <- read_gear("poly_noreastern_trawl")
  narrow <- quiet(update(gear, otter_boards.lift_coefficient = 0.1), nodes = 500)
  found <- expect_finding(narrow, "spread over headline", "rope headline")
  spread <- measures(narrow)[["upper_wing_spread_m"]]
  expect_equal(found$value, spread / narrow$si$ropes$headline$length)
  slow <- quiet(update(gear, towing.speed = "0.01 knot"), nodes = 500)
  found <- expect_finding(slow, "slack netting", "netting")
  # hanging netting is part of the slack netting
  expect_lt(found$value, measures(slow)[["slack_netting_percent"]])
})

test_that("findings() reports closed nets and breaking ropes first with fields", {
  gear <- read_gear("poly_noreastern_trawl")
  bare <- quiet(update(gear, floats = NULL), nodes = 500)
  found <- expect_finding(bare, "opening", "net mouth height")
  expect_equal(found$value, measures(bare)[["net_mouth_height_m"]])
  expect_lt(found$value, 0)
  expect_identical(found$field, "floats")
  thin <- quiet(update(gear, warps.diameter = "6 mm"), nodes = 500)
  # the higher load of two equal warps is decided by rounding
  side <- if (any(findings(thin)$location == "rope warp_port")) "port" else "starboard"
  found <- expect_finding(thin, "load", paste0("rope warp_", side))
  # breaking load of wire rope by EN 12385-4, 0.356 x 1770 MPa x d^2
  pull <- measures(thin)[["warp_tension_port_kN"]]
  expect_equal(found$value, 100 * pull * 1e3 / (0.356 * 1770e6 * 0.006^2), tolerance = 0.01)
  expect_identical(found$field, "warps.diameter")
  # one line for both warps; breaking ropes precede proportions
  expect_equal(found$n_similar, 1)
  expect_match(finding_sentences(findings(thin))[1], "^rope warp_.* and 1 more: .*warps.diameter")
  expect_false(is.unsorted(findings(thin)$rank))
})

test_that("findings() reports unusual proportions for the kind of gear", {
  trawl <- read_gear("poly_noreastern_trawl")
  discs <- list(number = 100, diameter = "300 mm", width = "100 mm", mass = "60 kg")
  rolling <- update(trawl, ground_gear.discs = discs, ground_gear.mass_in_water = "3 kg/m")
  length <- gear_si(rolling)$ropes$ground_gear$length
  expect_equal(expect_finding(rolling, "ground gear weight", "ground_gear")$value,
    3 + 100 * (60 - 1025 * pi / 4 * 0.3^2 * 0.1) / length, tolerance = 1e-3)
  start <- new_plan("bottom_trawl")
  short <- update(start, footrope.length = "21 m", ground_gear.length = "21 m")
  expect_equal(expect_finding(short, "footrope over headline", "footrope.length")$value, 21 / 25)
  scant <- update(start, warps.length = "120 m")
  expect_equal(expect_finding(scant, "warp over depth", "warps.length")$value, 1.2)
  long <- quiet(update(start, sweeps.length = "300 m"), nodes = 500)
  found <- expect_finding(long, "bridle angle", "sweeps.length")
  expect_equal(found$value, measures(long)[["bridle_angle_deg"]])
  lying <- quiet(update(read_gear("gillnet"), water.current.speed = "0.6 m/s"), nodes = 300)
  found <- expect_finding(lying, "net height over hung height", "float_line")
  # 25 meshes of 150 mm with a hanging ratio of 0.5
  hung <- 25 * 0.15 * sqrt(1 - (50 / (667 * 0.15))^2)
  expect_equal(found$value, measures(lying)[["net_height_m"]] / hung)
  # an assembly has no kind with usual ranges
  expect_false("towing speed" %in% findings(update(read_gear("towed_cable"),
    towing.speed = "8 knot"))$check)
})

test_that("every range has a number, limits, a kind and a source", {
  bands <- number_bands
  expect_setequal(number_ranges$check, names(checked_numbers))
  limited <- !is.na(number_ranges$least) | !is.na(number_ranges$greatest)
  expect_setequal(number_ranges$check[!limited],
    c(unique(bands$quantity), paste(c("length", "diameter", "mass"), "for its role")))
  expect_true(all(bands$kind %in% c(names(new_plan_kinds()), "assembly")))
  expect_true(all(nzchar(bands$source)))
  within <- function(a, b) all(is.na(a) | is.na(b) | a <= b)
  expect_true(within(bands$least, bands$usual_least))
  expect_true(within(bands$usual_greatest, bands$greatest))
})

test_that("findings() reports a rope without tension", {
  line <- function(from, to) rope(from, to, length = "20 m", diameter = "20 mm", material = "PA")
  towed <- gear("Two ropes", towing = list(speed = "2 knot"),
    block = gear_point(position = c(0, 0, 0), held = "moved"), sphere = gear_point(),
      tail = gear_point(),
    line = line("block", "sphere"), thread = rope("sphere", "tail", length = "1 cm",
      diameter = "0.3 mm", material = "PA"),
    weight = piece(at = "sphere", mass = "500 kg", density = "7850 kg/m3", drag_area = "1 m2"))
  found <- expect_finding(quiet(towed), "idle rope", "rope thread")
  expect_identical(found$field, "ropes.thread.length")
})

test_that("findings() reports gear above the water surface", {
  flying <- quiet(update(read_gear("pair_trawl"), floats.number = 2000), nodes = 500)
  found <- expect_finding(flying, "out of the water", "rope `headline`, netting `back_square`")
  expect_equal(found$value, max(flying$position[3, ]))
})

test_that("findings() reports a board that stalls or exceeds its tests", {
  gear <- read_gear(test_path("plans", "towed_board.yaml"))
  name <- names(gear$plan$otter_boards)[1]
  state <- quiet(gear)
  # the same state with angles of attack above and below the tested range
  for (case in list(list(deg = 50, words = "stalled"), list(deg = 4, words = "tested from"))) {
    state$boards$attack[1] <- case$deg * pi / 180
    found <- expect_finding(state, "boards", gsub("_", " ", name))
    expect_match(found$message, case$words)
    expect_equal(found$value, case$deg)
  }
})

test_that("summary, report and record list findings", {
  gear <- update(read_gear("towed_cable"), pieces.sphere.lift_coefficient = 11,
    pieces.sphere.area = 1e-6, pieces.sphere.lift_direction = "up")
  state <- quiet(gear)
  lines <- format(summary(state))
  expect_true("Warnings" %in% cli::ansi_strip(lines))
  expect_match(paste(lines, collapse = " "), "lift coefficient is 11")
  file <- tempfile(fileext = ".html")
  report(state, file)
  page <- paste(readLines(file, warn = FALSE), collapse = " ")
  begins <- regexpr("Warnings</h2>", page, fixed = TRUE)
  expect_match(substr(page, begins, begins + 2000), "lift coefficient is 11")
  record <- jsonlite::fromJSON(state_json(state))$findings
  expect_equal(record$value[record$check == "lift coefficient"], 11)
  worth <- finding_rows(settled_start(gear, 100)$worth)
  expect_match(worth$message, "lift coefficient is 11", all = FALSE)
})

test_that("findings() reports a weight that hangs on netting alone", {
  cage <- update(read_gear("model_cage"), side_ropes = NULL)
  found <- expect_finding(quiet(cage, nodes = 300), "weight on netting", "piece sinker_1")
  expect_equal(found$value, 0.4)
  # a rope along the edge also suffices
  roped <- update(cage, bottom_rope = list(diameter = "2 mm", material = "polyamide"))
  expect_false("weight on netting" %in% findings(quiet(roped, nodes = 300))$check)
})

test_that("findings() reports a net that hangs as a bundle", {
  # In still water no force opens the seine.
  rest <- suppressWarnings(settled("purse_seine", nodes = 300))
  found <- findings(rest)
  found <- found[found$check == "bundle", ]
  expect_identical(found$location, "rope lead_line")
  # a cylinder of the same depth whose circumference is the lead line
  line <- rest$si$ropes$lead_line$length
  open <- line^2 / (4 * pi) * -min(rest$position[3, rest$mesh$ropes$lead_line$node])
  expect_equal(found$value, 100 * measures(rest)[["enclosed_volume_m3"]] / open)
})

test_that("settle() warns about a drag model beyond its tested angles", {
  gear <- update(read_gear("poly_noreastern_trawl"), netting_drag = "loland")
  expect_warning(state <- settle(gear, nodes = 500), class = "codend_warning_drag_model")
  share <- expect_finding(state, "drag model", "netting_drag")$value
  # reference: a plane whose normal is 80 degrees from the flow
  tilt <- 80 * pi / 180
  plane <- list(si = list(towing = list(speed = 1), water = list(current = list(x = 0, y = 0))),
    mesh = list(model = list(cells = list(node = c(1:3, 3L)))),
    position = cbind(c(0, 0, 0), c(0, 2, 0), c(sin(tilt), 0, cos(tilt))))
  expect_equal(netting_to_flow(plane, 1L), list(angle = 80, area = 1))
  expect_gt(share, 50)
  # across the flow the model is in its fitted range
  expect_no_warning(settle(read_gear("model_cage")))
})

test_that("settle() warns about netting denser than a screen model's range", {
  cage <- update(read_gear("model_cage"), water.current.speed = 0.02)
  # squares of 16 mm: 2 d/a - (d/a)^2
  expect_equal(range(solidity_of_panels(quiet(cage, nodes = 300), "wall_1")),
    rep(2 * 1.8 / 16 - (1.8 / 16)^2, 2), tolerance = 0.02)
  dense <- update(cage, wall.twine.diameter = "4 mm")
  expect_warning(state <- settle(dense, nodes = 300), "fitted to at most 0.35",
    class = "codend_warning_drag_model")
  found <- subset(findings(state), check == "solidity")
  expect_match(found$location, "^panel wall_")
  expect_equal(found$value, 0.5 - 0.25^2, tolerance = 0.02)
  expect_no_match(found$advice, "kristiansen_faltinsen")
  # the engine limits this model to the same solidity (test-plan-drag-models.R)
  other <- quiet(update(dense, netting_drag = "kristiansen_faltinsen"), nodes = 300)
  found <- subset(findings(other), check == "solidity")
  expect_match(found$message, "kristiansen_faltinsen was fitted to at most 0.35", fixed = TRUE)
})

test_that("settle() warns about netting more open than a screen model's range", {
  # squares of 16 mm: 2 d/a of twine of 0.6 mm
  cage <- update(read_gear("model_cage"), water.current.speed = 0.02,
    wall.twine.diameter = "0.6 mm")
  expect_warning(state <- settle(cage, nodes = 300), "fitted to at least 0.1",
    class = "codend_warning_drag_model")
  found <- subset(findings(state), check == "solidity")
  expect_equal(found$value, 2 * 0.6 / 16, tolerance = 0.05)
  summed <- update(cage, netting_drag = "morison")
  expect_no_warning(state <- settle(summed, nodes = 300))
  expect_false("solidity" %in% findings(state)$check)
})

test_that("settle() warns about Reynolds numbers outside the screen model's range", {
  cage <- update(read_gear("model_cage"), netting_drag = "kristiansen_faltinsen")
  expect_false("Reynolds number" %in% findings(quiet(cage, nodes = 300))$check)
  slow <- update(cage, water.current.speed = 0.01)
  expect_warning(state <- settle(slow, nodes = 300), "Reynolds number",
    class = "codend_warning_drag_model")
  found <- subset(findings(state), check == "Reynolds number")
  si <- gear_si(slow)
  solidity <- 2 * 1.8 / 16 - (1.8 / 16)^2
  expect_equal(found$value, 0.01 * 1.8e-3 / si$water$viscosity / (1 - solidity), tolerance = 0.02)
})

test_that("findings() without warnings prints one sentence", {
  found <- findings(read_gear("towed_cable"))
  expect_s3_class(found, "data.frame")
  expect_identical(capture.output(print(found)),
    "No warnings: everything is within practice and tests.")
  expect_output(print(found["check"]), "check")
})
