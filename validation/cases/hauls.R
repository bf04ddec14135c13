# Trawls at sea: means of many hauls compared with the gear as the ships report it.

# Settles one gear at each row of `at`: list(field = values), each from the previous state. Returns
# a matrix with a row per row of `at` and a column per measure.
settled_along <- function(gear, at, measures) {
  state <- NULL
  t(vapply(seq_along(at[[1]]), function(k) {
    state <<- settle(do.call(update, c(list(gear), lapply(at, `[[`, k))), nodes = 1500,
      from = state)
    vapply(measures, function(name) measures(state)[[name]], 0)
  }, stats::setNames(numeric(length(measures)), measures)))
}

# Hauls of a NOAA survey trawl by wire, in classes with more than 100 hauls.
survey_hauls <- function(trawl) {
  hauls <- utils::read.csv(system.file("extdata", "survey_hauls_by_wire.csv", package = "codend"),
    comment.char = "#")
  hauls[hauls$trawl == trawl & hauls$hauls > 100, ]
}

# tuned: wire (m) of the hauls used to tune the net; tuned_width: wire of the hauls used to tune the
# boards.
survey_case <- function(gear, hauls, tuned, tuned_width) {
  found <- settled_along(gear,
    list(warps.length = hauls$wire_m, seabed.depth = hauls$depth_m,
      towing.speed = paste(hauls$speed_knot, "knot")),
    c("upper_wing_spread_m", "headline_height_m")
  )
  at <- sprintf("%.0f m of wire", hauls$wire_m)
  wire <- round(hauls$wire_m)
  rbind(
    compared("wing_spread", at, hauls$width_m, found[, 1], wire %in% c(tuned, tuned_width)),
    compared("opening", at, hauls$height_m, found[, 2], wire %in% tuned),
    trend("wing_spread", "wire", hauls$wire_m, hauls$width_m, found[, 1]),
    trend("opening", "wire", hauls$wire_m, hauls$height_m, found[, 2])
  )
}

case_poly_noreastern_hauls <- function() {
  hauls <- survey_hauls("PNE")
  survey_case(read_gear("poly_noreastern_trawl"), hauls[hauls$wire_m < 1000, ], c(183, 689), 340)
}

case_eastern_hauls <- function() {
  survey_case(read_gear(system.file("extdata", "eastern_trawl.yaml", package = "codend")),
    survey_hauls("83-112"), 229, 229)
}

# Means of a ship's hauls with one sweep length by warp length, in classes with three hauls or more.
# The class limits (m) follow.
warp_classes <- c(0, 150, 200, 250, 300, 400, 500, 700, 1000)
hauls_by_warp <- function(ship, sweep, gear = "GOV") {
  hauls <- utils::read.csv(
    system.file("extdata", "datras_survey_hauls_geometry.csv.gz", package = "codend"),
    comment.char = "#"
  )
  hauls <- hauls[hauls$Ship == ship & hauls$SweepLngt %in% sweep & hauls$Gear == gear, ]
  # speed through the water if reported, else over ground, else the survey's standard speed
  hauls$speed <- ifelse(is.na(hauls$SpeedWater), hauls$speed_kn, hauls$SpeedWater)
  hauls$speed[is.na(hauls$speed)] <- 4
  of <- c("Depth", "Warplngt", "Warpdia", "speed", "DoorSurface", "DoorWgt", "Buoyancy", "KiteDim",
    "WgtGroundRope", "DoorSpread", "WingSpread", "Netopening")
  classes <- split(hauls[of], cut(hauls$Warplngt, warp_classes), drop = TRUE)
  classes <- classes[vapply(classes, nrow, 0L) >= 3]
  means <- do.call(rbind, lapply(classes, colMeans, na.rm = TRUE))
  data.frame(means, hauls = vapply(classes, nrow, 0L), row.names = NULL)
}

