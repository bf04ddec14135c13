# A net towed by its own two points, in the conditions of the twin trawl.
lone_net <- function() {
  twin <- read_gear("twin_trawl")$plan
  as_gear(c(twin[c("codend", "name", "towing", "seabed", "coefficients", "netting_drag")],
    twin$gears$port[names(twin$gears$port) != "joined"]))
}

test_that("each net of a twin trawl has the parts of the net alone", {
  alone <- assembly(lone_net())$plan
  twin <- assembly(read_gear("twin_trawl"))$plan
  for (net in c("port", "starboard")) {
    of_net <- twin$panels[startsWith(names(twin$panels), paste0(net, "_"))]
    expect_identical(unname(of_net), unname(alone$panels))
    expect_identical(names(of_net), paste0(net, "_", names(alone$panels)))
  }
  expect_length(twin$ropes, 2 * length(alone$ropes) + 3)
  expect_identical(twin$ropes$port_sweep_port$from, "port_board_port")
  expect_identical(twin$points$port_board_port, list(at = "door_port"))
  expect_identical(twin$measures$starboard_headline_height,
    list(clearance = "starboard_headline.middle"))
})

test_that("one mesh size moves both nets, and a field of one net only that net", {
  mesh_sizes <- function(gear) {
    panels <- gear_si(gear)$panels
    vapply(panels[c("port_back_codend", "starboard_back_codend")], `[[`, 0, "mesh_size",
      USE.NAMES = FALSE)
  }
  twin <- read_gear("twin_trawl")
  both <- update(twin, gears.port.sections.codend.mesh_size = "90 mm")
  expect_equal(mesh_sizes(both), c(0.09, 0.09))
  one <- update(twin, gears.starboard.sections.codend.mesh_size = "90 mm")
  expect_equal(mesh_sizes(one), c(0.08, 0.09))
  # A change that follows another finds the same gear as a new check.
  expect_identical(gear_si(update(both, towing.speed = "3 knot")),
    gear_si(as_gear(update(both, towing.speed = "3 knot")$plan)))
})

test_that("twin trawl is symmetric and its warps pull its drag", {
  state <- settle("twin_trawl", nodes = 1500)
  found <- measures(state)
  twins <- c("headline_height_m", "wing_end_spread_m", "mouth_area_m2", "net_mouth_height_m")
  expect_equal(unname(plain_measures(found[paste0("port_", twins)])),
    unname(plain_measures(found[paste0("starboard_", twins)])), tolerance = 1e-6)
  table <- as.data.frame(state, what = "tensions")
  table <- table[table$role %in% "warp", ]
  first <- table[!duplicated(table$part), ]
  # The winches are at x = 0, so the middle of the first bar is half of the bar aft.
  pull <- first$tension_kN * 2 * first$x_m / first$length_m
  expect_equal(pull[1], pull[3], tolerance = 1e-6)
  expect_equal(sum(pull), found[["total_drag_kN"]], tolerance = 0.002)
})

test_that("the default number of nodes is for each net of a rig", {
  rig <- read_gear("twin_trawl")
  first <- function(gear) build_mesh(gear_si(gear), usual_nodes(gear))$nodes
  alone <- first(lone_net())
  # The two nets share the nodes of the rig, except those of its warps.
  expect_equal(first(rig), 2 * alone, tolerance = 0.2)
  expect_gt(settle("twin_trawl")$mesh$nodes, 1.8 * alone)
})

test_that("measures() lists a rig's own measures before the measures of each net", {
  state <- settled("twin_trawl")
  net <- sub("^(port|starboard)_.*|.*", "\\1", names(measures(state)))
  expect_identical(rle(net)$values, c("", "port", "starboard"))
  printed <- grep("computed to", capture.output(print(state)), value = TRUE)
  printed <- sub("  +.*", "", trimws(printed))
  expect_identical(printed[c(1, 4)], c("door spread", "total drag"))
  expect_identical(sum(startsWith(printed, "port ")), 4L)
  expect_identical(sub("^port", "starboard", grep("^port", printed, value = TRUE)),
    grep("^starboard", printed, value = TRUE))
  expect_identical(names(summary(state)$measures), names(measures(state)))
})

