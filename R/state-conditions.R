# Flow past the gear in a state, as numbers and as text.

# Returns the water velocity at the gear's mid-depth [m/s]: x aft, y to starboard.
flow_past <- function(state) {
  if (state$mesh$model$water$density == 0) return(c(0, 0))
  water_velocity(state, -mean(range(state$position[3L, ])))
}

# Returns the water velocity (x, y) at a depth, relative to the vessel [m/s].
water_velocity <- function(state, depth) {
  water <- state$mesh$model$water
  if (length(water$depth) == 1L) return(c(water$x, water$y))
  vapply(water[c("x", "y")], function(speed) {
    stats::approx(water$depth, speed, depth, rule = 2)$y
  }, 0, USE.NAMES = FALSE)
}

# Returns a string such as "towed at 3 knot".
state_conditions <- function(state) {
  paste0(still_conditions(state), wave_conditions(state))
}

# Waves move a gear only in a tow; a settled gear is in the mean conditions.
wave_conditions <- function(state) {
  waves <- state$si$water$waves
  if (is.null(waves)) return("")
  if (is.null(state$time)) return(sprintf(", mean over %s", wave_text(waves)))
  sprintf(", in %s", wave_text(waves))
}

still_conditions <- function(state) {
  knots <- state$si$towing$speed / plan_units$speed[["knot"]]
  flow <- flow_past(state)
  if (knots > 0) return(sprintf("towed at %s knot", shortest_decimal(round(knots, 2))))
  if (any(flow != 0)) return(sprintf("in a current of %.2f m/s", sqrt(sum(flow^2))))
  if (state$si$water$density > 0) "in still water" else "in air"
}

# Returns a string such as "regular waves of 2 m and 7 s".
wave_text <- function(waves) {
  sprintf(
    "%s of %s m%s and %s s",
    switch(waves$spectrum,
      regular = "regular waves", jonswap = "waves of a JONSWAP spectrum",
      pierson_moskowitz = "waves of Pierson and Moskowitz's spectrum"
    ),
    shortest_decimal(signif(waves$height, 3)),
    if (waves$spectrum != "regular") " (significant)" else "",
    shortest_decimal(signif(waves$period, 3))
  )
}
