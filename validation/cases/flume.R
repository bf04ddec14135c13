# The Poly Nor'Eastern in the flume of 2025: a rig without warps and boards, with water 8^1.5 times
# as viscous, so that the gear has the Reynolds numbers of the 1:8 model.

flume_tests <- function() {
  tests <- utils::read.csv(system.file("extdata", "flume_poly_noreastern.csv", package = "codend"),
    comment.char = "#")
  # weights on the split bridles are not printed: they are computed without
  tests$rigging <- sub("_weighted", "", tests$bridles)
  tests[tests$catch == "empty" & tests$trial != 55, ]
}

survey_rig <- function(rigging, height) {
  rig <- update(read_gear("poly_noreastern_trawl"), warps = NULL, otter_boards = NULL,
    towing_points = list(spread = "50 m", height = height), water.viscosity = 1.15e-6 * 8^1.5)
  if (rigging == "standard") return(rig)
  update(rig,
    bridles.upper.length = "27.4 m", bridles.middle.length = "27.4 m",
    bridles.lower.length = "27.4 m",
    sweeps = list(length = "27.4 m", diameter = "16 mm", material = "steel_wire"))
}

# The distance of the towing points at which the upper wing ends are `wing` apart at 3 knot, by the
# straight line through two tried ones; it stays at other speeds, as in the flume.
set_spread <- function(rig, wing) {
  tried <- wing + 2 * 54.9 * sin(18 * pi / 180) + c(-2, 2)
  found <- vapply(tried, function(spread) {
    state <- settle(update(rig, towing_points.spread = spread), nodes = 1500)
    measures(state)[["upper_wing_spread_m"]]
  }, 0)
  tried[1] + (wing - found[1]) * diff(tried) / diff(found)
}

in_flume_rig <- function(tests) {
  series <- split(seq_len(nrow(tests)), paste(tests$rigging, tests$spread_treatment_m))
  found <- matrix(NA_real_, nrow(tests), 6)
  for (set in series) {
    rigging <- tests$rigging[set[1]]
    usual <- if (rigging == "standard") "1.6 m" else "1.2 m"
    spread <- set_spread(survey_rig(rigging, usual), tests$spread_treatment_m[set[1]])
    state <- NULL
    for (k in set) {
      rig <- survey_rig(rigging, paste(tests$pulling_point_mm[k] * 8 / 1000, "m"))
      state <- settle(update(rig, towing_points.spread = spread,
        towing.speed = paste(tests$speed_knot[k], "knot")), nodes = 1500, from = state)
      pull <- summary(state)$reactions
      m <- measures(state)
      found[k, ] <- c(sum(sqrt(pull$x_kN^2 + pull$y_kN^2 + pull$z_kN^2)) / 9.81,
        m[["net_mouth_height_m"]], m[["middle_wing_spread_m"]], m[["lower_wing_spread_m"]],
        m[["wing_end_height_m"]], m[["bridle_angle_deg"]])
    }
  }
  found
}
flume_columns <- c(
  bridle_tension = "bridle_tension_t", opening = "headline_height_m",
  middle_wing_spread = "middle_wing_spread_m", lower_wing_spread = "lower_wing_spread_m",
  wing_height = "upper_wing_height_m", bridle_angle = "bridle_angle_deg"
)

flume_case <- function(tests, found, by) {
  at <- sprintf("%s, %g m, %g knot, %g m up", tests$rigging, tests$spread_treatment_m,
    tests$speed_knot, tests$pulling_point_mm * 8 / 1000)
  # five tests that the net was tuned on, in all that was measured
  tuned <- tests$rigging == "standard" & tests$pulling_point_mm == 200 &
    ifelse(tests$spread_treatment_m == 16, tests$speed_knot %in% c(2, 3, 4), tests$speed_knot == 3)
  rows <- lapply(seq_along(flume_columns), function(k) {
    name <- names(flume_columns)[k]
    compared(name, at, tests[[flume_columns[k]]], found[, k], tuned)
  })
  # trends of each series, all but what is varied alike
  trends <- lapply(names(by), function(column) {
    same <- setdiff(c("rigging", "spread_treatment_m", "speed_knot", "pulling_point_mm"), column)
    series <- split(seq_len(nrow(tests)), do.call(paste, tests[same]))
    series <- series[lengths(series) > 1]
    do.call(rbind, lapply(series, function(k) {
      do.call(rbind, lapply(by[[column]], function(name) {
        col <- match(name, names(flume_columns))
        trend(name, paste(column, at[k[1]]), tests[[column]][k], tests[[flume_columns[col]]][k],
          found[k, col])
      }))
    }))
  })
  do.call(rbind, c(rows, trends))
}

# The tests at the usual pulling height of a rigging.
usual_pull <- function(tests) {
  tests$pulling_point_mm == ifelse(tests$rigging == "standard", 200, 150)
}

case_flume_speed <- function() {
  tests <- flume_tests()
  tests <- tests[tests$rigging == "standard" & tests$spread_treatment_m == 16 & usual_pull(tests), ]
  flume_case(tests, in_flume_rig(tests), list(speed_knot = c("bridle_tension", "opening")))
}

case_flume_spread <- function() {
  tests <- flume_tests()
  tests <- tests[tests$rigging == "standard" & tests$spread_treatment_m != 16 & usual_pull(tests), ]
  flume_case(tests, in_flume_rig(tests),
    list(speed_knot = c("bridle_tension", "opening"), spread_treatment_m = "opening"))
}

case_flume_split_bridles <- function() {
  tests <- flume_tests()
  tests <- tests[tests$rigging == "split" & usual_pull(tests), ]
  flume_case(tests, in_flume_rig(tests),
    list(speed_knot = c("bridle_tension", "opening"), spread_treatment_m = "opening"))
}

case_flume_pulling_height <- function() {
  tests <- flume_tests()
  tests <- tests[tests$speed_knot == 3 & tests$spread_treatment_m == 16 & !(tests$trial == 52), ]
  flume_case(tests, in_flume_rig(tests),
    list(pulling_point_mm = c("bridle_tension", "opening", "wing_height")))
}
