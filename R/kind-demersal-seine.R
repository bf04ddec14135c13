# The demersal seine's short form and the assembly that it stands for: the net and legs of a bottom
# trawl between two long ropes, its warps, which lie on the sea bed when hauling begins.

# fields: checked, in SI; plan: as given, so that the assembly keeps the designer's units.
expand_demersal_seine <- function(fields, plan) {
  check_section_names(fields)
  check_wing_ends(fields)
  check_middle_bridle(fields)
  net <- bottom_trawl_net(fields, plan)
  ends <- paste0("warp_end_", trawl_sides)
  rig <- list(
    points = c(
      towing_points(paste0("block_", trawl_sides), fields$warps$spacing),
      stats::setNames(list(nothing, nothing), ends)
    ),
    ropes = trawl_warps(plan, to = "warp_end")
  )
  rig <- trawl_legs(plan, fields, rig, ends)
  out <- shared_fields(plan, fields)
  out$points <- c(rig$points, net$points)
  out$ropes <- c(rig$ropes, net$ropes)
  out$panels <- net$panels
  out$seams <- net$seams
  out$pieces <- c(rig$pieces, trawl_fittings(fields, plan, panels_around(fields)))
  corners <- lapply(trawl_sides, function(side) first_of(plan$laying[[side]], list()))
  out$laid <- list(
    net = plan$laying$net, ropes = stats::setNames(corners, paste0("warp_", trawl_sides))
  )
  out$tow <- demersal_seine_tow(fields, plan)
  out$measures <- demersal_seine_measures(fields)
  out
}

# Over this time the vessel takes up the speed of a phase, s.
vessel_gathers <- 30

# The haul: phase after phase, from rest.
demersal_seine_tow <- function(fields, plan) {
  length <- vapply(trawl_sides, function(side) of_side(fields$warps, side)$length, 0)
  hauled <- time <- 0
  speed <- 0
  out <- list(list(time = 0, value = 0))
  speeds <- list(list(time = 0, value = 0))
  for (k in seq_along(fields$hauling)) {
    phase <- fields$hauling[[k]]
    path <- sprintf("hauling[%d]", k)
    if (is.null(phase$rope_out)) {
      lasts <- phase$time
    } else {
      left <- max(length) - hauled - phase$rope_out
      if (left <= 0 || phase$winch == 0) {
        abort_field(paste0(path, if (left <= 0) ".rope_out" else ".winch"),
          format_si(if (left <= 0) phase$rope_out else 0, if (left <= 0) "length" else "speed"),
          if (left <= 0) {
            paste("less than what is out before,", format_si(max(length) - hauled, "length"))
          } else {
            "greater than 0 where it hauls until `rope_out`"
          })
      }
      lasts <- left / phase$winch
    }
    gathers <- min(vessel_gathers, lasts / 2)
    speeds <- c(speeds, list(
      list(time = time, value = speed), list(time = time + gathers, value = phase$vessel)
    ))
    hauled <- hauled + lasts * phase$winch
    time <- time + lasts
    speed <- phase$vessel
    out <- c(out, list(list(time = time, value = hauled)))
  }
  if (hauled > min(length) - least_left) {
    abort_field("hauling", format_si(hauled, "length"),
      paste("such that at most", format_si(min(length) - least_left, "length"), "are hauled"))
  }
  warp_out <- lapply(length, function(whole) {
    lapply(out, function(row) list(time = row$time, value = whole - row$value))
  })
  own <- list(
    until = time, every = time / 200, speed = speeds[-1L],
    warp_out = stats::setNames(warp_out, paste0("warp_", trawl_sides))
  )
  own[names(plan$tow)] <- plan$tow
  own
}

# Rope that is left out at the end of a haul, m.
least_left <- 10

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
