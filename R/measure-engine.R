# What the vessel's engine gives to tow a gear.

has_vessel <- function(state) !is.null(state$si$vessel) && has_towing(state)

# What a vessel can pull (N) at a speed (m/s) and full power. Beyond its table's end the line
# through the last two rows goes on to 0.
vessel_pull <- function(vessel, speed) {
  of <- vessel$pull
  n <- nrow(of)
  if (speed <= of$speed[n]) return(stats::approx(of$speed, of$pull, speed, rule = 2)$y)
  slope <- (of$pull[n] - of$pull[n - 1L]) / (of$speed[n] - of$speed[n - 1L])
  max(0, of$pull[n] + slope * (speed - of$speed[n]))
}

# What a vessel needs to pull a force (N) at a speed (m/s): list(pull_share (of what it can pull
# there), power (W), fuel (m3/s, NULL where its consumption is not given)). See ?vessel.
engine_need_at <- function(vessel, force, speed) {
  share <- max(0, force) / vessel_pull(vessel, speed)
  power <- vessel$power * share^1.5
  fuel <- vessel[["fuel"]]
  list(
    pull_share = share, power = power,
    fuel = if (!is.null(fuel) && is.finite(power)) {
      at <- if (nrow(fuel) > 1L) {
        stats::approx(fuel$load, fuel$consumption, power / vessel$power, rule = 2)$y
      } else {
        fuel$consumption
      }
      power * at / vessel$fuel_density
    }
  )
}

# The same of a state whose total drag is `drag` (N); NULL without a vessel that tows it.
engine_need <- function(state, drag) {
  if (has_vessel(state)) engine_need_at(state$si$vessel, drag, state$si$towing$speed)
}

# x / y, or NULL where either is not known or y is 0.
per <- function(x, y) if (!is.null(x) && !is.null(y) && !is.na(y) && y != 0) x / y