test_that("measures() adds swept area and filtered volume of both nets", {
  state <- settled("twin_trawl")
  found <- measures(state)
  both <- function(name) sum(found[paste0(c("port_", "starboard_"), name)])
  speed <- 2.6 * 1.852  # km/h
  # Wing ends are level in the water: their lines are across the tow within 2 %.
  expect_equal(found[["swept_area_km2_per_h"]], speed * both("wing_end_spread_m") / 1000,
    tolerance = 0.01)
  expect_equal(found[["filtered_volume_m3_per_h"]], 1000 * speed * both("mouth_area_m2"),
    tolerance = 0.01)
  # The assembly keeps the roles.
  expect_equal(measure_value(settle(assembly(state$gear), nodes = 1500), "swept_area"),
    measure_value(state, "swept_area"), tolerance = 1e-6)
})

test_that("findings() reports a lost clump, a torn net and a missing mouth", {
  twin <- read_gear("twin_trawl")
  lost <- findings(update(twin, pieces.clump = NULL))
  expect_identical(lost[c("check", "location")],
    data.frame(check = "warp end", location = "rope warp_middle"), ignore_attr = TRUE)
  # The starboard wing end of a torn net is free, so its port bridle carries the whole net.
  torn <- update(twin, gears.port.joined.board_starboard = "torn",
    gears.starboard.joined = list(board_port = "clump", board_starboard = "door_starboard"),
    points.torn = stats::setNames(list(), character()))
  expect_true("bridles" %in% findings(suppressWarnings(settle(torn, nodes = 1500)))$check)
  expect_false("bridles" %in% findings(settled("twin_trawl"))$check)
  # The finding of both nets is about the field that they share.
  short <- findings(update(twin, gears.port.footrope.length = "12 m"))
  short <- short[short$check == "footrope over headline", ]
  expect_identical(short$field, "gears.port.footrope.length")
  expect_identical(short$n_similar, 1L)
  one_mouth <- update(assembly(twin), nets.starboard.mouth = NULL)
  blocked <- findings(settle(one_mouth, nodes = 1500))
  expect_true("mouth blockage" %in% blocked$check)
})

test_that("nets that do not touch have the measures of the net alone", {
  alone <- settle(lone_net(), nodes = 1500)
  pair <- gear("Two nets", gears = list(port = lone_net(), starboard = list(like = "port",
    moved = c(0, "100 m", 0))))
  together <- measures(settle(pair, nodes = 3000))
  one <- measures(alone)
  of_nets <- c("wing_end_spread_m", "headline_height_m", "mouth_area_m2", "sweep_tension_kN")
  for (net in c("port_", "starboard_")) {
    off <- abs(as.double(together[paste0(net, of_nets)]) - as.double(one[of_nets]))
    error <- attr(alone, "error")[of_nets] + attr(together, "error")[paste0(net, of_nets)]
    expect_true(all(off <= error))
  }
  expect_equal(together[["total_drag_kN"]], 2 * one[["total_drag_kN"]], tolerance = 0.01)
})

test_that("a gear with `number` makes copies, each joined to its own location", {
  buoyed <- list(
    points = list(top = list(position = c(0, 0, 0), held = "fixed"), foot = list()),
    ropes = list(line = list(from = "top", to = "foot", length = "20 m", diameter = "10 mm",
      material = "PP")),
    pieces = list(weight = list(at = "foot", mass = "10 kg", density = "7850 kg/m3")),
    number = 3, apart = c(0, 5, 0)
  )
  si <- gear_si(gear("Three lines", gears = list(line = buoyed)))
  expect_identical(names(si$points), paste0("line_", rep(1:3, each = 2), c("_top", "_foot")))
  expect_equal(si$points$line_3_top$position, c(0, 10, 0))
  buoyed$joined <- list(top = "float_#")
  floats <- lapply(1:3, function(k) gear_point(position = c(0, k, 0), held = "fixed"))
  joined <- gear_si(do.call(gear, c(list("Joined lines", gears = list(line = buoyed)),
    stats::setNames(floats, paste0("float_", 1:3)))))
  expect_identical(joined$points$line_2_top$at, "float_2")
})

