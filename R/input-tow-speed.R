#' Compute the towing speed for an engine power
#'
#' Returns the state in which the drag of a gear equals the pull of the vessel at a given engine
#' power (see [vessel]). The gear is settled at about 8 speeds, each from the last shape.
#'
#' @param gear A gear of class `codend_gear` with a `vessel`, or the name or file of a plan.
#' @param power Engine power: a number in W, a string with a unit (`"1500 kW"`), or a fraction of
#'   full power (`"80 %"`). Default `NULL`: full power.
#' @param nodes,netting,accuracy As in [settle()]. The gear as given determines the number of nodes
#'   for all speeds.
#' @return The settled state at this speed (class `codend_state`). The speed (m/s) is
#'   `si$towing$speed`; [measures()] include the engine measures. The relative error of the speed is
#'   1e-4. An error of class `codend_error_argument` is thrown for a gear without a vessel, a power
#'   above full power, or a power too low to tow the gear at 0.2 m/s.
#' @seealso [vessel] for the fields, [measures()] for power and fuel.
#' @export
#' @examples
#' trawl <- update(read_gear("beam_trawl"), vessel = list(
#'   power = "221 kW", pull = list(
#'     list(speed = "0 knot", pull = "30 kN"), list(speed = "9 knot", pull = "0 kN")
#'   ), fuel = "215 g/kWh"
#' ))
#' state <- tow_speed(trawl, "60 %", nodes = 300)
#' measures(state)[c("engine_power_kW", "fuel_rate_l_per_h")]
tow_speed <- function(gear, power = NULL, nodes = NULL, netting = NULL, accuracy = NULL) {
  check_given("gear")
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  vessel <- gear_si(gear)$vessel
  if (is.null(vessel)) abort_argument("{.arg gear} has no {.field vessel} in its plan.")
  share <- power_share(power, vessel)
  state <- NULL
  # Excess of the gear's required pull over the requested pull, as a fraction of the available pull.
  excess <- function(speed) {
    text <- format_like(speed, "speed", gear$plan$towing$speed)
    at <- with_fields(gear, list(towing.speed = text))
    state <<- if (is.null(state)) {
      settle(at, nodes, netting, accuracy = accuracy)
    } else {
      settle(at, netting = netting, from = state)
    }
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
      abort_argument("{.arg power} is too small to tow the gear at {least} m/s.")
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

# Returns a power as a fraction of the vessel's full power.
power_share <- function(power, vessel) {
  if (is.null(power)) return(1)
  share <- given_si(power, "power", "power") / vessel$power
  if (is.na(share)) share <- given_si(power, "number", "power")
  if (is.na(share) || share <= 0 || share > 1 + 1e-9) {
    full <- format_si(vessel$power, "power")
    abort_argument("{.arg power} is {.val {power}}; it must be a power above 0 and at most {full},
      the power of the vessel, or a percentage such as {.val 80 %}.")
  }
  share
}
