one_line_trawl <- function() {
  two_seam(
    headline = list(length = "30 m", bosom = "5 m", diameter = "22 mm", material = "PE"),
    floats = list(number = 60L, buoyancy = "2.7 kgf", diameter = "200 mm"))
}

test_that("wings in pieces hang headline and footrope edge by edge", {
  ropes <- gear_si(one_line_trawl())$ropes
  edges <- vapply(ropes$headline$along, function(edge) paste0(edge$panel, ".", edge$edge), "")
  expect_identical(edges, c("back_wing_1_left.right", "back_wing_2_left.right", "back_square.upper",
    "back_wing_2_right.left", "back_wing_1_right.left"))
  # 12.5 m of headline along 6.4 m and 7 m of netting; 5 m along the bosom
  expect_equal(ropes$headline$shares * 30, c(12.5 * c(6.4, 7) / 13.4, 5, 12.5 * c(7, 6.4) / 13.4))
  expect_equal(range(covered_edges(one_line_trawl())), c(1, 1))
})

test_that("random nets join or hang each edge once and settle", {
  found <- vapply(1:12, function(seed) {
    trawl <- tryCatch(random_net(seed), codend_error_plan = function(e) conditionMessage(e))
    if (is.character(trawl)) {
      expect_match(trawl, "`net\\.")
      return(NA)
    }
    expect_equal(range(covered_edges(trawl)), c(1, 1), info = seed)
    state <- tryCatch(settle(trawl, nodes = 300), codend_error = function(e) NULL)
    !is.null(state)
  }, NA)
  expect_gte(sum(found, na.rm = TRUE), 10)
  expect_true(all(found, na.rm = TRUE))
})

test_that("a topless net hangs the free edges of the lower panel on the side lines", {
  trawl <- one_line_trawl()
  topless <- update(trawl, net.upper.wing_1 = NULL, net.upper.wing_2 = NULL,
    net.upper.square = NULL, headline.length = "9 m", headline.bosom = NULL,
    side_lines.hanging_ratio = 0.9)
  si <- gear_si(topless)
  expect_equal(range(covered_edges(topless)), c(1, 1))
  side <- vapply(si$ropes$side_line_starboard$along, `[[`, "", "panel")
  expect_identical(side, c("belly_lower_wing_2_left", "belly_lower_wing_1_left",
    "belly_lower_wing_1_left"))
  expect_gt(measures(settle(topless, nodes = 300))[["net_mouth_height_m"]], 0.5)
})

test_that("a piece between parallel edges keeps its width and its netting", {
  trawl <- update(one_line_trawl(),
    net.upper.wing_2.meshes = list(front = 51, rear = 51, deep = 50),
    net.upper.wing_2.cutting = list(inner = "1N2B", outer = "1N2B"))
  panel <- gear_si(trawl)$panels$back_wing_2_left
  expect_equal(c(panel$lost_left, panel$lost_right), c(25, -25))
  expect_no_error(state <- settle(trawl, nodes = 300))
  # 50 rows of 51 meshes, each with four bars of 70 mm
  expect_equal(panel_bars(panel) * cell_twine(panel), 51 * 50 * 4 * 0.07)
})

test_that("middle bridle of a net of two panels leads to the side line", {
  wire <- list(length = "25 m", diameter = "12 mm", material = "steel_wire")
  trawl <- update(one_line_trawl(), bridles.middle = wire)
  expect_identical(assembly(trawl)$plan$points$middle_port$at, "side_line_port.middle")
  found <- measures(settle(trawl, nodes = 300))
  expect_gt(found[["bridle_middle_tension_kN"]], 0)
})

test_that("assembly() with `only` keeps the measures of short forms", {
  for (name in c("poly_noreastern_trawl", "small_midwater_trawl", "pair_trawl")) {
    short <- read_gear(name)
    expect_equal(plain_measures(measures(settle(assembly(short, only = "net"), nodes = 300))),
      plain_measures(measures(settle(short, nodes = 300))), tolerance = 1e-6, info = name)
  }
})

# Returns a trawl of four panels whose side panels end behind `body`, with `rear` meshes.
short_sided <- function(rear, until = "body", gear = "poly_noreastern_trawl") {
  trawl <- assembly(read_gear(gear), only = "net")
  side <- trawl$plan$net$side
  side <- side[seq_len(match(until, names(side)))]
  whole <- trawl$plan$net$upper[[until]]
  side[[until]]$meshes <- list(front = side[[until]]$meshes$front, rear = rear,
    deep = first_of(side[[until]]$meshes$deep, whole$meshes$deep))
  side[[until]]$cutting <- NULL
  update(trawl, net.side = side)
}

test_that("side panels may end ahead of the codend, pointed or joined to both panels", {
  rows <- names(assembly(read_gear("poly_noreastern_trawl"), only = "net")$plan$net$side)
  until <- rows[length(rows) - 1L]
  for (rear in c(0, 12)) {
    trawl <- short_sided(rear, until)
    expect_equal(range(covered_edges(trawl)), c(1, 1), info = rear)
    expect_false(any(grepl(paste0("side_.*", rows[length(rows)]), names(gear_si(trawl)$panels))))
    state <- settle(trawl, nodes = 400)
    found <- measures(state)
    expect_equal(found[["warp_tension_port_kN"]], found[["warp_tension_starboard_kN"]],
      tolerance = 1e-4)
  }
  # a half of the side's rear edge is joined to each panel behind, by width
  seams <- gear_si(short_sided(12, until))$seams
  edges <- unlist(unlist(unname(lapply(seams, `[[`, "edges")), recursive = FALSE),
    recursive = FALSE)
  own <- Filter(function(edge) {
    edge$edge == "lower" && grepl(paste0("side_.*", until), edge$panel)
  }, edges)
  expect_equal(vapply(own, function(edge) edge$to - edge$from, 0), rep(0.5, 4))
})

