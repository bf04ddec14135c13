# What a state is in: the flow past the gear, and words for it.

# Water past the gear at the depth of its middle, m/s (x aft, y starboard).
flow_past <- function(state) {
  water <- state$lattice$engine$water
  depth <- -mean(range(state$position[3L, ]))
  along <- function(speed) {
    if (length(speed) == 1L) speed else stats::approx(water$depth, speed, depth, rule = 2)$y
  }
  if (water$density == 0) c(0, 0) else c(along(water$x), along(water$y))
}

# Such as "towed at 3 knot".
state_conditions <- function(state) {
  knots <- state$si$towing$speed / plan_units$speed[["knot"]]
  flow <- flow_past(state)
  if (knots > 0) return(sprintf("towed at %s knot", format(round(knots, 2))))
  if (any(flow != 0)) return(sprintf("in a current of %.2f m/s", sqrt(sum(flow^2))))
  if (state$si$water$density > 0) "in still water" else "in air"
}
