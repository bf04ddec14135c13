# Demersal seine (short form): the net and legs of a bottom trawl between two long ropes (its
# warps), which are on the seabed when hauling starts.

expand_demersal_seine <- function(fields, plan) {
  if (is.null(plan$warps$segments)) {
    plan$warps$segments <- ceiling(fields$warps$length / rope_segment)
  }
  out <- rigged_net(fields, plan, boardless_rig(fields, plan, fields$warps$spacing))
  corners <- lapply(trawl_sides, function(side) first_of(plan$laying[[side]], list()))
  out$laid <- list(
    net = plan$laying$net, ropes = stats::setNames(corners, paste0("warp_", trawl_sides))
  )
  out$tow <- demersal_seine_tow(fields, plan)
  out$measures <- demersal_seine_measures(fields)
  out
}

# Default length of the segments of its ropes, m.
rope_segment <- 30

# Time in which the vessel reaches the speed of a phase, s.
vessel_gathers <- 30

# Minimum fraction of a rope that remains out at the end of a haul.
least_left <- 0.05

# Default error of a time step of a haul. Ropes alone would need only 1/1000 of their length; nets
# of tens of metres need this accuracy.
haul_accuracy <- "0.3 m"

# Returns the `tow` of the haul: all phases in order, starting from rest.
demersal_seine_tow <- function(fields, plan) {
  long <- vapply(trawl_sides, function(side) of_side(fields$warps, side)$length, 0)
  row <- function(time, value) list(time = time, value = value)
  time <- hauled <- 0
  speed <- list(row(0, 0))
  in_board <- list(row(0, 0))
  for (k in seq_along(fields$hauling)) {
    phase <- fields$hauling[[k]]
    lasts <- phase_time(phase, max(long) - hauled, sprintf("hauling[%d]", k))
    speed <- c(speed, list(
      row(time, speed[[length(speed)]]$value),
      row(time + min(vessel_gathers, lasts / 2), phase$vessel)
    ))
    time <- time + lasts
    hauled <- hauled + lasts * phase$winch
    in_board <- c(in_board, list(row(time, hauled)))
  }
  most <- min(long) - least_left * max(long)
  if (hauled > most) {
    abort_field("hauling", hauled, paste("at most", format_si(most, "length")),
      is = paste("hauls", format_si(hauled, "length"), "of each rope"))
  }
  own <- list(
    until = time, every = time / 200, speed = speed[-1L], accuracy = haul_accuracy,
    warp_out = lapply(stats::setNames(long, paste0("warp_", trawl_sides)), function(whole) {
      lapply(in_board, function(at) row(at$time, whole - at$value))
    })
  )
  own[names(plan$tow)] <- plan$tow
  own
}

# Returns the duration (s) of a phase that starts with `out` metres of rope.
phase_time <- function(phase, out, path) {
  if (is.null(phase$rope_out)) return(phase$time)
  if (phase$winch == 0) {
    abort_field(paste0(path, ".winch"), "0 m/s", "greater than 0 with `rope_out`")
  }
  if (phase$rope_out >= out) {
    abort_field(paste0(path, ".rope_out"), format_si(phase$rope_out, "length"),
      paste("less than the length at the start,", format_si(out, "length")))
  }
  (out - phase$rope_out) / phase$winch
}

demersal_seine_measures <- function(fields) {
  legs <- function(side) {
    paste(c("warp", if (!is.null(fields$sweeps)) "sweep", "bridle_lower"), side, sep = "_")
  }
  around <- c(legs("port"), "footrope", rev(legs("starboard")))
  c(
    bottom_trawl_measures(fields, NULL, "warp_end", "warp_end_spread"),
    list(
      enclosed_area = list(enclosed_area = around),
      distance_to_net = list(spread = c("warp_port.start", "footrope.middle")),
      net_speed = list(ground_speed = "footrope.middle")
    )
  )
}