test_that("check names panels that lack the last row of a side panel", {
  trawl <- Find(function(trawl) length(trawl$plan$net) == 4L, lapply(1:12, random_net))
  rows <- trawl$plan$net$upper_side
  short <- rows[seq_len(match("row_2", names(rows)))]
  both <- update(trawl, net.upper_side = short, net.lower_side = short)
  expect_equal(range(covered_edges(both)), c(1, 1))
  expect_no_error(settle(both, nodes = 300))
  names(rows)[match("row_2", names(rows))] <- "other"
  upper <- trawl$plan$net$upper$row_2
  rows$other <- modifyList(upper[names(upper) != "cutting"], rows$other)
  expect_refused(update(trawl, net.upper_side = short, net.lower_side = rows),
    "net.upper_side.row_2` is the last piece of its panel, but the panel `lower_side` has no piece")
})

test_that("assembly() with `only` keeps the measures of a beam trawl", {
  short <- read_gear("beam_trawl")
  expect_equal(plain_measures(measures(settle(assembly(short, only = "net"), nodes = 300))),
    plain_measures(measures(settle(short, nodes = 300))), tolerance = 1e-6)
})

test_that("errors about nets, lines and windows name fields of the plan", {
  window <- list(ahead = 20, rows = 20, across = 40, mesh_size = "100 mm", orientation = "square",
    twine = list(diameter = "4 mm", material = "PE"),
    meshes = list(front = 40, rear = 40, deep = 56))
  separator <- list(from = "body_1", to = "body_1", mesh_size = "100 mm",
    meshes = list(upper = 120, lower = 60, deep = 84), twine = window$twine)
  trawl <- update(one_line_trawl(), net.upper.body_2.window = window,
    separators = list(separator = separator),
    ground_gear = list(sections = list(
      list(length = "6 m", diameter = "16 mm", material = "steel_wire"),
      list(length = "15 m", diameter = "60 mm", mass_in_water = "5 kg/m",
        axial_stiffness = "10 MN")
    )))
  leaves <- plan_leaves(unclass(trawl$plan))
  use <- grepl("^(net|separators|ground_gear|headline|side_lines)", leaves$path)
  refused <- 0
  for (k in which(use)) {
    value <- leaves$value[[k]]
    tries <- list(NULL)
    if (is.numeric(value)) tries <- c(tries, list(20 * value, value / 20))
    for (other in tries) {
      change <- stats::setNames(list(other), leaves$path[k])
      error <- tryCatch({
        do.call(update, c(list(trawl), change))
        NULL
      }, error = function(e) e)
      if (is.null(error)) next
      refused <- refused + 1
      expect_s3_class(error, "codend_error_plan")
      expect_no_match(conditionMessage(error),
        "`(panels|seams|ropes|points|pieces)[.]|back_|belly_(?!lines)", perl = TRUE,
        label = leaves$path[k])
    }
  }
  expect_gt(refused, 100)
})

test_that("a sheet of 13 rows reads as a net by one paste and settles", {
  sheet <- paste(c(
    "panel\trow\tpair\tmesh size (mm)\ttwine (mm)\tmaterial\tfront\tdeep\tinner\touter\tcutting",
    "upper\twing 1\tyes\t160\t3\tPE\t25\t40\tAB\t1N2B\t",
    "\twing 2\tyes\t140\t3\tPE\t51\t50\tAB\t1N2B\t",
    "upper\tsquare\t\t140\t3\tPE\t220\t30\t\t\t1N2B",
    "upper\tbody 1\t\t140\t3\tPE\t190\t60\t\t\t1N2B",
    "upper\tbody 2\t\t100\t2,5\tPE\t182\t80\t\t\t1N2B",
    "upper\textension\t\t80\t2,5\tPE\t127\t90\t\t\t5N2B",
    "upper\tcodend\t\t80\t3\tPE\t97\t75\t\t\tAN",
    "lower\tlower wing 1\tyes\t160\t4\tPE\t30\t48\t1N4B\t1N2B\t",
    "lower\tlower wing 2\tyes\t140\t4\tPE\t44\t66\t1N4B\t1N2B\t",
    "lower\tbody 1\t\t\t4\t\t\t\t\t\t",
    "lower\tbody 2\t\t\t3\t\t\t\t\t\t",
    "lower\textension\t\t\t\t\t\t\t\t\t",
    "lower\tcodend\t\t\t\t\t\t\t\t\t"
  ), collapse = "\n")
  trawl <- update(one_line_trawl(), net = read_net(sheet))
  drawn <- gear_si(update(one_line_trawl(), net.upper.codend.twine.double = NULL))$panels
  expect_equal(unname(gear_si(trawl)$panels), unname(drawn))
  expect_no_error(settle(trawl, nodes = 300))
})
