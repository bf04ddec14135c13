#' Engine of the vessel
#'
#' The plan field `vessel` gives the pull and the fuel consumption of the vessel. It adds the
#' measures `engine_power`, `pull_used`, `fuel_rate`, `fuel_per_swept_area`,
#' `fuel_per_filtered_volume` and `fuel_per_catch` ([measures()]), and it is the input of
#' [tow_speed()]. It does not affect the shape of the gear.
#'
#' @section Fields:
#' - `power`: full brake power of the engine.
#' - `pull`: a list of `speed` and `pull`, the pull available for the gear at full power. The first
#'   row is the bollard pull at speed 0. Use values from a trial or the yard. Interpolation is
#'   linear. A first estimate needs two rows: the bollard pull, and zero pull at the free speed.
#' - `fuel`: fuel per energy, such as `"210 g/kWh"`. Or a list of `load` (fraction of full power)
#'   and `consumption`, interpolated linearly and clamped at the ends.
#' - `fuel_density`: default 840 kg/m3, marine gas oil (an assumption).
#' - `catch_per_hour`: catch, for `fuel_per_catch`.
#'
#' @section Power at less than full pull:
#' At full pull the power is `power`. At a fraction s of full pull it is `power` s^1.5.
#'
#' Reason: at a constant advance V / (n D), thrust is proportional to n^2 and power to n^3, with n
#' the speed of rotation (J. S. Carlton, Marine Propellers and Propulsion, chapter 6: K_T and K_Q
#' depend on the advance alone). The relation is exact at zero speed. Under way, a lightly loaded
#' propeller has a larger advance, and a light tow takes somewhat more power.
#'
#' @seealso [tow_speed()] for the speed at a given power, [measures()] for the fuel measures.
#'
#' @examples
#' with_engine <- update(read_gear("towed_cable"), vessel = list(power = "200 kW",
#'   pull = list(list(speed = "0 knot", pull = "30 kN"), list(speed = "10 knot", pull = "0 kN")),
#'   fuel = "215 g/kWh"))
#' measures(settle(with_engine))[c("engine_power_kW", "pull_used_percent", "fuel_rate_l_per_h")]
#' @name vessel
NULL

# Returns list(power (W), pull = data.frame(speed (m/s), pull (N)), fuel = data.frame(load,
# consumption (kg/J)) or NULL, fuel_density (kg/m3), catch_per_hour (kg, or NA)).
si_vessel <- function(vessel, path) {
  column <- function(rows, field) vapply(rows, `[[`, 0, field, USE.NAMES = FALSE)
  rising <- function(field, x) {
    if (is.unsorted(x, strictly = TRUE)) {
      abort_field(paste(path, field, sep = "."), x, "in increasing order, without duplicates")
    }
  }
  speed <- column(vessel$pull, "speed")
  rising("pull", speed)
  pull <- column(vessel$pull, "pull")
  if (any(diff(pull) > 0) || pull[1L] == 0) {
    abort_field(paste0(path, ".pull"), pull, "a pull that decreases with speed")
  }
  fuel <- vessel[["fuel"]] # excludes fuel_density
  if (is.list(fuel)) {
    load <- column(fuel, "load")
    rising("fuel", load)
    fuel <- data.frame(load = load, consumption = column(fuel, "consumption"))
  } else if (!is.null(fuel)) {
    fuel <- data.frame(load = 1, consumption = fuel)
  }
  list(
    power = vessel$power, pull = data.frame(speed = speed, pull = pull), fuel = fuel,
    fuel_density = vessel$fuel_density, catch_per_hour = first_of(vessel$catch_per_hour, NA_real_)
  )
}
