new_text <- function(...) strsplit(format(new_plan(...), remarks = TRUE), "\n", fixed = TRUE)[[1]]

test_that("new_plan() returns a commented plan for every kind", {
  for (kind in names(new_plan_kinds())) {
    gear <- new_plan(kind)
    rig <- length(gear$plan$gears) > 0L
    if (!rig) expect_identical(gear$plan$kind, kind)
    expect_true(any(grepl("#", new_text(kind), fixed = TRUE)), label = kind)
    expect_lte(length(new_text(kind)), if (rig) 80 else 60)
  }
  expect_identical(setdiff(plan_kinds, c("assembly", names(new_plan_kinds()))), character())
})

# Usual range of published values for a kind (inst/extdata/bands.csv).
usual_band <- function(quantity, kind) {
  bands <- number_bands
  unlist(bands[bands$quantity == quantity & bands$kind == kind, c("usual_least", "usual_greatest")])
}

expect_in_band <- function(value, quantity, kind, info, wider = 0) {
  band <- usual_band(quantity, kind)
  expect_gte(value, band[[1]] * (1 - wider), label = paste(info, quantity, signif(value, 3)))
  expect_lte(value, band[[2]] * (1 + wider), label = paste(info, quantity, signif(value, 3)))
}

settled_starter <- function(kind, ...) {
  state <- settle(new_plan(kind, ...), nodes = 500)
  found <- findings(state)
  expect_identical(finding_sentences(found), character(), info = paste(kind, ...))
  list(measures = as.list(measures(state)), loads = tension_table(state)$strength_percent)
}

test_that("new_plan() bottom trawls of every size match published ranges without warnings", {
  # Widths of otter trawls by engine power, kW (Eigaard et al. 2016, ICES J. Mar. Sci. 73:27, with
  # additions of ICES 2015): a mixed fishery, crustaceans, demersal fish. Their scatter
  # is a third of the mean.
  widths <- function(kw) c(10.6608 * kw^0.2921, 5.1039 * kw^0.469, 9.6054 * kw^0.4337)
  # bollard pull: 30 / 2240 long tons a horsepower (US Navy, open propellers); at 3 knot a
  # trawler has about 0.7 times this pull
  power <- function(drag) drag / (9.964 * 0.7 * 30 / 2240) * 0.7457
  for (h in c(8, 25, 50, 80)) {
    found <- settled_starter("bottom_trawl", headline = paste(h, "m"))
    m <- found$measures
    # spread up to a sixth beyond published course values
    expect_in_band(m$wing_end_spread_m / h, "spread over headline", "bottom_trawl", h, 1 / 6)
    expect_in_band(m$net_mouth_height_m / h, "headline height over headline", "bottom_trawl", h)
    expect_in_band(m$bridle_angle_deg, "bridle angle", "bottom_trawl", h)
    expect_gt(m$door_spread_m, 2 / 3 * min(widths(power(m$total_drag_kN))), label = h)
    expect_lt(m$door_spread_m, 4 / 3 * max(widths(power(m$total_drag_kN))), label = h)
    # rope tensions are at most a quarter of the breaking load
    expect_lt(max(found$loads, na.rm = TRUE), 25)
    expect_gt(m$ground_load_kN, 0)
    # A vessel of 3000 hp pulls about 270 kN at this speed (as above, with a nozzle) and tows a
    # trawl of 60 m. By area, small gear at 2.5 knot has half of this pull because of its speed
    # alone.
    expect_lt(m$total_drag_kN / (h / 60)^2, 270)
    expect_gt(m$total_drag_kN / (h / 60)^2, 270 / 3)
  }
  pair <- settled_starter("pair_trawl", headline = "40 m")$measures
  expect_in_band(pair$wing_end_spread_m / 40, "spread over headline", "pair_trawl", "pair")
  expect_in_band(pair$net_mouth_height_m / 40, "headline height over headline", "pair_trawl", "")
})

