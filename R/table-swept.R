# Returns distance, swept volume and swept area of a tow. Rates are integrated by the trapezoid rule
# between saved times. A column is NA if the gear has no such measure.
swept_table <- function(trajectory) {
  time <- trajectory$time
  found <- lapply(time, function(at) measures(state_at(trajectory, at)))
  # Measures are per hour.
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
