# Pair trawl (short form): the net and legs of a bottom trawl, towed by two vessels without otter
# boards. Optional weights are at the joints of warps and sweeps or bridles.

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
