# Measures how often 90 % intervals of calibrate() contain the true values if the hauls come from a
# finer mesh (4,000 nodes) than the first fit (300 nodes).
#
# Each repeat draws true values within 15 % of the plan's values and two hauls at each of four
# speeds. The errors equal the scatter of repeated flume tests: 2 % of spreads and tensions, 4 % of
# heights. Each fit starts from the plan's values and estimates two fields, hence two intervals.
#
#   Rscript bench/coverage-trawls.R [repeats of each gear]
#
# Writes bench/results/coverage.md: coverage by gear and field. With 200 intervals of 90 %, the
# coverage itself is uncertain by +- 4.2 % (two standard deviations of a binomial fraction).
library(codend)
source("bench/results.R")

given <- commandArgs(TRUE)
repeats <- if (length(given)) as.integer(given[1L]) else 34L

# of: plan; speeds: knot; change: fields with their value in the plan (number, unit); match:
# measures with the relative standard deviation of their errors.
cases <- list(
  list(of = "small_midwater_trawl", speeds = c(2, 2.5, 3, 3.5),
    change = list(otter_boards.lift_coefficient = list(1.5, ""), hammers.mass = list(200, "kg")),
    match = c(door_spread_m = 0.02, net_mouth_height_m = 0.04, warp_tension_port_kN = 0.02)),
  list(of = "beam_trawl", speeds = c(3, 3.5, 4, 4.5),
    change = list(shoes.mass = list(300, "kg"), seabed.friction = list(0.5, "")),
    match = c(warp_tension_kN = 0.02, warp_declination_deg = 0.02)),
  list(of = "pair_trawl", speeds = c(2, 2.5, 3, 3.5),
    change = list(floats.buoyancy = list(2.9, "kgf"), ground_gear.mass_in_water = list(5, "kg/m")),
    match = c(net_mouth_height_m = 0.04, warp_tension_port_kN = 0.02, wing_end_spread_m = 0.02))
)

given_in <- function(value, unit) if (nzchar(unit)) paste(value, unit) else value

# Returns one logical per field: TRUE if the interval of this repeat contains the true value. NA if
# the fit fails or returns no interval for the field.
one_repeat <- function(case, number) {
  set.seed(number, kind = "Mersenne-Twister", normal.kind = "Inversion", sample.kind = "Rejection")
  plan <- read_gear(case$of)
  truth <- vapply(case$change, `[[`, 0, 1L) * stats::runif(length(case$change), 0.85, 1.15)
  unit <- vapply(case$change, `[[`, "", 2L)
  true <- do.call(update, c(list(plan), Map(given_in, truth, unit)))
  fine <- vary(true, towing.speed = paste(case$speeds, "knot"), nodes = 4000)
  k <- rep(seq_along(case$speeds), 2L)
  runs <- data.frame(towing.speed = paste(case$speeds, "knot")[k])
  for (name in names(case$match)) {
    runs[[name]] <- fine[[name]][k] * (1 + case$match[[name]] * stats::rnorm(length(k)))
  }
  ranges <- Map(function(field) {
    lapply(field[[1L]] * c(0.7, 1.4), given_in, field[[2L]])
  }, case$change)
  match <- lapply(names(case$match), function(name) {
    stats::as.formula(paste0("`", name, "` ~ ", name))
  })
  fit <- tryCatch(
    suppressWarnings(calibrate(plan, runs, change = lapply(ranges, unlist), match = match,
      nodes = 300)),
    codend_error = function(e) NULL
  )
  if (is.null(fit)) return(truth * NA)
  ends <- stats::confint(fit, level = 0.9, method = "normal")
  truth >= ends[, 1L] & truth <= ends[, 2L]
}

found <- do.call(rbind, lapply(cases, function(case) {
  inside <- vapply(seq_len(repeats), function(number) as.double(one_repeat(case, number)),
    numeric(length(case$change)))
  data.frame(gear = case$of, field = names(case$change), intervals = rowSums(!is.na(inside)),
    `held, %` = 100 * rowMeans(inside, na.rm = TRUE), failed = rowSums(is.na(inside)),
    check.names = FALSE)
}))
all <- sum(found$intervals)
save_page(c(
  "# How often intervals of calibrate() hold what was planted", "",
  sprintf(paste("Written by `Rscript bench/coverage-trawls.R`: hauls of 4,000 nodes, fits that",
    "begin with 300, 90 %% intervals by the covariance. Of %d intervals %.1f %% hold. %s"), all,
  sum(found$intervals * found[["held, %"]]) / all, measured_with()), "",
  markdown_table(found)
), "coverage")
