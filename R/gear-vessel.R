# The vessel's engine as SI numbers.

#' The vessel's engine
#'
#' The plan's field `vessel` says what the vessel can pull and what fuel that takes, for the
#' measures `engine_power`, `pull_used`, `fuel_rate`, `fuel_per_swept_area`,
#' `fuel_per_filtered_volume` and `fuel_per_catch` ([measures()]) and for [tow_speed()]. It changes
#' nothing of how the gear settles.
#'
#' @section Fields:
#' - `power`: full power of the engine, on its brake.
#' - `pull`: a list of `speed` and `pull`: what is left for the gear at full power, as a trial or
#'   the yard gives it, from the bollard pull at speed 0 on. It is straight between rows. Two rows,
#'   the bollard pull and no pull at the free speed, are a first guess.
#' - `fuel`: fuel over energy, such as `"210 g/kWh"`, or a list of `load` (share of full power) and
#'   `consumption`, straight between rows and constant beyond them.
#' - `fuel_density` (840 kg/m3, of marine gas oil; an assumption) and `catch_per_hour`.
#'
#' @section Power at less than full pull:
#' A propeller's thrust grows with the square of its speed of rotation n and its power with the cube
#' while the water meets it alike (J. S. Carlton, Marine Propellers and Propulsion, chapter 6: K_T
#' and K_Q depend on the advance V / (n D) alone). So at full pull the power is `power`, and at a
#' share s of it `power` s^1.5. That is exact where the vessel lies still; under way a lightly
#' loaded propeller meets the water faster than that, and a light tow takes somewhat more.
#'
#' @examples
#' with_engine <- update(read_gear("towed_cable"), vessel = list(power = "200 kW",
#'   pull = list(list(speed = "0 knot", pull = "30 kN"), list(speed = "10 knot", pull = "0 kN")),
#'   fuel = "215 g/kWh"))
#' measures(settle(with_engine))[c("engine_power_kW", "pull_used_percent", "fuel_rate_l_per_h")]
#' @name vessel
NULL

# list(power (W), pull = data.frame(speed (m/s), pull (N)), fuel = data.frame(load, consumption
# (kg/J)) or NULL, fuel_density (kg/m3), catch_per_hour (kg, NA)).
si_vessel <- function(vessel, path) {
  column <- function(rows, field) vapply(rows, `[[`, 0, field, USE.NAMES = FALSE)
  rising <- function(field, x) {
    if (is.unsorted(x, strictly = TRUE)) {
      abort_field(paste(path, field, sep = "."), x, "in rising order, each once")
    }
  }
  speed <- column(vessel$pull, "speed")
  rising("pull", speed)
  pull <- column(vessel$pull, "pull")
  if (any(diff(pull) > 0) || pull[1L] == 0) {
    abort_field(paste0(path, ".pull"), pull, "a pull that falls with speed")
  }
  fuel <- vessel[["fuel"]] # not fuel_density
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
