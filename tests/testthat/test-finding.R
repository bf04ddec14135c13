# What is worth a look: each check fires on a plan that is wrong in its way, with the number and the
# place, and none on a gear that ships.

quiet <- function(gear, ...) suppressWarnings(settle(gear, ...))

# The one finding of a check, as list(check, place, value, ...).
expect_finding <- function(x, check, place) {
  found <- findings(x)
  mine <- found[found$check == check, ]
  expect_gte(nrow(mine), 1L)
  expect_true(place %in% mine$place, info = paste(mine$place, collapse = ", "))
  expect_true(all(nzchar(mine$advice)))
  as.list(mine[match(place, mine$place), ])
}

test_that("no shipped gear gives a false alarm", {
  for (name in gears()$name) {
    # a seine at rest in still water does hang as a bundle
    known <- if (name == "purse_seine") "bundle" else character()
    nodes <- if (name == "purse_seine") 300 else 1500
    state <- suppressWarnings(settled(name, nodes = nodes))
    expect_identical(findings(state)$check, known, info = name)
  }
})

test_that("a forgotten unit shows", {
  cable <- update(read_gear("towed_cable"), ropes.cable.diameter = 17.3)
  expect_equal(expect_finding(cable, "rope diameter", "rope cable")$value, 17300)
  trawl <- read_gear("poly_noreastern_trawl")
  thick <- update(trawl, sections.body.twine.diameter = "25 mm")
  expect_equal(expect_finding(thick, "twine", "panel back_body")$value, 25)
  # of the panels of one section with one twine the first speaks for all; the belly has its own
  expect_equal(sum(findings(thick)$check == "twine"), 1)
  fast <- update(trawl, towing.speed = "40 knot")
  expect_equal(expect_finding(fast, "towing speed", "towing.speed")$value, 40)
  # of kinds without a band of their own
  cable <- update(read_gear("towed_cable"), towing.speed = "40 knot")
  expect_equal(expect_finding(cable, "speed", "towing.speed")$value, 40)
  gillnet <- update(read_gear("gillnet"), water.current.speed = "15 m/s")
  expect_equal(expect_finding(gillnet, "speed", "water.current")$value, 15)
})

test_that("a coefficient beyond every test shows", {
  trawl <- read_gear("poly_noreastern_trawl")
  found <- expect_finding(update(trawl, otter_boards.lift_coefficient = 11), "lift coefficient",
    "otter board port")
  expect_equal(found$value, 11)
  found <- expect_finding(update(trawl, otter_boards.drag_coefficient = 5), "lift coefficient",
    "otter board port")
  expect_match(found$words, "drag coefficient is 5")
})

test_that("a number of panels that is not written shows", {
  gear <- read_gear("midwater_trawl")
  found <- expect_finding(update(gear, panels = NULL), "number of panels", "panels")
  # which is what the plan stands for
  expect_equal(found$value, length(trawl_rings[["4"]]$panels))
})