test_that("new_plan() scales bottom trawls from 25 m at 3 knot", {
  plan <- new_plan("bottom_trawl", headline = "25 m")$plan
  expect_identical(plan$towing$speed, "3 knot")
  expect_identical(plan$otter_boards$lift_coefficient, 1.2)
  expect_equal(speed_over_usual(3 * 1852 / 3600, 25), 1)
})

test_that("new_plan() midwater trawls of every size match published ranges without warnings", {
  for (h in c(20, 50, 120)) {
    found <- settled_starter("midwater_trawl", headline = paste(h, "m"))
    m <- found$measures
    expect_in_band(m$net_mouth_height_m / h, "mouth height over headline", "midwater_trawl", h)
    expect_in_band(m$wing_end_spread_m / h, "spread over headline", "midwater_trawl", h, 0.25)
    expect_lt(max(found$loads, na.rm = TRUE), 40)
    if (h != 50) next
    # A midwater trawl of 45 m has 48 to 72 kN at 2 to 3 knot with boards of 5 m2 (CIFT). A Korean
    # pair trawl has 53 kN at 4 knot (479 V^1.75 kgf, V in knot). A trawl with a circumference of
    # 400 m at 4 knot is therefore within half of their middle.
    expect_gt(m$total_drag_kN, 40)
    expect_lt(m$total_drag_kN, 100)
  }
  # meshes of 64 m, with every bar modelled
  large <- settled_starter("midwater_trawl", headline = "250 m", mesh_size = "64 m")$measures
  expect_gt(large$net_mouth_height_m / 250, 0.2)
})

test_that("new_plan() rigs of tested sizes have nets within published ranges and no warnings", {
  nets <- list(twin_trawl = c("port", "starboard"), triple_rig = c("port", "middle", "starboard"),
    quad_rig = c("one", "two", "three", "four"))
  for (kind in names(nets)) {
    for (size in new_plan_kinds()[[kind]]$tested) {
      m <- settled_starter(kind, headline = size)$measures
      h <- quantity_si(size, "length")
      spread <- unlist(m[paste0(nets[[kind]], "_wing_end_spread_m")]) / h
      # Small nets spread up to a quarter beyond published course values.
      for (s in spread) expect_in_band(s, "spread over headline", "bottom_trawl", kind, 1 / 4)
      # The rig is symmetric.
      expect_equal(unname(spread), rev(unname(spread)), tolerance = 1e-6)
      expect_gt(m$door_spread_m, sum(spread) * h)
    }
  }
})

test_that("new_plan() gives other kinds the requested dimensions", {
  beam <- settled_starter("beam_trawl", beam = "9 m", speed = "5 knot")$measures
  expect_equal(beam$wing_end_spread_m, 9, tolerance = 0.05)
  net <- settled_starter("gillnet", length = "80 m", height = "5 m", mesh_size = "100 mm",
    current = "0.05 m/s")$measures
  expect_equal(net$net_height_m, 5, tolerance = 0.1)
  cage <- new_plan("cage", diameter = "50 m", depth = "20 m", current = "0.1 m/s")
  # moorings are 2 % longer than the distance from the collar to their anchors
  line <- cage$plan$moorings
  metres <- vapply(line[c("length", "reach", "anchor_depth")], quantity_si, 0, "length")
  expect_equal(metres[[1]], 1.02 * sqrt(metres[[2]]^2 + metres[[3]]^2), tolerance = 2e-3)
  held <- measures(settle(cage, nodes = 500))
  # a cylinder and its cone
  expect_equal(held[["net_volume_m3"]], pi * 25^2 * (20 + 7.5 / 3), tolerance = 0.05)
  stow <- settled_starter("stow_net", width = "14 m", height = "8 m")$measures
  expect_equal(stow$mouth_width_m, 14, tolerance = 0.1)
  expect_equal(stow$mouth_height_m, 8, tolerance = 0.25)
  seine <- gear_si(new_plan("purse_seine", length = "450 m", depth = "80 m"))
  expect_equal(seine$ropes$float_line$length, 450)
  expect_equal(seine$panels$body$deep * seine$panels$body$mesh_size, 80, tolerance = 1e-3)
  line <- new_plan("longline", baskets = 4, branch_lines = "10", main_line = "500 m")
  expect_identical(as.numeric(line$plan$baskets), 4)
  expect_identical(line$plan$main_line$length, "500 m")
  expect_match(format(line, remarks = TRUE), "Scaled from the shipped plan", fixed = TRUE)
})

