# What a state is in: the flow past the gear, and words for it.

# Water past the gear at the depth of its middle, m/s (x aft, y starboard).
flow_past <- function(state) {
  if (state$lattice$mesh$water$density == 0) return(c(0, 0))
  water_velocity(state, -mean(range(state$position[3L, ])))
}

# Velocity (m/s, along x and y) of the water past the vessel at a depth (m).
water_velocity <- function(state, depth) {
  water <- state$lattice$mesh$water
  if (length(water$depth) == 1L) return(c(water$x, water$y))
  vapply(water[c("x", "y")], function(speed) {
    stats::approx(water$depth, speed, depth, rule = 2)$y
  }, 0, USE.NAMES = FALSE)
}

# Such as "towed at 3 knot".
state_conditions <- function(state) {
  paste0(still_conditions(state), wave_conditions(state))
}

# Waves move a gear in a tow; settled it is in their mean.
wave_conditions <- function(state) {
  waves <- state$si$water$waves
  if (is.null(waves)) return("")
  if (is.null(state$time)) return(sprintf(", in the mean of %s", wave_words(waves)))
  sprintf(", in %s", wave_words(waves))
}

still_conditions <- function(state) {
  knots <- state$si$towing$speed / plan_units$speed[["knot"]]
  flow <- flow_past(state)
  if (knots > 0) return(sprintf("towed at %s knot", shortest_decimal(round(knots, 2))))
  if (any(flow != 0)) return(sprintf("in a current of %.2f m/s", sqrt(sum(flow^2))))
  if (state$si$water$density > 0) "in still water" else "in air"
}

# Such as "regular waves of 2 m and 7 s".
wave_words <- function(waves) {
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