test_that("edges that do not fit show", {
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

test_that("cells finer than meshes show", {
  # meshes of 32 m in the wings and the first section
  state <- settle("midwater_trawl", nodes = 1500, netting = "cells")
  found <- expect_finding(state, "cells finer than meshes", "panel back_wing_left")
  # A wing that widens from 1 to 8 meshes, 3 deep, in cells of which half hold less than the mean.
  counts <- matrix(state$lattice$division$count, 4L) - 1L
  wing <- match("back_wing_left", names(state$si$panels))
  mean <- (1 + 8) / 2 * 3 / (counts[1L, wing] * counts[3L, wing])
  expect_equal(found$value, mean, tolerance = 0.25)
})

test_that("a bottom trawl that flies shows", {
  gear <- update(read_gear("poly_noreastern_trawl"), warps.length = "50 m", seabed.depth = "60 m")
  state <- quiet(gear)
  found <- expect_finding(state, "net off the bed", "rope ground_gear")
  height <- measures(state)[["footrope_height_m"]]
  # the height that half of it is above, less half its thickness, beside that of its middle
  expect_equal(found$value, height, tolerance = 0.1)
})

test_that("a beam trawl whose footrope hangs between its shoes shows", {
  gear <- read_gear("beam_trawl")
  expect_false("net off the bed" %in% findings(quiet(gear, nodes = 500))$check)
  state <- quiet(update(gear, towing.speed = "7 knot"), nodes = 500)
  found <- expect_finding(state, "net off the bed", "rope ground_gear")
  # its middle less half its thickness; the shoes stand on the bed and hold the ends down
  expect_gt(found$value,
    measures(state)[["footrope_height_m"]] - state$si$ropes$ground_gear$diameter)
  expect_gt(measures(state)[["footrope_height_m"]], 0.1)
})

test_that("a bridle that carries nearly all shows", {
  state <- quiet(update(read_gear("pair_trawl"), bridles.upper.length = "20.5 m"), nodes = 500)
  found <- expect_finding(state, "bridles", "rope bridle_lower_port")
  pull <- measures(state)[c("bridle_upper_tension_kN", "bridle_lower_tension_kN")]
  # mean along the bridle beside the tension at its end
  expect_equal(found$value, 100 * pull[[2]] / sum(pull), tolerance = 0.02)
})

test_that("a spread that is odd for the head line, and loose netting, show", {
  gear <- read_gear("poly_noreastern_trawl")
  narrow <- quiet(update(gear, otter_boards.lift_coefficient = 0.1), nodes = 500)
  found <- expect_finding(narrow, "spread over head line", "rope head_line")
  spread <- measures(narrow)[["upper_wing_spread_m"]]
  expect_equal(found$value, spread / narrow$si$ropes$head_line$length)
  slow <- quiet(update(gear, towing.speed = "0.01 knot"), nodes = 500)
  found <- expect_finding(slow, "slack netting", "netting")
  # what hangs loose is part of what is slack
  expect_lt(found$value, measures(slow)[["slack_netting_percent"]])
})

test_that("a net that is closed, and ropes that break, show first and by the field to change", {
  gear <- read_gear("poly_noreastern_trawl")
  bare <- quiet(update(gear, floats = NULL), nodes = 500)
  found <- expect_finding(bare, "opening", "net mouth height")
  expect_equal(found$value, measures(bare)[["net_mouth_height_m"]])
  expect_lt(found$value, 0)
  expect_identical(found$field, "floats")
  thin <- quiet(update(gear, warps.diameter = "6 mm"), nodes = 500)
  # of two warps alike, whichever carries more in the last digit
  side <- if (any(findings(thin)$place == "rope warp_port")) "port" else "starboard"
  found <- expect_finding(thin, "rope load", paste0("rope warp_", side))
  # breaking load of wire rope by EN 12385-4, 0.356 x 1770 MPa x d^2
  pull <- measures(thin)[["warp_tension_port_kN"]]
  expect_equal(found$value, 100 * pull * 1e3 / (0.356 * 1770e6 * 0.006^2), tolerance = 0.01)
  expect_identical(found$field, "warps.diameter")
  # of both warps one line, and what breaks before what is out of proportion
  expect_equal(found$alike, 1)
  expect_match(finding_sentences(findings(thin))[1], "^rope warp_.* and 1 more: .*warps.diameter")
  expect_false(is.unsorted(findings(thin)$rank))
})

test_that("what is out of proportion for its kind shows", {
  trawl <- read_gear("poly_noreastern_trawl")
  seven <- update(trawl, towing.speed = "7 knot")
  expect_equal(expect_finding(seven, "towing speed", "towing.speed")$value, 7)
  heavy <- update(trawl, ground_gear.mass_in_water = "40 kg/m")
  expect_equal(expect_finding(heavy, "ground gear weight", "ground_gear")$value, 40)
  discs <- list(number = 100, diameter = "300 mm", width = "100 mm", mass = "60 kg")
  rolling <- update(trawl, ground_gear.discs = discs, ground_gear.mass_in_water = "3 kg/m")
  length <- gear_si(rolling)$ropes$ground_gear$length
  expect_equal(expect_finding(rolling, "ground gear weight", "ground_gear")$value,
    3 + 100 * (60 - 1025 * pi / 4 * 0.3^2 * 0.1) / length, tolerance = 1e-3)
  light <- update(trawl, otter_boards.mass = "100 kg")
  expect_equal(expect_finding(light, "board weight over area", "otter_boards.mass")$value,
    100 / 4.86)
  start <- new_plan("bottom_trawl")
  short <- update(start, footrope.length = "21 m", ground_gear.length = "21 m")
  expect_equal(expect_finding(short, "footrope over head line", "footrope.length")$value, 21 / 25)
  scant <- update(start, warps.length = "120 m")
  expect_equal(expect_finding(scant, "warp over depth", "warps.length")$value, 1.2)
  long <- quiet(update(start, sweeps.length = "300 m"), nodes = 500)
  found <- expect_finding(long, "bridle angle", "sweeps.length")
  expect_equal(found$value, measures(long)[["bridle_angle_deg"]])
  lying <- quiet(update(read_gear("gillnet"), water.current.speed = "0.6 m/s"), nodes = 300)
  found <- expect_finding(lying, "net height over hung height", "float_line")
  # of 25 meshes of 150 mm hung by a half
  hung <- 25 * 0.15 * sqrt(1 - (50 / (667 * 0.15))^2)
  expect_equal(found$value, measures(lying)[["net_height_m"]] / hung)
  # an assembly has no kind to be compared with
  expect_false("towing speed" %in% findings(update(read_gear("towed_cable"),
    towing.speed = "8 knot"))$check)
})

test_that("every band has its quantity, a kind and a source", {
  bands <- known_bands()
  expect_setequal(unique(bands$quantity), intersect(bands$quantity, names(finding_checks)))
  expect_true(all(bands$kind %in% c(names(new_plan_kinds()), "assembly")))
  expect_true(all(nzchar(bands$source)))
  within <- function(a, b) all(is.na(a) | is.na(b) | a <= b)
  expect_true(within(bands$least, bands$usual_least))
  expect_true(within(bands$usual_greatest, bands$greatest))
})

test_that("a rope that does nothing shows", {
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

test_that("gear above the surface shows", {
  flying <- quiet(update(read_gear("pair_trawl"), floats.number = 2000), nodes = 500)
  found <- expect_finding(flying, "out of the water", "rope `head_line`, netting `back_square`")
  expect_equal(found$value, max(flying$position[3, ]))
})

test_that("a board at stall, or beyond what was tested, shows", {
  gear <- read_gear(test_path("plans", "towed_board.yaml"))
  name <- names(gear$plan$otter_boards)[1]
  state <- quiet(gear)
  # the same state with the flow turned beyond the tests, then below them
  for (case in list(list(deg = 50, words = "stalled"), list(deg = 4, words = "tested from"))) {
    state$boards$attack[1] <- case$deg * pi / 180
    found <- expect_finding(state, "boards", gsub("_", " ", name))
    expect_match(found$words, case$words)
    expect_equal(found$value, case$deg)
  }
})

test_that("findings are told in the summary, the report and the record", {
  gear <- update(read_gear("towed_cable"), pieces.sphere.lift_coefficient = 11,
    pieces.sphere.area = 1e-6, pieces.sphere.lift_direction = "up")
  state <- quiet(gear)
  lines <- format(summary(state))
  expect_true("Warnings" %in% cli::ansi_strip(lines))
  expect_match(paste(lines, collapse = " "), "its lift coefficient is 11")
  file <- tempfile(fileext = ".html")
  report(state, file)
  page <- paste(readLines(file, warn = FALSE), collapse = " ")
  begins <- regexpr("Warnings</h2>", page, fixed = TRUE)
  expect_match(substr(page, begins, begins + 2000), "its lift coefficient is 11")
  expect_identical(state_record(state)$findings[[1]]$check, "lift coefficient")
  expect_identical(unname(state_record(state)$findings[[1]]$value), 11)
  worth <- finding_rows(settled_start(gear, 100)$worth)
  expect_match(worth$words, "lift coefficient is 11", all = FALSE)
})

test_that("a weight that hangs on netting alone shows", {
  cage <- update(read_gear("model_cage"), side_ropes = NULL)
  found <- expect_finding(quiet(cage, nodes = 300), "weight on netting", "piece sinker_1")
  expect_equal(found$value, 0.4)
  # a rope along the edge will do as well
  roped <- update(cage, bottom_rope = list(diameter = "2 mm", material = "polyamide"))
  expect_false("weight on netting" %in% findings(quiet(roped, nodes = 300))$check)
})

test_that("a net that hangs as a bundle shows", {
  # In still water nothing holds the seine open.
  rest <- suppressWarnings(settled("purse_seine", nodes = 300))
  found <- findings(rest)
  found <- found[found$check == "bundle", ]
  expect_identical(found$place, "rope lead_line")
  expect_equal(found$value, measures(rest)[["enclosed_volume_m3"]])
  expect_match(found$words, "bundle")
})

test_that("a law outside what it was measured for warns", {
  gear <- update(read_gear("poly_noreastern_trawl"), netting_drag = "loland")
  expect_warning(state <- settle(gear, nodes = 500), class = "codend_warning_drag_law")
  share <- expect_finding(state, "drag law", "netting_drag")$value
  # a plane by hand: its normal 80 degrees from the flow
  tilt <- 80 * pi / 180
  plane <- list(si = list(towing = list(speed = 1), water = list(current = list(x = 0, y = 0))),
    lattice = list(mesh = list(cells = list(node = c(1:3, 3L)))),
    position = cbind(c(0, 0, 0), c(0, 2, 0), c(sin(tilt), 0, cos(tilt))))
  expect_equal(netting_to_flow(plane, 1L), list(angle = 80, area = 1))
  expect_gt(share, 50)
  # across the flow it is used as it was fitted
  expect_no_warning(settle(read_gear("model_cage")))
})

test_that("a screen's law on netting denser than it was fitted to warns", {
  cage <- update(read_gear("model_cage"), water.current.speed = 0.02)
  # squares of 16 mm: 2 d/a - (d/a)^2
  expect_equal(range(solidity_of_panels(quiet(cage, nodes = 300), "wall_1")),
    rep(2 * 1.8 / 16 - (1.8 / 16)^2, 2), tolerance = 0.02)
  dense <- update(cage, wall.twine.diameter = "4 mm")
  expect_warning(state <- settle(dense, nodes = 300), "fitted to at most 0.35",
    class = "codend_warning_drag_law")
  found <- subset(findings(state), check == "solidity")
  expect_match(found$place, "^panel wall_")
  expect_equal(found$value, 0.5 - 0.25^2, tolerance = 0.02)
  expect_no_match(found$advice, "kristiansen_faltinsen")
  # the engine holds that one at the same solidity (test-plan-laws.R)
  other <- quiet(update(dense, netting_drag = "kristiansen_faltinsen"), nodes = 300)
  found <- subset(findings(other), check == "solidity")
  expect_match(found$words, "kristiansen_faltinsen was fitted to at most 0.35", fixed = TRUE)
})

test_that("a screen's law on netting more open than it was fitted to warns", {
  # squares of 16 mm: 2 d/a of twine of 0.6 mm
  cage <- update(read_gear("model_cage"), water.current.speed = 0.02,
    wall.twine.diameter = "0.6 mm")
  expect_warning(state <- settle(cage, nodes = 300), "fitted to at least 0.1",
    class = "codend_warning_drag_law")
  found <- subset(findings(state), check == "solidity")
  expect_equal(found$value, 2 * 0.6 / 16, tolerance = 0.05)
  summed <- update(cage, netting_drag = "twines")
  expect_no_warning(state <- settle(summed, nodes = 300))
  expect_false("solidity" %in% findings(state)$check)
})

test_that("the screen by Reynolds number warns outside its range of them", {
  cage <- update(read_gear("model_cage"), netting_drag = "kristiansen_faltinsen")
  expect_false("Reynolds number" %in% findings(quiet(cage, nodes = 300))$check)
  slow <- update(cage, water.current.speed = 0.01)
  expect_warning(state <- settle(slow, nodes = 300), "Reynolds number",
    class = "codend_warning_drag_law")
  found <- subset(findings(state), check == "Reynolds number")
  si <- gear_si(slow)
  solidity <- 2 * 1.8 / 16 - (1.8 / 16)^2
  expect_equal(found$value, 0.01 * 1.8e-3 / si$water$viscosity / (1 - solidity), tolerance = 0.02)
})
