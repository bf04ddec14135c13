# The speed that an engine tows a gear at.

#' The speed that a power tows
#'
#' Settles a gear at one speed after the other, each from the last, until its engine gives the power
#' that is given: where the gear's drag is what the vessel pulls (see [vessel]).
#'
#' @param gear A gear with a `vessel`, or the name or file of a plan.
#' @param power Power of the engine, W, or text with a unit (`"1500 kW"`), or a share of full power
#'   (`"80 %"`); `NULL` for all of it.
#' @param nodes,netting As [settle()] takes them.
#' @return The settled state at that speed, whose `si$towing$speed` is the speed (m/s) and whose
#'   [measures()] have the engine's. The speed is found to 1e-4 of itself. A gear without a vessel,
#'   a power above full power, or one that does not tow the gear at 0.2 m/s is an error of class
#'   `codend_error_argument`.
#' @export
#' @examples
#' trawl <- update(read_gear("beam_trawl"), vessel = list(
#'   power = "221 kW", pull = list(
#'     list(speed = "0 knot", pull = "30 kN"), list(speed = "9 knot", pull = "0 kN")
#'   ), fuel = "215 g/kWh"
#' ))
#' state <- tow_speed(trawl, "60 %", nodes = 300)
#' measures(state)[c("engine_power_kW", "fuel_rate_l_per_h")]
tow_speed <- function(gear, power = NULL, nodes = 1500, netting = NULL) {
  check_given("gear")
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  vessel <- gear_si(gear)$vessel
  if (is.null(vessel)) abort_argument("{.arg gear} has no {.field vessel} in its plan.")
  share <- power_share(power, vessel)
  state <- NULL
  # How much more than the power asked for the gear takes, as a share of what the vessel pulls.
  excess <- function(speed) {
    at <- update(gear, towing.speed = speed)
    state <<- settle(at, nodes, netting, from = state)
    measures(state)[["pull_used_percent"]] / 100 - share^(2 / 3)
  }
  least <- 0.2
  begun <- max(least, gear_si(gear)$towing$speed)
  low <- high <- begun
  at_low <- at_high <- excess(begun)
  while (at_high < 0) {
    low <- high
    at_low <- at_high
    high <- high * 1.15
    at_high <- excess(high)
  }
  while (at_low > 0) {
    high <- low
    at_high <- at_low
    if (low <= least) {
      abort_argument("{.arg power} does not tow the gear at {least} m/s.")
    }
    low <- max(least, low / 1.15)
    at_low <- excess(low)
  }
  if (high > low) {
    found <- stats::uniroot(excess, c(low, high), f.lower = at_low, f.upper = at_high,
      tol = 1e-4 * low)$root
    excess(found)
  }
  state
}

# A power as a share of a vessel's.
power_share <- function(power, vessel) {
  if (is.null(power)) return(1)
  share <- given_si(power, "power", "power") / vessel$power
  if (is.na(share)) share <- given_si(power, "number", "power")
  if (is.na(share) || share <= 0 || share > 1 + 1e-9) {
    full <- format_si(vessel$power, "power")
    abort_argument("{.arg power} is {.val {power}}; it must be a power above 0, at most the
      vessel's {full}, or a share of it such as {.val 80 %}.")
  }
  share
}
