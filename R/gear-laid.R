# Initial position of a gear on the seabed before hauling, in SI. Returns list(net = c(x, y) in m,
# ropes = named list of corner positions, 2 x n in m).
si_laid <- function(laid, path, known) {
  if (!known$ground) abort_field(path, "given", "omitted in a plan without `seabed`")
  corners <- lapply(laid$ropes, function(way) matrix(as.double(unlist(way)), 2L))
  for (name in names(corners)) find_rope(name, paste0(path, ".ropes"), known)
  list(net = unlist(laid$net), ropes = corners)
}