test_that("new_plan() checks its arguments by name", {
  text <- new_text("bottom_trawl", headline = "31 m", depth = 77)
  expect_true(any(grepl("depth: 77 m,", text, fixed = TRUE)))
  expect_true(any(startsWith(text, "headline: {length: 31 m")))
  # the message names the argument and no position in the generated plan
  large <- tryCatch(new_plan("bottom_trawl", headline = "3000 m"), codend_error_plan = identity)
  expect_match(large$message, "`headline` is 3000 m, outside the tested sizes from 8 m to 80 m")
  expect_identical(large$path, "headline")
  expect_null(large$line)
  expect_identical(new_plan("cage", diameter = "30 m")$plan$diameter, "30 m")
  # other fields by their path
  expect_identical(new_plan("gillnet", wall.twine.diameter = "0.4 mm")$plan$wall$twine$diameter,
    "0.4 mm")
})

test_that("new_plan() keeps given numbers to their last digit and unit", {
  for (kind in c("bottom_trawl", "pair_trawl", "demersal_seine", "midwater_trawl")) {
    for (headline in c("36.13 m", "20.15 fathom")) {
      gear <- new_plan(kind, headline = headline)
      expect_identical(gear$plan$headline$length, headline)
      expect_match(gear$plan$name, paste("headline", headline), fixed = TRUE)
    }
  }
  expect_identical(new_plan("bottom_trawl", headline = 15.6)$plan$headline$length, "15.6 m")
  expect_identical(new_plan("purse_seine", length = "301.2 m")$plan$float_line$length, "301.2 m")
  expect_match(new_plan("gillnet", height = "3.27 m")$plan$name, "50 m by 3.27 m", fixed = TRUE)
})

test_that("prompt_for_values() takes the usual value for an empty answer", {
  answers <- textConnection(c("22 m", "", " 60 mm"))
  on.exit(close(answers))
  requests <- new_plan_kinds()$bottom_trawl$requests
  capture.output(given <- prompt_for_values(requests, list(speed = "2 knot"), answers),
    type = "message")
  expect_identical(given, list(speed = "2 knot", headline = "22 m", codend_mesh_size = "60 mm"))
})

test_that("prompt_for_values() offers mesh sizes that suit the headline", {
  answers <- textConnection(c("64 m", "", "", "", ""))
  on.exit(close(answers))
  about <- new_plan_kinds()$bottom_trawl
  said <- capture.output(given <- prompt_for_values(about$requests, list(), answers, about$usual),
    type = "message")
  expect_identical(given, list(headline = "64 m"))
  # 25 m's value times the square root of 64/25 gives about double
  expect_match(said, "mesh size [160 mm]", fixed = TRUE, all = FALSE)
  expect_identical(new_plan("bottom_trawl", headline = "64 m")$plan$square$mesh_size, "160 mm")
})

test_that("prompt_for_values() adds the usual unit and repeats invalid questions", {
  answers <- textConnection(c("32", "80", "wide", "3 knot", "-1", "60 mm", "2.5", "-4 m"))
  on.exit(close(answers))
  requests <- new_plan_kinds()$bottom_trawl$requests
  said <- capture.output(given <- prompt_for_values(requests, list(), answers), type = "message")
  # if input ends, the last answer remains and its own error is thrown
  expect_identical(given, list(headline = "32 m", mesh_size = "80 mm", codend_mesh_size = "60 mm",
    speed = "2.5 knot", depth = "-4 m"))
  expect_match(said, "\"wide\" is not a length; enter one such as 80 mm", fixed = TRUE,
    all = FALSE)
  expect_length(grep("is not a length", said), 4L)
})
