# Pair trawl (short form): the net and legs of a bottom trawl, towed by two vessels without otter
# boards. Optional weights are at the joints of warps and sweeps or bridles. With `lower_warps` each
# vessel has a warp to the upper and a warp to the lower bridle.

expand_pair_trawl <- function(fields, plan) {
  rig <- boardless_rig(fields, plan, fields$vessels$distance)
  low <- !is.null(plan$lower_warps)
  if (low) rig <- with_lower_warps(fields, plan, rig)
  for (side in trawl_sides) {
    rig$pieces[[paste0("weight_", side)]] <- part_with_role(plan$weights, "weight",
      at = paste0(if (low) "lower_", "warp_end_", side))
  }
  out <- rigged_net(fields, plan, rig)
  out$measures <- bottom_trawl_measures(fields, NULL, "warp_end", "warp_end_spread")
  if (low) {
    out$measures[paste0("lower_warp_tension_", trawl_sides)] <-
      lapply(paste0("lower_warp_", trawl_sides, ".start"), function(end) list(tension = end))
  }
  out
}

# Returns a rig in which the lower bridles start at the ends of lower warps.
with_lower_warps <- function(fields, plan, rig) {
  for (path in c("sweeps", "danlenos", "bridles.middle")) {
    field <- strsplit(path, ".", fixed = TRUE)[[1L]]
    if (!is.null(fields[[field]])) {
      abort_field(path, "given", "omitted in a plan with `lower_warps`")
    }
  }
  for (side in trawl_sides) {
    end <- paste0("lower_warp_end_", side)
    rig$points[[end]] <- nothing
    rig$ropes[[paste0("lower_warp_", side)]] <-
      rope_between(paste0("block_", side), end, of_side(plan$lower_warps, side), "warp")
    rig$ropes[[paste0("bridle_lower_", side)]]$from <- end
  }
  rig
}
