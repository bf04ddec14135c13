# Returns the state of a shipped gear that the gallery shows: a purse seine when its wire has closed
# the net, other gears settled. nodes: as settle() takes it.
gallery_state <- function(name, nodes = NULL) {
  if (name != "purse_seine") return(settle(name, nodes = nodes))
  state_at(tow(name, until = 420, every = 420, nodes = 120, accuracy = 1), 420)
}