test_that("wrong joints, names and fields of a rig are errors at the written field", {
  twin <- read_gear("twin_trawl")
  wrong <- function(path, message, ...) {
    error <- expect_error(update(twin, ...), message, class = "codend_error_plan")
    expect_identical(error$path, path)
  }
  wrong("gears.port.joined.bord_port", "no point of this gear.*did you mean `board_port`",
    gears.port.joined = list(bord_port = "door_port"))
  wrong("gears.starboard.joined.board_port", "no point `clmp`.*did you mean `clump`",
    gears.starboard.joined.board_port = "clmp")
  wrong("gears.starboard.like", "another gear of this plan: port",
    gears.starboard.like = "prot")
  wrong("gears.starboard.like", "not itself like this one", gears.port.like = "starboard")
  wrong("gears.port.sweeps.length", "5 kg", gears.port.sweeps.length = "5 kg")
  # The net's own check reports the gear that defines the field.
  wrong("gears.port.wings.lower.meshes.deep", "lower wings as deep",
    gears.port.wings.lower.meshes.deep = 60)
  wrong("gears.starboard.wings.lower.meshes.deep", "lower wings as deep",
    gears.starboard.wings.lower.meshes.deep = 60)
  wrong("points.port_codline", "same name as a part of a gear", points.port_codline = list())
  wrong("gears.port.kind", "one of", gears.port.kind = "trawl")
  wrong("towing.speed", "a speed", towing.speed = "3 kg")
})

test_that("included plans are files in the same folder and are written with their fields", {
  folder <- withr::local_tempdir()
  lines <- c("codend: 1", "name: Pair", "towing: {speed: 4 knot}", "seabed: {depth: 30 m}",
    "gears:", "  port: {plan: own.yaml}", "  starboard: {like: port, moved: [0, 20 m, 0]}")
  writeLines(lines, file.path(folder, "pair.yaml"))
  expect_error(read_gear(file.path(folder, "pair.yaml")), "shipped plan or a file in the folder",
    class = "codend_error_plan")
  write_gear(update(read_gear("beam_trawl"), beam.length = "4.5 m"), file.path(folder, "own.yaml"))
  pair <- read_gear(file.path(folder, "pair.yaml"))
  expect_equal(gear_si(pair)$ropes$starboard_beam$length, 4.5)
  # Uncertainties of the included plan refer to its field in the rig.
  expect_true(any(startsWith(names(pair$plan$uncertain), "gears.port.")))
  write_gear(pair, file.path(folder, "written.yaml"))
  file.remove(file.path(folder, "own.yaml"))
  expect_identical(read_gear(file.path(folder, "written.yaml"))$plan, pair$plan)
  # A plan cannot make codend open a file elsewhere, or itself.
  writeLines(sub("own.yaml", "../secret.yaml", lines), file.path(folder, "pair.yaml"))
  writeLines("password", file.path(folder, "..", "secret.yaml"))
  withr::defer(unlink(file.path(folder, "..", "secret.yaml")))
  expect_error(read_gear(file.path(folder, "pair.yaml")), "a file in the folder")
  writeLines(sub("own.yaml", "pair.yaml", lines), file.path(folder, "pair.yaml"))
  expect_error(read_gear(file.path(folder, "pair.yaml")), "does not include itself")
})

