# A gear that is shot, before it is in the water.

# The gear hung, in water at rest, from the rope that it is shot along, drawn out straight along x
# from 0: positions (3 x nodes, m). Every node's x then says when it is shot.
hang_out <- function(si, lattice, panels, chains) {
  si$towing$speed <- 0
  si$water$current[c("x", "y")] <- 0
  rope <- si$shooting$rope
  from_rope <- function(skeleton) {
    run <- skeleton$ropes[[rope]]
    held <- logical(skeleton$nodes)
    position <- load <- matrix(0, 3L, skeleton$nodes)
    held[run$node] <- TRUE
    position[1, run$node] <- run$at * si$ropes[[rope]]$length
    list(held = held, position = position, load = load)
  }
  lattice$start <- lay_out(si, lattice, panels, chains, supports = from_rope, open = 1)
  place_inner_nodes(lattice)
}
