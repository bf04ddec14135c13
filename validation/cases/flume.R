# Two survey trawls in the flume of 2025: a rig without warps and boards. Its water is 8^1.5 times
# as viscous, so that the gear has the Reynolds numbers of the 1:8 model.

flume_tests <- function(net = "poly_noreastern") {
  tests <- utils::read.csv(
    system.file("extdata", paste0("flume_", net, ".csv"), package = "codend"), comment.char = "#"
  )
  # weights on the split bridles are not published, so they are omitted
  tests$rigging <- sub("_weighted", "", tests$bridles)
  # trial 55 repeats 52
  tests[tests$catch == "empty" & tests$trial != 55, ]
}

# The trawl as rigged at sea, but with the flume's equal bridles.
flume_gear <- function(net) {
  if (net == "poly_noreastern") {
    return(update(read_gear("poly_noreastern_trawl"), bridles.upper.setback = "0 m",
      bridles.middle.setback = "0 m"))
  }
  # floats as in the flume's model
  update(read_gear(system.file("extdata", "eastern_trawl.yaml", package = "codend")),
    bridles.lower.length = "54.9 m", floats = list(number = 47, buoyancy = "2.506 kgf"))
}

survey_rig <- function(rigging, height, net = "poly_noreastern") {
  rig <- update(flume_gear(net), warps = NULL, otter_boards = NULL,
    towing_points = list(spread = "50 m", height = height), water.viscosity = 1.15e-6 * 8^1.5)
  if (rigging == "standard") return(rig)
  lengths <- lapply(rig$plan$bridles, function(bridle) "27.4 m")
  names(lengths) <- paste0("bridles.", names(lengths), ".length")
  do.call(update, c(list(rig), lengths,
    list(sweeps = list(length = "27.4 m", diameter = "16 mm", material = "steel_wire"))))
}

# The distance of the towing points at which the upper wing ends are `wing` apart at 3 knot, by
# linear interpolation of two trials. It is constant at other speeds, as in the flume.
set_spread <- function(rig, wing) {
  tried <- wing + 2 * 54.9 * sin(18 * pi / 180) + c(-2, 2)
  found <- vapply(tried, function(spread) {
    state <- settle(update(rig, towing_points.spread = spread), nodes = 1500)
    measures(state)[["upper_wing_spread_m"]]
  }, 0)
  tried[1] + (wing - found[1]) * diff(tried) / diff(found)
}

# The flume's measures (columns) for each test; NA if the net has no such measure.
in_flume_rig <- function(tests, net = "poly_noreastern") {
  series <- split(seq_len(nrow(tests)), paste(tests$rigging, tests$spread_treatment_m))
  found <- matrix(NA_real_, nrow(tests), length(flume_columns))
  for (set in series) {
    rigging <- tests$rigging[set[1]]
    usual <- paste(usual_pull(rigging, net) * 8 / 1000, "m")
    spread <- set_spread(survey_rig(rigging, usual, net), tests$spread_treatment_m[set[1]])
    state <- NULL
    for (k in set) {
      rig <- survey_rig(rigging, paste(tests$pulling_point_mm[k] * 8 / 1000, "m"), net)
      state <- settle(update(rig, towing_points.spread = spread,
        towing.speed = paste(tests$speed_knot[k], "knot")), nodes = 1500, from = state)
      pull <- summary(state)$reactions
      m <- plain_measures(measures(state))
      found[k, ] <- c(sum(sqrt(pull$x_kN^2 + pull$y_kN^2 + pull$z_kN^2)) / 9.81,
        unname(m[c("net_mouth_height_m", "middle_wing_spread_m", "lower_wing_spread_m",
          "wing_end_height_m", "bridle_angle_deg")]))
    }
  }
  found
}
flume_columns <- c(
  bridle_tension = "bridle_tension_t", opening = "headline_height_m",
  middle_wing_spread = "middle_wing_spread_m", lower_wing_spread = "lower_wing_spread_m",
  wing_height = "upper_wing_height_m", bridle_angle = "bridle_angle_deg"
)

