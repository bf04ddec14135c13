# Measures the sensitivity of net openings at sea and the limit of any model: writes openings.md. A
# part of `make validate`.
suppressPackageStartupMessages(library(codend))
room <- new.env(parent = asNamespace("codend"))
for (file in c("manifest.R", "page.R", "cases/flume.R", "cases/hauls.R")) {
  sys.source(file.path("validation", file), room)
}
attach(room, name = "cases of the book")

# ---- comparison of measurements ------------------------------------------------------------------

# Two runs of one rig in the flume, days apart: tests of the 83-112 before and after the others.
repeats <- function() {
  tests <- flume_tests("eastern")
  tests <- tests[tests$rigging == "standard" & tests$spread_treatment_m == 17.5 &
    tests$pulling_point_mm == 200, ]
  both <- merge(tests[tests$trial < 63, ], tests[tests$trial >= 63, ], by = "speed_knot")
  data.frame(
    speed_knot = both$speed_knot, first_m = both$headline_height_m.x,
    again_m = both$headline_height_m.y
  )
}

# Headline heights in the flume and at sea at the same width between the upper wing ends, near 3
# knot.
flume_and_sea <- function() {
  do.call(rbind, lapply(c(PNE = "poly_noreastern", `83-112` = "eastern"), function(net) {
    tests <- flume_tests(net)
    tests <- tests[tests$rigging == "standard" & tests$speed_knot == 3 &
      tests$pulling_point_mm == 200, ]
    hauls <- survey_hauls(if (net == "eastern") "83-112" else "PNE")
    hauls <- hauls[order(hauls$width_m), ]
    near <- tests$upper_wing_spread_m > min(hauls$width_m) &
      tests$upper_wing_spread_m < max(hauls$width_m)
    tests <- tests[near, ]
    sea <- stats::approx(hauls$width_m, hauls$height_m, tests$upper_wing_spread_m)$y
    data.frame(net = net, width_m = tests$upper_wing_spread_m, flume_m = tests$headline_height_m,
      sea_m = sea)
  }))
}

# ---- sensitivity of an opening -------------------------------------------------------------------

# Opening, width between the upper wing ends (m), and the middle bridle's fraction of the bridles'
# tension.
shape_of <- function(gear, ...) {
  m <- codend:::plain_measures(measures(settle(update(gear, ...), nodes = 1500)))
  pull <- m[c("bridle_upper_tension_kN", "bridle_middle_tension_kN", "bridle_lower_tension_kN")]
  c(opening = m[["headline_height_m"]], width = m[["upper_wing_spread_m"]],
    middle = 100 * unname(pull[2]) / sum(pull))
}

survey_rigs <- function() {
  rigs <- list(
    `as at sea: setbacks of 457 mm above, 152 in the middle, none below` = list(),
    `bridles of one length` = list(bridles.upper.setback = "0 m", bridles.middle.setback = "0 m"),
    `setbacks twice as long` =
      list(bridles.upper.setback = "914 mm", bridles.middle.setback = "304 mm"),
    `middle bridle 0.5 m longer` = list(bridles.middle.length = "55.4 m"),
    `middle bridle 0.25 m shorter` = list(bridles.middle.length = "54.65 m"),
    `middle bridle 0.5 m shorter` = list(bridles.middle.length = "54.4 m"),
    `a fifth less buoyancy` = list(floats.buoyancy = "8.16 kgf"),
    `netting by the law of twines` = list(netting_drag = "morison")
  )
  gear <- read_gear("poly_noreastern_trawl")
  t(vapply(rigs, function(changes) do.call(shape_of, c(list(gear), changes)), numeric(3)))
}

# The opening of Scotia III's GOV at the middle of her hauls with its kite and without, and the
# measured values.
kite_shares <- function() {
  hauls <- hauls_by_warp("SCO3", 60)
  hauls <- hauls[ceiling(nrow(hauls) / 2), ]
  gear <- update(gov_of(hauls_by_warp("SCO3", 60), 60),
    ropes.warp_port.length = hauls$Warplngt, ropes.warp_starboard.length = hauls$Warplngt,
    seabed.depth = hauls$Depth, towing.speed = paste(hauls$speed, "knot"))
  opening <- function(gear) measures(settle(gear, nodes = 1500))[["headline_height_m"]]
  c(warp = hauls$Warplngt, hauls = hauls$Netopening, with = opening(gear),
    without = opening(update(gear, pieces.kite = NULL)))
}

table_lines <- function(head, rows) {
  c(paste("|", paste(head, collapse = " | "), "|"),
    paste0("|---|", strrep("--:|", length(head) - 1L)),
    apply(rows, 1, function(row) paste("|", paste(row, collapse = " | "), "|")), "")
}

again <- repeats()
apart <- flume_and_sea()
rigs <- survey_rigs()
kite <- kite_shares()
number <- function(x, digits = 2) formatC(x, digits, format = "f")
room$write_lines("validation/openings.md", c(
  "# Openings: how near any model can come", "",
  paste("The height of a headline is the softest measure of a trawl. This page, which",
    "`make validate` computes, sets measurements of it beside each other, and says what moves",
    "codend's."), "",
  "## The flume beside itself", "",
  paste("The 83-112 Eastern trawl in one flume, with one rig, at the start and at the end of the",
    "tests:"), "",
  table_lines(c("speed, knot", "first, m", "again, m", "change, %"), cbind(
    again$speed_knot, number(again$first_m), number(again$again_m),
    number(100 * (again$again_m / again$first_m - 1), 0))),
  "## The flume beside the sea", "",
  paste("Headlines of the flume at 3 knot, and of means of hundreds of hauls at the same width",
    "between the upper wing ends. No model with one set of numbers is right in both: the mean of",
    "the two is as far off each as half the last column."), "",
  table_lines(c("net", "width, m", "flume, m", "hauls, m", "hauls over flume, %"), cbind(
    c(poly_noreastern = "Poly Nor'Eastern", eastern = "83-112 Eastern")[apart$net],
    number(apart$width_m, 1), number(apart$flume_m), number(apart$sea_m),
    number(100 * (apart$sea_m / apart$flume_m - 1), 0))),
  paste("Haul by haul, openings with as much warp scatter by 12.5 % (standard deviation of",
    "20 groups, 1,140 hauls of DATRAS)."), "",
  "## What moves the opening of the survey trawl", "",
  paste("The Poly Nor'Eastern with 340 m of warp at 3 knot. The middle bridle carries little as",
    "long as it is not shorter than the others: upper and lower bridle pull at lines, the head",
    "line and the fishing line, and the middle one at the jib between the wings, which gives.",
    "Half a metre less doubles its load, and leaves the opening nearly as it was."), "",
  table_lines(c("rig", "opening, m", "width, m", "middle bridle, % of tension"), cbind(
    rownames(rigs), number(rigs[, 1]), number(rigs[, 2], 1), number(rigs[, 3], 0))),
  "## The kite of the GOV", "",
  sprintf(paste("Scotia III's GOV with %.0f m of warp: hauls open by %.2f m, codend by %.2f m with",
    "the kite (0.7 m2, lift coefficient 1) and by %.2f m without: the kite makes %.0f %% of it.",
    "Its lift coefficient is assumed; 10 %% of that is some %.0f %% of the opening."),
  kite[["warp"]], kite[["hauls"]], kite[["with"]], kite[["without"]],
  100 * (1 - kite[["without"]] / kite[["with"]]),
  10 * (1 - kite[["without"]] / kite[["with"]]))
))
