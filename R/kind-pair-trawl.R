# The pair trawl's short form: the net and legs of a bottom trawl, towed by two vessels instead of
# spread by otter boards. Where warp and sweep or bridles meet there may be weights.

# fields: checked, in SI; plan: as given, so that the assembly keeps the designer's units.
expand_pair_trawl <- function(fields, plan) {
  rig <- boardless_rig(fields, plan, fields$vessels$distance)
  for (side in trawl_sides) {
    rig$pieces[[paste0("weight_", side)]] <- part_with_role(plan$weights, "weight",
      at = paste0("warp_end_", side))
  }
  out <- rigged_net(fields, plan, rig)
  out$measures <- bottom_trawl_measures(fields, NULL, "warp_end", "warp_end_spread")
  out
}
