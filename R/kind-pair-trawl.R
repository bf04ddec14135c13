# The pair trawl's short form: the net and legs of a bottom trawl, towed by two vessels instead of
# spread by otter boards. Where warp and sweep or bridles meet there may be weights.

# fields: checked, in SI; plan: as given, so that the assembly keeps the designer's units.
expand_pair_trawl <- function(fields, plan) {
  check_section_names(fields)
  check_wing_ends(fields)
  check_middle_bridle(fields)
  net <- bottom_trawl_net(fields, plan)
  ends <- paste0("warp_end_", trawl_sides)
  rig <- list(
    points = c(
      towing_points(paste0("block_", trawl_sides), fields$vessels$distance),
      stats::setNames(list(nothing, nothing), ends)
    ),
    ropes = trawl_warps(plan, to = "warp_end")
  )
  rig <- trawl_legs(plan, fields, rig, ends)
  if (!is.null(plan$weights)) {
    for (side in trawl_sides) {
      rig$pieces[[paste0("weight_", side)]] <- c(
        list(at = paste0("warp_end_", side)), plan$weights, list(role = "weight")
      )
    }
  }
  out <- shared_fields(plan, fields)
  out$points <- c(rig$points, net$points)
  out$ropes <- c(rig$ropes, net$ropes)
  out$panels <- net$panels
  out$seams <- net$seams
  out$pieces <- c(rig$pieces, trawl_fittings(fields, plan, panels_around(fields)))
  out$measures <- bottom_trawl_measures(fields, NULL, "warp_end", "warp_end_spread")
  out
}
