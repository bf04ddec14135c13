# What a tow went through.

#' Water and ground swept in a tow
#'
#' @param trajectory A trajectory, from [tow()], of a gear with `mouth_area` or `wing_end_spread`
#'   among its measures.
#' @return A data frame with a row per kept time: `time_s`, `distance_m` (the vessel's way over the
#'   ground) and, summed up since the start, `swept_volume_m3` (water that flowed through the mouth)
#'   and `swept_area_m2` (ground that the lines between the wing ends passed over): the integrals of
#'   `filtered_volume` and `swept_area` ([measures()]) by the trapezoid rule between kept times.
#'   `NA` where the gear has no such measure.
#' @seealso [mesh_openings()], the other half of what a model of selection takes.
#' @examples
#' # two ropes side by side sweep the ground between their ends
#' line <- function(from, to) rope(from, to, length = "20 m", diameter = "20 mm", material = "PA")
#' pair <- gear("Two ropes", towing = list(speed = "2 knot"),
#'   port = gear_point(position = c(0, -5, 0), held = "moved"), end_port = gear_point(),
#'   starboard = gear_point(position = c(0, 5, 0), held = "moved"), end_starboard = gear_point(),
#'   line_port = line("port", "end_port"), line_starboard = line("starboard", "end_starboard"),
#'   wing_end_spread = measure(spread = c("end_port", "end_starboard")))
#' swept(tow(settle(pair), until = 60, every = 20))
#' @export
swept <- function(trajectory) {
  check_given("trajectory")
  check_is_trajectory(trajectory)
  time <- trajectory$time
  found <- lapply(time, function(at) measures(state_at(trajectory, at)))
  # per hour, as measures are shown
  summed <- function(name, unit) {
    rate <- vapply(found, function(one) {
      if (name %in% names(one)) one[[name]] else NA_real_
    }, 0) * unit_size(unit)
    c(0, cumsum(diff(time) * (rate[-1L] + rate[-length(rate)]) / 2))
  }
  conditions <- trajectory$conditions
  data.frame(
    time_s = time,
    distance_m = c(0, cumsum(sqrt(diff(conditions$x)^2 + diff(conditions$y)^2))),
    swept_volume_m3 = summed("filtered_volume_m3_per_h", "m3/h"),
    swept_area_m2 = summed("swept_area_km2_per_h", "km2/h")
  )
}
