# The shipped survey trawl with bridles of one length, changed.
even_bridles <- function() {
  update(read_gear("poly_noreastern_trawl"), bridles.upper.setback = "0 m",
    bridles.middle.setback = "0 m")
}
changed_trawl <- function(...) gear_si(update(even_bridles(), ...))

test_that("floats have their spacing, in groups", {
  # 27.2 m of headline; 11 floats with a spacing of 1 m occupy 10 m about its middle
  floats <- list(number = 11, buoyancy = "10 kgf", spacing = "1 m")
  si <- changed_trawl(floats = floats)
  expect_equal(si$pieces$floats$extent, 0.5 + c(-5, 5) / 27.2)
  expect_true(si$pieces$floats$end_to_end)
  # without a number, as many floats as fit: 0 to 13.6 m by 1.5 m is 10
  si <- changed_trawl(floats = list(
    list(buoyancy = "3 kgf", spacing = "1.5 m", extent = c(0, 0.5)),
    list(number = 4, buoyancy = "10 kgf", extent = c(0.6, 0.9))
  ))
  expect_identical(si$pieces$floats_1$number, 10)
  expect_equal(si$pieces$floats_1$extent, 0.25 + c(-0.5, 0.5) * 13.5 / 27.2)
  expect_identical(si$pieces$floats_2$number, 4)
  expect_equal(si$pieces$floats_2$extent, c(0.6, 0.9))
})

test_that("floats in two groups lift as the same floats in one", {
  one <- changed_trawl(floats = list(number = 20, buoyancy = "5 kgf"))
  two <- changed_trawl(floats = list(list(number = 10, buoyancy = "5 kgf"),
    list(number = 10, buoyancy = "5 kgf")))
  lift <- function(si) {
    floats <- si$pieces[startsWith(names(si$pieces), "floats")]
    sum(vapply(floats, function(piece) piece$number * piece$volume, 0))
  }
  expect_equal(lift(two), lift(one), tolerance = 1e-14)
})

test_that("port and starboard differ only in the given fields", {
  ropes <- changed_trawl(warps.starboard = list(length = "352 m"),
    bridles.upper.port = list(length = "56 m", diameter = "18 mm"))$ropes
  expect_equal(c(ropes$warp_port$length, ropes$warp_starboard$length), c(340, 352))
  expect_equal(ropes$warp_starboard$diameter, ropes$warp_port$diameter)
  expect_equal(c(ropes$bridle_upper_port$length, ropes$bridle_upper_starboard$length), c(56, 54.9))
  expect_equal(c(ropes$bridle_upper_port$diameter, ropes$bridle_upper_starboard$diameter),
    c(0.018, 0.016))
})

test_that("longer warp moves its board aft", {
  trawl <- update(new_plan("bottom_trawl"), warps.length = "325 m",
    warps.starboard = list(length = "335 m"))
  state <- settle(trawl, nodes = 200)
  boards <- vapply(c("board_port", "board_starboard"), function(point) {
    state$position[1, state$mesh$places[[point]]]
  }, 0)
  # 10 m more of a warp that is nearly straight and nearly horizontal
  expect_gt(boards[[2]] - boards[[1]], 5)
  expect_lt(boards[[2]] - boards[[1]], 10.5)
})

test_that("ticklers hang between the lower wing ends", {
  ticklers <- list(tickler_1 = list(length = "20 m", diameter = "16 mm", material = "steel_chain"))
  rope <- changed_trawl(ticklers = ticklers)$ropes$tickler_1
  expect_identical(c(rope$from, rope$to, rope$role), c("lower_port", "lower_starboard", "tickler"))
})

test_that("setback lengthens its bridle on both sides", {
  set <- changed_trawl(bridles.upper.setback = "457 mm", bridles.upper.port.length = "56 m")$ropes
  expect_equal(set$bridle_upper_starboard$length, 54.9 + 0.457)
  expect_equal(set$bridle_upper_port$length, 56 + 0.457)
  expect_equal(set$bridle_lower_port$length, 54.9)
  # an upper wing end with a setback equals a gear with a longer bridle, and is higher
  gear <- even_bridles()
  shape <- function(...) measures(settle(update(gear, ...), nodes = 300))
  back <- shape(bridles.upper.setback = "0.5 m")
  expect_equal(back, shape(bridles.upper.length = "55.4 m"), tolerance = 1e-9)
  expect_gt(back[["headline_height_m"]], shape()[["headline_height_m"]])
})

test_that("headline extension connects the headline to the upper bridle", {
  wire <- list(length = "2 m", diameter = "16 mm", material = "steel_wire")
  plan <- changed_trawl(headline_extensions = wire)
  rope <- plan$ropes$headline_extension_port
  expect_identical(c(rope$from, rope$to), c("headline_extension_port", "upper_port"))
  expect_identical(plan$ropes$bridle_upper_port$to, "headline_extension_port")
  expect_identical(plan$ropes$bridle_lower_port$to, "extension_port")
})

test_that("danlenos and wing-end weights attach to their points on each side", {
  steel <- list(mass = "50 kg", density = "7850 kg/m3")
  pieces <- changed_trawl(danlenos = steel, wing_end_weights = steel)$pieces
  # without sweeps the bridles start at the boards
  expect_identical(pieces$danleno_port$at, "board_port")
  expect_identical(pieces$wing_end_weight_starboard$at, "lower_starboard")
  swept <- update(new_plan("bottom_trawl"), danlenos = steel)
  expect_identical(assembly(swept)$plan$pieces$danleno_port$at, "sweep_end_port")
  # their weight in water is exact
  heavy <- settle(swept, nodes = 200)
  table <- as.data.frame(heavy, what = "drag")
  found <- table$weight_in_water_kN[table$part == "danleno_port"]
  expect_equal(found, 50 * (1 - 1025 / 7850) * 9.81 / 1000, tolerance = 2e-3)
})

test_that("middle bridle without a jib leads to the side line", {
  gear <- read_gear("poly_noreastern_trawl")
  # side wings as deep as upper wings plus square: 80 + 45 - 46 meshes
  fits <- update(gear, wings.jib = NULL, bridles.middle = NULL, wings.side.meshes.deep = 79,
    wings.lower.meshes.deep = 99)
  middle <- list(length = "54.9 m", diameter = "16 mm", material = "steel_wire")
  bridled <- update(fits, bridles.middle = middle)
  expect_identical(assembly(bridled)$plan$points$middle_port$at, "side_line_port.middle")
})