test_that("gear() with gears makes the rig of the plan with its uncertainties", {
  trawl <- read_gear("beam_trawl")
  pair <- gear("Pair", gears = list(port = trawl, starboard = list(like = "port",
    moved = c(0, 20, 0))))
  expect_identical(sort(names(pair$plan$uncertain), method = "radix"),
    sort(c(grep("^(towing|seabed)", names(trawl$plan$uncertain), value = TRUE),
      paste0("gears.port.", grep("^(towing|seabed)", names(trawl$plan$uncertain), value = TRUE,
        invert = TRUE))), method = "radix"))
  twin <- read_gear("twin_trawl")$plan
  by_hand <- do.call(gear, c(list("Twin",
    gears = list(port = lone_net(), starboard = list(like = "port")),
    joined = list(port = c(board_port = "door_port", board_starboard = "clump"),
      starboard = c(board_port = "clump", board_starboard = "door_starboard"))),
    twin[c("points", "ropes", "pieces", "measures")]))
  same <- c("points", "ropes", "panels", "seams", "pieces", "measures", "towing", "water")
  expect_identical(gear_si(by_hand)[same], gear_si(read_gear("twin_trawl"))[same])
  expect_error(gear("Twin", gears = list(a = trawl), joined = list(b = c(x = "y"))), "joined",
    class = "codend_error_argument")
})

test_that("rigs in the folder of examples settle with symmetric results", {
  rig <- function(name) {
    file <- system.file("examples", paste0(name, ".yaml"), package = "codend", mustWork = TRUE)
    expect_lte(length(readLines(file)), 75L)
    measures(settle(read_gear(file), nodes = 2000))
  }
  expect_mirrored <- function(found, one, other) {
    expect_equal(found[[one]], found[[other]], tolerance = 1e-6)
  }
  triple <- rig("triple_rig")
  for (name in c("wing_end_spread_m", "headline_height_m")) {
    expect_mirrored(triple, paste0("port_", name), paste0("starboard_", name))
  }
  quad <- rig("quad_rig")
  for (name in c("wing_end_spread_m", "headline_height_m")) {
    expect_mirrored(quad, paste0("one_", name), paste0("four_", name))
    expect_mirrored(quad, paste0("two_", name), paste0("three_", name))
  }
  two <- rig("two_warp_twin_trawl")
  expect_mirrored(two, "port_wing_end_spread_m", "starboard_wing_end_spread_m")
  farm <- rig("cage_farm")
  expect_mirrored(farm, "cage_1_net_net_drag_kN", "cage_2_net_net_drag_kN")
  # The rear cages are in the wake of the front cages.
  expect_lt(farm[["cage_3_net_net_drag_kN"]], 0.9 * farm[["cage_1_net_net_drag_kN"]])
  pair <- rig("double_beam_trawl")
  alone <- measures(settle("beam_trawl", nodes = 1000))
  expect_equal(pair[["total_drag_kN"]], 2 * alone[["total_drag_kN"]], tolerance = 0.01)
  expect_equal(pair[["swept_area_km2_per_h"]], 2 * alone[["swept_area_km2_per_h"]],
    tolerance = 0.01)
})

test_that("a warp that ends in further warps needs no door", {
  state <- settle(example_gear("two_warp_twin_trawl"), nodes = 300)
  expect_false("warp end" %in% findings(state)$check)
  # The clump is beside the doors: within 4 m of 280 m behind the vessel.
  pieces <- as.data.frame(state, what = "pieces")
  x <- pieces$x_m[match(c("door_port", "clump"), pieces$part)]
  expect_lt(abs(diff(x)), 4)
})

test_that("bridle angle of a net is the mean angle of its two sweeps", {
  side <- function(name) list(angle = stats::setNames(list("divergence"), paste0(name, ".start")))
  rig <- update(read_gear("twin_trawl"), measures = list(
    outer = side("port_sweep_port"), inner = side("port_sweep_starboard")
  ))
  m <- measures(settle(rig, nodes = 300))
  expect_gt(abs(m[["outer_deg"]] - m[["inner_deg"]]), 0.1)
  expect_equal(m[["port_bridle_angle_deg"]], (m[["outer_deg"]] + m[["inner_deg"]]) / 2)
  expect_equal(m[["port_bridle_angle_deg"]], m[["starboard_bridle_angle_deg"]], tolerance = 1e-6)
  ends <- paste0("port_sweep_port.", c("start", "end"))
  both <- list(angle = stats::setNames(list("divergence", "divergence"), ends))
  expect_error(update(rig, measures = list(mixed = both)), "same end of every rope",
    class = "codend_error_plan")
})