# The GOV of a ship, with the ship's reported gear, else the plan's.
gov_of <- function(hauls, sweep) {
  reported <- function(column, unit) {
    value <- mean(hauls[[column]])
    if (is.finite(value)) paste(value, unit)
  }
  plan <- read_gear("validation/plans/gov_36_47.yaml")
  buoyancy <- mean(hauls$Buoyancy) / 60
  fields <- list(
    sweeps.length = paste(sweep, "m"), warps.diameter = reported("Warpdia", "mm"),
    otter_boards.area = reported("DoorSurface", "m2"),
    otter_boards.mass = reported("DoorWgt", "kg"),
    floats.buoyancy = if (is.finite(buoyancy)) paste(buoyancy, "kgf"),
    # one ship's discs, 700 kg, are weighed in air
    ground_gear.mass_in_water = if (isTRUE(mean(hauls$WgtGroundRope) < 300)) {
      paste(mean(hauls$WgtGroundRope) / 47.2, "kg/m")
    }
  )
  gear <- do.call(update, c(list(plan), Filter(Negate(is.null), fields)))
  # the kite at the middle of the headline: area reported, coefficients of a plate at about 30
  # degrees
  update(assembly(gear), pieces.kite = list(at = "headline.middle", area = 0.7,
    lift_coefficient = 1, drag_coefficient = 0.4, lift_direction = "up", role = "kite"))
}

# Sensors of wing spread are at the upper wing ends.
gov_hauls <- function(ship, sweep) {
  hauls <- hauls_by_warp(ship, sweep)
  gear <- gov_of(hauls, sweep)
  found <- settled_along(gear,
    list(ropes.warp_port.length = hauls$Warplngt, ropes.warp_starboard.length = hauls$Warplngt,
      seabed.depth = hauls$Depth, towing.speed = paste(hauls$speed, "knot")),
    c("door_spread_m", "upper_wing_spread_m", "headline_height_m")
  )
  at <- sprintf("%.0f m of warp", hauls$Warplngt)
  columns <- c(door_spread = "DoorSpread", wing_spread = "WingSpread", opening = "Netopening")
  do.call(rbind, lapply(seq_along(columns), function(k) {
    measured <- hauls[[columns[k]]]
    told <- which(is.finite(measured))
    if (!length(told)) return(NULL)
    rbind(
      compared(names(columns)[k], at[told], measured[told], found[told, k]),
      trend(names(columns)[k], "warp", hauls$Warplngt[told], measured[told], found[told, k])
    )
  }))
}

case_gov_scotia_3 <- function() gov_hauls("SCO3", 60)
case_gov_scotia_2 <- function() gov_hauls("SCO2", 60)
case_gov_argos <- function() gov_hauls("ARG", 60)
case_gov_argos_long <- function() gov_hauls("ARG", 110)
case_gov_dana <- function() gov_hauls("DAN2", 60)
case_gov_dana_long <- function() gov_hauls("DAN2", 120)
case_gov_thalassa <- function() gov_hauls("THA2", 50)
case_gov_tridens <- function() gov_hauls("TRI2", 50)

# Published drag of the midwater trawl by Lee and others (1987), t by speed in m/s. The spread of
# its boards (1986), m, is the middle of the published range for each length of warp.
case_small_midwater_trawl <- function() {
  gear <- read_gear("small_midwater_trawl")
  speeds <- c(1.1, 1.45, 1.8)
  by_speed <- settled_along(gear, list(towing.speed = speeds),
    c("total_drag_kN", "door_spread_m"))
  warps <- c(100, 150, 200)
  by_warp <- settled_along(gear, list(warps.length = warps), "door_spread_m")
  drag <- by_speed[, 1] / 9.80665
  printed <- 2.15 * speeds^1.12
  spread <- c(44, 54, 56.5)
  rbind(
    # twine is tuned to the drag at the middle speed, boards to their spread with 150 m of warp
    compared("drag", paste(speeds, "m/s"), printed, drag, speeds == 1.45),
    compared("door_spread", paste(warps, "m of warp"), spread, drop(by_warp), warps == 150),
    trend("drag", "speed", speeds, printed, drag),
    trend("door_spread", "warp", warps, spread, drop(by_warp)),
    # only the sign of the trend with speed is published
    trend("door_spread", "speed", range(speeds), 1:2, by_speed[c(1, 3), 2])
  )
}