# by: list(varied column = quantities whose trend is compared).
flume_case <- function(tests, by, net = "poly_noreastern") {
  found <- in_flume_rig(tests, net)
  at <- sprintf("%s, %g m, %g knot, %g m up", tests$rigging, tests$spread_treatment_m,
    tests$speed_knot, tests$pulling_point_mm * 8 / 1000)
  tuned <- if (net == "poly_noreastern") tuned_tests(tests) else rep(FALSE, nrow(tests))
  rows <- lapply(seq_along(flume_columns), function(k) {
    measured <- tests[[flume_columns[k]]]
    given <- which(!is.na(measured))
    if (length(given)) {
      compared(names(flume_columns)[k], at[given], measured[given], found[given, k], tuned[given])
    }
  })
  # trends of each series, with all other columns equal
  trends <- lapply(names(by), function(column) {
    same <- setdiff(c("rigging", "spread_treatment_m", "speed_knot", "pulling_point_mm"), column)
    series <- split(seq_len(nrow(tests)), do.call(paste, tests[same]))
    series <- series[lengths(series) > 1]
    do.call(rbind, lapply(series, function(k) {
      do.call(rbind, lapply(by[[column]], function(name) {
        col <- match(name, names(flume_columns))
        if (anyNA(tests[[flume_columns[col]]][k])) return(NULL)
        trend(name, paste(column, at[k[1]]), tests[[column]][k], tests[[flume_columns[col]]][k],
          found[k, col])
      }))
    }))
  })
  do.call(rbind, c(rows, trends))
}

# Five tests that were used to tune the Poly Nor'Eastern, in all measured quantities.
tuned_tests <- function(tests) {
  tests$rigging == "standard" & tests$pulling_point_mm == 200 &
    ifelse(tests$spread_treatment_m == 16, tests$speed_knot %in% c(2, 3, 4), tests$speed_knot == 3)
}

# The usual height of the pulling points with a rigging, mm of the model.
usual_pull <- function(rigging, net = "poly_noreastern") {
  ifelse(rigging == "split" & net == "poly_noreastern", 150, 200)
}

at_usual_pull <- function(tests, net = "poly_noreastern") {
  tests[tests$pulling_point_mm == usual_pull(tests$rigging, net), ]
}

by_speed_and_spread <- list(speed_knot = c("bridle_tension", "opening"),
  spread_treatment_m = "opening")

case_flume_speed <- function() {
  tests <- at_usual_pull(flume_tests())
  flume_case(tests[tests$rigging == "standard" & tests$spread_treatment_m == 16, ],
    by_speed_and_spread["speed_knot"])
}

case_flume_spread <- function() {
  tests <- at_usual_pull(flume_tests())
  flume_case(tests[tests$rigging == "standard" & tests$spread_treatment_m != 16, ],
    by_speed_and_spread)
}

case_flume_split_bridles <- function() {
  tests <- at_usual_pull(flume_tests())
  flume_case(tests[tests$rigging == "split", ], by_speed_and_spread)
}

case_flume_pulling_height <- function() {
  tests <- flume_tests()
  flume_case(
    tests[tests$speed_knot == 3 & tests$spread_treatment_m == 16 & !(tests$trial == 52), ],
    list(pulling_point_mm = c("bridle_tension", "opening", "wing_height"))
  )
}

# The 83-112 Eastern, which was not tuned to the flume.
case_flume_eastern_speed <- function() {
  tests <- at_usual_pull(flume_tests("eastern"), "eastern")
  tests <- tests[tests$rigging == "standard" & tests$spread_treatment_m == 17.5, ]
  # of two runs the later one, which alone has tensions
  flume_case(tests[tests$trial >= 63, ], by_speed_and_spread["speed_knot"], "eastern")
}

case_flume_eastern_narrow <- function() {
  tests <- at_usual_pull(flume_tests("eastern"), "eastern")
  flume_case(tests[tests$spread_treatment_m == 12.5, ],
    list(speed_knot = c("bridle_tension", "opening")), "eastern")
}

case_flume_eastern_split <- function() {
  tests <- at_usual_pull(flume_tests("eastern"), "eastern")
  flume_case(tests[tests$rigging == "split" & tests$spread_treatment_m == 17.5, ],
    by_speed_and_spread["speed_knot"], "eastern")
}

case_flume_eastern_pulling <- function() {
  tests <- flume_tests("eastern")
  flume_case(tests[tests$rigging == "split" & tests$speed_knot == 3 &
    tests$spread_treatment_m == 17.5, ],
  list(pulling_point_mm = c("bridle_tension", "opening", "wing_height")), "eastern")
}
