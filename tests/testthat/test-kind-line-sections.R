# Returns the ropes of a line in sections.
ropes_of <- function(gear, name) {
  ropes <- gear_si(gear)$ropes
  ropes[grepl(paste0("^", name), names(ropes))]
}

test_that("ground gear in sections has the length and weight of each section on both sides", {
  section <- function(length, mass) {
    list(length = length, diameter = "100 mm", mass_in_water = mass, axial_stiffness = "10 MN")
  }
  ropes <- ropes_of(two_seam(ground_gear = list(
    sections = list(section("6 m", "9 kg/m"), section("5 m", "7 kg/m"), section("10 m", "4 kg/m"))
  )), "ground_gear")
  expect_setequal(names(ropes), c("ground_gear", "ground_gear_2_port", "ground_gear_2_starboard",
    "ground_gear_3_port", "ground_gear_3_starboard"))
  long <- vapply(ropes, `[[`, 0, "length")
  expect_equal(sort(unname(long)), c(5, 5, 6, 10, 10))
  density <- 1025
  in_water <- vapply(ropes, function(rope) {
    rope$length * (rope$mass_per_length - density * rope$volume_per_length)
  }, 0)
  expect_equal(sum(in_water), 6 * 9 + 2 * 5 * 7 + 2 * 10 * 4)
})

test_that("sections cover the chain of a line once, from port to starboard", {
  trawl <- two_seam(
    headline.sections = list(list(length = "8 m"), list(length = "11 m", diameter = "20 mm")))
  ropes <- ropes_of(trawl, "headline")
  expect_identical(names(ropes), c("headline_2_port", "headline", "headline_2_starboard"))
  expect_equal(range(covered_edges(trawl)), c(1, 1))
  # the bosom of 5 m is the middle of the middle section of 8 m
  expect_equal(ropes$headline$shares * 8, c(1.5, 5, 1.5))
  expect_identical(vapply(ropes, `[[`, 0, "diameter"), c(headline_2_port = 0.02, headline = 0.022,
    headline_2_starboard = 0.02))
})

test_that("a line in equal sections keeps the shape of the net", {
  floats <- function(number) list(number = number, buoyancy = "2.7 kgf", diameter = "200 mm")
  line <- list(bosom = "5 m", diameter = "22 mm", material = "combination_rope")
  whole <- two_seam(headline = c(list(length = "30 m"), line), floats = floats(60L))
  cut <- two_seam(headline = c(line, list(sections = list(
    list(length = "5 m", floats = floats(10L)), list(length = "12.5 m", floats = floats(25L))
  ))))
  found <- lapply(list(whole, cut), function(gear) measures(settle(gear, nodes = 600)))
  for (name in c("net_mouth_height_m", "wing_end_spread_m", "mouth_area_m2")) {
    expect_equal(found[[2]][[name]], found[[1]][[name]], tolerance = 0.02, info = name)
  }
})

test_that("floats and discs of a section are on each side", {
  float <- function(number) list(number = number, buoyancy = "2.7 kgf", diameter = "200 mm")
  trawl <- two_seam(headline.sections = list(
    list(length = "6 m", floats = float(14L)), list(length = "12 m", floats = list(float(8L),
      c(float(5L), list(extent = c(0, 0.5)))))
  ))
  pieces <- gear_si(trawl)$pieces
  floats <- Filter(function(piece) identical(piece$role, "float"), pieces)
  expect_equal(sum(vapply(floats, `[[`, 0, "number")), 14 + 2 * (8 + 5))
  expect_setequal(unname(vapply(floats, function(piece) piece$along$name, "")),
    c("headline", "headline_2_port", "headline_2_starboard"))
})

test_that("backstrops of fixed boards share the pull of the sweep", {
  trawl <- two_seam(backstrops = list(length = "3 m", diameter = "18 mm", material = "steel_wire"))
  state <- settle(trawl, nodes = 300)
  tensions <- as.data.frame(state, what = "tensions")
  at <- function(rope) max(tensions$tension_kN[tensions$part == rope])
  expect_equal(at("backstrop_upper_port") + at("backstrop_lower_port"), at("sweep_port"),
    tolerance = 0.05)
})

test_that("side lines and belly lines in sections run from end to end", {
  wire <- list(diameter = "14 mm", material = "PP")
  parts <- function(...) list(sections = lapply(list(...), function(long) list(length = long)))
  trawl <- two_seam(side_lines = c(wire, parts("3 m", "4 m")),
    belly_lines = c(wire, parts("10 m", "14 m")))
  side <- ropes_of(trawl, "side_line")
  expect_identical(names(side), c("side_line_starboard", "side_line_2_starboard",
    "side_line_2_port", "side_line_port"))
  expect_equal(vapply(side, `[[`, 0, "length"), c(3, 4, 4, 3), ignore_attr = TRUE)
  # each section of the port side has the same netting as its mirror image
  edges <- function(rope) {
    part <- vapply(rope$along, function(edge) edge$to - edge$from, 0)
    panels <- sub("_(left|right)$", "", vapply(rope$along, `[[`, "", "panel"))
    sort(round(stats::setNames(part, panels), 9))
  }
  expect_equal(edges(side$side_line_port), edges(side$side_line_starboard))
  expect_equal(range(covered_edges(trawl)), c(1, 1))
  belly <- ropes_of(trawl, "belly_line")
  expect_length(belly, 4)
  expect_equal(sum(vapply(belly, `[[`, 0, "length")), 2 * 24)
  # the first section starts at the wing, the second one ends at the codline
  expect_identical(belly$belly_line_back_belly$along[[1]]$panel, "belly_lower_wing_1_left")
  expect_identical(belly$belly_line_2_back_belly$along[[
    length(belly$belly_line_2_back_belly$along)]]$panel, "belly_codend")
  # both sides are mirror images, in the drawing too
  expect_true(all(flat_layout(gear_si(trawl))$columns$symmetric))
  found <- measures(settle(trawl, nodes = 300))
  expect_equal(found[["warp_tension_port_kN"]], found[["warp_tension_starboard_kN"]],
    tolerance = 1e-6)
})

