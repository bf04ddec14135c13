# How a gear lies on the sea bed before it is hauled, in SI.

# Returns list(net = x, y (m), ropes = by name, corners (2 x n, m)).
si_laid <- function(laid, path, known) {
  if (!known$ground) abort_field(path, "given", "left out where the plan has no `seabed`")
  corners <- lapply(laid$ropes, function(way) matrix(as.double(unlist(way)), 2L))
  for (name in names(corners)) find_rope(name, paste0(path, ".ropes"), known)
  list(net = unlist(laid$net), ropes = corners)
}