test_that("middle bridles lead to joints of the side line, or to equal distances along it", {
  wire <- function(long) list(length = long, diameter = "12 mm", material = "steel_wire")
  trawl <- two_seam(bridles.middle = list(wire("25 m"), wire("25.1 m")))
  points <- assembly(trawl)$plan$points
  expect_identical(points$middle_1_starboard$at, "side_line_starboard[0.333333]")
  expect_identical(points$middle_1_port$at, "side_line_port[0.666667]")
  line <- list(diameter = "14 mm", material = "PP", sections = list(list(length = "2 m"),
    list(length = "2 m"), list(length = "3 m")))
  jointed <- two_seam(bridles.middle = list(wire("25 m"), wire("25.1 m")), side_lines = line)
  state <- settle(jointed, nodes = 300)
  height <- function(point) state$position[3, nodes_at(state, point)]
  for (side in c("port", "starboard")) {
    heights <- vapply(paste0(c("upper", "middle_1", "middle_2", "lower"), "_", side), height, 0)
    expect_true(all(diff(heights) < 0.05))
  }
  expect_equal(height("middle_1_port"), height("middle_1_starboard"), tolerance = 1e-3)
  expect_gt(measures(state)[["bridle_middle_2_tension_kN"]], 0)
})

# Returns the stretched length (m) of the netting along each rope, by name.
netting_along <- function(gear, ropes) {
  panels <- gear_si(gear)$panels
  vapply(ropes, function(rope) chain_length(rope$along, panels), 0)
}

test_that("sections of a line have the netting of their length and hanging ratio", {
  line <- function(...) list(diameter = "20 mm", material = "combination_rope",
    sections = list(...))
  bare <- function(...) two_seam(..., floats = NULL)
  whole <- sum(netting_along(bare(), ropes_of(bare(), "headline")))
  # 12 m at 0.5 in the middle, the rest of the netting at 0.8
  trawl <- bare(headline = line(list(length = "12 m", hanging_ratio = 0.5),
    list(hanging_ratio = 0.8)))
  ropes <- ropes_of(trawl, "headline")
  netting <- netting_along(trawl, ropes)
  expect_equal(netting[["headline"]], 24)
  expect_equal(netting[["headline_2_port"]], (whole - 24) / 2)
  expect_equal(vapply(ropes, `[[`, 0, "length"), netting * c(0.8, 0.5, 0.8))
  expect_equal(range(covered_edges(trawl)), c(1, 1))
  # lengths alone take the rest in proportion
  trawl <- bare(headline = line(list(length = "12 m", hanging_ratio = 0.5), list(length = "3 m"),
    list(length = "6 m")))
  netting <- netting_along(trawl, ropes_of(trawl, "headline"))
  expect_equal(netting[["headline_3_port"]], 2 * netting[["headline_2_port"]])
  expect_equal(sum(netting), whole)
})

test_that("hanging ratios alone follow the pieces of netting", {
  ratios <- function(...) list(diameter = "20 mm", material = "PP",
    sections = lapply(list(...), function(ratio) list(hanging_ratio = ratio)))
  trawl <- two_seam(footrope = ratios(0.5, 0.9, 0.8))
  ropes <- ropes_of(trawl, "footrope")
  expect_identical(vapply(ropes, function(rope) length(rope$along), 0L, USE.NAMES = FALSE),
    rep(1L, 5))
  expect_equal(unname(vapply(ropes, `[[`, 0, "length") / netting_along(trawl, ropes)),
    c(0.8, 0.9, 0.5, 0.9, 0.8))
  # ground gear of the same length is distributed like the footrope
  long <- sum(vapply(ropes, `[[`, 0, "length"))
  gear <- two_seam(footrope = ratios(0.5, 0.9, 0.8), ground_gear = list(length = long,
    diameter = "60 mm", mass_in_water = "5 kg/m", axial_stiffness = "10 MN"))
  expect_equal(ropes_of(gear, "ground_gear")$ground_gear$shares * long,
    unname(vapply(ropes, `[[`, 0, "length")))
  belly <- ropes_of(two_seam(belly_lines = ratios(0.95)), "belly_line")
  expect_equal(vapply(belly, `[[`, 0, "length"),
    0.95 * netting_along(two_seam(belly_lines = ratios(0.95)), belly))
  expect_no_error(settle(trawl, nodes = 300))
})

test_that("floats on a section of the footrope are pieces on each side", {
  float <- list(number = 6L, buoyancy = "1 kgf", diameter = "150 mm")
  trawl <- two_seam(footrope = list(diameter = "20 mm", material = "combination_rope",
    sections = list(list(length = "6 m"), list(length = "15 m", floats = float))))
  floats <- Filter(function(piece) isTRUE(grepl("^footrope", piece$along$name)),
    gear_si(trawl)$pieces)
  expect_equal(sum(vapply(floats, `[[`, 0, "number")), 12)
})
